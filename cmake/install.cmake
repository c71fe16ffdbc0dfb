# What an outside project gets: find_package(odemark) and the targets odemark::*, with the headers that belong to each.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(libraries)
set(programs)
get_property(targets DIRECTORY PROPERTY BUILDSYSTEM_TARGETS)
foreach(target ${targets})
  get_target_property(type ${target} TYPE)
  get_target_property(is_tool ${target} EXCLUDE_FROM_ALL)
  if(type STREQUAL "EXECUTABLE" AND NOT is_tool)
    list(APPEND programs ${target})
  elseif(type MATCHES "LIBRARY" AND NOT type STREQUAL "OBJECT_LIBRARY" AND NOT target STREQUAL "odemark_warnings")  # ours to heed, nobody else's
    list(APPEND libraries ${target})
    string(REGEX REPLACE "^odemark_" "" name ${target})
    set_target_properties(${target} PROPERTIES EXPORT_NAME ${name})
  endif()
endforeach()

# A header belongs to the library of its folder. `--target all_verify_interface_header_sets` compiles each on its own.
function(odemark_headers name)
  get_target_property(type odemark_${name} TYPE)
  set(scope PUBLIC)
  if(type STREQUAL "INTERFACE_LIBRARY")
    set(scope INTERFACE)
  endif()
  file(GLOB_RECURSE headers CONFIGURE_DEPENDS ${PROJECT_SOURCE_DIR}/${name}/*.hpp)
  # programs and the adapters of third-party solvers are no interface
  list(FILTER headers EXCLUDE REGEX "/(bench/cli|bench/step_cost|reference/contestants)/")
  target_sources(odemark_${name} ${scope} FILE_SET HEADERS BASE_DIRS ${PROJECT_SOURCE_DIR} FILES ${headers})
  set_target_properties(odemark_${name} PROPERTIES VERIFY_INTERFACE_HEADER_SETS ${PROJECT_IS_TOP_LEVEL})
endfunction()
foreach(name integrators problems reference bench reports)
  odemark_headers(${name})
endforeach()
target_sources(odemark_integrators PUBLIC FILE_SET generated_headers TYPE HEADERS
  BASE_DIRS ${ODEMARK_GENERATED}/include FILES ${ODEMARK_GENERATED}/include/integrators/catalogue.hpp)
if(TARGET odemark_main)  # of the command line, only the one function that its users define
  target_sources(odemark_main PUBLIC FILE_SET HEADERS BASE_DIRS ${PROJECT_SOURCE_DIR}
    FILES ${PROJECT_SOURCE_DIR}/bench/cli/user.hpp)
endif()

install(TARGETS ${libraries} EXPORT odemarkTargets
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
  FILE_SET HEADERS DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/odemark
  FILE_SET generated_headers DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/odemark)
install(TARGETS ${programs} RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})

set(package ${CMAKE_INSTALL_LIBDIR}/cmake/odemark)
install(EXPORT odemarkTargets NAMESPACE odemark:: DESTINATION ${package})
foreach(optional sundials gsl step_cost)  # Boost.odeint is headers only: nothing of it is left to find
  string(TOUPPER ${optional} upper)
  set(ODEMARK_HAS_${upper} OFF)
  if(TARGET odemark_${optional})
    set(ODEMARK_HAS_${upper} ON)
  endif()
endforeach()
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/odemarkConfig.cmake.in
  ${PROJECT_BINARY_DIR}/odemarkConfig.cmake INSTALL_DESTINATION ${package})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/odemarkConfigVersion.cmake COMPATIBILITY SameMajorVersion)
install(FILES ${PROJECT_BINARY_DIR}/odemarkConfig.cmake ${PROJECT_BINARY_DIR}/odemarkConfigVersion.cmake
  DESTINATION ${package})
install(FILES LICENSE THIRD_PARTY_NOTICES.md DESTINATION ${CMAKE_INSTALL_DOCDIR})
