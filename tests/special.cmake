# Tests that are more than one executable: several builds compared, a program driven, instructions counted.

# equal bits across -O levels and compilers: the library as it is built, the same runs compiled without optimisation, and by
# the other compiler, where there is one, at the level in between
if(NOT ODEMARK_NATIVE)
  set(bits ${CMAKE_CURRENT_BINARY_DIR}/final_bits.cpp)
  odemark_write(${bits} "#include \"tests/support/final_bits.cpp\"
#include \"integrators/shifted_lu.cpp\"
#include \"integrators/stage_modes.cpp\"
")
  add_executable(final_bits_of_library support/final_bits_of_library.cpp)
  odemark_compile_test(final_bits_of_library)
  target_link_libraries(final_bits_of_library PRIVATE odemark::bench odemark_warnings)
  add_executable(final_bits_o0 ${bits})
  target_link_libraries(final_bits_o0 PRIVATE odemark::numbers odemark_warnings Eigen3::Eigen)
  target_include_directories(final_bits_o0 PRIVATE ${PROJECT_SOURCE_DIR})
  target_compile_options(final_bits_o0 PRIVATE -O0)
  target_compile_definitions(final_bits_o0 PRIVATE FMT_HEADER_ONLY)
  set(bits_programs $<TARGET_FILE:final_bits_of_library> $<TARGET_FILE:final_bits_o0>)
  if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    find_program(ODEMARK_OTHER_COMPILER NAMES clang++-14 clang++)
  else()
    find_program(ODEMARK_OTHER_COMPILER NAMES g++-12 g++)
  endif()
  if(ODEMARK_OTHER_COMPILER)
    set(other ${CMAKE_CURRENT_BINARY_DIR}/final_bits_other)
    add_custom_command(OUTPUT ${other} DEPENDS ${bits} DEPFILE ${other}.d
      COMMAND ${ODEMARK_OTHER_COMPILER} -std=c++20 -O1 -ffp-contract=off -DEIGEN_FAST_MATH=0 -DNDEBUG -DFMT_HEADER_ONLY
        -I${PROJECT_SOURCE_DIR} "-isystem;$<JOIN:$<TARGET_PROPERTY:Eigen3::Eigen,INTERFACE_INCLUDE_DIRECTORIES>,;-isystem;>"
        -MD -MF ${other}.d ${bits} -o ${other} COMMAND_EXPAND_LISTS VERBATIM)
    add_custom_target(final_bits_other_compiler ALL DEPENDS ${other})
    list(APPEND bits_programs ${other})
  endif()
  add_test(NAME same_bits_everywhere COMMAND ${CMAKE_COMMAND} "-DPROGRAMS=${bits_programs}"
    -P ${CMAKE_CURRENT_SOURCE_DIR}/support/compare_bits.cmake)
  set_tests_properties(same_bits_everywhere PROPERTIES LABELS unit TIMEOUT 120)
endif()

# a wrong coefficient does not compile
add_test(NAME wrong_tableau_does_not_compile COMMAND ${CMAKE_COMMAND} -DCXX=${CMAKE_CXX_COMPILER}
  -DROOT=${PROJECT_SOURCE_DIR} -P ${CMAKE_CURRENT_SOURCE_DIR}/planted/must_not_compile.cmake)
set_tests_properties(wrong_tableau_does_not_compile PROPERTIES LABELS unit TIMEOUT 120)

# the program, driven as people drive it
find_program(ODEMARK_BASH bash)
if(TARGET odemark AND ODEMARK_BASH)
  file(GLOB scripts CONFIGURE_DEPENDS ${CMAKE_CURRENT_SOURCE_DIR}/cli/*_test.sh)
  foreach(script ${scripts})
    get_filename_component(name ${script} NAME_WE)
    add_test(NAME cli_${name} COMMAND ${ODEMARK_BASH} ${script})
    set_tests_properties(cli_${name} PROPERTIES LABELS cli TIMEOUT 120 ENVIRONMENT "ODEMARK=$<TARGET_FILE:odemark>")
  endforeach()
endif()

# instructions per step
find_program(ODEMARK_VALGRIND valgrind)
include(CheckIncludeFileCXX)
check_include_file_cxx(valgrind/callgrind.h ODEMARK_HAS_CALLGRIND_HEADER)
if(ODEMARK_VALGRIND AND ODEMARK_HAS_CALLGRIND_HEADER AND TARGET odemark_step_cost AND NOT ODEMARK_NATIVE
   AND NOT CMAKE_CXX_FLAGS MATCHES "sanitize")
  add_executable(odemark_count_cells instructions/count_cells.cpp)
  target_link_libraries(odemark_count_cells PRIVATE odemark::step_cost odemark_warnings)
  string(REGEX MATCH "^[0-9]+" major ${CMAKE_CXX_COMPILER_VERSION})
  string(TOLOWER ${CMAKE_CXX_COMPILER_ID} compiler)
  set(table ${CMAKE_CURRENT_SOURCE_DIR}/instructions/${compiler}${major}.txt)
  set(here ${CMAKE_CURRENT_BINARY_DIR}/instructions_here.cmake)
  file(GENERATE OUTPUT ${here} CONTENT "set(PROGRAM $<TARGET_FILE:odemark_count_cells>)
set(VALGRIND ${ODEMARK_VALGRIND})
set(TABLE ${table})
if(PLANTED)
  set(WORK ${CMAKE_CURRENT_BINARY_DIR}/instructions_planted)
else()
  set(WORK ${CMAKE_CURRENT_BINARY_DIR}/instructions)
endif()
include(${CMAKE_CURRENT_SOURCE_DIR}/instructions/instructions.cmake)
")
  add_test(NAME instructions COMMAND ${CMAKE_COMMAND} -P ${here})
  add_test(NAME instructions_bites COMMAND ${CMAKE_COMMAND} -DPLANTED=ON -P ${here})
  set_tests_properties(instructions instructions_bites PROPERTIES LABELS instructions TIMEOUT 300)
else()
  message(STATUS "no test instructions: it needs valgrind with its headers, Google Benchmark and a portable build")
endif()
