#!/usr/bin/env python3
"""The same verdict from double, mixed, quad and float, each at its default and at its finest tol.

  precisions.py FOLDER [CASES]      FOLDER/PRECISION-TOL.txt as battery.c writes them; CASES: ../shared/cases, for its files;
                                    FOLDER/double: battery.c in double, FOLDER/files: the cases unpacked

One row a scene: relative distance from its limit in what it is named by (friction, overhang, lean; - where none is known), the
same in load where a precision leaves it undecided, what is true, and for every precision and tol S, U or ? and omega.

In load: the least share of its weight that, added to every block's along an axis, makes what stands fall; that, or in any direction
chosen for every block, makes what falls stand. Measured here, in double at tol 1e-12 (battery.c, far). Behind a verdict:

  b    undecided, and the distance in load is within the declared band: double 1e-8, mixed 1e-6, quad 1e-12, float 1e-3 at the
       finest tol; 1000 tol where that is more at the default
  t    within tol: it falls, but there are forces that miss balance by less than tol (at most omega where it is called stable; the
       least there are, proved in double or quad, where it is undecided outside the band)
  c    unstable as far as force_bound goes, not final, within the band by the first distance
  r    refused (hard.h says why), weights whose squares no float holds, weights whose own last digit is more than tol (battery.c)
  X    anything else: it fails

Exit status 1: an X. A wrong verdict is one however near its limit: unstable where it stands (but c), stable beyond tol.
"""
import json, os, subprocess, sys

BANDS = {"double": 1e-8, "mixed": 1e-6, "quad": 1e-12, "float": 1e-3}
TOLS = {"double": ("1e-9", "1e-12"), "mixed": ("1e-9", "1e-12"), "quad": ("1e-9", "1e-15"), "float": ("1e-4", "3e-6")}
HUGE = "c_wall_huge_"


def read(path):
    rows = {}
    for line in open(path):
        f = [x.strip() for x in line.split("|")]
        rows[f[0]] = dict(verdict=f[1], told=f[2], omega=float(f[3]), proved=float(f[6]), final=f[7] == "1", far=float(f[8]), truth=f[9])
    return rows


def known(folder, name):
    """Truth of a case and its distance from the limit."""
    e = json.load(open(os.path.join(folder, name[:-4], "expected.json")))
    t = e.get("truth") or {}
    stands = (t.get("statically_stable") or {}).get("soc")
    if stands is None:
        stands = ((e.get("static") or {}).get("soc") or {}).get("admissible")
    limit, value = t.get("limit") or {}, t.get("value")
    limit = limit.get("soc") if isinstance(limit, dict) else None
    far = abs(value / limit - 1) if isinstance(limit, (int, float)) and isinstance(value, (int, float)) and limit else 0
    return {True: "stable", False: "unstable", None: ""}[stands], far


def measured(folder, name):
    """Distance from the limit in load."""
    words = [os.path.join(folder, "files", name)] if name.endswith(".obj") else ["only=" + name, "short"]
    out = subprocess.run([os.path.join(folder, "double"), "far", "tol=1e-12"] + words, stdout=subprocess.PIPE, universal_newlines=True).stdout
    return float(out.split("|")[1])


def refused(p, name, r):
    """Told by battery.c, with the reason in hard.h; or a file whose weights' squares no float holds."""
    return r["verdict"] == "undecided" and p == "float" and (r["told"] in ("refused", "short") or HUGE in name)


def mark(p, tol, name, r, truth, far, load, least):
    v, t = r["verdict"], tol * 1.01
    band = BANDS[p] if "%g" % tol == "%g" % float(TOLS[p][1]) else max(BANDS[p], 1000 * tol)
    if refused(p, name, r):
        return "r"
    if r["told"] == "refused":
        return "X"
    if not truth or v == truth:
        return ""
    if v == "unstable":
        return "c" if not r["final"] and far <= band else "X"
    if v == "stable":
        return "t" if r["omega"] <= t else "X"
    if load <= band:
        return "b"
    return "t" if truth == "unstable" and least <= t else "X"


def main():
    folder, cases = sys.argv[1], sys.argv[2] if len(sys.argv) > 2 else None
    columns = [(p, t) for p in ("double", "mixed", "quad", "float") for t in TOLS[p]]
    told = {c: read("%s/%s-%s.txt" % (folder, c[0], c[1])) for c in columns}
    names = list(told[columns[0]])
    count = {c: {} for c in columns}
    bad = 0
    print("%-38s %8s %8s %-8s " % ("scene", "distance", "in load", "truth") + " ".join("%-11s" % (p + " " + t) for p, t in columns))
    for n in names:
        rows = [told[c].get(n) for c in columns]
        if None in rows:
            print("%s: not told in every precision" % n)
            bad += 1
            continue
        truth, far = known(cases, n) if n.endswith(".obj") else (rows[0]["truth"], rows[0]["far"])
        least = max([r["proved"] for c, r in zip(columns, rows) if c[0] in ("double", "quad") and r["verdict"] == "unstable"], default=1)
        open_in = [c for c, r in zip(columns, rows) if r["verdict"] == "undecided" and truth and not refused(c[0], n, r)]
        load = measured(folder, n) if open_in else 0
        cells = []
        for c, r in zip(columns, rows):
            m = mark(c[0], float(c[1]), n, r, truth, far, load, least)
            count[c][m] = count[c].get(m, 0) + 1
            bad += m == "X"
            cells.append("%s%-1s %-8.1e" % ({"stable": "S", "unstable": "U"}.get(r["verdict"], "?"), m, r["omega"]))
        print("%-38s %8s %8s %-8s %s" % (n, "%.1g" % far if far else "-", "%.1g" % load if load else "-", truth or "-", " ".join(cells)))
    for c in columns:
        k = count[c]
        print("%-6s at tol %-5s: %d as it is, %d in its band, %d within tol, %d beyond force_bound, %d refused or at the end of numbers, %d else"
              % (c[0], c[1], k.get("", 0), k.get("b", 0), k.get("t", 0), k.get("c", 0), k.get("r", 0), k.get("X", 0)))
    print("%d scenes, %d cells fail" % (len(names), bad))
    return bad > 0


sys.exit(main())
