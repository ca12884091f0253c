# cmake -D build=... -D config=... -D cpack=... -D work=... -D version=... -P run.cmake
#
# Makes the two Debian packages of this build, looks what is in them, asks lintian, and installs, runs and
# removes them in an empty file system of their own.
file(REMOVE_RECURSE ${work})
file(MAKE_DIRECTORY ${work})

# Standard output of a command that must succeed.
function(step out)
  execute_process(COMMAND ${ARGN} COMMAND_ECHO STDOUT OUTPUT_VARIABLE text COMMAND_ERROR_IS_FATAL ANY)
  set(${out} "${text}" PARENT_SCOPE)
endfunction()
function(require text pattern)
  if(NOT text MATCHES "${pattern}")
    message(FATAL_ERROR "expected ${pattern} in\n${text}")
  endif()
endfunction()
function(refuse text pattern)
  if(text MATCHES "${pattern}")
    message(FATAL_ERROR "found ${CMAKE_MATCH_0} in\n${text}")
  endif()
endfunction()

execute_process(COMMAND ${cpack} -G DEB -C ${config} -B ${work}/made --config ${build}/CPackConfig.cmake
  WORKING_DIRECTORY ${build} COMMAND_ERROR_IS_FATAL ANY)
file(GLOB program ${work}/made/stationary_${version}-1_*.deb)
file(GLOB development ${work}/made/libstationary-dev_${version}-1_*.deb)
foreach(package IN ITEMS "${program}" "${development}")
  if(NOT EXISTS "${package}")
    message(FATAL_ERROR "a package is missing in ${work}/made")
  endif()
endforeach()

step(files dpkg-deb --contents ${program})
foreach(file bin/stationary share/man/man1/stationary.1.gz share/bash-completion/completions/stationary
    share/zsh/vendor-completions/_stationary share/stationary/metadata.schema.json
    share/doc/stationary/copyright share/doc/stationary/changelog.gz
    share/doc/stationary/changelog.Debian.gz share/doc/stationary/examples/disc.toml)
  require("${files}" "\\./usr/${file}\n")
endforeach()
refuse("${files}" "[^\n]*\\.(hpp|a|cmake)\n")
step(control dpkg-deb --info ${program})
if(hdf5)
  require("${control}" "Depends: [^\n]*libhdf5")
endif()
require("${control}" "Recommends: gnuplot-nox")

step(files dpkg-deb --contents ${development})
foreach(file libstationary_mechanics.a libstationary_solver.a cmake/stationary/stationaryConfig.cmake
    cmake/stationary/stationaryMechanicsTargets.cmake cmake/stationary/stationarySolverTargets.cmake)
  require("${files}" "\\./usr/lib/([^/\n]*/)?${file}\n")
endforeach()
foreach(file include/stationary/solver/solve/solve.hpp include/stationary/lib/body/body.hpp
    share/doc/libstationary-dev/copyright share/doc/libstationary-dev/changelog.Debian.gz)
  require("${files}" "\\./usr/${file}\n")
endforeach()
refuse("${files}" "\\./usr/bin/[^\n]+\n")
step(control dpkg-deb --info ${development})
require("${control}" "Depends: [^\n]*libeigen3-dev")

find_program(lintian lintian)
if(lintian)
  step(remarks ${lintian} --allow-root --tag-display-limit 0 --fail-on error ${program} ${development})
  message(STATUS "lintian finds no error\n${remarks}")
else()
  message("lintian is not there: what it would say of the packages is not tested (Debian: lintian)")
endif()

# A file system in which nothing is but dpkg's own lists; what the packages depend on is outside.
set(root ${work}/root)
file(MAKE_DIRECTORY ${root}/var/lib/dpkg/info ${root}/var/lib/dpkg/updates)
file(TOUCH ${root}/var/lib/dpkg/status)
set(dpkg dpkg --root=${root} --log=${work}/dpkg.log --force-not-root --force-depends --force-bad-path)
step(ignored ${dpkg} --install ${program} ${development})
step(listed ${dpkg} --list)
require("${listed}" "ii +libstationary-dev")
require("${listed}" "ii +stationary ")
step(said ${root}/usr/bin/stationary --version)
require("${said}" "${version}")
step(said ${root}/usr/bin/stationary solve ${root}/usr/share/doc/stationary/examples/disc.toml)
require("${said}" "spectrum +unstable")
file(WRITE ${work}/use/CMakeLists.txt
  "cmake_minimum_required(VERSION 3.25)\nproject(use LANGUAGES CXX)\n"
  "find_package(stationary ${version} REQUIRED COMPONENTS mechanics solver)\n")
step(ignored ${CMAKE_COMMAND} -S ${work}/use -B ${work}/use/build -D CMAKE_PREFIX_PATH=${root}/usr)
file(STRINGS ${work}/use/build/CMakeCache.txt found REGEX "^stationary_DIR:")
require("${found}" "${root}/usr/lib")

step(ignored ${dpkg} --purge libstationary-dev stationary)
file(GLOB_RECURSE left LIST_DIRECTORIES false ${root}/usr/*)
if(left)
  message(FATAL_ERROR "left behind: ${left}")
endif()
