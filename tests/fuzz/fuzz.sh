#!/bin/sh
# fuzz: any bytes into every reader and every question.
#
#     sh tests/fuzz/fuzz.sh [TARGET...]         libFuzzer with ASan and clang's UBSan, FUZZ_SECONDS (30) of clock each, then
#                                               with MSan: those that ask the library alone as long again, readers a fifth of
#                                               their time; without clang as --quick. FUZZ_HOW=sanitized or
#                                               forgotten: with one of these alone, all the time each
#     sh tests/fuzz/fuzz.sh --quick [TARGET...] a plain loop (loop.c): all targets with gcc's ASan and UBSan, then those that
#                                               ask the library alone, optimised; FUZZ_SECONDS (4) of processor each, 20,000
#                                               scenes; inputs that campaigns have kept, once each; AFL++, AFL_SECONDS (3) each
# With `scene` three faults are put into the certificate check at the end, and must be found. Very many executions: campaign.sh.
#
#     scene   a small scene by port/fuzz, every question, its invariants          obj    scene files, JSON of COMPAS
#     qp      sp_qp_solve                                                         qps    files of quadratic programs
#     json    stored answers into `verify`                                        blob   requests and results of the worker
#
# Found inputs go to build/fuzz/, by the loop as small as they get and of `scene` as a scene file, too; run
# `build/fuzz/TARGET FILE` again. FUZZ_SEED: of what is drawn, the day if it is not given.
set -eu
. tests/fuzz/targets.sh
quick=
if [ "${1:-}" = --quick ]; then quick=1; shift; fi
targets=${*:-scene qp obj qps json blob}
seconds=${FUZZ_SECONDS:-}
seed=${FUZZ_SEED:-$(date +%Y%m%d)}
bad=0 passed=0

