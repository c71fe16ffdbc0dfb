# Reads integrators/catalogue.txt and problems/catalogue.txt and writes what follows from them: units of methods and of families, and for
# the static tier one per `static` family and chunk of `static` methods. A method or a family is one file and one line; nothing else
# names them.
set(ODEMARK_GENERATED ${PROJECT_BINARY_DIR}/generated)

# Touches a file only when its content changes, so that a configure does not rebuild the world.
function(odemark_write path content)
  file(CONFIGURE OUTPUT ${path} CONTENT "${content}" @ONLY)
endfunction()

# Methods and families share units of a few, because what they have in common is then compiled once; methods share with
# those of their kind, which have most in common (three quarters of the time of 48 units dealt by name alone). Which unit is
# theirs follows from the kind and the name: a new one changes one unit, or those of its kind where they have become too large.
function(odemark_group out groups name)
  string(MD5 hash ${name})
  string(SUBSTRING ${hash} 0 4 hash)
  math(EXPR number "0x${hash} % ${groups}")
  set(${out} ${number} PARENT_SCOPE)
endfunction()
macro(odemark_write_groups units kind header)
  list(REMOVE_DUPLICATES ${kind}_groups)
  foreach(group ${${kind}_groups})
    odemark_write(${ODEMARK_GENERATED}/${kind}/${group}.cpp
"${${kind}_headers_${group}}#include \"${header}\"
namespace odemark {
${${kind}_code_${group}}}
")
    list(APPEND ${units} ${ODEMARK_GENERATED}/${kind}/${group}.cpp)
  endforeach()
endmacro()

# The header of its kind: the first of integrators/ that the method includes, or else that of the method it varies.
function(odemark_kind out file)
  set(path ${PROJECT_SOURCE_DIR}/integrators/methods/${file}.hpp)
  file(STRINGS ${path} lines REGEX "^#include \"integrators/[a-z0-9_]+\\.hpp\"" LIMIT_COUNT 1)
  if(lines MATCHES "integrators/([a-z0-9_]+)\\.hpp")
    set(${out} ${CMAKE_MATCH_1} PARENT_SCOPE)
    return()
  endif()
  file(STRINGS ${path} lines REGEX "^#include \"integrators/methods/" LIMIT_COUNT 1)
  if(lines MATCHES "methods/([a-z0-9_]+)\\.hpp")
    odemark_kind(kind ${CMAKE_MATCH_1})
    set(${out} ${kind} PARENT_SCOPE)
  else()
    set(${out} others PARENT_SCOPE)
  endif()
endfunction()

# methods: ids; method_files: file stem of each
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS
  ${PROJECT_SOURCE_DIR}/integrators/catalogue.txt ${PROJECT_SOURCE_DIR}/problems/catalogue.txt)
file(STRINGS ${PROJECT_SOURCE_DIR}/integrators/catalogue.txt lines REGEX "^[a-z]")
set(ODEMARK_METHODS)
set(ODEMARK_STATIC_METHODS)
foreach(line ${lines})
  string(STRIP "${line}" line)
  if(line MATCHES "^([a-z0-9_]+) +static(=([a-z0-9_,]+))?$")
    set(line ${CMAKE_MATCH_1})
    string(REPLACE "," ";" static_families_of_${line} "${CMAKE_MATCH_3}")  # empty: all that are marked
    list(APPEND ODEMARK_STATIC_METHODS ${line})
  endif()
  if(line MATCHES "^([a-z0-9_]+)\\[([0-9]+)\\.\\.([0-9]+)\\]$")
    foreach(n RANGE ${CMAKE_MATCH_2} ${CMAKE_MATCH_3})
      list(APPEND ODEMARK_METHODS ${CMAKE_MATCH_1}${n})
      set(file_of_${CMAKE_MATCH_1}${n} ${CMAKE_MATCH_1})
    endforeach()
  elseif(line MATCHES "^[a-z0-9_]+$")
    list(APPEND ODEMARK_METHODS ${line})
    set(file_of_${line} ${line})
  else()
    message(FATAL_ERROR "integrators/catalogue.txt: cannot read \"${line}\"; write an id, an id and `static` or `static=family,family`, or name[first..last]")
  endif()
endforeach()

set(includes "")
set(declarations "")
set(calls "")
set(ODEMARK_METHOD_UNITS)
set(files)
foreach(method ${ODEMARK_METHODS})
  set(file ${file_of_${method}})
  if(NOT EXISTS ${PROJECT_SOURCE_DIR}/integrators/methods/${file}.hpp)
    message(FATAL_ERROR "integrators/catalogue.txt names ${method}, but integrators/methods/${file}.hpp does not exist")
  endif()
  if(NOT file IN_LIST files)
    list(APPEND files ${file})
    string(APPEND includes "#include \"integrators/methods/${file}.hpp\"\n")
  endif()
  string(APPEND unit_of_${file} "AnyMethod erased_${method}();\nAnyMethod erased_${method}() { return erase_method<${method}>(); }\n")
  string(APPEND declarations "AnyMethod erased_${method}();\n")
  string(APPEND calls "    methods.push_back(erased_${method}());\n")
