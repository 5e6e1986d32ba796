# targets: what the targets of tests/fuzz need to be built: seeds, objects, one program each. Read by fuzz.sh and campaign.sh.
# shellcheck shell=sh disable=SC2034
out=build/fuzz
mkdir -p $out
host="$(ls port/host/*.c port/host/*/*.c | grep -v /main.c | tr '\n' ' ') tests/scenes/gen.c"
plain='-std=c99 -D_GNU_SOURCE -ffp-contract=off -fno-math-errno -w'

seeds() {                                               # seeds TARGET: a folder of them, and of what campaigns have kept
    mkdir -p "$out/seeds/$1" "$out/kept/$1"
    case $1 in
    obj) cp tests/scenes/two-cubes.obj tests/scenes/h-model.obj tests/scenes/arch.obj tests/examples/doorway.json \
             "$out/seeds/obj" 2> /dev/null || :
         sed '/^#@ interface/d' tests/scenes/two-cubes.obj > "$out/seeds/obj/beside"
         printf '#beside\n#@ mu 0.5\no b0\n#@ density 2000\n#@ fixed\n' >> "$out/seeds/obj/beside" ;;
    qps) cp tests/fuzz/seeds/qps/* "$out/seeds/qps" ;;
    json) [ ! -x build/stonepack ] ||
              build/stonepack check --json --forces tests/scenes/two-cubes.obj > "$out/seeds/json/two-cubes" || : ;;
    *) cp tests/fuzz/seeds/scene/* "$out/seeds/$1" ;;
    esac
}
needs() { case $1 in scene) echo port/fuzz/bytes.c ;; qp) ;; blob) echo "port/fuzz/bytes.c" ;; esac; }
alone() { case $1 in scene | qp) true ;; *) false ;; esac; }

# Objects of the program, compiled once for all targets that read files.
program() {                                             # program FOLDER COMPILER FLAGS...
    pr_to=$1
    shift
    mkdir -p "$pr_to"
    # shellcheck disable=SC2012
    pr_h=$(ls -t stonepack.h port/*/*.h port/host/*/*.h settle/*.h tests/scenes/*.h | head -n 1)        # the newest header
    for pr_c in $host; do
        pr_o=$pr_to/$(echo "$pr_c" | tr / _ | sed 's/c$/o/')
        [ "$pr_o" -nt "$pr_c" ] && [ "$pr_o" -nt "$pr_h" ] && continue
        # shellcheck disable=SC2086
        printf '%s\0' "$* $plain -c $pr_c -o $pr_o"
    done | xargs -0 -P "$(nproc 2> /dev/null || echo 1)" -I{} sh -c '{}'
}
link() {                                                # link TARGET PROGRAM LIBRARY DRIVER OUTPUT COMPILER FLAGS...
    li_t=$1 li_prog=$2 li_lib=$3 li_drive=$4 li_out=$5
    shift 5
    li_more=
    alone "$li_t" || li_more=$(ls "$li_prog"/*.o | tr '\n' ' ')
    # shellcheck disable=SC2086,SC2046
    "$@" $plain "tests/fuzz/fuzz_$li_t.c" $(needs "$li_t") $li_drive $li_more "$li_lib" -lm -o "$li_out"
}
# fresh OBJECT: is it newer than all of the library?
fresh() { [ -f "$1" ] && [ -z "$(find stonepack.c stonepack.h solvers -newer "$1" -name '*.[ch]' | head -n 1)" ]; }

# For libFuzzer: sanitized by ASan and clang's UBSan; forgotten, memory that nobody has written, by MSan; or optimised.
flags() {
    case $1 in
    sanitized) echo '-O1 -g -fsanitize=address,undefined -fno-sanitize-recover=all' ;;
    forgotten) echo '-O1 -g -fsanitize=memory -fno-sanitize-recover=all' ;;
    *) echo '-O2 -g' ;;
    esac
}
# shellcheck disable=SC2046,SC2086
library() { fresh "$out/$1.o" || clang $(flags "$1") -fsanitize=fuzzer-no-link $plain -c stonepack.c -o "$out/$1.o"; }
# libraries TARGET-HOW...: what they need of the library, side by side.
libraries() {
    for li_how in sanitized forgotten; do case " $* " in *"-$li_how "*) library $li_how & ;; esac; done
    wait
}
# shellcheck disable=SC2046,SC2086
guided() {                                              # guided TARGET HOW: build/fuzz/HOW-TARGET
    library "$2"
    alone "$1" || program "$out/$2" clang $(flags "$2") -fsanitize=fuzzer-no-link
    link "$1" "$out/$2" "$out/$2.o" '' "$out/$2-$1" clang $(flags "$2") -fsanitize=fuzzer
}
# unpack TARGET: what campaigns have kept, a line in base64 each, as files.
unpack() {
    mkdir -p "$out/kept/$1"
    if [ ! -f "tests/fuzz/kept/$1" ] || [ "$out/kept/$1.done" -nt "tests/fuzz/kept/$1" ]; then return; fi
    rm -f "$out/kept/$1"/*
    un_n=0
    while read -r un_line; do
        un_n=$((un_n + 1))
        printf %s "$un_line" | base64 -d > "$out/kept/$1/$un_n"
    done < "tests/fuzz/kept/$1"
    touch "$out/kept/$1.done"
}
