#!/bin/sh
# fuzz: any bytes into every reader and every question.
#
#     sh tests/fuzz/fuzz.sh [TARGET...]         libFuzzer with ASan and clang's UBSan, then those that ask the library alone with
#                                               MSan; FUZZ_SECONDS (30) of clock each; without clang as --quick
#     sh tests/fuzz/fuzz.sh --quick [TARGET...] a plain loop (loop.c): all targets with gcc's ASan and UBSan, then those that ask
#                                               the library alone, optimised; FUZZ_SECONDS (4) of processor each, 20,000 small
#                                               scenes; inputs that campaigns have kept, once each
# With `scene` a fault is put into the certificate check at the end, and must be found. Very many executions: campaign.sh.
#
#     scene   a small scene by port/fuzz, every question, its invariants          obj    scene files, JSON of COMPAS
#     qp      sp_qp_solve                                                         qps    files of quadratic programs
#     json    stored answers into `verify`                                        blob   requests and results of the worker
#
# Found inputs go to build/fuzz/, by the loop as small as they get and of `scene` as a scene file, too; run `build/fuzz/TARGET FILE`
# again. FUZZ_SEED: of what is drawn, the day if it is not given.
set -eu
. tests/fuzz/targets.sh
quick=
if [ "${1:-}" = --quick ]; then quick=1; shift; fi
targets=${*:-scene qp obj qps json blob}
seconds=${FUZZ_SECONDS:-}
seed=${FUZZ_SEED:-$(date +%Y%m%d)}
bad=0 passed=0

said() {                                                # said TARGET HOW: the last line of its log; counts
    if [ "$3" -eq 0 ]; then passed=$((passed + 1)); echo "ok      $1, $2: $(grep -oE '[0-9]+ executions|Done [0-9]+ runs' "$4" | tail -n 1)"
    else bad=$((bad + 1)); echo "FAILED  $1, $2"; grep -vE '^#[0-9]+' "$4" | head -n 30 | sed 's/^/        /'; fi
}
loop() {                                                # loop TARGET HOW PROGRAM SECONDS-OR-COUNTx: seeds, then that
    lo_status=0
    FOUND=$out/$1-found UBSAN_OPTIONS=halt_on_error=1 "$3" "$4" "$seed" $out/seeds/"$1"/* > "$out/$1.log" 2>&1 || lo_status=$?
    if [ $lo_status -ne 0 ] && [ "$1" = scene ] && as_scene $out/scene-found; then
        echo "as a scene: $out/scene-found.obj" >> "$out/$1.log"
    fi
    said "$1" "$2, seed $seed" $lo_status "$out/$1.log"
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
    gcc $plain tests/fuzz/to_obj.c port/fuzz/bytes.c port/host/files/obj_write.c port/host/files/text.c port/host/files/failure.c \
        build/libstonepack.a -lm -o $out/to_obj && $out/to_obj "$1" > "$1.obj" || return 1
    as_status=0
    build/stonepack check --quiet "$1.obj" > /dev/null || as_status=$?
    [ $as_status -le 2 ]
}
# The library with a fault put in, the resistance of contacts left out of what a motion proves: it must be found, and made small.
planted() {
    mkdir -p $out/planted
    rm -f $out/planted-found $out/planted-found.obj
    cp -r stonepack.c stonepack.h solvers $out/planted/
    sed -i 's/resist += cap \* P;/resist += 0 * P;/' $out/planted/solvers/proof/forces.c
    # shellcheck disable=SC2086
    ! cmp -s solvers/proof/forces.c $out/planted/solvers/proof/forces.c && gcc $plain -O1 -c $out/planted/stonepack.c -o $out/planted.o &&
        gcc $plain -O1 tests/fuzz/fuzz_scene.c port/fuzz/bytes.c tests/fuzz/loop.c $out/planted.o -lm -o $out/scene-planted &&
        ! FOUND=$out/planted-found $out/scene-planted 20000x 1 $out/seeds/scene/* > $out/planted.log 2>&1 &&
        [ "$(wc -c < $out/planted-found)" -le 60 ] && as_scene $out/planted-found
}

by_libfuzzer() {                                        # by_libfuzzer TARGET HOW: its end into TARGET-HOW.status
    by_status=0
    "$out/$2-$1" -max_total_time="${seconds:-30}" -timeout=60 -entropic=0 -seed="$seed" -rss_limit_mb=3000 -max_len=4000 \
        -artifact_prefix="$out/$1-" -print_final_stats=1 "$out/corpus/$1" "$out/seeds/$1" "$out/kept/$1" \
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

for t in $targets; do seeds "$t"; done
if [ -z "$quick" ] && command -v clang > /dev/null; then
    all=
    for t in $targets; do all="$all $t-sanitized"; done
    for t in $targets; do ! alone "$t" || all="$all $t-forgotten"; done
    for t in $targets; do unpack "$t"; mkdir -p "$out/corpus/$t"; done
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
    fresh build/asan.o || gcc $plain $san -c stonepack.c -o build/asan.o
    for t in $targets; do alone "$t" || { program $out/gcc gcc $san; break; }; done
    for t in $targets; do
        # shellcheck disable=SC2086
        link "$t" $out/gcc build/asan.o tests/fuzz/loop.c "$out/$t" gcc $san
        loop "$t" "ASan, UBSan" "$out/$t" "${seconds:-4}"
        kept "$t" "$out/$t"
    done
    [ -f build/stonepack.o ] || make -s build/stonepack.o > /dev/null
    for t in $targets; do
        alone "$t" || continue
        link "$t" '' build/stonepack.o tests/fuzz/loop.c "$out/$t-fast" gcc -O2
        case $t in scene) many=${seconds:-20000x} ;; *) many=${seconds:-4} ;; esac
        loop "$t" "optimised" "$out/$t-fast" "$many"
    done
fi
case " $targets " in *" scene "*)
    if planted; then passed=$((passed + 1)); echo "ok      a planted fault is found: $(tail -n 1 $out/planted.log)"
    else bad=$((bad + 1)); echo "FAILED  a planted fault is found"; cat $out/planted.log 2> /dev/null; fi ;;
esac
echo "$passed passed, $bad failed"
[ $bad -eq 0 ]
