#!/bin/sh
# analyze: what compilers and their like find by reading alone. Status 1 where they tell what is not listed.
#
#     analyze.sh gcc [FLAGS]...     gcc -fanalyzer, once for each; '' is the whole library: more than half an hour. What it says
#                                   and is wrong about is in analyzer.txt; the last line tells how many files were read and what
#                                   was said
#     analyze.sh gcc-program        gcc -fanalyzer over the program (port/host), which reads what may be hostile, file by file
#     analyze.sh clang-tidy         the library in double, in float and SP_SMALL; the program and settle; deviations are in
#                                   clang-tidy.yaml
#     analyze.sh cppcheck           library, program and settle; deviations are in cppcheck.txt
set -eu
LC_ALL=C
export LC_ALL
out=build/analyze
mkdir -p $out
how=$1
shift
program=$(ls port/host/*.c port/host/*/*.c)
# What gcc has said in said.$$: of how many files, by how many runs; status 1 where it is not listed.
told() {                                                # told WHAT
    sed -n 's/^\([^:]*\):[0-9]*:[0-9]*: warning: \(.*\)$/\1: \2/p' $out/said.$$ > $out/told.$$
    grep -v 'too-complex' $out/told.$$ | sed 's/ \[CWE-[0-9]*\]//; s/ \[-W[a-z-]*\]$//' | sort -u > $out/new.$$ || :
    grep -v '^#' tests/checks/analyzer.txt | sed 's/ :: .*//' | sort -u | comm -13 - $out/new.$$ > $out/left.$$
    cat $out/left.$$
    bad=$(wc -l < $out/left.$$)
    echo "$1: $(wc -l < $out/new.$$) remarks, $bad not listed;" \
        "gave up $(grep -c 'too-complex' $out/told.$$ || :) times in the middle of a function"
    rm -f $out/*.$$
    [ "$bad" -eq 0 ]
}
case $how in
gcc)
    for flags; do
        # shellcheck disable=SC1003,SC2086
        gcc -std=c99 -MM $flags stonepack.c | tr -d '\\' | tr ' ' '\n' | grep '\.c$' >> $out/read.$$
        # shellcheck disable=SC2086
        gcc -std=c99 -O1 -fanalyzer -Wanalyzer-too-complex $flags -c stonepack.c -o $out/analyzed.o 2>> $out/said.$$ ||
            { cat $out/said.$$; exit 1; }
    done
    told "$# builds of $(sort -u $out/read.$$ | wc -l) files" ;;
gcc-program)
    for file in $program; do
        gcc -std=c99 -O1 -fanalyzer -Wanalyzer-too-complex -c "$file" -o $out/analyzed.o 2>> $out/said.$$ ||
            { cat $out/said.$$; exit 1; }
    done
    told "$(echo "$program" | wc -l) files" ;;
clang-tidy)
    tidy() {
        to=$1
        shift
        clang-tidy --quiet --config-file=tests/checks/clang-tidy.yaml ${to:+"$to"} stonepack.c -- -std=c99 "$@" || exit 1
    }
    tidy ''
    tidy --checks=-bugprone-branch-clone -DSP_REAL_FLOAT        # some constants differ in double alone
    tidy '' -DSP_SMALL
    program_leaves_out=$(sed -n 's/^# PROGRAM: //p' tests/checks/clang-tidy.yaml | tr -d '\n')
    # shellcheck disable=SC2086
    clang-tidy --quiet --config-file=tests/checks/clang-tidy.yaml --checks="$program_leaves_out" $program settle/*.c \
        -- -std=c99 2> $out/tidy.$$ || { cat $out/tidy.$$; exit 1; }
    rm $out/tidy.$$ ;;
cppcheck)
    sed '/^#/d; s/ :: .*//' tests/checks/cppcheck.txt > $out/cppcheck.$$
    check() {
        cppcheck -q --std=c99 --error-exitcode=1 --enable=warning,portability --suppressions-list=$out/cppcheck.$$ \
            --suppress=missingInclude --suppress=missingIncludeSystem "$@" || exit 1
    }
    check stonepack.c                                   # in up to 12 configurations
    # shellcheck disable=SC2086
    check -D__linux__ -DWITH_BULLET $program settle/*.c # in this one: 7 s, in all it finds 73
    rm $out/cppcheck.$$ ;;
esac
