# Debian ships two packages that both answer to the name NLopt, with different targets
# (NLopt::nlopt and NLopt::nlopt_cxx). Sorted by directory name the former is taken, always.
set(CMAKE_FIND_PACKAGE_SORT_ORDER NAME)
set(CMAKE_FIND_PACKAGE_SORT_DIRECTION ASC)
find_package(NLopt CONFIG QUIET)
unset(CMAKE_FIND_PACKAGE_SORT_ORDER)
unset(CMAKE_FIND_PACKAGE_SORT_DIRECTION)
