# Two Debian packages by CPack: the program, and the libraries with their headers. `deb` is the target;
# the tools are Debian's dpkg-dev (dpkg-deb, dpkg-shlibdeps), scdoc and gzip.
find_program(STATIONARY_DPKG_DEB dpkg-deb)
find_program(STATIONARY_DPKG_SHLIBDEPS dpkg-shlibdeps)
mark_as_advanced(STATIONARY_DPKG_DEB STATIONARY_DPKG_SHLIBDEPS)
if(NOT (TARGET stationary AND TARGET manual AND STATIONARY_DPKG_DEB AND STATIONARY_DPKG_SHLIBDEPS AND STATIONARY_GZIP))
  return()
endif()

# Who makes a package answers for it, as with Debian's own tools. Nobody reads what is sent to example.org.
if(DEFINED ENV{DEBFULLNAME} AND DEFINED ENV{DEBEMAIL})
  set(maintainer "$ENV{DEBFULLNAME} <$ENV{DEBEMAIL}>")
else()
  set(maintainer "The stationary authors <stationary@example.org>")
endif()
set(STATIONARY_MAINTAINER ${maintainer} CACHE STRING "Maintainer of the Debian packages: NAME <ADDRESS>")
string(TIMESTAMP changed "%a, %d %b %Y %H:%M:%S +0000" UTC)  # or SOURCE_DATE_EPOCH

set(debian ${PROJECT_BINARY_DIR}/debian)
configure_file(${CMAKE_CURRENT_LIST_DIR}/debian/changelog.in ${debian}/changelog.Debian @ONLY)
configure_file(${PROJECT_SOURCE_DIR}/CHANGELOG.md ${debian}/changelog COPYONLY)
foreach(file changelog.Debian changelog)
  add_custom_command(OUTPUT ${debian}/${file}.gz
    COMMAND ${STATIONARY_GZIP} -9nkf ${debian}/${file} DEPENDS ${debian}/${file} VERBATIM)
endforeach()
add_custom_target(debian_files ALL DEPENDS ${debian}/changelog.Debian.gz ${debian}/changelog.gz)

# Only packages have these: an ordinary install asks for no gzip.
foreach(package stationary libstationary-dev)
  set(component program)
  if(package STREQUAL libstationary-dev)
    set(component development)
  endif()
  install(FILES ${CMAKE_CURRENT_LIST_DIR}/debian/copyright ${debian}/changelog.Debian.gz ${debian}/changelog.gz
    DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${package} COMPONENT ${component} EXCLUDE_FROM_ALL)
endforeach()

set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "")  # each package's description begins with its own
set(CPACK_PACKAGE_VENDOR "The stationary authors")
set(CPACK_PACKAGE_CONTACT ${STATIONARY_MAINTAINER})
set(CPACK_VERBATIM_VARIABLES ON)
set(CPACK_STRIP_FILES ON)
set(CPACK_COMPONENTS_ALL program development)
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)

set(CPACK_DEBIAN_PROGRAM_PACKAGE_NAME stationary)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SECTION science)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_RECOMMENDS gnuplot-nox)
set(CPACK_DEBIAN_PROGRAM_PACKAGE_SUGGESTS libstationary-dev)
set(CPACK_COMPONENT_PROGRAM_DESCRIPTION "relative equilibria of affinely-rigid bodies and their stability
Finds the stationary ellipsoids (relative equilibria) of a body that deforms
homogeneously under the Kirchhoff-Love constraints, for a given inertia,
potential and spin, with error bounds; follows them, locates bifurcations,
and decides their stability.")

set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_NAME libstationary-dev)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
# What stationaryConfig.cmake looks for.
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS
  "libeigen3-dev (>= 3.4), libceres-dev, libnlopt-dev, libnlopt-cxx-dev, libboost-dev (>= 1.74), libtbb-dev")
set(CPACK_COMPONENT_DEVELOPMENT_DESCRIPTION "relative equilibria of affinely-rigid bodies - C++ library
Headers, static libraries and CMake package of the solver that the program
stationary is made of: find_package(stationary), targets
stationary::mechanics (Eigen only) and stationary::solver.")
include(CPack)

add_custom_target(deb
  COMMAND ${CMAKE_CPACK_COMMAND} -G DEB -C $<CONFIG> -B ${PROJECT_BINARY_DIR}/packages
  WORKING_DIRECTORY ${PROJECT_BINARY_DIR}
  DEPENDS stationary manual debian_files
  COMMENT "Debian packages: ${PROJECT_BINARY_DIR}/packages"
  VERBATIM USES_TERMINAL)
