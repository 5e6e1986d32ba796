#!/bin/sh
# host_floors: the program's floors.      host_floors.sh [port/host]
#
# port/host is built bottom-up: the files beside main.c, which know the library only, then files, picture, worker, command, and
# main.c on top. An #include goes down, or stays in its folder; picture and worker know nothing of each other; and no two rooms
# include each other, by whatever way round (a room: NAME.h and NAME.c).
root=${1:-port/host}
find "$root" -name '*.[ch]' | sort | xargs awk -v root="$root" '
    function base(f) { sub(/^.*\//, "", f); return f }
    function floor_of(f) {                              # folder of a file, by its path below root
        if (f == "main.c") return "main"
        return f ~ /\// ? substr(f, 1, index(f, "/") - 1) : "run"
    }
    function resolve(dir, path,   n, part, k, out, depth) {     # dir/path without its ..
        n = split(dir == "" ? path : dir "/" path, part, "/")
        depth = 0
        for (k = 1; k <= n; k++) {
            if (part[k] == "..") { if (depth == 0) return ""; depth-- }
            else out[++depth] = part[k]
        }
        path = out[1]
        for (k = 2; k <= depth; k++) path = path "/" out[k]
        return path
    }
    function room_of(f) { sub(/\.[ch]$/, "", f); return f }
    function reaches(from, to,   k, n, next_one) {
        if (from == to) return 1
        if (seen[from, to]++) return 0
        n = split(below[from], next_one, " ")
        for (k = 1; k <= n; k++) if (reaches(next_one[k], to)) return 1
        return 0
    }
    function wrong(text) { print "host_floors: " text; bad++ }
    BEGIN {
        split("run files picture worker command main", order, " ")
        for (k in order) rank[order[k]] = k + 0
    }
    FNR == 1 {
        file = substr(FILENAME, length(root) + 2)
        dir = file ~ /\// ? substr(file, 1, length(file) - length(base(file)) - 1) : ""
        here = floor_of(file)
        files++
        if (!(here in rank)) wrong(file ": no floor has this folder")
    }
    /^#include "/ {
        split($0, quoted, "\"")
        to = resolve(dir, quoted[2])
        if (to == "") next                              # leaves port/host: the library, a plugin, scenes by formula
        there = floor_of(to)
        includes++
        if (rank[there] > rank[here]) wrong(file " includes " to ", which stands above it")
        if (here == "worker" && there == "picture") wrong(file " includes " to ": worker and picture stand beside each other")
        if (room_of(to) != room_of(file)) below[room_of(file)] = below[room_of(file)] " " room_of(to)
    }
    END {
        for (room in below) {
            n = split(below[room], to_one, " ")
            for (k = 1; k <= n; k++) if (reaches(to_one[k], room)) wrong(room " and " to_one[k] " include each other")
        }
        if (!files || !includes) wrong("nothing was read")
        exit bad > 0
    }'
