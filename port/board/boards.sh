#!/bin/sh
# boards: the tests and the corpus on every simulated target. Ends with `N passed, N failed`.
#
#     ONLY=text    only boards whose names contain the text
#     STRICT=1     what could not be run counts as a failure
. tests/checks/tally.sh
jobs=$(getconf _NPROCESSORS_ONLN 2> /dev/null || echo 1)

on() { make --no-print-directory -s -j "$jobs" -f port/board/board.mk BOARD="$1" REAL="$2" "$3"; }

# What was not run here, each with its reason.
left_out() {
    sed -n 's|"\(.*\)", /\* \(.*\) \*/|        left out: \1: \2|p' "build/board/$1-$2/left_out.h"
}

for suite in $(grep -l '"\.\./port/' tests/test_*.c); do echo "left out everywhere: $suite: it tests programs of port/"; done
# Board, precisions of the tests; the corpus runs in both everywhere.
while read -r board simulator package reals; do
    case $board in *"${ONLY:-}"*) ;; *) continue ;; esac
    compiler=$(make -s -f port/board/board.mk BOARD="$board" compiler)
    if ! have "$compiler" || ! have "$simulator"; then skip "$board" "$package"; continue; fi
    for real in $reals; do
        count "$board $real" on "$board" "$real" tests
        left_out "$board" "$real"
    done
    for real in double float; do
        part "$board $real: the bits of the host" on "$board" "$real" corpus
    done
done <<'END'
rv64gc   qemu-system-riscv64 gcc-riscv64-unknown-elf,qemu-system-misc double float
m3       qemu-system-arm     gcc-arm-none-eabi,qemu-system-arm        double
m4f      qemu-system-arm     gcc-arm-none-eabi,qemu-system-arm        float
m7       qemu-system-arm     gcc-arm-none-eabi,qemu-system-arm        double float
m33      qemu-system-arm     gcc-arm-none-eabi,qemu-system-arm        float
m55      qemu-system-arm     gcc-arm-none-eabi,qemu-system-arm        double
a53      qemu-system-aarch64 gcc-aarch64-linux-gnu,qemu-system-arm    double
rv32imac qemu-system-riscv32 gcc-riscv64-unknown-elf,qemu-system-misc float
rv32gc   qemu-system-riscv32 gcc-riscv64-unknown-elf,qemu-system-misc double
armhf    qemu-arm            gcc-arm-linux-gnueabihf,qemu-user        double
powerpc  qemu-ppc            gcc-powerpc-linux-gnu,qemu-user          float
mips     qemu-mips           gcc-mips-linux-gnu,qemu-user             double
s390x    qemu-s390x          gcc-s390x-linux-gnu,qemu-user            double
i686     true                gcc-i686-linux-gnu                       float
END
total
