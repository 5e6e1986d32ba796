#!/bin/sh
# readme: the pages show what happens.      readme.sh [build/stonepack [PAGE...]]
#
# Pages are README.md, every README.md below it, port/ORACLE.md and port/host/COMPAS.md, unless some are named. Of each page
#     a C block that begins with a comment /* NAME.c ... is that program; the others are syntax-checked as parts of a function;
#     console blocks are run, in one folder per page that holds its programs: those that run such a program must print what the
#         page prints, the others the same but for times, memory (pointers are of the host), powers of ten, and digits of a
#         search beyond the fifth;
#     links lead to a file, and to a heading where they name one;
#     names of the library and targets of make stand in the header and in the Makefile.
# Sections of the specification and departures that comments cite are on a page. README.md itself stays short.
. "$(dirname "$0")/program.sh"
root=$(pwd)
case $cli in /*) ;; *) cli=$root/$cli ;; esac
if [ $# -gt 1 ]; then
    shift
    pages=$*
else
    pages=$(find . -name build -prune -o -name .git -prune -o '(' -name README.md -o -name ORACLE.md -o -name COMPAS.md ')' -print | sed 's|^\./||' | sort)
fi

# A page's blocks: $tmp/KEY/NAME.c, fragment.N.c, console.N; the folder it runs in: $tmp/KEY/run.
key() { echo "$1" | tr / _; }
blocks() {                                              # blocks PAGE
    dir=$tmp/$(key "$1")
    mkdir -p "$dir/run/build"
    ln -s "$root/solvers" "$root/tests" "$root/port" "$root/settle" "$root/stonepack.c" "$root/stonepack.h" "$dir/run/"
    ln -s "$cli" "$dir/run/build/stonepack"
    awk -v dir="$dir" '
        /^```c$/       { begun = 1; next }
        /^```console$/ { out = dir "/console." ++consoles; next }
        /^```/         { out = ""; begun = 0 }
        begun          { begun = 0; out = dir "/fragment." ++fragments ".c"
                         if (match($0, /^\/\* [a-z]+\.c/)) out = dir "/run/" substr($0, 4, RLENGTH - 3) }
        out            { print > out }' "$1"
}

# A console block as a script: prints each line that starts with "$ " and runs it; $? is that of the line before.
session() {                                             # session DIR BLOCK > what happens
    {
        # shellcheck disable=SC2016
        echo 'cc() { command ${CC:-gcc} "$@" -O0; }; was=0'  # the same bits, built in a sixth of the time
        awk '/^\$ / { line = substr($0, 3); print "printf \"%s\\n\" \047$ " line "\047; (exit $was)"; print line; print "was=$?" }' "$2"
    } > "$tmp/script"
    (cd "$1/run" && sh "$tmp/script" 2>&1)
}
words() { sed -E 's/[0-9][0-9.]* [pnum]?s([^a-z]|$)/# s\1/g; s/[0-9.]+ KiB/# KiB/g; s/[0-9.]+e[-+]?[0-9]+/#/g; s/([0-9]\.[0-9]{5})[0-9]+/\1/g' "$1"; }
same() {                                                # same DIR BLOCK
    session "$1" "$2" > "$tmp/got"
    if grep -q '^\$ \./' "$2"; then diff "$2" "$tmp/got"; return; fi
    words "$2" > "$tmp/want.words"
    words "$tmp/got" > "$tmp/got.words"
    diff "$tmp/want.words" "$tmp/got.words"
}

# A fragment as the body of a function that has what a caller has.
fragment() {                                            # fragment FILE
    {
        echo '#include "stonepack.h"'
        echo 'void caller(sp_scene scene, sp_arena arena, sp_result result, sp_sequence *sequence, int32_t stone, sp_step step,'
        echo '            sp_held held, sp_suggestion next, const sp_stage *own);'
        echo 'void caller(sp_scene scene, sp_arena arena, sp_result result, sp_sequence *sequence, int32_t stone, sp_step step,'
        echo '            sp_held held, sp_suggestion next, const sp_stage *own)'
        echo '{ (void)scene, (void)arena, (void)result, (void)sequence, (void)stone, (void)step, (void)held, (void)next, (void)own;'
        cat "$1"
        echo '}'
    } > "$tmp/fragment.c"
    ${CC:-gcc} -std=c99 -fsyntax-only -I. "$tmp/fragment.c"
}

# Headings as the anchors a browser finds them by, and the links of a page.
anchors() { sed -n 's/^##* //p' "$1" | tr 'A-Z' 'a-z' | sed 's/[^a-z0-9 _-]//g; s/ /-/g'; }
links() {                                               # links PAGE
    sed 's/](\([^)]*\))/\n](\1)\n/g' "$1" | sed -n 's/^](\(.*\))$/\1/p' | grep -v '^https:' > "$tmp/links"
    from=$(dirname "$1")
    while read -r link; do
        file=${link%%#*}
        [ -z "$file" ] || [ -e "$from/$file" ] || { echo "no such file: $link"; return 1; }
        case $link in
        *'#'*) to=$1; if [ -n "$file" ]; then to=$from/$file; fi
               anchors "$to" | grep -qxF -- "${link#*#}" || { echo "no such heading: $link"; return 1; } ;;
        esac
    done < "$tmp/links"
}

# `sp_...`, `SP_...` and `make TARGET` that are there no more.
stale() {                                               # stale PAGE
    status=0
    for name in $(grep -oE '\b(sp|SP)_[A-Za-z0-9_]*[A-Za-z0-9]' "$1" | sort -u); do
        grep -rqE --include="*.[ch]" "\b$name\b" stonepack.h solvers port/fuzz || { echo "$1: no $name in stonepack.h, solvers or port/fuzz"; status=1; }
    done
    for target in $(grep -oE '(^|`|    )make [a-z-]+' "$1" | sed 's/.*make //' | grep -v '^-' | sort -u); do
        grep -qE "^[a-z /.-]*\b$target\b[a-z /.-]*:" Makefile || { echo "$1: no target $target"; status=1; }
    done
    return $status
}

# [seed n.m] and [departure n] of the code.
cited() {
    code=$(find stonepack.c stonepack.h solvers port settle tests \( -name '*.[ch]' -o -name '*.cpp' \) -print)
    # shellcheck disable=SC2086
    comments=$(grep -hE 'seed [0-9]|departure [0-9]|DESIGN' $code)
    sections=$(echo "$comments" | grep -oE 'seed [0-9](\.[0-9])?(, [0-9](\.[0-9])?)*' | grep -oE '[0-9](\.[0-9])?' | sort -u)
    [ -n "$sections" ] || return 1
    for n in $sections; do grep -qE "^(## |\*\*)$n " solvers/seed/README.md || { echo "no section $n in solvers/seed/README.md"; return 1; }; done
    for n in $(echo "$comments" | grep -oE 'departure [0-9]+' | sort -u | sed 's/.* //'); do
        grep -q "^$n\. \*\*" solvers/README.md || { echo "no departure $n in solvers/README.md"; return 1; }
    done
    if echo "$comments" | grep DESIGN; then return 1; fi
}

for page in $pages; do
    blocks "$page"
    dir=$tmp/$(key "$page")
    n=1
    if [ "$page" = settle/README.md ] && ! [ -f build/bullet.o ]; then
        skip "commands of $page" "g++ libbullet-dev"
        n=1000
    fi
    while [ -f "$dir/console.$n" ]; do
        if grep -qE '\.(stl|ply)$' "$dir/console.$n" && ! grep -q WITH_ASSIMP build/plugins; then
            skip "commands of $page, $n" "pkg-config libassimp-dev"
            n=$((n + 1))
            continue
        fi
        part "$page: commands answer in its words, $n" same "$dir" "$dir/console.$n"
        n=$((n + 1))
    done
    for file in "$dir"/fragment.*.c; do
        if [ -f "$file" ]; then part "$page: $(basename "$file" .c) compiles" fragment "$file"; fi
    done
    part "$page: links lead somewhere" links "$page"
    part "$page: names and targets are there" stale "$page"
done
part "what comments cite is on a page" cited
part "README.md: at most 200 lines, 14 kB" sh -c '[ "$(wc -l < README.md)" -le 200 ] && [ "$(wc -c < README.md)" -le 14000 ]'
total
