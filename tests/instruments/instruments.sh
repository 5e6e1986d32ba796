#!/bin/sh
# instruments: the battery of hard scenes and the corpus in another arithmetic.      instruments.sh NAME
#
#     plain     double as it is; the truth of the corpus for the others
#     float     24 bits: no wrong verdict on hard scenes outside its band, the corpus as double has it
#     mixed     factors in float, refined in double: what double says, with the planar search and without
#     quad      113 bits; prints how far double's largest force is off, the worst ten
#     rounding  up, down, towards zero
#     traps     invalid, division by zero, overflow stop the program; in double and in float
#     flush     denormals are zero
#     near      113 bits again: limits of tests/scenes/near.h, both sides told at 1e-12
#     chance    20 samples of random rounding, the first with the corpus; prints the digits all of them share, the worst ten
#
# Passes when no verdict is wrong and none is missing that has to be there. Needs gcc; chance: g++. Output: build/instruments.
set -eu
name=$1
cc=${CC:-gcc}
out=build/instruments
own=tests/instruments
flags="-ffp-contract=off -fno-math-errno -Ibuild -w"
mkdir -p $out
awk -f tests/corpus/scenes.awk tests/scenes/*.obj > build/scenes.h.new && mv build/scenes.h.new build/scenes.h

build() {                                               # build NAME FLAGS...
    bu=$1
    shift
    # shellcheck disable=SC2086
    $cc -std=gnu99 $flags "$@" $own/battery.c -lm ${LIBS:-} -o $out/"$bu"
}
run() {                                                 # run PROGRAM TO WORDS...
    ru=$1 to=$2
    shift 2
    $out/"$ru" "$@" > $out/"$to".txt || { grep -E 'WRONG|OPEN' $out/"$to".txt; echo "$to: wrong or missing, or stopped"; return 1; }
}
# The same verdicts as plain double, but where a row says it is open; a verdict against another is wrong everywhere.
same() {                                                # same TO [may-open]
    awk -F'|' -v may="${2:-}" '{ gsub(/ /, "", $2); gsub(/ /, "", $3) }
        NR == FNR { verdict[$1] = $2; open[$1] = $3 == "open"; next }
        $2 != verdict[$1] && $3 != "open" && !open[$1] && !(may && ($2 == "undecided" || verdict[$1] == "undecided")) { print FILENAME ": " $0; bad = 1 }
        END { exit bad }' $out/plain.txt $out/"$1".txt
}
plain() { build plain -O2 && run plain plain; }

case $name in
plain) plain && cat $out/plain.txt ;;
float) plain && build float -O2 -DSP_REAL_FLOAT && run float float && same float may-open ;;
mixed)
    plain && build mixed -O2 -DSP_REAL_MIXED && run mixed mixed && same mixed
    build mixed -O2 -DSP_REAL_MIXED -DSP_NO_PLAN && run mixed mixed-rows && same mixed-rows ;;
rounding)
    plain && build modes -O1 -frounding-math
    for mode in up down zero; do run modes $mode $mode && same $mode; done ;;
traps)
    plain && run plain traps traps && same traps
    build float -O1 -DSP_REAL_FLOAT && run float float-traps traps ;;
flush) plain && run plain flush flush && same flush ;;
quad)
    plain && LIBS=-lquadmath build quad -O2 -DSP_REAL_QUAD -include quadmath.h '-DSP_SQRT(x)=sqrtq(x)' && run quad quad light
    same quad
    awk -F'|' 'NR == FNR { f[$1] = $5; next } ($1 in f) && $5 > 0 { e = f[$1] / $5 - 1; printf "%.1e %s\n", e < 0 ? -e : e, $1 }' \
        $out/plain.txt $out/quad.txt | sort -g -r | head -n 10 ;;
near) sh tests/bench/near.sh check ;;
chance)
    plain && g++ -x c++ -std=gnu++20 -fpermissive -DSP_REAL_OTHER -include $own/random.hpp $flags -O2 $own/battery.c -lm -o $out/chance
    k=1
    while [ $k -le 20 ]; do
        export SEED=$k
        if [ $k -gt 1 ]; then words='light short'; else words=light; fi
        # shellcheck disable=SC2086
        $out/chance $words > $out/chance-$k.txt || true          # undecided by chance is told, wrong is not forgiven
        if grep WRONG $out/chance-$k.txt; then exit 1; fi
        same chance-$k may-open
        k=$((k + 1))
    done
    echo "undecided by chance: $(cat $out/chance-*.txt | grep -c OPEN || true) of $(cat $out/chance-*.txt | wc -l)"
    awk -F'|' '{ n[$1]++; s[$1] += $5; if (n[$1] == 1 || $5 < lo[$1]) lo[$1] = $5; if ($5 > hi[$1]) hi[$1] = $5 }
        END { for (k in n) if (s[k] > 0) printf "%.1e %s\n", (hi[k] - lo[k]) * n[k] / s[k], k }' $out/chance-*.txt | sort -g -r | head -n 10 ;;
*) echo "instruments: no $name" >&2; exit 64 ;;
esac
