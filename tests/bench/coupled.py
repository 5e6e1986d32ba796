#!/usr/bin/env python3
"""coupled: the coupled check on a folder of assemblies, as CSV.      coupled.py PROGRAM CASES > coupled.csv

CASES/NAME/scene.obj (or .gz) with expected.json beside it. Every case is asked with its own eps and eta, compas_cra's cone (8c)
and its bound per component: by the default search, and by the alternation of the specification (--preset seed) at the default tol
and at its own. truth: is there a triple? ms: the least of 5 runs for compas_cra's own samples (names that begin with a_), else of
one; ipopt_ms and ipopt: what the published program did on another machine. Standard library only.
"""
import csv
import os
import sys

sys.path.insert(0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", "checks"))
from coupled_cases import Case, ask, WORDS                                                             # noqa: E402

SEARCHES = (("default", "1e-9", []), ("alternation", "1e-9", ["--preset", "seed", "--tol", "1e-9"]),
            ("alternation", "its own", ["--preset", "seed"]))
KEYS = ["case", "corners", "truth", "search", "tol", "verdict", "reason", "residual", "rounds", "ms", "ipopt_ms", "ipopt"]


def rows(program, c):
    sample = c.name.startswith("a_")
    if not sample and c.feasible is None:
        return
    theirs = c.cra.get("eq11_compas") or {}
    for search, tol, more in SEARCHES:
        if search != "default" and c.feasible is None:
            continue
        runs = [ask(program, c.text, ["--cra-box", "--cone", "8c"] + c.lengths() + more)
                for _ in range(5 if sample and search == "default" else 1)]
        x = runs[0]["coupled"]
        row = {"case": c.name, "corners": runs[0]["contact_vertices"], "truth": WORDS[c.feasible], "search": search, "tol": tol,
               "verdict": x["verdict"], "reason": x["reason"], "residual": f"{x['residual']:.2g}" if x["verdict"] == "coupled" else "",
               "rounds": x["rounds"], "ms": f"{1e3 * min(d['cost']['seconds'] for d in runs):.3g}"}
        if search == "default" and sample and theirs:
            row.update(ipopt_ms=f"{1e3 * theirs['time_s']:.0f}", ipopt=theirs["status"].replace("_", " ").lower())
        yield row


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    out = csv.DictWriter(sys.stdout, KEYS, lineterminator="\n")
    out.writeheader()
    for name in sorted(os.listdir(sys.argv[2])):
        if os.path.exists(os.path.join(sys.argv[2], name, "expected.json")):
            out.writerows(rows(sys.argv[1], Case(sys.argv[2], name)))
            sys.stdout.flush()


if __name__ == "__main__":
    main()
