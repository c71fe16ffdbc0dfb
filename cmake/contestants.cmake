# One library per provider found; what links odemark::contestants sees which they are. A provider that is off or
# missing is skipped: nobody must need all of them.
function(odemark_provider name)
  cmake_parse_arguments(arg "" "" "SOURCES;LINK" ${ARGN})
  odemark_library(${name} SOURCES ${arg_SOURCES} LINK odemark::integrators ${arg_LINK})
  string(TOUPPER ${name} upper)
  target_compile_definitions(odemark_${name} PUBLIC ODEMARK_HAS_${upper}=1)
  set(ODEMARK_PROVIDERS ${ODEMARK_PROVIDERS} odemark::${name} PARENT_SCOPE)
endfunction()

function(odemark_sources out)
  list(TRANSFORM ARGN PREPEND reference/contestants/)
  list(TRANSFORM ARGN APPEND .cpp)
  set(${out} ${ARGN} PARENT_SCOPE)
endfunction()

set(ODEMARK_PROVIDERS)
if(ODEMARK_WITH_SUNDIALS)
  find_package(SUNDIALS 6.0 QUIET COMPONENTS cvode arkode nvecserial sunmatrixdense sunmatrixband sunlinsoldense
    sunlinsolband sunnonlinsolfixedpoint)
  if(SUNDIALS_FOUND)
    odemark_sources(sources sundials_arkode sundials_checks sundials_cvode sundials_methods)
    set(sundials_core SUNDIALS::generic)
    if(TARGET SUNDIALS::core)  # its name since 7.0
      set(sundials_core SUNDIALS::core)
    endif()
    odemark_provider(sundials SOURCES ${sources} LINK SUNDIALS::cvode SUNDIALS::arkode SUNDIALS::nvecserial
      SUNDIALS::sunmatrixdense SUNDIALS::sunmatrixband SUNDIALS::sunlinsoldense SUNDIALS::sunlinsolband
      SUNDIALS::sunnonlinsolfixedpoint ${sundials_core})
    if(SUNDIALS_VERSION VERSION_GREATER_EQUAL 7)  # ARKStepX became a deprecated name of ARKodeX
      target_compile_options(odemark_sundials PRIVATE -Wno-deprecated-declarations)
    endif()
  else()
    message(STATUS "odemark: no SUNDIALS, CVODE and ARKODE will not compete (libsundials-dev, or set SUNDIALS_DIR)")
  endif()
endif()

if(ODEMARK_WITH_GSL)
  find_package(GSL 2.0 QUIET)
  if(GSL_FOUND)
    odemark_sources(sources gsl_methods gsl_run)
    odemark_provider(gsl SOURCES ${sources} LINK GSL::gsl)
  else()
    message(STATUS "odemark: no GSL, its odeiv2 will not compete (libgsl-dev)")
  endif()
endif()

if(ODEMARK_WITH_ODEINT)
  if(EXISTS ${Boost_INCLUDE_DIRS}/boost/numeric/odeint.hpp)
    odemark_sources(sources odeint_bulirsch_stoer odeint_checks odeint_explicit odeint_inlined odeint_rosenbrock
      odeint_rosenbrock_stepper odeint_velocity_verlet)
    odemark_provider(odeint SOURCES ${sources} LINK Boost::headers)
    # without NDEBUG uBLAS checks every solve again; uBLAS up to Boost 1.74 does not compile as C++20
    target_compile_definitions(odemark_odeint PRIVATE NDEBUG BOOST_UBLAS_NDEBUG)
    # GCC 12 sees the work arrays of a copied stepper and does not see that each is written before it is read
    set_source_files_properties(reference/contestants/odeint_inlined.cpp PROPERTIES
      COMPILE_OPTIONS $<$<CXX_COMPILER_ID:GNU>:-Wno-maybe-uninitialized>)
    set_source_files_properties(reference/contestants/odeint_rosenbrock_stepper.cpp PROPERTIES
      COMPILE_OPTIONS -std=c++17)
  else()
    message(STATUS "odemark: no Boost.odeint, it will not compete (libboost-dev)")
  endif()
endif()

odemark_sources(sources contestants)
odemark_library(contestants SOURCES ${sources} LINK ${ODEMARK_PROVIDERS})
list(APPEND ODEMARK_CONTESTANTS odemark::contestants)
