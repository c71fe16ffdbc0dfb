# What an outside project gets: find_package(odemark) and the targets odemark::*, with the headers that belong to each.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(exported)
foreach(name numbers integrators problems reference sundials gsl odeint bench reports main)
  if(TARGET odemark_${name})
    set_target_properties(odemark_${name} PROPERTIES EXPORT_NAME ${name})
    list(APPEND exported odemark_${name})
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
  # the command line and the adapters of third-party solvers are no interface
  list(FILTER headers EXCLUDE REGEX "/(bench/cli|reference/contestants)/")
  target_sources(odemark_${name} ${scope} FILE_SET HEADERS BASE_DIRS ${PROJECT_SOURCE_DIR} FILES ${headers})
  set_target_properties(odemark_${name} PROPERTIES VERIFY_INTERFACE_HEADER_SETS ${PROJECT_IS_TOP_LEVEL})
endfunction()
foreach(name integrators problems reference bench reports)
  odemark_headers(${name})
endforeach()
target_sources(odemark_integrators PUBLIC FILE_SET generated_headers TYPE HEADERS
  BASE_DIRS ${ODEMARK_GENERATED}/include FILES ${ODEMARK_GENERATED}/include/integrators/catalogue.hpp)

install(TARGETS ${exported} EXPORT odemarkTargets
  ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
  FILE_SET HEADERS DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/odemark
  FILE_SET generated_headers DESTINATION ${CMAKE_INSTALL_INCLUDEDIR}/odemark)
foreach(program odemark odemark_bench)
  if(TARGET ${program})
    install(TARGETS ${program} RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
  endif()
endforeach()

set(package ${CMAKE_INSTALL_LIBDIR}/cmake/odemark)
install(EXPORT odemarkTargets NAMESPACE odemark:: DESTINATION ${package})
foreach(contestant sundials gsl)  # Boost.odeint is headers only: nothing of it is left to find
  string(TOUPPER ${contestant} upper)
  set(ODEMARK_HAS_${upper} OFF)
  if(TARGET odemark_${contestant})
    set(ODEMARK_HAS_${upper} ON)
  endif()
endforeach()
configure_package_config_file(${CMAKE_CURRENT_LIST_DIR}/odemarkConfig.cmake.in
  ${PROJECT_BINARY_DIR}/odemarkConfig.cmake INSTALL_DESTINATION ${package})
write_basic_package_version_file(${PROJECT_BINARY_DIR}/odemarkConfigVersion.cmake COMPATIBILITY SameMajorVersion)
install(FILES ${PROJECT_BINARY_DIR}/odemarkConfig.cmake ${PROJECT_BINARY_DIR}/odemarkConfigVersion.cmake
  DESTINATION ${package})
install(FILES LICENSE THIRD_PARTY_NOTICES.md DESTINATION ${CMAKE_INSTALL_DOCDIR})
