#!/bin/sh
# peers: stonepack beside other people's solvers, those that are installed; what is not is told and left out. Fetches nothing.
#
#     make bench-peers [SCS=PREFIX] [QOCO=PREFIX] [ECOS=PREFIX] [PIQP=PREFIX] [OSQP=PREFIX] [QPS=FOLDER] [LONG=1] [TEXT=WORDS]
#
# PREFIX: where include/ and lib/ of a solver are, or its folder after `make` (else the compiler's own places). All but PIQP as
# static libraries: each is linked with its adapter into one object that shows nothing else, as several bring their own AMD and
# QDLDL with integers of their own. QOCO 0.3.2 does not install all its headers: include/*.h and algebra/*/*.h belong beside those
# it does. An SCS with LAPACK, which its acceleration needs, has to bring that in its libscsdir.a (a serial OpenBLAS by `ld -r`).
# QPS: a folder of QPS files, such as the Maros-Meszaros collection. HiGHS: that of python3's SciPy. TEXT: only checks of scenes
# whose group or words contain it. Writes build/peers-check.csv, build/peers-qp.csv and build/peers-limit.csv.
set -eu
cc=${CC:-cc}
here=tests/bench/peers
flags="-std=gnu99 -O2 -Wall -Wextra -Wshadow -I."
mkdir -p build
piqp=''
with=''
objects=''

# Where a solver's headers and libraries may be below its prefix.
places()
{
    [ -n "$1" ] || return 0
    for d in include include/* external/*/include external/SuiteSparse_config; do
        for f in "$1"/$d; do [ ! -d "$f" ] || printf ' -isystem %s' "$f"; done
    done
    for d in lib lib/* lib64 out .; do for f in "$1"/$d; do [ ! -d "$f" ] || printf ' -L%s' "$f"; done; done
}

# NAME PREFIX LIBRARY [FLAG...]: adapter and library to build/peer-NAME.o that shows peer_NAME alone.
static()
{
    name=$1 prefix=$2 library=$3
    shift 3
    # shellcheck disable=SC2046,SC2086  # several words each
    if $cc $flags "$@" $(places "$prefix") -r -nostdlib -Wl,-Bstatic $here/$name.c -l$library -o build/peer-$name.o \
        2> build/peer-$name.log && objcopy --keep-global-symbol=peer_$name build/peer-$name.o; then
        with="$with -DWITH_$(echo $name | tr '[:lower:]' '[:upper:]')"
        objects="$objects build/peer-$name.o"
    else echo "skipped $name: no header or lib$library.a (see build/peer-$name.log)" >&2; fi
}

static scs "${SCS:-}" scsdir
static qoco "${QOCO:-}" qocostatic
static ecos "${ECOS:-}" ecos -DDLONG -DLDL_LONG
static osqp "${OSQP:-}" osqpstatic
include=$(places "${PIQP:-}")
[ -z "${PIQP:-}" ] || include="$include -Wl,-rpath,$PIQP/lib"
# shellcheck disable=SC2086
if printf '#include <piqp.h>\nint main(void) { piqp_settings s; piqp_set_default_settings_sparse(&s); return 0; }\n' |
    $cc -x c - -x none $include -lpiqpc -lstdc++ -lm -o build/peer-probe 2> /dev/null; then
    piqp="$here/piqp.c -DWITH_PIQP $include -lpiqpc -lstdc++"
else echo "skipped piqp: no piqp.h and libpiqpc" >&2; fi
rm -f build/peer-probe

# shellcheck disable=SC2086
$cc $flags $here/check.c tests/scenes/gen.c $with $objects build/libstonepack.a $piqp -lm -o build/bench-check
build/bench-check ${TEXT:+"$TEXT"} > build/peers-check.csv
echo "build/peers-check.csv"
# shellcheck disable=SC2086
$cc $flags $here/qp.c port/host/run.c port/host/clock.c port/host/files/*.c build/libstonepack.a $piqp -lm -o build/bench-peers
if [ -n "${QPS:-}" ]; then
    find "$QPS" -iname '*.qps' | sort | xargs build/bench-peers > build/peers-qp.csv
    echo "build/peers-qp.csv"
else echo "skipped quadratic programs: no folder QPS" >&2; fi
python3 -B tests/bench/peers/limit.py build/stonepack ${LONG:+--long} > build/peers-limit.csv
echo "build/peers-limit.csv"
