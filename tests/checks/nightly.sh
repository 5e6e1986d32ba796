#!/bin/sh
# nightly: what takes too long for every change: more samples, slower arithmetic, all boards. Ends with `N passed, N failed`.
#
#     ONLY=text    only lines whose names contain the text; two runs of different lines may go side by side
#     STRICT=1     what could not be run counts as a failure
#     --list       names of all lines, run or not, which trust.sh asks for
#
# Each line becomes a row of tests/NIGHTLY.md, to be committed: when, of which commit, seconds of processor, and the last line
# that its command said. A row stays until that line is run again, so a night may be put together from pieces.
. tests/checks/tally.sh
TIMES=1
listed=
if [ "${1:-}" = --list ]; then                          # of machines that have everything
    listed=1
    have() { :; }
fi
out=build/nightly
table=tests/NIGHTLY.md
mkdir -p $out
if [ ! -f $table ]; then
    {   echo "# What was run by night"
        echo
        echo "\`make nightly\` keeps this table: a row for each of its lines, with the day and the commit it was last run at, seconds of"
        echo "processor, and the last line that it said."
        echo
        echo "| what | day | commit | seconds | figure |"
        echo "|---|---|---|--:|---|"
    } > $table
fi
only=${ONLY:-}                                          # of lines of this script, not of what they run
unset ONLY MAKEFLAGS
instrument() { sh tests/instruments/instruments.sh "$1"; }

# row NAME SECONDS FIGURE: written in the place of the row of that name, or at the end
row() {
    awk -v n="| $1 |" -v r="| $1 | $(date +%Y-%m-%d) | $(git rev-parse --short HEAD) | $2 | $3 |" \
        'index($0, n) == 1 { $0 = r; done = 1 } { print } END { if (!done) print r }' $table > $table.$$ && mv $table.$$ $table
}
line() {                                                # line NAME COMMAND...
    line_name=$1
    shift
    if [ "$listed" ]; then echo "$line_name"; return; fi
    case $line_name in *"$only"*) ;; *) return ;; esac
    line_failed=$failed
    begun
    line_from=$since
    part "$line_name" sh -c '"$@" > "$0" 2>&1 || { tail -n 40 "$0"; exit 1; }' "$out/said.$$" "$@"
    spent
    line_figure=$(grep -v '^ *$' "$out/said.$$" | tail -n 1 | tr '|' '/' | sed 's/^ *//')
    if [ "$failed" -gt "$line_failed" ]; then line_figure="FAILED: $line_figure"; fi
    row "$line_name" "$(awk -v a="$line_from" -v b="$spent" 'BEGIN { printf "%.0f", b - a }')" "$line_figure"
}
long_san() {                                            # long_san COMPILER SANITIZERS PRECISION
    ${1:-gcc} -std=c99 -w -ffp-contract=off -fno-math-errno -O1 -g -fsanitize="$2" -fno-sanitize-recover=all ${3:+"$3"} \
        -DTEST_SUITES="$(ls tests/*/test_*.c | sed 's|.*/test_\(.*\)\.c|X(\1)|' | tr '\n' ' ')" tests/run.c tests/*/test_*.c \
        $(ls port/host/*.c port/host/*/*.c | grep -v /main.c) tests/scenes/gen.c stonepack.c -lm -o $out/run.$$ && LONG=1 $out/run.$$
}
strong() {                                              # strong FOLDER...: 10,000 attempts, 2,000 random scenes
    # shellcheck disable=SC2046
    gcc -std=gnu99 -O2 -w -ffp-contract=off -fno-math-errno -Ibuild tests/instruments/friction.c port/host/run.c port/host/clock.c \
        $(echo port/host/files/*.c) -lm -o $out/friction &&
    gcc -std=c99 -O2 -w -ffp-contract=off -fno-math-errno -DSP_REAL_QUAD -D_XOPEN_SOURCE=700 -D_DEFAULT_SOURCE -include quadmath.h \
        '-DSP_SQRT(x)=sqrtq(x)' stonepack.c $(ls port/host/*.c port/host/*/*.c) tests/scenes/gen.c \
        -Wl,--no-as-needed -lquadmath -lm -o $out/quad &&
    python3 -B tests/checks/strong_cases.py build/stonepack "$@" --quad $out/quad --attack $out/friction --attempts 300 \
        --random 2000 --seed "$(date +%Y%m%d)"
}
case ${1:-} in
long_san | instrument | strong) "$@"; exit ;;
esac

if [ "$listed" ] || [ -f build/python/made ]; then
    line "1,000,000 random towers from Python against the closed form" \
        env PYTHONPATH=build/python python3 -B tests/python/towers.py 1000000 1
else skip "1,000,000 random towers from Python" python3; fi
line "all samples, ASan and UBSan" sh "$0" long_san gcc address,undefined
line "all samples, ASan and UBSan, float" sh "$0" long_san gcc address,undefined -DSP_REAL_FLOAT
if have clang; then
    line "all samples, clang's UBSan" sh "$0" long_san clang undefined
    line "all samples, clang's MSan, memory forgotten before each test" sh "$0" long_san clang memory
