# recursion: from the call graph gcc writes with -fcallgraph-info, every function on a cycle; status 1 if there is one.
#
#     awk -f recursion.awk FILE.ci
#
# edge: { sourcename: "a" targetname: "b" }. Functions that call nothing left, or that nothing left calls, are taken away
# until none can be; what remains lies on cycles or between them.
/^edge:/ {
    a = $0; sub(/.*sourcename: "/, "", a); sub(/".*/, "", a)
    b = $0; sub(/.*targetname: "/, "", b); sub(/".*/, "", b)
    if (b ~ /__indirect_call/ || (a, b) in edge) next
    edge[a, b] = 1
    from[++n] = a; to[n] = b
    calls[a]++; called[b]++
    name[a] = name[b] = 1
}
END {
    do {
        changed = 0
        for (f in name) if (!calls[f] || !called[f]) {
            for (k = 1; k <= n; k++) if (!gone[k] && (to[k] == f || from[k] == f)) {
                gone[k] = 1
                calls[from[k]]--
                called[to[k]]--
            }
            delete name[f]
            changed = 1
        }
    } while (changed)
    for (f in name) { print "recursion through " f; bad = 1 }
    exit bad
}
