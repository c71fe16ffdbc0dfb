# What a builder may choose, and the flags that belong to targets because they change numbers.
option(ODEMARK_WITH_SUNDIALS "CVODE and ARKODE as contestants" ON)
option(ODEMARK_WITH_GSL "GSL's odeiv2 as contestants (GPL-3: affects the licence of the binary)" ON)
option(ODEMARK_WITH_ODEINT "Boost.odeint as contestants" ON)
option(ODEMARK_NATIVE "Peak speed: -march=native with contraction; rows say so and are never compared bit for bit" OFF)
option(ODEMARK_STATIC_TIER "Compile the methods marked static into the steps of the families marked static" ON)
option(ODEMARK_PCH "Precompile the headers that most files share" ON)
option(ODEMARK_UNITY "Compile files that gain nothing from -O3 sixteen at a time: OFF rebuilds less after an edit" ON)
option(ODEMARK_WERROR "Treat warnings as errors" ${PROJECT_IS_TOP_LEVEL})

# Repeated builds in a tenth of the time, where ccache is installed. A build folder asks once: ./test.sh after ./run.sh on a new
# machine installs it, and another launcher would build everything again.
if(PROJECT_IS_TOP_LEVEL AND NOT CMAKE_CXX_COMPILER_LAUNCHER)
  if(NOT DEFINED CACHE{ODEMARK_CCACHE})
    find_program(ODEMARK_CCACHE ccache)
  endif()
  if(ODEMARK_CCACHE)
    set(CMAKE_CXX_COMPILER_LAUNCHER ${CMAKE_COMMAND} -E env CCACHE_SLOPPINESS=pch_defines,time_macros ${ODEMARK_CCACHE})
  endif()
endif()

# two thirds of the linking time of GNU ld (0.5 s against 0.7 s for a test), and part of the same package
include(CheckLinkerFlag)
check_linker_flag(CXX -fuse-ld=gold ODEMARK_HAS_GOLD)
if(PROJECT_IS_TOP_LEVEL AND ODEMARK_HAS_GOLD AND CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
  add_link_options(-fuse-ld=gold)
endif()

find_package(Eigen3 3.4 REQUIRED)
find_package(Boost 1.74 REQUIRED)
find_package(fmt REQUIRED)
find_package(Threads REQUIRED)

# Contraction and Eigen's fast math would make results differ between -O levels, compilers and batch widths.
add_library(odemark_numbers INTERFACE)
add_library(odemark::numbers ALIAS odemark_numbers)
set_target_properties(odemark_numbers PROPERTIES EXPORT_NAME numbers)
target_compile_features(odemark_numbers INTERFACE cxx_std_20)
target_compile_definitions(odemark_numbers INTERFACE EIGEN_FAST_MATH=0)
# GCC 12 and clang 14 pack the two or three components of a small state into vectors and pay for it in every stage (rk4
# on lorenz63: 24.5 ns against 20.8 with GCC, 18.0 against 15.3 with clang); loops over lanes and large states are
# vectorised all the same. No number changes.
target_compile_options(odemark_numbers INTERFACE $<$<CXX_COMPILER_ID:GNU>:-fno-tree-slp-vectorize>
  $<$<CXX_COMPILER_ID:Clang,AppleClang>:-fno-slp-vectorize>)
# orders are proved at compile time: a sum over some hundred trees, each a product over all stages
target_compile_options(odemark_numbers INTERFACE $<$<CXX_COMPILER_ID:Clang,AppleClang>:-fconstexpr-steps=100000000>)
if(ODEMARK_NATIVE)
  target_compile_options(odemark_numbers INTERFACE -march=native -ffp-contract=fast)
else()
  target_compile_options(odemark_numbers INTERFACE -ffp-contract=off)
endif()

add_library(odemark_warnings INTERFACE)
target_compile_options(odemark_warnings INTERFACE -Wall -Wextra -Wpedantic -Wconversion
  $<$<CXX_COMPILER_ID:GNU>:-Wdouble-promotion>  # of float; clang also warns of double to long double
  -Wshadow
  $<$<CXX_COMPILER_ID:GNU>:-Wno-restrict>)  # false alarms on std::string in GCC 12 (its PR 105651)
if(ODEMARK_WERROR)
  target_compile_options(odemark_warnings INTERFACE -Werror)
endif()
