#!/bin/sh
# host_floors: the program's floors.      host_floors.sh [port/host]
#
# port/host is built bottom-up: the files beside main.c, which know the library only, then files, picture, worker, command, and
# main.c on top. An #include goes down, or stays in its folder; picture and worker know nothing of each other; and no two rooms
# include each other, by whatever way round (a room: NAME.h and NAME.c). What NAME.h declares is defined in NAME.c or NAME_*.c, or
# includes would not tell who calls whom; commands.h declares a function of each command. No file is longer than 700 lines, no line than 128.
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
    /^[a-z].*[a-z0-9_]+\(/ && !/^(static|typedef|extern)/ {      # a function that others may call
        match($0, /[a-z0-9_]+\(/)
        name = substr($0, RSTART, RLENGTH - 1)
        if (file ~ /\.h$/) declared[name] = file
        else defined[name] = file
    }
    length($0) > 128 { wrong(file ":" FNR ": " length($0) " columns") }
    { if (++lines[file] == 701) wrong(file " has more than 700 lines") }
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
        for (name in declared) {
            room = room_of(declared[name])
            at = (name in defined) ? defined[name] : "no file"
            if (room != "command/commands" && index(at, room) != 1) wrong(name " of " declared[name] " is defined in " at)
        }
        for (room in below) {
            n = split(below[room], to_one, " ")
            for (k = 1; k <= n; k++) if (reaches(to_one[k], room)) wrong(room " and " to_one[k] " include each other")
        }
        if (!files || !includes) wrong("nothing was read")
        exit bad > 0
    }'