said() {                                                # said TARGET HOW: the last line of its log; counts
    if [ "$3" -eq 0 ]; then
        passed=$((passed + 1))
        echo "ok      $1, $2: $(grep -oE '[0-9]+ executions|Done [0-9]+ runs' "$4" | tail -n 1)"
    else bad=$((bad + 1)); echo "FAILED  $1, $2"; grep -vE '^#[0-9]+' "$4" | head -n 30 | sed 's/^/        /'; fi
}
# Of 20,000 scenes each invariant was asked of 1,000 at least, each other question 500 times; of verdicts at most one in a
# thousand is undecided, decided in one way only, or within tol of a limit.
asked() {                                               # asked LOG: says so; counts
    as_status=0
    awk '$1 == "invariant" || $1 == "question" {
             k = $1; n[k]++
             if (n[k] == 1 || $2 < least[k]) least[k] = $2
             if ($2 > most[k]) most[k] = $2
             if ($2 < (k == "invariant" ? 1000 : 500)) { print "asked too rarely: " $0; bad = 1 } }
         $1 == "verdicts" {
             told = $0; gsub(/ +/, " ", told)
             all = $2 + $4 + $6; odd = $6 + $8 + $13; if (1000 * odd > all) bad = 1 }
         END { if (!all || n["invariant"] < 7) { print "not told what was asked"; exit 1 }
               printf "%d invariants of %d to %d scenes, ", n["invariant"], least["invariant"], most["invariant"]
               printf "%d questions of %d to %d; %s\n", n["question"], least["question"], most["question"], told
               exit bad }' "$1" > "$1.asked" || as_status=$?
    if [ $as_status -eq 0 ]; then passed=$((passed + 1)); echo "ok      $(cat "$1.asked")"
    else bad=$((bad + 1)); echo "FAILED  what was asked"; cat "$1.asked"; fi
}
loop() {                                                # loop TARGET HOW PROGRAM SECONDS-OR-COUNTx FILE...: seeds, then that
    lo_t=$1 lo_how=$2 lo_prog=$3 lo_many=$4 lo_status=0
    shift 4
    FOUND=$out/$lo_t-found UBSAN_OPTIONS=halt_on_error=1 "$lo_prog" "$lo_many" "$seed" $out/seeds/"$lo_t"/* "$@" \
        > "$out/$lo_t.log" 2>&1 || lo_status=$?
    if [ $lo_status -ne 0 ] && [ "$lo_t" = scene ] && as_scene $out/scene-found; then
        echo "as a scene: $out/scene-found.obj" >> "$out/$lo_t.log"
    fi
    said "$lo_t" "$lo_how, seed $seed" $lo_status "$out/$lo_t.log"
    case $lo_t,$lo_many,$lo_status in scene,20000x,0) asked $out/scene.log ;; esac
}
kept() {                                                # kept TARGET PROGRAM: each input that campaigns have kept, once
    unpack "$1"
    find "$out/kept/$1" -type f > "$out/$1-kept.txt"
    if [ ! -s "$out/$1-kept.txt" ]; then return; fi
    ke_status=0
    xargs -n 200 "$2" < "$out/$1-kept.txt" > "$out/$1-kept.log" 2>&1 || ke_status=$?
    echo "$(wc -l < "$out/$1-kept.txt") executions" >> "$out/$1-kept.log"
    said "$1" "kept inputs, ASan, UBSan" $ke_status "$out/$1-kept.log"
}
as_scene() {                                            # as_scene FILE: what was found as a scene file, which the program reads
    make -s build/libstonepack.a build/stonepack > /dev/null
    # shellcheck disable=SC2086
    gcc $plain tests/fuzz/to_obj.c port/fuzz/bytes.c port/host/files/obj_write.c port/host/files/text.c \
        port/host/files/failure.c build/libstonepack.a -lm -o $out/to_obj && $out/to_obj "$1" > "$1.obj" || return 1
    as_status=0
    build/stonepack check --quiet "$1.obj" > /dev/null || as_status=$?
    [ $as_status -le 2 ]
}
# The library with a fault put in, by sed of one line of the certificate check: it must be found, and made small.
planted() {                                             # planted FOLDER SED FILE: its end into FOLDER.status
    rm -rf "$1" "$1"-found*
    mkdir -p "$1"
    cp -r stonepack.c stonepack.h solvers "$1"
    sed -i "$2" "$1/solvers/proof/$3"
    pl_status=0
    # shellcheck disable=SC2086
    { ! cmp -s "solvers/proof/$3" "$1/solvers/proof/$3" && gcc $plain -c "$1/stonepack.c" -o "$1.o" &&
        gcc $plain -O1 tests/fuzz/fuzz_scene.c port/fuzz/bytes.c tests/fuzz/loop.c "$1.o" -lm -o "$1/scene" &&
        ! FOUND=$1-found "$1/scene" 20000x 1 $out/seeds/scene/* > "$1.log" 2>&1 &&
        [ "$(wc -c < "$1-found")" -le 60 ]; } || pl_status=1
    echo $pl_status > "$1.status"
}
found() {                                               # found FOLDER WHAT: counts
    if [ "$(cat "$1.status")" -eq 0 ] && as_scene "$1-found"; then
        passed=$((passed + 1)); echo "ok      a planted fault is found, $2: $(tail -n 1 "$1.log")"
    else bad=$((bad + 1)); echo "FAILED  a planted fault is found, $2"; tail -n 40 "$1.log" 2> /dev/null; fi
}

by_libfuzzer() {                                        # by_libfuzzer TARGET HOW: its end into TARGET-HOW.status
    by_status=0 by_seconds=${seconds:-30}
    by_share=$(((by_seconds + 4) / 5))
    alone "$1" || [ "${FUZZ_HOW:-}" ] || case $2 in forgotten) by_seconds=$by_share ;; *) by_seconds=$((by_seconds - by_share)) ;; esac
    [ $by_seconds -gt 0 ] || by_seconds=1               # libFuzzer takes 0 for ever
    FUZZ_SOME=1 "$out/$2-$1" -max_total_time="$by_seconds" -timeout=60 -entropic=0 -seed="$seed" -rss_limit_mb=3000 \
        -max_len=4000 -artifact_prefix="$out/$1-" -print_final_stats=1 "$out/corpus/$1" "$out/seeds/$1" "$out/kept/$1" \
        > "$out/$1-$2.log" 2>&1 || by_status=$?
    echo $by_status > "$out/$1-$2.status"
}
side_by_side() {                                        # side_by_side TARGET-HOW...: as many at once as there are cores
    si_n=0
    rm -f $out/*.status
    for si in "$@"; do
        by_libfuzzer "${si%-*}" "${si#*-}" &
        si_n=$((si_n + 1))
        if [ $((si_n % $(nproc 2> /dev/null || echo 1))) -eq 0 ]; then wait; fi
    done
    wait
}

# AFL++, with its own instruments and driver, built in seconds (-O0) as it runs for seconds; what crashes or hangs is in
# build/fuzz/afl/TARGET/default.
by_afl() {                                              # by_afl TARGET
    rm -rf "$out/afl/$1" "$out/afl/in-$1"
    mkdir -p "$out/afl/in-$1"
    cp $out/seeds/"$1"/* "$out/afl/in-$1/" 2> /dev/null || printf '                ' > "$out/afl/in-$1/blanks"
    link "$1" $out/afl/o $out/afl/stonepack.o '' "$out/afl/fuzz-$1" afl-clang-fast -O0 -fsanitize=fuzzer
    FUZZ_SOME=1 AFL_SKIP_CPUFREQ=1 AFL_I_DONT_CARE_ABOUT_MISSING_CRASHES=1 AFL_NO_AFFINITY=1 AFL_NO_UI=1 AFL_FAST_CAL=1 \
        afl-fuzz -s 1 -V "${AFL_SECONDS:-3}" -t 20000 -i "$out/afl/in-$1" -o "$out/afl/$1" -- "$out/afl/fuzz-$1" \
        > "$out/afl/$1.log" 2>&1 || :
    awk -F ' *: *' '$1 == "execs_done" { n = $2 } $1 ~ /^saved_(crashes|hangs)$/ && $2 > 0 { bad = 1; print $0 }
                    END { print n + 0 " executions"; exit bad || !n }' "$out/afl/$1/default/fuzzer_stats" >> "$out/afl/$1.log"
}
afl() {
    mkdir -p $out/afl/o
    # shellcheck disable=SC2086
    fresh $out/afl/stonepack.o || afl-clang-fast $plain -O0 -c stonepack.c -o $out/afl/stonepack.o > /dev/null 2>&1
    for t in $targets; do alone "$t" || { program $out/afl/o afl-clang-fast -O0 > /dev/null 2>&1; break; }; done
    for t in $targets; do
        af_status=0
        by_afl "$t" > "$out/afl/$t.build" 2>&1 || af_status=$?
        said "$t" 'AFL++' $af_status "$out/afl/$t.log"
    done
}

for t in $targets; do seeds "$t"; done
if [ -z "$quick" ] && command -v clang > /dev/null; then
    all=
    for t in $targets; do all="$all $t-${FUZZ_HOW:-sanitized}"; done
    if [ -z "${FUZZ_HOW:-}" ]; then
        for t in $targets; do ! alone "$t" || all="$all $t-forgotten"; done
        for t in $targets; do alone "$t" || all="$all $t-forgotten"; done
    fi
    for t in $targets; do unpack "$t"; mkdir -p "$out/corpus/$t"; done
    # shellcheck disable=SC2086
    libraries $all
    for a in $all; do guided "${a%-*}" "${a#*-}"; done
    # shellcheck disable=SC2086
    side_by_side $all
    for a in $all; do
        case $a in *-sanitized) how='ASan, UBSan' ;; *) how=MSan ;; esac
        said "${a%-*}" "libFuzzer, $how" "$(cat "$out/$a.status")" "$out/$a.log"
    done
else
    san='-O1 -g -fsanitize=address,undefined -fno-sanitize-recover=all'
    # shellcheck disable=SC2086
    fresh build/asan.o || gcc $plain $san -fPIC -c stonepack.c -o build/asan.o
    for t in $targets; do alone "$t" || { program $out/gcc gcc $san; break; }; done
    for t in $targets; do
        # shellcheck disable=SC2086
        link "$t" $out/gcc build/asan.o tests/fuzz/loop.c "$out/$t" gcc $san
        export FUZZ_SOME=1                              # more scenes, of each a part of what can be asked
        loop "$t" "ASan, UBSan" "$out/$t" "${seconds:-4}"
        unset FUZZ_SOME
        kept "$t" "$out/$t"
    done
    fresh build/stonepack.o || make -s build/stonepack.o > /dev/null
    for t in $targets; do
        alone "$t" || continue
        link "$t" '' build/stonepack.o tests/fuzz/loop.c "$out/$t-fast" gcc -O2
        case $t in scene) many=${seconds:-20000x} ;; *) many=${seconds:-4} ;; esac
        find "$out/kept/$t" -type f | LC_ALL=C sort > "$out/$t-kept.txt"
        # shellcheck disable=SC2046
        loop "$t" "optimised" "$out/$t-fast" "$many" $(cat "$out/$t-kept.txt")
    done
    if ! command -v afl-clang-fast > /dev/null || ! command -v afl-fuzz > /dev/null; then echo "skipped AFL++: needs afl++"
    else afl; fi
fi
case " $targets " in *" scene "*)
    planted $out/planted-1 's/resist += cap \* P;/resist += 0 * P;/' forces.c &
    planted $out/planted-2 's/sp__ratio(sp__norm3(row + 3), Si)/0/' forces.c &
    planted $out/planted-3 's/return worst < SP__HUGE ? worst : SP__HUGE;/return 0;/' triple.c &
    wait
    found $out/planted-1 'a motion that contacts resist'
    found $out/planted-2 'moments that nothing balances'
    found $out/planted-3 'motions that explain no forces' ;;
esac
echo "$passed passed, $bad failed"
[ $bad -eq 0 ]
