#!/bin/sh
# coverage: which lines, branches and conditions of the library do its own tests reach? By clang-19 and llvm-19.
#
#     coverage.sh [SUITE...]     these suites, else all that need no program
#
# A row a folder of solvers/: lines, branch outcomes and MC/DC, that is conditions of && and || shown to decide alone, each as
# covered/all, but for those that a switch of the build decides. White-box suites include parts of the library, some by parts.h:
# what one of them covers counts as covered.
#
#     OF=proof       this folder alone;  LEFT=1: its conditions that are left, too
#     LEFT=compare   exit status 1 where conditions are left that left.txt does not argue; tells what it argues and is no longer left
#     LEAST=95       exit status 1 where fewer per cent of the conditions of what is told are covered
set -eu
out=build/coverage
mkdir -p $out
rm -f $out/*.profraw
where() { ls tests/*/test_"$1".c; }
if [ $# -eq 0 ]; then
    # shellcheck disable=SC2046
    set -- $(ls tests/*/test_*.c | grep -vE 'tests/(host|settle)/' | sed 's|.*/test_\(.*\)\.c|\1|')
fi
plain='-std=c99 -ffp-contract=off -fno-math-errno -w'
cover='-O0 -fprofile-instr-generate -fcoverage-mapping -fcoverage-mcdc'
stems='' sources='stonepack.c tests/run.c tests/scenes/gen.c'
for s; do stems="$stems X($s)" sources="$sources $(where "$s")"; done

# The library and what includes parts of it are measured, all else is only compiled.
for c in $sources; do
    o=$out/$(echo "$c" | tr / _).o
    how="gcc $plain -O0"
    if [ "$c" = stonepack.c ] || grep -qE '^#include "(../../solvers/|parts.h)' "$c"; then how="clang-19 $plain $cover"; fi
    if [ "$c" != tests/run.c ] && [ "$o" -nt "$c" ] && [ -z "$(find solvers stonepack.h tests/test.h tests/*/*.h -newer "$o")" ]; then continue; fi
    printf '%s\0' "$how -DTEST_SUITES='$stems' -c $c -o $o"
done | xargs -0 -P "$(nproc 2> /dev/null || echo 1)" -I{} sh -c '{}' 2> $out/warnings.txt
# shellcheck disable=SC2046
clang-19 -fprofile-instr-generate $(for c in $sources; do echo $out/"$(echo "$c" | tr / _)".o; done) -lm -o $out/run
LLVM_PROFILE_FILE=$out/run.profraw $out/run > $out/said.txt || { grep -A 5 FAILED $out/said.txt; exit 1; }
llvm-profdata-19 merge -sparse $out/run.profraw -o $out/run.profdata
llvm-cov-19 export $out/run -instr-profile=$out/run.profdata > $out/run.json
OF=${OF:-} LEFT=${LEFT:-} LEAST=${LEAST:-0} python3 -B tests/mutation/coverage.py $out/run.json
