#!/bin/sh
# sizes: bytes of code and constants for Cortex-M7 (double) and Cortex-M4F (float) at -Os: of every build that leaves parts out,
# then of every part.                                                                  needs arm-none-eabi-gcc
#
# A build is what the linker gets; --gc-sections may take more away. A part is the functions and tables of its file, those the
# compiler merged into callers counted there.
cd "$(dirname "$0")/../.." || exit 1
out=build/sizes
mkdir -p $out
m7='-mcpu=cortex-m7 -mfpu=fpv5-d16'
m4='-mcpu=cortex-m4 -mfpu=fpv4-sp-d16 -DSP_REAL_FLOAT'

compile() {                                             # compile OUTPUT FLAGS...
    c_out=$1
    shift
    arm-none-eabi-gcc -std=c99 -Os -g -ffp-contract=off -fno-math-errno -mthumb -mfloat-abi=hard -ffunction-sections "$@" \
        -c stonepack.c -o $out/"$c_out".o
}
code() { arm-none-eabi-size $out/"$1".o | awk 'NR == 2 { if ($2 + $3) exit 1; print $1 }'; }
build() {                                               # build WHAT FLAGS...
    b_what=$1
    shift
    # shellcheck disable=SC2086
    compile m7 $m7 "$@" && compile m4 $m4 "$@" && printf '%-56s %7d %7d\n' "$b_what" "$(code m7)" "$(code m4)" || exit 1
}
parts() { arm-none-eabi-nm -S -l $out/"$1".o | awk 'NF > 4 && $3 ~ /[tTrR]/ { print $2, $NF }'; }

printf '%-56s %7s %7s\n' 'build' M7 M4F
build 'quadratic programs only: SP_QP_ONLY, SP_NO_DYKSTRA' -DSP_QP_ONLY -DSP_NO_DYKSTRA
build 'quadratic programs only: SP_QP_ONLY' -DSP_QP_ONLY
build 'no quadratic programs, no coupled check: SP_NO_QP, _CRA' -DSP_NO_QP -DSP_NO_CRA
build 'no quadratic programs: SP_NO_QP' -DSP_NO_QP
build 'no stage ADMM: SP_NO_ADMM' -DSP_NO_ADMM
build 'no projections of Dykstra: SP_NO_DYKSTRA' -DSP_NO_DYKSTRA
build 'all'
{ parts m7 | sed 's/^/7 /'; parts m4 | sed 's/^/4 /'; } | awk '
    BEGIN { for (i = 0; i < 16; i++) hex[substr("0123456789abcdef", i + 1, 1)] = i }
    { n = 0; for (i = 1; i <= length($2); i++) n = 16 * n + hex[substr($2, i, 1)]
      sub(/:[0-9]*$/, "", $3); sub(/.*\//, "", $3); size[$1, $3] += n; file[$3] }
    END { for (f in file) printf "%-56s %7d %7d\n", "part " f, size[7, f], size[4, f] }' | sort -k3,3n
