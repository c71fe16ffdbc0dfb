# The command line, as a library with a ready main() and as the program.
find_package(CLI11 REQUIRED)
find_package(nlohmann_json REQUIRED)

file(GLOB step_cost_sources CONFIGURE_DEPENDS bench/step_cost/*.cpp)
list(FILTER step_cost_sources EXCLUDE REGEX "_main\\.cpp$")
find_package(benchmark QUIET)
if(benchmark_FOUND AND step_cost_sources)
  odemark_library(step_cost SOURCES ${step_cost_sources} LINK odemark::bench benchmark::benchmark)
  target_compile_definitions(odemark_step_cost PUBLIC ODEMARK_HAS_BENCHMARK)
  add_executable(odemark_bench_program bench/step_cost/step_cost_main.cpp)
  set_target_properties(odemark_bench_program PROPERTIES OUTPUT_NAME odemark_bench)
  target_link_libraries(odemark_bench_program PRIVATE odemark::step_cost $<BUILD_INTERFACE:odemark_warnings>)
else()
  message(STATUS "odemark: Google Benchmark not found, no odemark_bench")
endif()

file(GLOB cli_sources CONFIGURE_DEPENDS bench/cli/*.cpp)
odemark_library(main LIGHT ${cli_sources} PRECOMPILE ${ODEMARK_COMMON_HEADERS} LINK odemark::bench odemark::reports)
# objects of their own: who defines main() or the registration links this library all the same
set_source_files_properties(bench/cli/main.cpp bench/cli/user.cpp PROPERTIES SKIP_UNITY_BUILD_INCLUSION ON)
target_link_libraries(odemark_main_light PRIVATE $<BUILD_INTERFACE:CLI11::CLI11>)
if(TARGET odemark_step_cost)
  target_link_libraries(odemark_main PUBLIC odemark::step_cost)
  target_link_libraries(odemark_main_light PUBLIC odemark::step_cost)
endif()

add_executable(odemark bench/cli/main.cpp)
target_link_libraries(odemark PRIVATE odemark::main $<BUILD_INTERFACE:odemark_warnings>)
