# Debian's cross compiler for aarch64 (g++-aarch64-linux-gnu), and qemu-user that runs what it makes.
# The libraries are those that aarch64_root.sh has unpacked below STATIONARY_AARCH64_ROOT.
set(CMAKE_SYSTEM_NAME Linux)
set(CMAKE_SYSTEM_PROCESSOR aarch64)
set(CMAKE_C_COMPILER aarch64-linux-gnu-gcc)
set(CMAKE_CXX_COMPILER aarch64-linux-gnu-g++)
set(CMAKE_CXX_FLAGS_INIT -Wno-psabi) # GCC's notes on how C++14 would have passed pairs of doubles

cmake_path(SET root NORMALIZE "${CMAKE_CURRENT_LIST_DIR}/../build/aarch64_root")
set(STATIONARY_AARCH64_ROOT "${root}" CACHE PATH "Where aarch64_root.sh has unpacked arm64's libraries")
list(APPEND CMAKE_TRY_COMPILE_PLATFORM_VARIABLES STATIONARY_AARCH64_ROOT)
if(NOT IS_DIRECTORY "${STATIONARY_AARCH64_ROOT}/usr/include")
  message(FATAL_ERROR "No libraries of arm64: run cmake/aarch64_root.sh ${STATIONARY_AARCH64_ROOT}")
endif()

# Libraries and headers from there alone, so that none of this machine's is taken for one; programs
# that the build runs from this machine.
set(CMAKE_FIND_ROOT_PATH "${STATIONARY_AARCH64_ROOT}")
set(CMAKE_FIND_ROOT_PATH_MODE_PROGRAM NEVER)
set(CMAKE_FIND_ROOT_PATH_MODE_LIBRARY ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_INCLUDE ONLY)
set(CMAKE_FIND_ROOT_PATH_MODE_PACKAGE ONLY)
# Others' libraries need each other, and the linker looks for those beside the C library's.
add_link_options("LINKER:-rpath-link,${STATIONARY_AARCH64_ROOT}/usr/lib/aarch64-linux-gnu")
set(CMAKE_CROSSCOMPILING_EMULATOR qemu-aarch64-static -L "${STATIONARY_AARCH64_ROOT}")
