# Builds the files of reference/solutions into the library as string literals, so that a program finds them without
# knowing where the sources were. Pieces stay below the 16 kB that MSVC allows for one literal.
file(GLOB ODEMARK_SOLUTIONS CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/reference/solutions/*.json)
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${ODEMARK_SOLUTIONS})
set(literals "")
set(entries "")
set(number 0)
foreach(path ${ODEMARK_SOLUTIONS})
  get_filename_component(preset ${path} NAME_WE)
  file(READ ${path} json)
  set(pieces "")
  string(LENGTH "${json}" length)
  set(begin 0)
  while(begin LESS length)
    string(SUBSTRING "${json}" ${begin} 8000 piece)
    string(APPEND pieces "\n    R\"~~(${piece})~~\"")
    math(EXPR begin "${begin} + 8000")
  endwhile()
  string(APPEND literals "constexpr std::string_view solution_${number} =${pieces};\n")
  string(APPEND entries "      {\"${preset}\", solution_${number}},\n")
  math(EXPR number "${number} + 1")
endforeach()
odemark_write(${ODEMARK_GENERATED}/stored_solutions.cpp
"#include \"reference/truth_store.hpp\"
namespace odemark {
namespace {
${literals}}
std::span<const StoredSolution> stored_solutions() {
  static const std::vector<StoredSolution> all{
${entries}  };
  return all;
}
}
")
# together the pieces of one solution may be longer than every compiler must take; those that build this do
set_source_files_properties(${ODEMARK_GENERATED}/stored_solutions.cpp PROPERTIES COMPILE_OPTIONS
  $<$<CXX_COMPILER_ID:Clang,AppleClang>:-Wno-overlength-strings>)
