#!/bin/sh
# boards: the tests and the corpus on every simulated target, one target a core. Ends with `N passed, N failed`.
#
#     ONLY=text    only boards whose names contain the text
#     STRICT=1     what could not be run counts as a failure
#     WHOLE="m4f-float m7-double"    the tests on these only, the corpus everywhere; else the tests, too, on all of the table
#     MOST=8000    tests of more work are left out, in thousands of steps [board.mk]
#     QUICK=1      where the corpus alone runs, it does in the precisions of the table, and the library is optimised by -O1, not -O2
#
# `boards.sh NAME` runs that board alone, in place.
. tests/checks/tally.sh
logs=build/board/logs
mkdir -p $logs

# Board, simulator, what it needs, precisions of the tests; the corpus runs in both, but for QUICK.
boards='
rv64gc   qemu-system-riscv64 gcc-riscv64-unknown-elf,qemu-system-misc double,float
m3       qemu-system-arm     gcc-arm-none-eabi,qemu-system-arm        double
m4f      qemu-system-arm     gcc-arm-none-eabi,qemu-system-arm        float
m7       qemu-system-arm     gcc-arm-none-eabi,qemu-system-arm        double,float
m33      qemu-system-arm     gcc-arm-none-eabi,qemu-system-arm        float
m55      qemu-system-arm     gcc-arm-none-eabi,qemu-system-arm        double
a53      qemu-system-aarch64 gcc-aarch64-linux-gnu,qemu-system-arm    double
rv32imac qemu-system-riscv32 gcc-riscv64-unknown-elf,qemu-system-misc float
rv32gc   qemu-system-riscv32 gcc-riscv64-unknown-elf,qemu-system-misc double
armhf    qemu-arm            gcc-arm-linux-gnueabihf,qemu-user        double
powerpc  qemu-ppc            gcc-powerpc-linux-gnu,qemu-user          float
mips     qemu-mips           gcc-mips-linux-gnu,qemu-user             double
s390x    qemu-s390x          gcc-s390x-linux-gnu,qemu-user            double
i686     qemu-i386           gcc-i686-linux-gnu,qemu-user             float
'

on() { MAKEFLAGS='' make --no-print-directory -s -f port/board/board.mk BOARD="$1" REAL="$2" "$3"; }
asked() { case " ${WHOLE:-$1-$2} " in *" $1-$2 "*) ;; *) return 1 ;; esac; }       # asked BOARD PRECISION: whether tests run there

# What tests need is measured by whoever comes first, beside the boards that do not ask for it.
needs() { MAKEFLAGS='' flock build/board/needs.lock make --no-print-directory -s -f port/board/board.mk needs; }

# What was not run here, each with its reason.
left_out() {
    sed -n 's|"\(.*\)", /\* \(.*\) \*/|        left out: \1: \2|p' "build/board/$1-$2/left_out.h"
}

one() {                                                 # one BOARD SIMULATOR PACKAGE PRECISION,...
    compiler=$(make -s -f port/board/board.mk BOARD="$1" compiler)
    if ! have "$compiler" || ! have "$2"; then skip "$1" "$3"; return; fi
    for real in $(echo "$4" | tr , ' '); do
        if ! asked "$1" "$real"; then continue; fi
        needs || :                                      # the tests ask again, and fail
        count "$1 $real" on "$1" "$real" tests
        left_out "$1" "$real"
    done
    for real in double float; do
        OPT=-O2
        if [ "${QUICK:-}" ] && ! asked "$1" "$real"; then
            case ,$4, in *",$real,"*) OPT=-O1 ;; *) continue ;; esac
        fi
        export OPT
        part "$1 $real: the bits of the host" on "$1" "$real" corpus
    done
}

joined() {                                              # joined BOARD: what it printed, and its numbers added
    jo_line=$(sed -n '$p' "$logs/$1")
    if echo "$jo_line" | grep -qxE '[0-9]+ passed, [0-9]+ failed'; then
        sed '$d' "$logs/$1"
        # shellcheck disable=SC2086
        set -- $jo_line
        passed=$((passed + $1)) failed=$((failed + $3))
    else
        failed=$((failed + 1))
        echo "FAILED  $1: no end"
        tail -n 20 "$logs/$1"
    fi
}

if [ "${1:-}" = needs ]; then
    needs
elif [ $# -gt 0 ]; then
    # shellcheck disable=SC2046
    one $(echo "$boards" | grep "^$1 ")
else
    for suite in $(grep -l '"\.\./\.\./port/' tests/*/test_*.c); do
        echo "left out everywhere: $suite: it tests programs of port/"
    done
    # First those that need not be told what a test needs.
    names=$(echo "$boards" | awk -v only="${ONLY:-}" -v whole=" ${WHOLE:-}" '
        NF && index($1, only) { print (index(whole, " " $1 "-") > 0), $1 }' | sort -s -n -k1,1 | cut -d ' ' -f 2)
    if [ -z "$names" ]; then echo "no board is called ${ONLY:-}"; exit 1; fi
    { echo needs; echo "$names"; } | xargs -P "$(nproc 2> /dev/null || echo 1)" -I{} sh -c "sh '$0' {} > $logs/{} 2>&1"
    for board in $names; do joined "$board"; done
fi
total
