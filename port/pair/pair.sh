#!/bin/sh
# pair: the library as two files.
#
#     sh port/pair/pair.sh [SPINE] [FOLDER]             default: stonepack.c build/pair
#
# Copies stonepack.h and writes stonepack.c with every quoted include put in its place once, at its first mention. The result
# needs nothing else of this repository: `cc -O2 -c stonepack.c`.
set -eu
spine=${1:-stonepack.c}
out=${2:-build/pair}
mkdir -p "$out"
cp "$(dirname "$spine")/stonepack.h" "$out/stonepack.h"
awk -v spine="$spine" '
    # a/b/../c -> a/c
    function tidy(path) {
        sub(/^\.\//, "", path)
        while (match(path, /[^\/.][^\/]*\/\.\.\//)) path = substr(path, 1, RSTART - 1) substr(path, RSTART + RLENGTH)
        return path
    }
    function put(path,      line, folder, name, got) {
        folder = path
        if (!sub(/[^\/]*$/, "", folder)) folder = ""
        while ((got = (getline line < path)) > 0) {
            if (line !~ /^[ \t]*#[ \t]*include[ \t]*"/) { print line; continue }
            name = line
            sub(/^[^"]*"/, "", name)
            sub(/".*$/, "", name)
            name = tidy(folder name)
            if (name in seen) continue
            seen[name] = 1
            if (name ~ /(^|\/)stonepack\.h$/) print "#include \"stonepack.h\""
            else put(name)
        }
        if (got < 0) { print "pair: cannot read " path > "/dev/stderr"; failed = 1 }
        close(path)
    }
    BEGIN { put(spine); exit failed }
' > "$out/stonepack.c"