endforeach()
foreach(file ${files})
  odemark_kind(kind_of_${file} ${file})
  list(APPEND files_of_${kind_of_${file}} ${file})
endforeach()
set(methods_groups)
foreach(file ${files})
  set(kind ${kind_of_${file}})
  list(LENGTH files_of_${kind} count)
  if(count LESS 4)  # kinds of few methods share
    odemark_group(part 2 ${file})
    set(group others_${part})
  else()
    math(EXPR units "(${count} + 8) / 9")
    odemark_group(part ${units} ${file})
    set(group ${kind}_${part})
  endif()
  list(APPEND methods_groups ${group})
  string(APPEND methods_headers_${group} "#include \"integrators/methods/${file}.hpp\"\n")
  string(APPEND methods_code_${group} "${unit_of_${file}}")
endforeach()
odemark_write_groups(ODEMARK_METHOD_UNITS methods "integrators/erase_method.hpp")
list(REMOVE_DUPLICATES ODEMARK_METHODS)
string(REPLACE ";" ", " names "${ODEMARK_METHODS}")
odemark_write(${ODEMARK_GENERATED}/include/integrators/catalogue.hpp
"// Every method of the suite, for code that instantiates them itself. Written from integrators/catalogue.txt.
#pragma once
${includes}
namespace odemark {
template <const auto&... methods>
struct MethodList {};
using SuiteMethods = MethodList<${names}>;
}
")
odemark_write(${ODEMARK_GENERATED}/suite_methods.cpp
"#include \"integrators/any_method.hpp\"
namespace odemark {
${declarations}
const std::vector<AnyMethod>& suite_methods() {
  static const std::vector<AnyMethod> all = [] {
    std::vector<AnyMethod> methods;
${calls}    return methods;
  }();
  return all;
}
}
")
list(APPEND ODEMARK_METHOD_UNITS ${ODEMARK_GENERATED}/suite_methods.cpp)

# families
file(STRINGS ${PROJECT_SOURCE_DIR}/problems/catalogue.txt lines REGEX "^[a-z]")
set(declarations "")
set(calls "")
set(wide_calls "")
set(wide_declarations "")
set(static_declarations "")
set(static_calls "")
set(static_marks "")
set(families_groups)
set(wide_groups)
set(ODEMARK_FAMILY_UNITS)
set(ODEMARK_WIDE_UNITS)
set(ODEMARK_STATIC_UNITS)
set(ODEMARK_FAMILIES)
set(ODEMARK_STATIC_FAMILIES)
set(chunk_size 32)  # headers are parsed once per chunk; a touched family is one chunk
foreach(line ${lines})
  if(NOT line MATCHES "^([a-z0-9_]+) +([A-Za-z0-9]+)( +static(=named)?)? *$")
    message(FATAL_ERROR "problems/catalogue.txt: cannot read \"${line}\"; write: id ClassTemplate [static|static=named]")
  endif()
  set(id ${CMAKE_MATCH_1})
  set(type ${CMAKE_MATCH_2})
  set(tier "${CMAKE_MATCH_3}")
  if(NOT EXISTS ${PROJECT_SOURCE_DIR}/problems/${id}.hpp)
    message(FATAL_ERROR "problems/catalogue.txt names ${id}, but problems/${id}.hpp does not exist")
  endif()
  list(APPEND ODEMARK_FAMILIES ${id})
  string(APPEND declarations "AnyFamily family_${id}();\n")
  string(APPEND calls "    families.push_back(family_${id}());\n")
  string(APPEND wide_declarations "WideFamily wide_${id}();\n")
  string(APPEND wide_calls "    families.push_back(wide_${id}());\n")
  odemark_group(group 8 ${id})
  foreach(kind families wide)
    list(APPEND ${kind}_groups ${group})
    string(APPEND ${kind}_headers_${group} "#include \"problems/${id}.hpp\"\n")
  endforeach()
  string(APPEND families_code_${group}
    "AnyFamily family_${id}();\nAnyFamily family_${id}() { return make_family<${type}>(); }\n")
  string(APPEND wide_code_${group}
    "WideFamily wide_${id}();\nWideFamily wide_${id}() { return make_wide_family<${type}>(); }\n")
  if(tier AND ODEMARK_STATIC_TIER)
    list(APPEND ODEMARK_STATIC_FAMILIES ${id})
    set(chunk "")
    set(chunk_number 0)
    set(filled 0)
    set(inlined)
    foreach(method ${ODEMARK_STATIC_METHODS})
      if((NOT static_families_of_${method} AND NOT tier MATCHES "named") OR id IN_LIST static_families_of_${method})
        list(APPEND inlined ${method})
        string(APPEND static_marks "    {\"${id}\", \"${method}\"},\n")
      endif()
    endforeach()
    foreach(method ${inlined} END)
      if(method STREQUAL "END" OR filled EQUAL chunk_size)
        if(filled GREATER 0)
          set(unit ${ODEMARK_GENERATED}/static/${id}_${chunk_number}.cpp)
          string(JOIN ", " list ${chunk})
          set(headers "")
          foreach(m ${chunk})
            string(APPEND headers "#include \"integrators/methods/${file_of_${m}}.hpp\"\n")
          endforeach()
          odemark_write(${unit}
"#include \"problems/${id}.hpp\"
${headers}#include \"bench/make_static_runs.hpp\"
namespace odemark {
void static_${id}_${chunk_number}(std::vector<StaticRun>& runs);
void static_${id}_${chunk_number}(std::vector<StaticRun>& runs) { add_static_runs<${type}<double>, ${list}>(runs); }
}
")
          list(APPEND ODEMARK_STATIC_UNITS ${unit})
          string(APPEND static_declarations "void static_${id}_${chunk_number}(std::vector<StaticRun>& runs);\n")
          string(APPEND static_calls "    static_${id}_${chunk_number}(runs);\n")
          math(EXPR chunk_number "${chunk_number} + 1")
        endif()
        set(chunk "")
        set(filled 0)
      endif()
      if(NOT method STREQUAL "END")
        list(APPEND chunk ${method})
        math(EXPR filled "${filled} + 1")
      endif()
    endforeach()
  endif()
endforeach()
odemark_write_groups(ODEMARK_FAMILY_UNITS families "reference/make_family.hpp")
odemark_write_groups(ODEMARK_WIDE_UNITS wide "reference/make_wide_family.hpp")
odemark_write(${ODEMARK_GENERATED}/suite_families.cpp
"#include \"reference/any_problem.hpp\"
namespace odemark {
${declarations}
const std::vector<AnyFamily>& suite_families() {
  static const std::vector<AnyFamily> all = [] {
    std::vector<AnyFamily> families;
${calls}    return families;
  }();
  return all;
}
}
")
list(APPEND ODEMARK_FAMILY_UNITS ${ODEMARK_GENERATED}/suite_families.cpp)
odemark_write(${ODEMARK_GENERATED}/suite_wide_families.cpp
"#include \"reference/wide_problem.hpp\"
namespace odemark {
${wide_declarations}
const std::vector<WideFamily>& suite_wide_families() {
  static const std::vector<WideFamily> all = [] {
    std::vector<WideFamily> families;
${wide_calls}    return families;
  }();
  return all;
}
}
")
list(APPEND ODEMARK_WIDE_UNITS ${ODEMARK_GENERATED}/suite_wide_families.cpp)
if(ODEMARK_STATIC_TIER)
  foreach(method ${ODEMARK_STATIC_METHODS})
    foreach(family ${static_families_of_${method}})
      if(NOT family IN_LIST ODEMARK_STATIC_FAMILIES)
        message(FATAL_ERROR "integrators/catalogue.txt: ${method} is static=${family}, which problems/catalogue.txt does not mark static")
      endif()
    endforeach()
  endforeach()
endif()
set(headers "")
foreach(method ${ODEMARK_STATIC_METHODS})
  if(NOT static_families_of_${method})
    string(APPEND headers "#include \"integrators/methods/${file_of_${method}}.hpp\"\n")
  endif()
endforeach()
odemark_write(${ODEMARK_GENERATED}/include/bench/static_headers.hpp
"// What every unit of the static tier includes.
#pragma once
#include \"bench/make_static_runs.hpp\"
${headers}")
odemark_write(${ODEMARK_GENERATED}/suite_static_runs.cpp
"#include \"bench/static_run.hpp\"
namespace odemark {
${static_declarations}
const std::vector<StaticRun>& suite_static_runs() {
  static const std::vector<StaticRun> all = [] {
    std::vector<StaticRun> runs;
${static_calls}    return runs;
  }();
  return all;
}
const std::vector<StaticMark>& suite_static_marks() {
  static const std::vector<StaticMark> all = {
${static_marks}  };
  return all;
}
}
")
list(APPEND ODEMARK_STATIC_UNITS ${ODEMARK_GENERATED}/suite_static_runs.cpp)
