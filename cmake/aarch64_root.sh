#!/bin/sh
# aarch64_root.sh DIRECTORY
#
# Unpacks below DIRECTORY what Debian's arm64 has of the libraries that a build needs, for
# aarch64-linux-gnu.cmake. With apt's lists of its own: neither root nor `dpkg --add-architecture` is
# needed, and nothing is installed.
set -eu
root=$1
mkdir -p "$root/packages/lists/partial"
root=$(cd "$root" && pwd)
cd "$root/packages"
touch status # as if nothing were installed
from_arm64() {
  apt-get -q -o APT::Architecture=arm64 -o APT::Architectures=arm64 -o Dir::State::Lists="$PWD/lists" \
    -o Dir::State::Status="$PWD/status" -o Dir::Cache="$PWD" -o APT::Sandbox::User= "$@"
}
from_arm64 update
from_arm64 download libc6 libgcc-s1 libstdc++6 \
  libfmt9 libfmt-dev libtbb12 libtbbmalloc2 libtbbbind-2-5 libtbb-dev libtomlplusplus3 libtomlplusplus-dev zlib1g zlib1g-dev \
  libeigen3-dev libcli11-dev nlohmann-json3-dev tao-pegtl-dev libboost1.74-dev libgtest-dev libgmock-dev
for package in *.deb; do
  dpkg -x "$package" "$root"
done
