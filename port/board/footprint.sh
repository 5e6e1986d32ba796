#!/bin/sh
# footprint: what the library costs on a microcontroller, as lines `what number`.
#
#     footprint.sh > port/board/footprint.txt        measures (make footprint)
#     footprint.sh --check                           measures and compares: 2 % more or less than the file says fails
#
# Bytes of code by arm-none-eabi-gcc and riscv64-unknown-elf-gcc at -Os; stacks by the compiler's own record of frames and
# calls, and painted on the simulated board; instructions counted there.
set -eu
to=build/footprint
table=port/board/footprint.txt
mkdir -p $to
flags='-std=c99 -Os -ffp-contract=off -fno-math-errno -ffunction-sections -fdata-sections'
m7='arm-none-eabi-gcc -mthumb -mfloat-abi=hard -mcpu=cortex-m7 -mfpu=fpv5-d16'
m4f='arm-none-eabi-gcc -mthumb -mfloat-abi=hard -mcpu=cortex-m4 -mfpu=fpv4-sp-d16 -DSP_REAL_FLOAT'
rv32='riscv64-unknown-elf-gcc -march=rv32imac -mabi=ilp32 -DSP_REAL_FLOAT -ffreestanding -Iport/board/include'
switches=$(grep -o 'SP_NO_[A-Z_]*' stonepack.h | sort -u)
row() { printf '%-72s %9s\n' "$1" "$2"; }

build() {                                               # build COMPILER FLAGS... -> $to/one.o
    # shellcheck disable=SC2086
    "$@" $flags -c stonepack.c -o $to/one.o
}
text() { arm-none-eabi-size $to/one.o | awk 'NR == 2 { print $1 }'; }

# Functions and tables by the part they come from: the files of solvers/, the chapters of stonepack.c.
parts() {
    arm-none-eabi-nm -S -l --defined-only $to/one.o | awk -v unit="$1" '
        BEGIN {
            while ((getline line < "stonepack.c") > 0) {
                n++
                if (line !~ /^\/\* [0-9]+ -----/) continue
                gsub(/^\/\* |-+|\*\/$/, "", line); gsub(/  +/, " ", line); sub(/ +$/, "", line)
                from[++chapters] = n; title[chapters] = line
            }
        }
        NF >= 5 && $3 ~ /[tTrR]/ {
            bytes = 0
            for (k = 1; k <= 8; k++) bytes = 16 * bytes + index("0123456789abcdef", substr($2, k, 1)) - 1
            split($5, at, ":")
            part = at[1]
            if (!sub(/.*\/solvers\//, "solvers/", part)) sub(/.*\//, "", part)
            if (part == "stonepack.c") for (k = 1; k <= chapters && from[k] <= at[2] + 0; k++) part = "stonepack.c " title[k]
            sum[part] += bytes
        }
        END { for (part in sum) printf "%-72s %9d\n", unit " text of " part, sum[part] }' | sort
}

measure() {
    for unit in m7-double m4f-float rv32imac-float; do
        case $unit in m7*) cc=$m7 ;; m4f*) cc=$m4f ;; *) cc=$rv32 ;; esac
        all=''
        # shellcheck disable=SC2086
        build $cc
        row "$unit text" "$(text)"
        row "$unit data and bss" "$(arm-none-eabi-size $to/one.o | awk 'NR == 2 { print $2 + $3 }')"
        for switch in $switches; do
            # shellcheck disable=SC2086
            build $cc -D$switch
            row "$unit text with $switch" "$(text)"
            all="$all -D$switch"
        done
        # shellcheck disable=SC2086
        build $cc $all
        row "$unit text with all of these" "$(text)"
    done
    for unit in m7-double m4f-float; do
        case $unit in m7*) cc=$m7 ;; *) cc=$m4f ;; esac
        # shellcheck disable=SC2086
        build $cc -g -fcallgraph-info=su
        parts $unit
        awk -f port/board/stack.awk $to/one.ci | sort -k 2 -nr | head -n 12 | while read -r call bytes; do
            row "$unit stack below $call" "$bytes"
        done
    done
    for unit in m4f-float m7-double m7-float rv32gc-double; do
        make --no-print-directory -s -f port/board/board.mk BOARD=${unit%-*} REAL=${unit#*-} cost > $to/cost
        awk -v unit=$unit 'NR > 1 {
            what = unit " " substr($0, 1, 50); gsub(/ +/, " ", what); sub(/ $/, "", what)
            split("1000 instructions,arena of the scene,arena of the check,stack painted", column, ",")
            for (k = 1; k <= 4; k++) printf "%-72s %9d\n", what ": " column[k], $(NF - 4 + k) }' $to/cost
    done
}

if [ "${1:-}" != --check ]; then
    measure
    exit
fi
measure > $to/now
awk '{ key = $0; sub(/ +[0-9]+$/, "", key) }
     NR == FNR { was[key] = $NF; next }
     !(key in was) { print "new: " $0; bad = 1; next }
     { seen[key] = 1; d = $NF - was[key]; if (d < 0) d = -d }
     d > 0.02 * was[key] { print key ": " $NF ", was " was[key]; bad = 1 }
     END { for (key in was) if (!(key in seen)) { print "gone: " key; bad = 1 }
           if (bad) print "make footprint writes the table anew"; exit bad }' $table $to/now
