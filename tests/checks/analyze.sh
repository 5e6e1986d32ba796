#!/bin/sh
# analyze: what compilers and their like find by reading the library alone. Status 1 where they tell what is not listed.
#
#     analyze.sh gcc [FLAGS]...     gcc -fanalyzer, once for each; '' is the whole library, which takes minutes. What it says and
#                                   is wrong about is in analyzer.txt; the last line tells how many files were read, what was said
#     analyze.sh clang-tidy         in double, in float and SP_SMALL; deviations are in clang-tidy.yaml
set -eu
LC_ALL=C
export LC_ALL
out=build/analyze
mkdir -p $out
how=$1
shift
case $how in
gcc)
    for flags; do
        # shellcheck disable=SC1003,SC2086
        gcc -std=c99 -MM $flags stonepack.c | tr -d '\\' | tr ' ' '\n' | grep '\.c$' >> $out/read.$$
        # shellcheck disable=SC2086
        gcc -std=c99 -O1 -fanalyzer -Wanalyzer-too-complex $flags -c stonepack.c -o $out/analyzed.o 2>> $out/said.$$ ||
            { cat $out/said.$$; exit 1; }
    done
    sed -n 's/^\([^:]*\):[0-9]*:[0-9]*: warning: \(.*\)$/\1: \2/p' $out/said.$$ > $out/told.$$
    rm $out/said.$$
    grep -v 'too-complex' $out/told.$$ | sed 's/ \[CWE-[0-9]*\]//; s/ \[-W[a-z-]*\]$//' | sort -u > $out/new.$$ || :
    grep -v '^#' tests/checks/analyzer.txt | sed 's/ :: .*//' | sort -u | comm -13 - $out/new.$$ > $out/left.$$
    cat $out/left.$$
    bad=$(wc -l < $out/left.$$)
    echo "$# builds of $(sort -u $out/read.$$ | wc -l) files: $(wc -l < $out/new.$$) remarks, $bad not listed;" \
        "gave up $(grep -c 'too-complex' $out/told.$$ || :) times in the middle of a function"
    rm -f $out/*.$$
    [ "$bad" -eq 0 ] ;;
clang-tidy)
    tidy() {
        to=$1
        shift
        clang-tidy --quiet --config-file=tests/checks/clang-tidy.yaml ${to:+"$to"} stonepack.c -- -std=c99 "$@" || exit 1
    }
    tidy ''
    tidy --checks=-bugprone-branch-clone -DSP_REAL_FLOAT        # some constants differ in double alone
    tidy '' -DSP_SMALL ;;
esac
