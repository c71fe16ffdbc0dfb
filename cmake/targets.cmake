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

# Headers that most files of a library parse anyway.
function(odemark_precompile target)
  if(ODEMARK_PCH)
    target_precompile_headers(${target} PRIVATE ${ARGN})
  endif()
endfunction()
set(ODEMARK_COMMON_HEADERS <algorithm> <array> <cmath> <fmt/format.h> <functional> <limits> <map> <memory> <optional>
  <string> <string_view> <vector>)

# What runs once per row or page gains nothing from -O3 and pays a third of its compile time for it. Numbers are the
# same at every level; engines, right-hand sides and contestants stay at -O3.
function(odemark_compile_lightly)
  if(CMAKE_BUILD_TYPE STREQUAL "Release")
    set_source_files_properties(${ARGN} PROPERTIES COMPILE_OPTIONS -O1)
  endif()
endfunction()

file(GLOB integrators_sources CONFIGURE_DEPENDS integrators/*.cpp)
odemark_library(integrators SOURCES ${integrators_sources} ${ODEMARK_METHOD_UNITS} LINK Eigen3::Eigen)
target_link_libraries(odemark_integrators PRIVATE $<BUILD_INTERFACE:Boost::headers>)

# what every unit of a method parses: two thirds of the time of a small one
odemark_precompile(odemark_integrators <algorithm> <array> <cmath> <complex> <functional> <limits> <string> <string_view>
  <tuple> <variant> <vector> ${PROJECT_SOURCE_DIR}/integrators/erase_method.hpp)
set(once_per_method ${integrators_sources})
list(FILTER once_per_method INCLUDE REGEX "/(linear_stability[a-z_]*|eigenvalues|real_polynomial|facts[a-z_]*)\\.cpp$")
odemark_compile_lightly(${once_per_method})

# problems/ is headers only: mathematics without integrators
add_library(odemark_problems INTERFACE)
add_library(odemark::problems ALIAS odemark_problems)
set_target_properties(odemark_problems PROPERTIES EXPORT_NAME problems)
target_include_directories(odemark_problems INTERFACE
  $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}> $<INSTALL_INTERFACE:include/odemark>)
target_link_libraries(odemark_problems INTERFACE odemark::numbers)

find_package(nlohmann_json REQUIRED)
include(cmake/solutions.cmake)
file(GLOB reference_sources CONFIGURE_DEPENDS reference/*.cpp)
odemark_library(reference SOURCES ${reference_sources} ${ODEMARK_FAMILY_UNITS} ${ODEMARK_WIDE_UNITS}
  ${ODEMARK_GENERATED}/stored_solutions.cpp
  LINK odemark::integrators odemark::problems Boost::headers fmt::fmt nlohmann_json::nlohmann_json)

# Makes and verifies reference/solutions; run from the top of the sources.
add_executable(odemark_make_solutions EXCLUDE_FROM_ALL tools/make_solutions.cpp)
target_link_libraries(odemark_make_solutions PRIVATE odemark::reference odemark_warnings Threads::Threads)

odemark_compile_lightly(${ODEMARK_WIDE_UNITS} ${reference_sources})  # wide arithmetic is a library call per operation
odemark_precompile(odemark_reference ${ODEMARK_COMMON_HEADERS} <nlohmann/json.hpp>
  ${PROJECT_SOURCE_DIR}/reference/make_wide_family.hpp)

# Third-party solvers, each its own target: GSL is GPL-3, and nobody must need all of them.
set(ODEMARK_CONTESTANTS)
include(cmake/contestants.cmake)

find_package(nlohmann_json REQUIRED)
find_package(tomlplusplus REQUIRED)
file(GLOB bench_sources CONFIGURE_DEPENDS bench/*.cpp)
odemark_library(bench SOURCES ${bench_sources} ${ODEMARK_STATIC_UNITS}
  LINK odemark::reference ${ODEMARK_CONTESTANTS} Threads::Threads nlohmann_json::nlohmann_json)

odemark_compile_lightly(${bench_sources})
odemark_precompile(odemark_bench ${ODEMARK_COMMON_HEADERS})

# What a results file says of the build: the commit if there is one, and the flags that matter to numbers.
execute_process(COMMAND git -C ${PROJECT_SOURCE_DIR} describe --always --dirty
  OUTPUT_VARIABLE ODEMARK_REVISION OUTPUT_STRIP_TRAILING_WHITESPACE ERROR_QUIET)
if(NOT ODEMARK_REVISION)
  set(ODEMARK_REVISION "unknown")
endif()
string(STRIP "${CMAKE_CXX_FLAGS} ${CMAKE_CXX_FLAGS_RELEASE}" ODEMARK_FLAGS)
if(ODEMARK_NATIVE)
  string(APPEND ODEMARK_FLAGS " -march=native -ffp-contract=fast")
else()
  string(APPEND ODEMARK_FLAGS " -ffp-contract=off")
endif()
set_property(SOURCE ${PROJECT_SOURCE_DIR}/bench/machine.cpp APPEND PROPERTY COMPILE_DEFINITIONS
  "ODEMARK_REVISION=\"${ODEMARK_REVISION}\"" "ODEMARK_FLAGS=\"${ODEMARK_FLAGS}\""
  "ODEMARK_BUILD_TYPE=\"${CMAKE_BUILD_TYPE}\"" "ODEMARK_VERSION=\"${PROJECT_VERSION}\"")

file(GLOB reports_sources CONFIGURE_DEPENDS reports/*.cpp)
odemark_library(reports SOURCES ${reports_sources}
  LINK fmt::fmt nlohmann_json::nlohmann_json tomlplusplus::tomlplusplus)

odemark_compile_lightly(${reports_sources})
odemark_precompile(odemark_reports ${ODEMARK_COMMON_HEADERS} <nlohmann/json.hpp>)

include(cmake/cli.cmake)
