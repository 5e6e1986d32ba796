#!/bin/sh
# instruments: the battery of hard scenes and the corpus in another arithmetic.      instruments.sh NAME
#
#     plain     double as it is; the truth of the corpus for the others
#     float     24 bits at tol 1e-5: hard scenes outside its band and the corpus as double has them
#     mixed     factors in float, refined in double: what double says, with the planar search and without
#     quad      113 bits; prints of each scene verdict, omega, how far double's largest force is off, time
#     rounding  up, down, towards zero
#     traps     invalid, division by zero, overflow stop the program; in double and in float
#     flush     denormals are zero
#     near      113 bits again: limits of tests/scenes/near.h, both sides told at 1e-12
#     precisions  hard scenes, and the cases below where they are: double, mixed, quad, float side by side, each at its default
#               and at its finest tol; no difference outside a declared band
#     chance    20 samples of random rounding, the first with the corpus; prints the digits all of them share, the worst ten
#
#     cases     assemblies of known truth (../shared/cases): the program in three rounding modes, traps, flushed, float; all
#               that stands balances to 1e-12
#     cases-quad, cases-mixed, cases-shadows, cases-chance (2 samples)     they as files of the battery, the truth plain double
#     shadows   clang's NSan: every number has a shadow of 113 bits; forces that stand are told where they leave theirs by
#               2^-19. A square root that loses eleven digits must be told, too
#
# Passes when no verdict is wrong and none is missing that has to be there. Needs gcc; chance: g++. Output: build/instruments.
set -eu
name=$1
cc=${CC:-gcc}
out=build/instruments
own=tests/instruments
flags="-ffp-contract=off -fno-math-errno -Ibuild -w"
battery="$own/battery.c port/host/run.c port/host/clock.c $(echo port/host/files/*.c)"
mkdir -p $out
[ -f build/scenes.h ] || { awk -f tests/corpus/scenes.awk tests/scenes/*.obj > build/scenes.h.new && mv build/scenes.h.new build/scenes.h; }

# What is newer than nothing it is made of stays: `plain` is asked for by most instruments.
fresh() {                                               # fresh FILE
    [ -f "$1" ] && [ -z "$(find stonepack.c stonepack.h solvers tests/instruments tests/scenes tests/corpus port/host build/scenes.h \
        -type f -newer "$1" | head -n 1)" ]
}
build() {                                               # build NAME FLAGS...
    bu=$1
    shift
    if fresh "$out/$bu" && [ "$(cat "$out/$bu.flags")" = "$cc $*" ]; then return; fi
    # shellcheck disable=SC2086
    $cc -std=gnu99 $flags "$@" $battery -lm ${LIBS:-} -o $out/"$bu" && echo "$cc $*" > $out/"$bu".flags
}
run() {                                                 # run PROGRAM TO WORDS...
    ru=$1 to=$2
    shift 2
    $out/"$ru" "$@" > $out/"$to".txt || { grep -E 'WRONG|OPEN' $out/"$to".txt; echo "$to: wrong or missing, or stopped"; return 1; }
}
# The last line of what runs by night, once `same` has found no other verdict: of how many scenes, in all samples, one was told.
counted() {                                             # counted TO...
    for co; do cat $out/"$co".txt; done |
        awk -F'|' '{ gsub(/ /, "", $2); d += $2 != "undecided" } END { printf "%d scenes, %d decided, none otherwise\n", NR, d }'
}
# The same verdicts as plain double, but where a row says it is open; a verdict against another is wrong everywhere.
same() {                                                # same TO [PLAIN]
    awk -F'|' '{ gsub(/ /, "", $2); gsub(/ /, "", $3) }
        NR == FNR { verdict[$1] = $2; open[$1] = $3 == "open"; next }
        $2 != verdict[$1] && $3 !~ /^(open|refused|capped|short)$/ && !open[$1] { print FILENAME ": " $0; bad = 1 }
        END { exit bad }' $out/"${2:-plain}".txt $out/"$1".txt
}
# Checked are the forces that come out (battery_shadow), not all that is stored on the way: a residual is all rounding.
shadow() {                                              # shadow NAME WORDS... FLAGS...
    sh=$1 words=''
    shift
    while [ $# -gt 0 ] && [ "${1#-}" = "$1" ]; do words="$words $1"; shift; done
    # shellcheck disable=SC2086
    clang-19 -std=gnu99 $flags -O1 -fsanitize=numerical -DBATTERY_SHADOW -mllvm -nsan-check-stores=false \
        -mllvm -nsan-check-loads=false -mllvm -nsan-check-ret=false -mllvm -nsan-instrument-fcmp=false \
        -mllvm '-check-functions-filter=^none$' "$@" $battery -lm -o $out/"$sh"
    # shellcheck disable=SC2086
    NSAN_OPTIONS=halt_on_error=0:log2_max_relative_error=19:log2_absolute_error_threshold=500 \
        $out/"$sh" $words > $out/"$sh".txt 2> $out/"$sh".err
}
plain() { build plain -O2; fresh $out/plain.txt || run plain plain || { rm -f $out/plain.txt; return 1; }; }
chance() {
    # shellcheck disable=SC2086
    g++ -x c++ -std=gnu++20 -fpermissive -DSP_REAL_OTHER -include $own/random.hpp $flags -O2 $battery -lm -o $out/chance
}
quad() { LIBS=-lquadmath build quad -O1 -DSP_REAL_QUAD -include quadmath.h '-DSP_SQRT(x)=sqrtq(x)'; }
files() {                                               # scenes of known truth, unpacked, as words
    mkdir -p $out/files
    for fi in ../shared/cases/*/scene.obj*; do
        fi_name=${fi%/*}
        fi_to=$out/files/${fi_name##*/}.obj
        case $fi in *.gz) gzip -dc "$fi" > "$fi_to" ;; *) cp "$fi" "$fi_to" ;; esac
        echo "$fi_to"
    done
}
table() {                                               # table PLAIN QUAD: every scene's omega, growth of rounding, time
    echo "rounding: how far the largest force in double is from that in 113 bits, in units of 2^-53 of it"
    printf '%-38s  %-9s  %8s  %8s  %8s\n' scene verdict omega rounding ms
    awk -F'|' 'NR == FNR { f[$1] = $5; next }
        ($1 in f) && $5 > 0 { e = f[$1] / $5 - 1; grown[$1] = sprintf("%.1e", (e < 0 ? -e : e) * 2 ^ 53) }
        END { for (k in grown) print k "|" grown[k] }' $out/"$2".txt $out/"$1".txt > $out/grown.txt
    awk -F'|' 'NR == FNR { g[$1] = $2; next } { printf "%s %s %s  %8s  %8s\n", $1, $2, $4, $1 in g ? g[$1] : "-", $6 }' \
        $out/grown.txt $out/"$1".txt
}

