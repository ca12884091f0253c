#!/usr/bin/env bash
# On a bare Debian 12: installs what is missing, builds, and runs or tests. See usage below.
set -euo pipefail

usage() {
  cat >&2 <<'TEXT'
usage: ./bootstrap.sh run     set up, build, solve cases/fold.toml and follow it into results/
       ./bootstrap.sh test    set up, build and pass the tests, in release and under the sanitizers: the Python module's,
                              the ranks' and, in a browser, those of the page and of the solver it carries, too
       ./bootstrap.sh all     as test, then the documentation, the Debian packages, and the Python module for the system
Set-up installs Debian packages that are missing, as root or through sudo; it asks nothing.
TEXT
  exit 2
}

[[ $# -eq 1 ]] || usage
case $1 in
  run | test | all) verb=$1 ;;
  *) usage ;;
esac

cd "$(dirname "${BASH_SOURCE[0]}")"

# libatlas-base-dev comes with libceres-dev; Ceres' package file asks for its BLAS and LAPACK.
# Clang compiles all of it in half of GCC's time, to a program that is no slower.
packages=(
  g++ clang cmake ninja-build
  libeigen3-dev libceres-dev libnlopt-dev libnlopt-cxx-dev libtbb-dev libhdf5-dev zlib1g-dev
  libcli11-dev libfmt-dev libtomlplusplus-dev nlohmann-json3-dev tao-pegtl-dev
  libboost-dev gnuplot-nox scdoc
)
test_packages=(libgtest-dev libgmock-dev libbenchmark-dev libcminpack-dev libclang-rt-14-dev lld)
# The Python module, what its results turn into, and what tests it.
python_packages=(
  python3-dev pybind11-dev python3-numpy python3-pandas python3-xarray python3-matplotlib
  python3-sympy python3-pip python3-venv python3-setuptools python3-wheel python3-pytest mypy
)
# Ranks of MPI, for the program stationary-mpi and its tests.
mpi_packages=(libopenmpi-dev openmpi-bin)
# The solver that a page of `explore` carries, and a browser for the page.
page_packages=(
  clang-19 lld-19 libc++-19-dev-wasm32 libc++abi-19-dev-wasm32 libclang-rt-19-dev-wasm32 wasi-libc binaryen zopfli
  chromium
)
# Node of another origin brings its npm, and Debian's npm is not installed beside it.
command -v npm >/dev/null || page_packages+=(nodejs npm)
[[ $verb == run ]] ||
  packages+=("${test_packages[@]}" "${python_packages[@]}" "${mpi_packages[@]}" "${page_packages[@]}")
# The documentation, and Debian packages with what looks them over.
all_packages=(python3-sphinx python3-myst-parser libjs-mathjax dpkg-dev lintian)
[[ $verb != all ]] || packages+=("${all_packages[@]}")

stage=
stage_begin=0
# Ends the stage before, if there was one, with its time.
end_stage() {
  [[ -z $stage ]] ||
    printf '== %s: %d min %02d s\n' "$stage" $(((SECONDS - stage_begin) / 60)) $(((SECONDS - stage_begin) % 60))
  stage=
}
say() {
  end_stage
  stage=$*
  stage_begin=$SECONDS
  printf '\n== %s\n' "$stage"
}

set_up() {
  local package missing=()
  for package in "${packages[@]}"; do
    [[ $(dpkg-query -W -f='${db:Status-Status}' "$package" 2>/dev/null) == installed ]] ||
      missing+=("$package")
  done
  [[ ${#missing[@]} -gt 0 ]] || return 0

  local as_root=()
  if [[ $(id -u) -ne 0 ]]; then
    if ! command -v sudo >/dev/null; then
      echo "bootstrap.sh: not root and no sudo; to be installed: ${missing[*]}" >&2
      exit 1
    fi
    as_root=(sudo)
  fi
  say "installing ${missing[*]}"
  local apt=(env DEBIAN_FRONTEND=noninteractive apt-get -o Acquire::Retries=3 -q)
  "${as_root[@]}" "${apt[@]}" update
  "${as_root[@]}" "${apt[@]}" install --yes --no-install-recommends "${missing[@]}" </dev/null
}

# One compiler a processor, but no more than memory holds: templates of Eigen and Ceres under
# -O3 or the sanitizers take up to about 1.5 GB each.
compile_jobs() {
  local count bytes limit
  count=$(nproc)
  bytes=$(awk '/^MemAvailable:/ { printf "%.0f", $2 * 1024 }' /proc/meminfo)
  if limit=$(cat /sys/fs/cgroup/memory.max 2>/dev/null) && [[ $limit =~ ^[0-9]+$ ]] &&
    ((limit < bytes)); then
    bytes=$limit
  fi
  local fit=$((bytes / 1500000000))
  ((fit >= 1)) || fit=1
  echo $((fit < count ? fit : count))
}

build() { # preset target [cmake option ...]
  local preset=$1 target=$2
  shift 2
  say "building ($preset)"
  # From nothing: many sources at once.
  cmake --preset "$preset" -D CMAKE_CXX_COMPILER=clang++ -D STATIONARY_BUILD_BENCHMARKS=OFF \
    -D STATIONARY_UNITY_BUILD=ON "$@"
  cmake --build --preset "$preset" --parallel "$(compile_jobs)" --target "$target"
}

run_tests() { # preset [ctest option ...]
  local preset=$1
  shift
  say "testing ($preset)"
  ctest --preset "$preset" --parallel "$(compile_jobs)" "$@"
}

if [[ $verb == run ]]; then
  echo "Installs missing Debian packages, builds the program and runs a first case: about 5 minutes on two cores."
else
  echo "Installs missing Debian packages, builds everything in release and under the sanitizers, and runs the tests, some in a browser: 40 to 70 minutes on two cores, by the machine."
fi
set_up
if [[ $verb == run ]]; then
  build release stationary -D STATIONARY_BUILD_TESTS=OFF
  program=build/release/solver/cli/stationary
  say "stationary solve cases/fold.toml"
  "$program" solve cases/fold.toml
  say "stationary continue cases/fold.toml -o results/fold.csv"
  "$program" continue cases/fold.toml -o results/fold.csv
  say "stationary plot results/fold.csv -o results/fold.svg"
  "$program" plot results/fold.csv -o results/fold.svg
  end_stage
  printf '\nOpen results/fold.svg: the stretches and the spectrum against nu. docs/tutorial.md goes on from here.\n'
else
  build release all -D STATIONARY_BUILD_TESTS=ON -D STATIONARY_PYTHON=ON -D STATIONARY_WASM=ON
  run_tests release
  # What the sanitizers are to look at are the libraries and the programs; the tests' objects are those of the release.
  build sanitize all -D STATIONARY_TEST_OBJECTS=build/release
  # The page in a browser, the installed library, the order of the sources and how the C library rounds are not what
  # the sanitizers look at.
  run_tests sanitize --exclude-regex '^(browser\.|consumer$|rooms|same_bits$)'
fi
if [[ $verb == all ]]; then
  say "documentation and Debian packages"
  cmake --build --preset release --target docs deb
  say "the Python module, into /usr/local"
  install_module=(cmake --install build/release --prefix /usr/local --component python)
  if [[ $(id -u) -eq 0 ]]; then "${install_module[@]}"; else sudo "${install_module[@]}"; fi
  /usr/bin/python3 -c 'import stationary; print(stationary.solve("cases/fold.toml"))'
fi
end_stage
