#!/bin/sh
# compile_with.sh COMPILER [LAUNCHER] OTHER ARGUMENT ...
#
# As a compiler launcher: compiles by COMPILER what the build meant for OTHER, g++, and leaves out the
# options that g++ alone knows. A launcher that stands before OTHER (ccache) is kept.
set -eu
compiler=$1
shift
launcher=
while [ $# -gt 0 ]; do
  case $1 in
    -*) break ;;
    *ccache) launcher=$1 ;;
  esac
  shift
done
count=$#
while [ "$count" -gt 0 ]; do
  argument=$1
  shift
  count=$((count - 1))
  case $argument in
    # A precompiled header that is there already, of either compiler, would be read for its own.
    *.gch) rm -f "$argument" && set -- "$@" "$argument" ;;
    -Wno-restrict | -fno-var-tracking) ;;
    *) set -- "$@" "$argument" ;;
  esac
done
exec ${launcher:+"$launcher"} "$compiler" "$@"