case $name in
plain) plain; cat $out/plain.txt ;;
float) plain; build float -O1 -DSP_REAL_FLOAT; run float float; same float ;;
mixed)
    plain; build mixed -O1 -DSP_REAL_MIXED; run mixed mixed; same mixed
    build mixed-rows -O1 -DSP_REAL_MIXED -DSP_NO_PLAN; run mixed-rows mixed-rows; same mixed-rows ;;
rounding)
    plain; build modes -O1 -frounding-math
    for mode in up down zero; do run modes $mode $mode; same $mode; done ;;
traps)
    plain; run plain traps traps; same traps
    build float-traps -O1 -DSP_REAL_FLOAT; run float-traps float-traps traps ;;
flush) plain; run plain flush flush; same flush ;;
quad)
    plain; quad; run quad quad light; same quad
    table plain quad ;;
shadows)
    shadow nsan light || { cat $out/nsan.txt; exit 1; }
    shadow nsan-bad light short -DBATTERY_BAD || true           # some of its verdicts are open
    told() { grep -c 'WARNING: Numerical' $out/"$1".err || true; }
    grep -A 5 'WARNING: Numerical' $out/nsan.err || true
    echo "told: $(told nsan); of the bad square root: $(told nsan-bad)"
    [ "$(told nsan)" -eq 0 ] && [ "$(told nsan-bad)" -gt 0 ] ;;
