# One library per folder; who may include whom is checked by the layers test. LIGHT sources run once per row or page: they
# gain nothing from -O3 and pay a third of their compile time for it; numbers are the same at every level. They share what
# their headers instantiate by being compiled several at a time. Engines, right-hand sides and contestants stay at -O3.
function(odemark_library name)
  cmake_parse_arguments(arg "" "" "SOURCES;LIGHT;LINK;PRECOMPILE" ${ARGN})
  set(parts odemark_${name})
  add_library(odemark_${name} STATIC ${arg_SOURCES})
  add_library(odemark::${name} ALIAS odemark_${name})
  if(arg_LIGHT)
    add_library(odemark_${name}_light OBJECT ${arg_LIGHT})
    list(APPEND parts odemark_${name}_light)
    if(CMAKE_BUILD_TYPE STREQUAL "Release")
      target_compile_options(odemark_${name}_light PRIVATE -O1)
    endif()
    set_target_properties(odemark_${name}_light PROPERTIES UNITY_BUILD ${ODEMARK_UNITY} UNITY_BUILD_BATCH_SIZE 16)
    target_sources(odemark_${name} PRIVATE $<TARGET_OBJECTS:odemark_${name}_light>)
    if(ODEMARK_PCH AND arg_PRECOMPILE)
      target_precompile_headers(odemark_${name}_light PRIVATE ${arg_PRECOMPILE})
    endif()
  endif()
  foreach(part ${parts})
    target_include_directories(${part} PUBLIC
      $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}> $<BUILD_INTERFACE:${ODEMARK_GENERATED}/include>
      $<INSTALL_INTERFACE:include/odemark>)
    target_link_libraries(${part} PUBLIC odemark::numbers ${arg_LINK})
    target_link_libraries(${part} PRIVATE $<BUILD_INTERFACE:odemark_warnings>)
  endforeach()
  set_target_properties(odemark_${name} PROPERTIES EXPORT_NAME ${name})
endfunction()

# Headers that most files of a library parse anyway.
function(odemark_precompile target)
  if(ODEMARK_PCH)
    target_precompile_headers(${target} PRIVATE ${ARGN})
  endif()
endfunction()
set(ODEMARK_COMMON_HEADERS <algorithm> <array> <cmath> <fmt/format.h> <functional> <limits> <map> <memory> <optional>
  <string> <string_view> <vector>)

file(GLOB integrators_sources CONFIGURE_DEPENDS integrators/*.cpp)
set(once_per_method ${integrators_sources})
list(FILTER once_per_method INCLUDE REGEX "/(linear_stability[a-z_]*|eigenvalues|real_polynomial|facts[a-z_]*)\\.cpp$")
list(REMOVE_ITEM integrators_sources ${once_per_method})
odemark_library(integrators SOURCES ${integrators_sources} ${ODEMARK_METHOD_UNITS} LIGHT ${once_per_method} LINK Eigen3::Eigen
  PRECOMPILE ${ODEMARK_COMMON_HEADERS} <complex>)
target_link_libraries(odemark_integrators PRIVATE $<BUILD_INTERFACE:Boost::headers>)
set_target_properties(odemark_integrators_light PROPERTIES UNITY_BUILD OFF)  # what they instantiate is mostly their own

# what every unit of a method parses: two thirds of the time of a small one
odemark_precompile(odemark_integrators <algorithm> <array> <cmath> <complex> <functional> <limits> <string> <string_view>
  <tuple> <variant> <vector> ${PROJECT_SOURCE_DIR}/integrators/erase_method.hpp)

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
odemark_library(reference SOURCES ${ODEMARK_FAMILY_UNITS} LIGHT ${reference_sources} ${ODEMARK_WIDE_UNITS}
  ${ODEMARK_GENERATED}/stored_solutions.cpp PRECOMPILE ${ODEMARK_COMMON_HEADERS} <nlohmann/json.hpp>
  ${PROJECT_SOURCE_DIR}/reference/make_wide_family.hpp
  LINK odemark::integrators odemark::problems Boost::headers fmt::fmt nlohmann_json::nlohmann_json)

# Right-hand sides behind a function pointer. At -O3 these units take a fifth longer to compile; the 360 erased pairs of the
# benchmark took 1.001 times as long (median) with families and methods at this level, where what lost were methods of many
# implicit stages: those stay at -O3, and so does the static tier, which reads the headers.
if(CMAKE_BUILD_TYPE STREQUAL "Release" AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  target_compile_options(odemark_reference PRIVATE -O2 -fvect-cost-model=dynamic)
endif()

# Makes reference/solutions; run from the top of the sources.
add_executable(odemark_make_solutions EXCLUDE_FROM_ALL tools/make_solutions.cpp)
target_link_libraries(odemark_make_solutions PRIVATE odemark::reference odemark_warnings Threads::Threads)

odemark_precompile(odemark_reference ${ODEMARK_COMMON_HEADERS} ${PROJECT_SOURCE_DIR}/reference/make_family.hpp)
set_source_files_properties(${ODEMARK_WIDE_UNITS} ${ODEMARK_GENERATED}/stored_solutions.cpp PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)

# Third-party solvers, each its own target: GSL is GPL-3, and nobody must need all of them.
set(ODEMARK_CONTESTANTS)
include(cmake/contestants.cmake)

find_package(nlohmann_json REQUIRED)
find_package(tomlplusplus REQUIRED)
file(GLOB bench_sources CONFIGURE_DEPENDS bench/*.cpp)
odemark_library(bench SOURCES ${ODEMARK_STATIC_UNITS} LIGHT ${bench_sources} PRECOMPILE ${ODEMARK_COMMON_HEADERS}
  LINK odemark::reference ${ODEMARK_CONTESTANTS} Threads::Threads nlohmann_json::nlohmann_json)

if(ODEMARK_STATIC_TIER)
  odemark_precompile(odemark_bench ${ODEMARK_GENERATED}/include/bench/static_headers.hpp)
endif()

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
odemark_library(reports LIGHT ${reports_sources} PRECOMPILE ${ODEMARK_COMMON_HEADERS} <nlohmann/json.hpp>
  LINK fmt::fmt nlohmann_json::nlohmann_json tomlplusplus::tomlplusplus)

include(cmake/cli.cmake)
