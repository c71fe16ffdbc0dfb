# Who may include whom. Run: cmake -P tools/check_layers.cmake, or with -DROOT=<another tree>
cmake_minimum_required(VERSION 3.25)
if(NOT ROOT)
  get_filename_component(ROOT ${CMAKE_CURRENT_LIST_DIR}/.. ABSOLUTE)
endif()

# One rule set per folder, the longest matching folder wins. OWN: regexes of what may be included in quotes;
# SYSTEM: regexes of what may be included in angle brackets beyond the standard library. .cpp files are less strict
# where CPP_SYSTEM says so: what stays in a .cpp costs nobody else anything.
set(layers integrators problems reference reference/contestants bench bench/data bench/step_cost bench/cli reports)
set(standard "^[a-z_]+$")

set(integrators_OWN "^integrators/")
# heavy algebra is compiled once; orders of fractions are proved in integers of any length
set(integrators_CPP_SYSTEM "^Eigen/" "^boost/multiprecision/")

set(problems_OWN "^problems/")  # mathematics: a problem satisfies the integrators' concepts without naming them

set(reference_OWN "^(reference|problems|integrators)/")
set(reference_CPP_SYSTEM "^fmt/" "^nlohmann/" "^boost/multiprecision/")

set(reference/contestants_OWN ${reference_OWN})
set(reference/contestants_SYSTEM
  "^gsl/" "^(sundials|cvode|cvodes|arkode|nvector|sunmatrix|sunlinsol|sunnonlinsol)/" "^boost/numeric/odeint" "^boost/version.hpp")
set(reference/contestants_CPP_SYSTEM ${reference/contestants_SYSTEM} "^fmt/")

set(bench_OWN "^(bench|reference|problems|integrators)/")
set(bench_NEVER "^bench/(cli|step_cost)/" "^reference/([a-z_]*wide|contestants/)")
set(bench_CPP_SYSTEM "^fmt/" "^nlohmann/" "^toml\\+\\+/" "^(sys/[a-z]+|unistd|sched)\\.h$")

set(bench/data_OWN "^bench/data/")  # plain data: all that reports may see of a bench

set(bench/step_cost_OWN ${bench_OWN})
set(bench/step_cost_SYSTEM "^benchmark/")
set(bench/step_cost_CPP_SYSTEM ${bench_CPP_SYSTEM})

set(bench/cli_OWN "^(bench|reports|reference|problems|integrators)/")
set(bench/cli_SYSTEM ".")

set(reports_OWN "^(reports|bench/data)/")
set(reports_CPP_SYSTEM "^fmt/" "^nlohmann/" "^toml\\+\\+/")

# What takes seconds to compile may enter those headers that are named for it, beside .cpp files.
set(named_for "wide|^boost/multiprecision/" "json|^nlohmann/" "toml|^toml\\+\\+/")

function(matches text regexes result)
  set(${result} FALSE PARENT_SCOPE)
  foreach(regex IN LISTS regexes)
    if(text MATCHES "${regex}")
      set(${result} TRUE PARENT_SCOPE)
      return()
    endif()
  endforeach()
endfunction()

set(violations 0)
set(looked_at 0)
foreach(layer ${layers})
  file(GLOB_RECURSE files RELATIVE ${ROOT} ${ROOT}/${layer}/*.hpp ${ROOT}/${layer}/*.cpp)
  foreach(other ${layers})
    if(other MATCHES "^${layer}/")
      list(FILTER files EXCLUDE REGEX "^${other}/")
    endif()
  endforeach()
  foreach(file ${files})
    math(EXPR looked_at "${looked_at} + 1")
    set(system ${standard} ${${layer}_SYSTEM})
    if(file MATCHES "\\.cpp$")
      list(APPEND system ${${layer}_CPP_SYSTEM})
    else()
      foreach(pair ${named_for})
        string(REGEX REPLACE "\\|.*" "" word ${pair})
        string(REGEX REPLACE "^[a-z]+\\|" "" library ${pair})
        if(file MATCHES "(/|_)${word}[a-z_]*\\.hpp$" AND library IN_LIST ${layer}_CPP_SYSTEM)
          list(APPEND system ${library})
        endif()
      endforeach()
    endif()
    file(STRINGS ${ROOT}/${file} lines REGEX "^[ \t]*#[ \t]*include")
    foreach(line IN LISTS lines)
      if(line MATCHES "\"([^\"]+)\"")
        set(target ${CMAKE_MATCH_1})
        matches(${target} "${${layer}_OWN}" allowed)
        matches(${target} "${${layer}_NEVER}" forbidden)
        if(NOT allowed OR forbidden)
          message(SEND_ERROR "${file}: ${layer}/ may not include \"${target}\"")
          math(EXPR violations "${violations} + 1")
        elseif(NOT EXISTS ${ROOT}/${target} AND NOT target STREQUAL "integrators/catalogue.hpp")  # that one is generated
          message(SEND_ERROR "${file}: there is no ${target}")
          math(EXPR violations "${violations} + 1")
        endif()
      elseif(line MATCHES "<([^>]+)>")
        set(target ${CMAKE_MATCH_1})
        matches(${target} "${system}" allowed)
        if(NOT allowed)
          message(SEND_ERROR "${file}: <${target}> is not for this place in ${layer}/")
          math(EXPR violations "${violations} + 1")
        endif()
      else()
        message(SEND_ERROR "${file}: cannot read ${line}")
        math(EXPR violations "${violations} + 1")
      endif()
    endforeach()
  endforeach()
endforeach()
if(looked_at EQUAL 0)
  message(FATAL_ERROR "no sources under ${ROOT}")
endif()
message(STATUS "layers: ${looked_at} files, ${violations} violations")