cases)
    host="port/host/*.c port/host/*/*.c tests/scenes/gen.c stonepack.c $own/modes.c"
    # shellcheck disable=SC2086
    $cc -std=gnu99 $flags -O1 -frounding-math $host -lm -o $out/program
    # shellcheck disable=SC2086
    $cc -std=gnu99 $flags -O1 -DSP_REAL_FLOAT $host -lm -o $out/program-float
    tell() { sed -n '$p' $out/cases.txt; }
    for mode in up down zero traps flush; do
        MODE=$mode python3 ../shared/tools/run_cases.py --cli $out/program > $out/cases.txt || { cat $out/cases.txt; exit 1; }
        echo "$mode: $(tell)"
    done
    scenes=$(files)
    build plain -O2
    for tol in 1e-9 1e-12; do
        # shellcheck disable=SC2086
        run plain fine fine tol=$tol $scenes
        echo "at tol $tol: $(grep -c '| stable' $out/fine.txt) stand, each balanced to 1e-12"
    done
    # Float at the tol its band of 1e-3 takes. Left open may be, with the distance from the limit:
    #   b_arch20_m001            1e-4
    #   b_wall15x20_m01, 8i      1e-3, the band's edge: hundreds of joints slide and open at once
    #   c_chain300_lean          1e-3 and 1e-2: height 300 x base, rounding comes to 300^2 u of a block's forces
    # and c_wall_huge is refused: squares of its weights leave the range of a float.
    printf '#!/bin/sh\nexec %s "$@" --tol 3e-6\n' $out/program-float > $out/program-fine
    chmod +x $out/program-fine
    python3 ../shared/tools/run_cases.py --cli $out/program-fine > $out/cases.txt || true
    echo "float: $(tell)"
    grep '^[0-9]* compared' $out/cases.txt > /dev/null && ! grep -E '^(WRONG|undecided|error) ' $out/cases.txt |
        grep -v -E '^undecided (b_arch20_m001 |b_wall15x20_m01 +8i |c_chain300_lean_)|^error +c_wall_huge_' ;;
cases-quad | cases-mixed | cases-shadows | cases-chance)
    scenes=$(files)
    # shellcheck disable=SC2086
    build plain -O2; run plain plain-cases $scenes
    # shellcheck disable=SC2086
    case $name in
    *-quad) quad; run quad quad $scenes; same quad plain-cases; table plain-cases quad; counted quad ;;
    *-mixed) build mixed-rows -O1 -DSP_REAL_MIXED -DSP_NO_PLAN; run mixed-rows mixed $scenes; same mixed plain-cases ;;
    *-shadows)
        shadow nsan $scenes; same nsan plain-cases
        if grep -A 5 'WARNING: Numerical' $out/nsan.err; then exit 1; fi
        echo "$(counted nsan), 0 with forces that leave their shadows" ;;
    *-chance)
        chance
        for k in 1 2; do export SEED=$k; run chance chance-$k $scenes; same chance-$k plain-cases; done
        counted chance-1 chance-2 ;;
    esac ;;
near) sh tests/bench/near.sh check ;;
precisions)
    scenes=
    if [ -d ../shared/cases ]; then scenes=$(files); fi
    build plain -O2; cp $out/plain $out/double; build mixed -O1 -DSP_REAL_MIXED; quad; build float -O1 -DSP_REAL_FLOAT
    for column in double-1e-9 double-1e-12 mixed-1e-9 mixed-1e-12 quad-1e-9 quad-1e-15 float-1e-4 float-3e-6; do
        program=${column%%-*} at=tol=${column#*-}
        {   $out/"$program" "$at" short || true                 # the table below judges
            # shellcheck disable=SC2086
            if [ "$scenes" ]; then $out/"$program" "$at" $scenes || true; fi
        } > $out/"$column".txt
    done
    # shellcheck disable=SC2086
    python3 -B $own/precisions.py $out ${scenes:+../shared/cases} ;;
chance)
    plain; chance
    k=1 samples=
    while [ $k -le 20 ]; do
        export SEED=$k samples="$samples chance-$k"
        if [ $k -gt 1 ]; then words='light short'; else words=light; fi
        # shellcheck disable=SC2086
        run chance chance-$k $words; same chance-$k
        k=$((k + 1))
    done
    awk -F'|' '{ n[$1]++; s[$1] += $5; if (n[$1] == 1 || $5 < lo[$1]) lo[$1] = $5; if ($5 > hi[$1]) hi[$1] = $5 }
        END { for (k in n) if (s[k] > 0) printf "%.1e %s\n", (hi[k] - lo[k]) * n[k] / s[k], k }' $out/chance-*.txt | sort -g -r | head -n 10
    # shellcheck disable=SC2086
    counted $samples ;;
*) echo "instruments: no $name" >&2; exit 64 ;;
esac
