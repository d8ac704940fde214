#!/bin/sh
# Prints the Python that the virtual environment is made with, or says in one sentence what this machine lacks.
# usage: find_python.sh [PYTHON]     PYTHON: take this one and no other
set -u

fail() {
    echo "$*" >&2
    exit 1
}

# An executable may be there and yet not run (a shim of a version manager), lack venv (a split package), or lack the headers.
runs() {
    "$1" -c 'import ensurepip, venv' >/dev/null 2>&1
}

is_suitable() {
    "$1" -c 'import sys; sys.exit(sys.implementation.name != "cpython" or not (3, 11) <= sys.version_info[:2] <= (3, 13))' 2>/dev/null
}

has_headers() {
    "$1" -c 'import os, sys, sysconfig; sys.exit(not os.path.exists(os.path.join(sysconfig.get_path("include"), "Python.h")))'
}

machine="$(uname -s -m)"
[ "$machine" = "Linux x86_64" ] ||
    fail "This machine is $machine, but ROS 2 on PyPI exists for Linux x86_64 alone; use a ROS 2 Jazzy installation and colcon here."

without_headers=""
found=""
for candidate in ${1:-python3.12 python3.13 python3.11 python3}; do
    if runs "$candidate" && is_suitable "$candidate"; then
        if has_headers "$candidate"; then
            found="$candidate"
            break
        fi
        without_headers="$candidate"
    fi
done

if [ -z "$found" ] && [ -n "$without_headers" ]; then
    fail "$without_headers has no header files (Python.h), which building msg_defs needs: install its development package (python3-dev)."
elif [ -z "$found" ] && [ -n "${1:-}" ]; then
    fail "PYTHON=$1 is not a CPython 3.11, 3.12 or 3.13 that runs and has the modules venv and ensurepip: give another one."
elif [ -z "$found" ]; then
    fail "No CPython 3.11, 3.12 or 3.13 with the modules venv and ensurepip was found: install one (python3, python3-venv, python3-dev) or name it by PYTHON=/path/to/python."
fi

for compiler in "${CC:-cc}" "${CXX:-c++}"; do
    command -v "${compiler%% *}" >/dev/null 2>&1 ||
        fail "The compiler $compiler was not found, and msg_defs needs a C and a C++ compiler: install one (g++) or name it by CC= and CXX=."
done

echo "$found"
