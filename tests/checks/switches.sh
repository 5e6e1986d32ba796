#!/bin/sh
# switches: every switch and every pair of them compiles without a warning, links all calls there are, and answers or refuses;
# pairs that contradict each other stop at one #error that names both. From the tree; each alone, and with EVERY=1 in pairs, from
# the pair and from the package, which are made of the same files.
#
#     sh tests/checks/switches.sh [SWITCH]...           default: all; with arguments only sets in which one of them is
#
#     TCC     a quick compiler for pair and package, where it is there; CC (gcc), which warns, for the tree
. tests/checks/tally.sh
out=build/switches
mkdir -p $out
features='SP_NO_IPM SP_NO_PLAN SP_NO_CRA SP_NO_STRONG SP_NO_SLIDING SP_NO_ADMM SP_NO_DYKSTRA SP_NO_QP SP_QP_ONLY SP_QP_NO_CG SP_QP_NO_POLISH SP_QP_NO_INTERIOR SP_SMALL SP_EXACT_ONLY SP_REAL_MIXED'
contradict='SP_NO_QP+SP_QP_ONLY SP_QP_ONLY+SP_EXACT_ONLY SP_REAL_MIXED+SP_REAL_FLOAT SP_REAL_FLOAT+SP_REAL_QUAD'
CC=${CC:-gcc}
TCC=${TCC:-$(command -v tcc || echo "$CC")}

# Sets of one and of two, as A and A+B, in the order of `features`.
sets() {
    echo "$features" | awk -v only="$*" '
        function wanted(a, b,   k, n, o) { n = split(only, o, " "); for (k = 1; k <= n; k++) if (o[k] == a || o[k] == b) return 1; return !n }
        { for (i = 1; i <= NF; i++) { if (wanted($i, "")) print $i; for (j = i + 1; j <= NF; j++) if (wanted($i, $j)) print $i "+" $j } }'
}
flags() { echo "-D$1" | sed 's/+/ -D/'; }

# The calls that FOLDER/stonepack.h declares in a build, each on a line CALL(name).
calls() {                                               # calls FOLDER FLAGS...
    c_folder=$1
    shift
    $TCC -E -P "$@" -I"$c_folder" $out/header.c | tr '\n;' ' \n' | sed -n 's/^.*extern [^(]*[ *]\(sp_[a-z0-9_]*\)(.*/CALL(\1)/p' > $out/calls.h
    [ -s $out/calls.h ] || { echo "no calls in $c_folder/stonepack.h"; return 1; }
}
answers() {                                             # answers LIBRARY.o FOLDER FLAGS...
    a_library=$1 a_folder=$2
    shift 2
    $TCC "$@" -I"$a_folder" -I$out -c tests/checks/switches.c -o $out/program.o &&
    $CC $out/program.o "$a_library" -lm -o $out/program && $out/program
}
# Everything of one set, compiled by the tree's compiler with warnings or quickly from a folder's stonepack.c.
tree() {                                                # tree FLAGS...
    calls . "$@" && warned "$@" && answers $out/tree.o . "$@"
}
# A pair of features by clang, whose warnings come from the text alone and tell of what is not used, too, in a quarter of gcc's time.
warned() {
    if [ $# -eq 2 ] && [ "$2" != -DSP_REAL_FLOAT ] && command -v clang > /dev/null; then
        clang -std=c99 -Wall -Wextra -Werror -fsyntax-only "$@" stonepack.c && $TCC "$@" -c stonepack.c -o $out/tree.o
    else $CC -std=c99 -O0 -Wall -Wextra -Werror "$@" -c stonepack.c -o $out/tree.o; fi
}
copy() {                                                # copy FOLDER FLAGS...
    y_folder=$1
    shift
    calls "$y_folder" "$@" && $TCC "$@" -I"$y_folder" -c "$y_folder/stonepack.c" -o $out/copy.o && answers $out/copy.o "$y_folder" "$@"
}
all_of() {                                              # all_of COMMAND [FOLDER]: over $chosen
    bad=0
    for set in $chosen; do
        case " $contradict " in *" $set "*) continue ;; esac
        # shellcheck disable=SC2046
        "$@" $(flags "$set") > $out/said.txt 2>&1 || { echo "$set:"; head -n 5 $out/said.txt; bad=1; }
    done
    return $bad
}
# One #error and nothing else, which names both.
stops() {                                               # stops A+B STONEPACK.c
    # shellcheck disable=SC2046
    $CC -std=c99 $(flags "$1") -c "$2" -o $out/none.o 2> $out/said.txt && { echo "$1 compiles"; return 1; }
    [ "$(grep -c 'error' $out/said.txt)" -le 2 ] && [ "$(grep -c 'error: #error' $out/said.txt)" -eq 1 ] &&
    grep 'error: #error' $out/said.txt | grep "${1%+*}" | grep -q "${1#*+}" || { cat $out/said.txt; return 1; }
}
all_stop() {
    for set in $contradict; do stops "$set" stonepack.c && stops "$set" $out/pair/stonepack.c || return 1; done
}
floats() { for set in $features; do [ "$set" = SP_REAL_MIXED ] || tree "-D$set" -DSP_REAL_FLOAT || { echo "$set, float"; return 1; }; done; }

echo '#include "stonepack.h"' > $out/header.c
sh port/pair/pair.sh stonepack.c $out/pair || exit 1
sh port/package/package.sh $out/package || exit 1
chosen=$(sets "$@")
count=$(echo "$chosen" | wc -l)
part "switches: contradictory pairs stop at one #error" all_stop
part "switches: the header's table is that of footprint.csv" sh port/board/switches.sh --check
part "switches: $count sets from the tree, no warning" all_of tree
if [ -z "${EVERY:-}" ]; then
    chosen=$(echo "$chosen" | grep -v +)
    count=$(echo "$chosen" | wc -l)
fi
part "switches: $count sets from the pair" all_of copy $out/pair
part "switches: $count sets from the package" all_of copy $out/package/src
[ $# -gt 0 ] || part "switches: each alone in float" floats
total
