#!/bin/sh
# peers: stonepack beside other people's solvers, those that are installed; what is not is told and left out. Fetches nothing.
#
#     make bench-peers [PIQP=PREFIX] [QPS=FOLDER] [LONG=1]
#
# PIQP: where include/piqp.h and lib/libpiqpc.* are (else the compiler's own places). QPS: a folder of QPS files, such as the
# Maros-Meszaros collection. HiGHS: that of python3's SciPy. Writes build/peers-qp.csv and build/peers-limit.csv.
set -eu
cc=${CC:-cc}
prefix=${PIQP:-}
include=''
lib=''
with=''
[ -z "$prefix" ] || { include=-I$prefix/include; lib="-L$prefix/lib -Wl,-rpath,$prefix/lib"; }
mkdir -p build
# shellcheck disable=SC2086  # several words each
if printf '#include <piqp.h>\nint main(void) { piqp_settings s; piqp_set_default_settings_sparse(&s); return 0; }\n' |
    $cc -x c - $include -x none $lib -lpiqpc -lstdc++ -lm -o build/peer-probe 2> /dev/null; then with=piqp
else echo "skipped PIQP: no piqp.h and libpiqpc (PIQP=PREFIX)" >&2; fi
rm -f build/peer-probe
set -- tests/bench/peers/qp.c port/host/run.c port/host/clock.c port/host/files/*.c
[ -z "$with" ] || set -- "$@" tests/bench/peers/piqp.c -DWITH_PIQP
# shellcheck disable=SC2086
$cc -std=gnu99 -O2 -Wall -Wextra -Wshadow -I. $include "$@" build/libstonepack.a $lib ${with:+-lpiqpc -lstdc++} -lm \
    -o build/bench-peers
if [ -n "${QPS:-}" ]; then
    find "$QPS" -iname '*.qps' | sort | xargs build/bench-peers > build/peers-qp.csv
    echo "build/peers-qp.csv"
else echo "skipped quadratic programs: no folder QPS" >&2; fi
python3 -B tests/bench/peers/limit.py build/stonepack ${LONG:+--long} > build/peers-limit.csv
echo "build/peers-limit.csv"
