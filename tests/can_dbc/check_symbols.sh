#!/bin/bash
# Fails when an object file needs more than the memory functions that every compiler may call.
source "$(dirname "${BASH_SOURCE[0]}")/../../cmake/environment/help"
for object in "$@"; do
    symbols=$(nm --undefined-only --format=just-symbols "$object") || exit 1
    needed=$(echo "$symbols" | grep -vxE 'memcpy|memset|memmove|memcmp|_GLOBAL_OFFSET_TABLE_|')
    if [ -n "$needed" ]; then
        echo "$object needs:" $needed
        exit 1
    fi
    nm --defined-only --format=just-symbols "$object" | grep -qx codec_footprint || {
        echo "$object does not define codec_footprint: nothing was checked"
        exit 1
    }
done
