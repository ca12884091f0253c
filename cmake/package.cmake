# What `find_package(stationary)` needs, beside the targets each directory installs.
include(CMakePackageConfigHelpers)

set(package_directory ${CMAKE_INSTALL_LIBDIR}/cmake/stationary)

configure_package_config_file(
  ${CMAKE_CURRENT_LIST_DIR}/stationaryConfig.cmake.in
  ${PROJECT_BINARY_DIR}/stationaryConfig.cmake
  INSTALL_DESTINATION ${package_directory})
# Before 1.0 a minor version may change the interface.
write_basic_package_version_file(
  ${PROJECT_BINARY_DIR}/stationaryConfigVersion.cmake
  COMPATIBILITY SameMinorVersion)

install(FILES
  ${PROJECT_BINARY_DIR}/stationaryConfig.cmake
  ${PROJECT_BINARY_DIR}/stationaryConfigVersion.cmake
  ${CMAKE_CURRENT_LIST_DIR}/findNLopt.cmake
  DESTINATION ${package_directory} COMPONENT development)
# One export set a library, so that the mechanics can be used without Ceres and NLopt.
foreach(library Mechanics Solver)
  install(EXPORT stationary${library}Targets NAMESPACE stationary::
    DESTINATION ${package_directory} COMPONENT development)
endforeach()
# Debian's packages have it in their file `copyright`.
install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR} COMPONENT license)
