# Every source is as clang-format 14 writes it. To mend: clang-format-14 -i <file>
# Run: cmake -DCLANG_FORMAT=clang-format-14 -DROOT=... -P tests/format.cmake
set(files)
foreach(folder integrators problems reference bench reports tests tools)
  file(GLOB_RECURSE found ${ROOT}/${folder}/*.hpp ${ROOT}/${folder}/*.cpp)
  list(APPEND files ${found})
endforeach()
execute_process(COMMAND ${CLANG_FORMAT} --dry-run -Werror ${files} RESULT_VARIABLE code)
list(LENGTH files count)
message(STATUS "format: ${count} files")
if(NOT code EQUAL 0)
  message(FATAL_ERROR "some are not formatted; mend with ${CLANG_FORMAT} -i <file>")
endif()
