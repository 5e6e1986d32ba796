#!/bin/sh
# windows: windows.h defines interface, far, near, small and more as macros. The header, and the library as part of the same file,
# compile after them, in C and (the header) in C++.
. tests/checks/tally.sh
tmp=$(mktemp -d)
trap 'rm -rf "$tmp" "$tally_log"' EXIT
cat > "$tmp/windows.h" << 'END'
#include <limits.h>
#include <math.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>
#define interface struct
#define far
#define near
#define small char
#define hyper long long
#define pascal
#define cdecl
#define IN
#define OUT
#define OPTIONAL
#define min(a, b) (((a) < (b)) ? (a) : (b))
#define max(a, b) (((a) > (b)) ? (a) : (b))
END
after() { printf '#include "windows.h"\n#include "%s"\n' "$1" > "$tmp/unity.c"; shift
          "$@" -Wall -Wextra -Werror -fsyntax-only -I"$tmp" -I. "$tmp/unity.c"; }

for what in "" -DSP_REAL_FLOAT -DSP_SMALL -DSP_EXACT_ONLY -DSP_QP_ONLY; do
    part "stonepack.c after windows.h $what" after stonepack.c "${CC:-gcc}" -std=c99 $what
done
part "stonepack.h after windows.h" after stonepack.h "${CC:-gcc}" -std=c99
if command -v "${CXX:-g++}" > /dev/null 2>&1; then
    part "stonepack.h after windows.h, C++" after stonepack.h "${CXX:-g++}" -std=c++98 -x c++ -Wno-long-long
fi
total
