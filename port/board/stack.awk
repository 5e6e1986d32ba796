# stack: the deepest chain of calls below each public function, in bytes, from gcc's -fcallgraph-info=su.
#
#     awk -f stack.awk FILE.ci                        prints "sp_check 780" per public function
#
# A call through a pointer goes to the functions of the table below, by name; a caller that is not in it is refused. What the
# compiler's runtime and the C library take comes on top.
BEGIN {
    reach["sp__sort_sink"] = "_before$"
    reach["sp__qp_walk"] = "^sp__ldl_(column|degree|put|edge)$"
    reach["sp__check_stage"] = "^sp__(gates|least_squares|dense|polish|exact|admm)_run$"
    reach["sp__stages_need"] = "^sp__(gates|least_squares|dense|polish|exact|admm)_need$"
    reach["sp__admm_run"] = "^sp__qp_[a-z]+_solve$"
    reach["sp__admm_need"] = "^sp__qp_[a-z]+_need$"
}
function name(line, key) { sub(".*" key ": \"", "", line); sub("\".*", "", line); sub(/.*:/, "", line); return line }
/^node:/ {
    f = name($0, "title")
    bytes = $0
    frame[f] = match(bytes, /[0-9]+ bytes/) ? substr(bytes, RSTART, RLENGTH) + 0 : 0
}
/^edge:/ {
    f = name($0, "sourcename"); g = name($0, "targetname")
    if (g == "__indirect_call") indirect[f] = 1
    else if (!((f, g) in edge)) { edge[f, g] = 1; to[f] = to[f] " " g }
}
function deep(f,   n, g, k, d, most) {
    if (f in depth) return depth[f]
    if (f in open) { print "recursion through " f > "/dev/stderr"; exit 1 }
    open[f] = 1
    n = split(to[f], g, " ")
    for (k = 1; k <= n; k++) if ((d = deep(g[k])) > most) most = d
    delete open[f]
    return depth[f] = frame[f] + most
}
END {
    for (f in indirect) {
        if (!(f in reach)) { print "calls through a pointer, unknown whom: " f > "/dev/stderr"; exit 1 }
        for (g in frame) if (g ~ reach[f] && g != "") to[f] = to[f] " " g
    }
    for (f in frame) if (f ~ /^sp_[a-z]/) print f, deep(f)
}
