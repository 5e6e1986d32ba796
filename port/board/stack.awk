# stack: the deepest stack of each public call, from gcc's -fcallgraph-info=su: the largest sum of frames along any chain of
# calls. Prints "call bytes", deepest first call by call; with -v chain=NAME the chain of that call.
#
#     awk -f stack.awk FILE.ci
#
# Calls through pointers go to the functions below, never to the caller's own (a custom stage, another solver), whose stack is
# theirs. A pointer called from elsewhere, a frame of unknown size and a chain without end are errors: status 1.
BEGIN {
    through["sp__sort_sink"]   = "^sp__[a-z_]+_before$"
    through["sp__run_stage"] = "^sp__(gates|least_squares|dense|polish|exact|admm|penalty)_run$"
    through["sp__stages_need"] = "^sp__(gates|sparse|dense|exact|admm|penalty)_need$"
    through["sp__admm_run"]    = "^sp__qp_(admm|interior)_solve$"
    through["sp__alt_explain"] = "^sp__qp_(admm|interior)_solve$"
    through["sp__alt_forces"]  = "^sp__qp_(admm|interior)_solve$"
    through["sp__admm_need"]   = "^sp__qp_(admm|interior)_need$"
    through["sp__alt_need"]    = "^sp__qp_(admm|interior)_need$"
    through["sp__kkt_walk"]    = "^sp__ldl_(degree|edge|value)$"
    through["sp__supernode_run"] = "^sp__(supernode_(rows|beyond)|bchol3_beyond)$"
    split("sp__watch_stage sp__system_factorisation sp__run_reduced", watches)   # the caller's sp_watch, nothing of ours
    for (k in watches) callers[watches[k]] = 1
}
function clean(name) { sub(/.*:/, "", name); sub(/\.(constprop|isra|part|cold).*/, "", name); return name }
/^node:/ {
    name = $0; sub(/.*title: "/, "", name); sub(/".*/, "", name)
    if ($0 !~ / bytes \(/) next                         # of the compiler's runtime or the C library
    bytes = $0; sub(/ bytes \(.*/, "", bytes); sub(/.*[^0-9]/, "", bytes)
    if ($0 ~ /\(dynamic\)/) { print "frame of unknown size: " name; bad = 1 }
    frame[name] = bytes + 0
}
/^edge:/ {
    a = $0; sub(/.*sourcename: "/, "", a); sub(/".*/, "", a)
    b = $0; sub(/.*targetname: "/, "", b); sub(/".*/, "", b)
    if (!((a, b) in edge)) { edge[a, b] = 1; callee[a, ++calls[a]] = b }
}
function reach(f,   k, g, d, met) {
    if (f in deep) return deep[f]
    if (open[f]) { print "recursion through " f; bad = 1; return 0 }
    open[f] = 1
    deep_of[f] = 0
    for (k = 1; k <= calls[f]; k++) {
        g = callee[f, k]
        if (g == "__indirect_call") {
            if (clean(f) in callers) continue
            if (!(clean(f) in through)) { print "a call through a pointer in " f; bad = 1; continue }
            met = 0
            for (g in frame) if (clean(g) ~ through[clean(f)]) {
                met = 1; d = reach(g); if (d > deep_of[f]) { deep_of[f] = d; next_of[f] = g }
            }
            if (!met) { print "nothing is called through the pointer in " f; bad = 1 }
        } else if (g in frame) { d = reach(g); if (d > deep_of[f]) { deep_of[f] = d; next_of[f] = g } }
    }
    open[f] = 0
    return deep[f] = frame[f] + deep_of[f]
}
END {
    for (f in frame) reach(f)
    for (f in frame) if (clean(f) ~ /^sp_[a-z]/) print clean(f), deep[f] | "sort -k2,2nr -k1,1"
    close("sort -k2,2nr -k1,1")
    for (f in frame) if (chain != "" && clean(f) == chain) for (g = f; g in frame; g = next_of[g]) print "  " clean(g), frame[g]
    exit bad
}
