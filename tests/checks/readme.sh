#!/bin/sh
# readme: README.md shows what happens.      readme.sh [build/stonepack]
#
# Its first C block is a program. Its console blocks are run in a folder where that program is arch.c: the first one must say
# what README says, the others the same but for times, memory (pointers are of the host), powers of ten, and digits of a search
# beyond the fifth.
# Its links lead somewhere.
. "$(dirname "$0")/program.sh"
root=$(pwd)

awk -v to="$tmp/block" '
    /^```c$/       { if (!programs++) out = to ".c"; next }
    /^```console$/ { out = to "." ++consoles; next }
    /^```/         { out = "" }
    out            { print > out }' README.md
mkdir -p "$tmp/run/build"
cp "$tmp/block.c" "$tmp/run/arch.c"
cp stonepack.c stonepack.h "$tmp/run/"
ln -s "$root/solvers" "$root/tests" "$tmp/run/"
case $cli in /*) ln -s "$cli" "$tmp/run/build/stonepack" ;; *) ln -s "$root/$cli" "$tmp/run/build/stonepack" ;; esac

# A console block as a script: prints each line that starts with "$ " and runs it; $? is that of the line before.
session() {                                             # session N > what happens
    {
        # shellcheck disable=SC2016
        echo 'cc() { command ${CC:-gcc} "$@"; }; was=0'
        awk '/^\$ / { line = substr($0, 3); print "printf \"%s\\n\" \047$ " line "\047; (exit $was)"; print line; print "was=$?" }' \
            "$tmp/block.$1"
    } > "$tmp/script"
    (cd "$tmp/run" && sh "$tmp/script" 2>&1)
}
words() { sed -E 's/[0-9][0-9.]* [pnum]?s([^a-z]|$)/# s\1/g; s/[0-9.]+ KiB/# KiB/g; s/[0-9.]+e[-+]?[0-9]+/#/g; s/([0-9]\.[0-9]{5})[0-9]+/\1/g' "$1"; }

same() { session "$1" > "$tmp/got"; diff "$tmp/block.$1" "$tmp/got"; }
alike() {
    session "$1" > "$tmp/got"
    words "$tmp/block.$1" > "$tmp/want.words"
    words "$tmp/got" > "$tmp/got.words"
    diff "$tmp/want.words" "$tmp/got.words"
}
links() {
    sed -n 's/](\([^)]*\))/\n](\1)\n/gp' README.md | sed -n 's/^](\([^)#]*\)\(#[^)]*\)\{0,1\})$/\1/p' | grep -v '^https:' | grep . > "$tmp/links"
    while read -r link; do [ -e "$link" ] || { echo "no such file: $link"; return 1; }; done < "$tmp/links"
    test -s "$tmp/links"
}

part "program prints what README says"  same 1
n=2
while [ -f "$tmp/block.$n" ]; do
    part "commands answer in README's words, $n" alike $n
    n=$((n + 1))
done
part "links of README lead somewhere"   links
total
