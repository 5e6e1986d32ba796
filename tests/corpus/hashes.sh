#!/bin/sh
# hashes: evidence, work and bytes of check, limit, coupled and sequence on the corpus, in four builds.
#
#     sh tests/corpus/hashes.sh                         says what differs from tests/corpus/hashes.txt, in words; 1 if anything does
#     sh tests/corpus/hashes.sh --write                 stores them anew; the commit says which moved and why
#     sh tests/corpus/hashes.sh --each [BUILD]          a line for each scene, to compare by diff
#
#     CC, CFLAGS (-O1)      compiler and flags        LIBRARY   the library, default stonepack.c        BUILDS  of: double float mixed small
set -eu
stored=tests/corpus/hashes.txt
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT
mkdir -p build
[ -f build/scenes.h ] || awk -f tests/corpus/scenes.awk tests/scenes/*.obj > build/scenes.h

hashes() {                                              # hashes BUILD [each]: its lines, the build's name before each
    case $1 in double) flag= ;; float) flag=-DSP_REAL_FLOAT ;; mixed) flag=-DSP_REAL_MIXED ;; small) flag=-DSP_SMALL ;; esac
    # shellcheck disable=SC2086
    ${CC:-gcc} -std=c99 ${CFLAGS:--O1} -ffp-contract=off -fno-math-errno $flag -Ibuild tests/corpus/hashes.c tests/scenes/gen.c \
        "${LIBRARY:-stonepack.c}" -lm -o "$work/$1"
    "$work/$1" ${2:+"$2"} | sed "s/^/$1 /"
}
all() { for build in ${BUILDS:-double float mixed small}; do hashes "$build" ${1:+"$1"}; done; }

case ${1:-} in
--write) { echo "build question evidence work bytes"; all; } > "$work/new" && cp "$work/new" $stored ;;
--each) BUILDS=${2:-${BUILDS:-double}} all each ;;
*)  all > "$work/now"
    awk 'NR == FNR { if (FNR > 1) { for (k = 3; k <= 5; k++) was[$1, $2, k] = $k } next }
         BEGIN { name[3] = "evidence"; name[4] = "work"; name[5] = "bytes" }
         { for (k = 3; k <= 5; k++) if (was[$1, $2, k] != $k) { print $1, $2 ": " name[k] " moved"; bad = 1 } n++ }
         END { if (!bad) print n " answers as they were: evidence, work, bytes"; exit bad }' $stored "$work/now" ;;
esac
