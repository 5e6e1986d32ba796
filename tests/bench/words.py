#!/usr/bin/env python3
"""words: do the numbers of README's tables stand in the CSV that its pictures are made of?     Exit status 1: no.

    words.py [README.md]

Times of a bench, factorisations, bytes (tests/bench/results/*/bench.csv); what accuracy costs (figures/cost.csv); how near to a
limit both sides are told (figures/near.csv); code by switch (port/board/footprint.csv). Counts and distances to the digits
written, times and bytes within a tenth.
"""
import csv
import glob
import math
import os
import re
import sys

HERE = os.path.dirname(os.path.abspath(__file__))
said = []


def rows_of(path):
    with open(path, encoding="utf-8") as f:
        return list(csv.DictReader(line for line in f if not line.startswith("#")))


def table(text, head):
    """Cells of the rows under the header that starts so."""
    lines = text[text.index(head):].split("\n")[2:]
    own = lines[:next(k for k, line in enumerate(lines) if not line.startswith("|"))]
    return [[c.strip() for c in line.strip("|").split("|")] for line in own]


def differs(what, written, is_):
    said.append(f"{what}: README {written}, CSV {is_}")


def rounded(what, written, value):
    """A number as it is written, to its own digits."""
    digits = len(written.split(".")[1]) if "." in written else 0
    if abs(float(written) - value) > 0.5001 * 10 ** -digits:
        differs(what, written, f"{value:.{digits + 1}f}")


def bench(text):
    rows = [r for p in glob.glob(os.path.join(HERE, "results", "*", "bench.csv")) for r in rows_of(p)
            if r["kind"] == "check" and r["config"] == "true"]
    for name, joints, corners, fs, ms, fu, mu, size in table(text, "| scene | joints | corners | stable"):
        own = [r for r in rows if r["family"] == name.split(",")[0] and r["interfaces"] == joints and r["vertices"] == corners]
        for loads, f, t in ((("flat", "thick"), fs, ms), (("top", "thin"), fu, mu)):
            r = next((r for r in own if r["load"] in loads), None)
            if not r:
                differs(f"{name} {joints}", "has it", "no such row")
                continue
            if r["factorisations"] != f:
                differs(f"{name} {joints} {r['load']}: factorisations", f, r["factorisations"])
            if not 0.9 < float(t) / float(r["median_ms"]) < 1.1:
                differs(f"{name} {joints} {r['load']}: ms", t, r["median_ms"])
            if r["load"] in ("flat", "thick") and not 0.9 < float(size) / float(r["bytes_per_vertex"]) < 1.1:
                differs(f"{name} {joints}: bytes a corner", size, r["bytes_per_vertex"])


def cost(text):
    rows = rows_of(os.path.join(HERE, "figures", "cost.csv"))
    words = {"least squares alone": ("double", "least squares", "true", 1e-9), "polish alone, 1e-9": ("double", "polish", "true", 1e-9),
             "ADMM alone, 1e-2": ("double", "ADMM", "true", 1e-2), "float, exact, 1e-4": ("float", "exact", "true", 1e-4),
             "mixed, exact, 1e-9": ("mixed", "exact", "true", 1e-9)}

    def work(real, stage, cone, tol):
        own = [float(r["flops"]) for r in rows
               if (r["real"], r["stage"], r["cone"]) == (real, stage, cone) and math.isclose(float(r["tol"]), tol, rel_tol=1e-3)]
        return math.exp(sum(math.log(max(x, 1)) for x in own) / len(own))

    base = work("double", "exact", "true", 1e-9)
    for choice, costs, _ in table(text, "| choice | what it costs"):
        tol, faces = re.match(r"tol (\S+)", choice), re.match(r"pyramid of (\d+) (inside|around)", choice)
        which = words.get(choice)
        if tol:
            which = ("double", "exact", "true", float(tol[1]))
        if faces:
            which = ("double", "exact", faces[1] + faces[2][0].replace("a", "c"), 1e-9)
            c = math.cos(math.pi / int(faces[1]))
            rounded(f"{choice}: % of friction", re.search(r"([\d.]+) % of friction", costs)[1], 100 * (1 - c if faces[2] == "inside" else 1 / c - 1))
        rounded(f"{choice}: times the work", re.search(r"([\d.]+) times the work", costs)[1], work(*which) / base)


def near(text):
    rows = {(r["real"], r["scene"], float(r["tol"])): float(r["distance"]) for r in rows_of(os.path.join(HERE, "figures", "near.csv"))}
    scenes = ["arch of 11 stones, pushed", "keystone about to slide, pushed", "overhang of 10 boards, pushed", "wall tilted out of its plane",
              "wall tilted in its plane"]
    columns = [("double", 1e-3), ("double", 1e-6), ("double", 1e-9), ("double", 1e-12), ("quad", 1e-15), ("float", 1e-4)]
    for scene, cells in zip(scenes, table(text, "| limit of a live load")):
        best, at = cells[7].split(" at ")
        for (real, tol), written in list(zip(columns, cells[1:7])) + [(("float", float(at)), best)]:
            if not math.isclose(float(written), rows[real, scene, tol], rel_tol=1e-6):
                differs(f"{scene}, {real}, tol {tol:.0e}", written, f"{rows[real, scene, tol]:.0e}")


def footprint(text):
    """Code by switch and part, and the deepest stack of a check: kB of 1024 bytes to the digits written."""
    with open(os.path.join(HERE, "..", "..", "port", "board", "footprint.csv"), encoding="utf-8") as f:
        rows = {r[0]: [float(x or "nan") for x in r[1:]] for r in list(csv.reader(f))[1:]}
    names = {"code and constants": ["all"], "(`SP_NO_ADMM`)": ["SP_NO_ADMM"], "(`SP_NO_PLAN`)": ["SP_NO_PLAN"], "(`SP_NO_IPM`)": ["SP_NO_IPM"],
             "(`SP_NO_CRA`)": ["SP_NO_CRA"], "(`SP_NO_QP`)": ["SP_NO_QP"], "(`SP_SMALL`": ["everything, SP_SMALL"],
             "without any of": ["SP_NO_QP, SP_NO_CRA, SP_NO_IPM, SP_NO_PLAN"], "of that a linker": ["check, interfaces given"],
             "for meshes": ["check, contacts found"], "(`SP_EXACT_ONLY`)": ["smallest check, interfaces given", "smallest check, contacts found"],
             "`sp_verify` alone": ["smallest verification, interfaces given"], "(`SP_QP_ONLY`)": ["SP_QP_ONLY"],
             "the same without": ["SP_QP_ONLY, no Dykstra, CG, polish"]}
    found = 0
    for name, *cells in table(text, "| | Cortex-M7, double | Cortex-M4F, float |"):
        parts = next((p for key, p in names.items() if key in name), None)
        if name.startswith("deepest stack"):
            for column, cell in enumerate(cells): rounded(name, cell.split()[0], rows["stack, bound: sp_check"][column])
        if parts is None: continue
        found += 1
        for column, cell in enumerate(cells):
            for part, written in zip(parts, re.findall(r"\d+", cell)):
                bytes_ = rows.get("text: " + part, rows.get("text, linked: " + part))[column]
                rounded(f"{name}, column {column + 1}", written, bytes_ / 1024)
    if found != len(names): differs("rows of the footprint", found, len(names))


def main():
    with open(sys.argv[1] if len(sys.argv) > 1 else "README.md", encoding="utf-8") as f:
        text = f.read()
    for part in (bench, cost, near, footprint):
        part(text)
    for line in said:
        print(line)
    sys.exit(1 if said else 0)


if __name__ == "__main__":
    main()
