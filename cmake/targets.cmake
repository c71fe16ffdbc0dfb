# One library per folder; who may include whom is checked by the layers test.
function(odemark_library name)
  cmake_parse_arguments(arg "" "" "SOURCES;LINK" ${ARGN})
  add_library(odemark_${name} STATIC ${arg_SOURCES})
  add_library(odemark::${name} ALIAS odemark_${name})
  set_target_properties(odemark_${name} PROPERTIES EXPORT_NAME ${name})
  target_include_directories(odemark_${name} PUBLIC
    $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}> $<BUILD_INTERFACE:${ODEMARK_GENERATED}/include>
    $<INSTALL_INTERFACE:include/odemark>)
  target_link_libraries(odemark_${name} PUBLIC odemark::numbers ${arg_LINK})
  target_link_libraries(odemark_${name} PRIVATE $<BUILD_INTERFACE:odemark_warnings>)
endfunction()

file(GLOB integrators_sources CONFIGURE_DEPENDS integrators/*.cpp)
odemark_library(integrators SOURCES ${integrators_sources} ${ODEMARK_METHOD_UNITS} LINK Eigen3::Eigen)

# problems/ is headers only: mathematics without integrators
add_library(odemark_problems INTERFACE)
add_library(odemark::problems ALIAS odemark_problems)
set_target_properties(odemark_problems PROPERTIES EXPORT_NAME problems)
target_include_directories(odemark_problems INTERFACE
  $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}> $<INSTALL_INTERFACE:include/odemark>)
target_link_libraries(odemark_problems INTERFACE odemark::numbers)

file(GLOB reference_sources CONFIGURE_DEPENDS reference/*.cpp)
odemark_library(reference SOURCES ${reference_sources} ${ODEMARK_FAMILY_UNITS} ${ODEMARK_WIDE_UNITS}
  LINK odemark::integrators odemark::problems Boost::headers fmt::fmt)

# Third-party solvers, each its own target: GSL is GPL-3, and nobody must need all of them.
set(ODEMARK_CONTESTANTS)
include(cmake/contestants.cmake)

file(GLOB bench_sources CONFIGURE_DEPENDS bench/*.cpp)
odemark_library(bench SOURCES ${bench_sources} ${ODEMARK_STATIC_UNITS}
  LINK odemark::reference ${ODEMARK_CONTESTANTS} Threads::Threads)

file(GLOB reports_sources CONFIGURE_DEPENDS reports/*.cpp)
odemark_library(reports SOURCES ${reports_sources} LINK fmt::fmt)
