# recursion: from the call graph gcc writes with -fcallgraph-info, every cycle of defined functions; status 1 if there is one.
#
#     awk -f recursion.awk FILE.ci
#
# edge: { sourcename: "a" targetname: "b" }. Functions that call nothing left are taken away until none can be; the rest is
# a cycle or calls one.
/^edge:/ {
    a = $0; sub(/.*sourcename: "/, "", a); sub(/".*/, "", a)
    b = $0; sub(/.*targetname: "/, "", b); sub(/".*/, "", b)
    if (b ~ /__indirect_call/) next
    if ((a SUBSEP b) in edge) next
    edge[a, b] = 1
    from[++n] = a; to[n] = b; out[a]++
    if (!(b in out)) out[b] = 0
}
END {
    do {
        changed = 0
        for (f in out) if (out[f] == 0) {
            for (k = 1; k <= n; k++) if (to[k] == f && !gone[k]) { gone[k] = 1; out[from[k]]-- }
            delete out[f]
            changed = 1
        }
    } while (changed)
    for (f in out) { print "recursion through " f; bad = 1 }
    exit bad
}