else skip "clang's UBSan and MSan" clang; fi
if [ "$listed" ] || /usr/bin/python3 -c 'import numpy, scipy.optimize' 2> /dev/null; then
    line "300 random scenes against linear programming" /usr/bin/python3 -B tests/oracle/random.py --seed "$(date +%Y%m%d)"
    for kind in strength loads supports masses; do
        line "200 random scenes, $kind, against linear programming" \
            /usr/bin/python3 -B tests/oracle/random.py --kind $kind --count 200 --seed "$(date +%Y%m%d)"
    done
    line "100 limits of joints with strength" \
        /usr/bin/python3 -B tests/oracle/random.py --kind strength --limits --count 100 --seed "$(date +%Y%m%d)"
    line "60 small coupled scenes against a search of another kind" \
        /usr/bin/python3 -B tests/oracle/coupled.py --count 60 --seed "$(date +%Y%m%d)"
else skip "random scenes against linear programming" "python3-numpy python3-scipy"; fi
if have g++; then line "battery: 20 samples of random rounding" sh "$0" instrument chance; else skip "random rounding" g++; fi
if have clang-19; then line "battery: shadows of 113 bits" sh "$0" instrument shadows
else skip "shadows of 113 bits" "clang-19 libclang-rt-19-dev"; fi
line "strong verdicts: 113 bits, attempts to move, 2,000 random scenes" \
    sh "$0" strong tests/scenes $(ls -d ../shared/cases ../shared/zoo 2> /dev/null)
if [ "$listed" ] || [ -d ../shared/cases ]; then
    line "cases: 113 bits" sh "$0" instrument cases-quad
    if have g++; then line "cases: two samples of random rounding" sh "$0" instrument cases-chance; fi
    if have clang-19; then line "cases: shadows of 113 bits" sh "$0" instrument cases-shadows; fi
    line "cases: coupled, every assembly in weaker forms and written otherwise" env EVERY=1 ONLY=cases sh tests/checks/check.sh
else lack "cases of known truth" ../shared/cases; fi
if have python3 && have tcc; then
    mutants='python3 -B tests/mutation/mutate.py --quiet --seed '$(date +%Y%m%d)
    # shellcheck disable=SC2086
    {
        line "300 mutants of the certificate check" $mutants --of proof --sample 300 --hashes --least 99
        line "constants of the certificate check in another size" $mutants --of proof --constants --least 100
        line "constants of the certificate check in another size, in float" $mutants --of proof --constants --float --least 100
        line "100 mutants of verify" $mutants --of verify --sample 100 --hashes --least 97
        line "200 mutants of limit" $mutants --of limit --sample 200 --hashes --least 85
        line "100 mutants of the core" $mutants --of core --guided --longest 400 --sample 100 --hashes --least 88
        line "60 mutants of the smallest build" $mutants --of small --sample 60 --least 75
    }
else skip "mutants" "python3 tcc"; fi
if have python3 && have clang-19 && have llvm-cov-19; then
    line "lines, branches, conditions of all folders" env LEAST=90 LEFT=compare sh tests/mutation/coverage.sh
else skip "coverage" "python3 clang-19 llvm-19 libclang-rt-19-dev"; fi
if have python3; then
    line "worker: 10,000 mutated requests, 500 timeouts, 400 clients that die" python3 -B tests/checks/worker.py build/stonepack --whole
else skip "worker campaign" python3; fi
if have clang; then
    for target in scene qp obj qps json blob; do
        line "campaign: $target, sanitized" env MORE=1 sh tests/fuzz/campaign.sh sanitized $target
        line "campaign: $target, optimised" env MORE=1 sh tests/fuzz/campaign.sh optimised $target
        line "campaign: $target, memory forgotten" env MORE=1 sh tests/fuzz/campaign.sh forgotten $target
    done
else skip "campaigns of any bytes" clang; fi
if have frama-c; then line "Frama-C Eva: arena, indices, kernels, certificate check" sh tests/eva/eva.sh
else skip "Frama-C Eva" frama-c-base; fi
# With its own bounds gcc had not come to an end of the whole library in 35 minutes, at 8 GB; with this one a minute, at 2.
line "gcc -fanalyzer, as far as it gets" sh tests/checks/analyze.sh gcc --param=analyzer-bb-explosion-factor=1 -DSP_SMALL -DSP_EXACT_ONLY
line "builds that leave parts out: every suite" env EVERY=1 ONLY=switches sh tests/checks/check.sh
line "switches in pairs from the pair and from the package" env EVERY=1 sh tests/checks/switches.sh
if have qemu-system-arm; then
    line "footprint: every row" sh port/board/footprint.sh --compare whole
    line "boards: all tests on all of them" sh port/board/boards.sh
else skip "footprint, boards" "qemu-system-arm"; fi

if [ "$listed" ]; then exit; fi
if [ $((passed + failed)) -eq 0 ] && [ -z "$skipped" ]; then
    echo "no line of nightly is called $only"
    exit 1
fi
total
