#!/bin/bash
# Runs a test script with the interpreter that it needs, or fails saying how to get it.
#   run_python.sh REMEDY INTERPRETER SCRIPT [ARGUMENT...]
source "$(dirname "${BASH_SOURCE[0]}")/../../cmake/environment/help"
remedy=$1
shift
if [ ! -x "$1" ]; then
    echo "The Python interpreter $1 is missing. $remedy" >&2
    exit 1
fi
exec "$@"
