#!/bin/sh
# corpus: builds and runs the corpus.      corpus.sh double|float COMPILER [FLAGS...] > one line per scene, then the number
#
#     LIBRARY=build/pair/stonepack.c    the library to build, default stonepack.c
#     STD=c11                           the language, default c99
#     DIFFER=1                          instead of printing, say where it differs from build/corpus-double.txt or -float.txt
set -eu
real=$1
shift
to=$(mktemp -d)
trap 'rm -rf "$to"' EXIT
case $real in float) set -- "$@" -DSP_REAL_FLOAT ;; esac
"$@" -std=${STD:-c99} -ffp-contract=off -fno-math-errno -Ibuild \
    tests/corpus/corpus.c tests/scenes/gen.c "${LIBRARY:-stonepack.c}" -lm -o "$to/corpus"
if [ "${DIFFER:-}" ]; then "$to/corpus" | diff "build/corpus-$real.txt" -; else "$to/corpus"; fi
