#!/bin/sh
# near: how near to a limit both sides are told, in every precision and at every tol.      near.sh [check] > near.csv
#
#     check    in __float128 alone, passes when limits and declared band hold
set -eu
cc=${CC:-gcc}
out=build/near
mkdir -p $out
build() {                                               # build NAME FLAGS...
    name=$1
    shift
    "$cc" -std=gnu99 -O2 -ffp-contract=off -fno-math-errno -w tests/bench/near.c "$@" -lm -o $out/"$name"
}
quad() { build quad -DSP_REAL_QUAD -include quadmath.h '-DSP_SQRT(x)=sqrtq(x)' -lquadmath; }
if [ "${1:-}" = check ]; then quad && $out/quad check && exit 0 || exit 1; fi
build float -DSP_REAL_FLOAT
build double
build mixed -DSP_REAL_MIXED -DSP_NO_PLAN            # the planar search has no factor in float
quad
echo "real,scene,tol,distance"
for real in float mixed double quad; do $out/$real; done
