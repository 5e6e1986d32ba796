#!/usr/bin/env python3
"""words: do the numbers in the tables of README.md and the manuals stand in the CSV they are taken from?     Exit status 1: no.

    words.py [PAGE...]                  default: every README.md

Times of a bench, factorisations, bytes (tests/bench/results/*/bench.csv); what leaving out effects saves (plan.csv beside it); the
coupled check (coupled.csv); how much faster than others' solvers (peers-check.csv); what accuracy costs
(tests/bench/figures/cost.csv); how near to a limit both sides are decided (near.csv); code by switch (port/board/footprint.csv).
A table that several pages show, whole or in part, is read in all of them.
Counts, ratios and distances to the digits written, times and bytes within a tenth.
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
    """Cells of the rows under every header that starts so."""
    rows, at = [], text.index("\n" + head)              # one at least
    while at >= 0:
        lines = text[at + 1:].split("\n")[2:]
        own = lines[:next(k for k, line in enumerate(lines) if not line.startswith("|"))]
        rows += [[c.strip() for c in line.strip("|").split("|")] for line in own]
        at = text.find("\n" + head, at + 1)
    return rows


def differs(what, written, is_):
    said.append(f"{what}: page {written}, CSV {is_}")


def rounded(what, written, value):
    """A number as it is written, to its own digits."""
    digits = len(written.split(".")[1]) if "." in written else 0
    if abs(float(written) - value) > 0.5001 * 10 ** -digits:
        differs(what, written, f"{value:.{digits + 1}f}")


def result(name):
    """Rows of a result beside bench.csv, on any machine."""
    return [r for p in glob.glob(os.path.join(HERE, "results", "*", name)) for r in rows_of(p)]


def bench(text):
    rows = [r for r in result("bench.csv") if r["kind"] == "check" and r["config"] == "true"]
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


def stages(text):
    """A wall by each stage: ms, Mflop, KiB and the imbalance left."""
    rows = [r for r in result("bench.csv") if (r["kind"], r["family"], r["load"]) == ("check", "wall", "flat")]
    for joints, *cells in table(text, "| joints | exact: ms"):
        for config, work, omega in zip(("true", "seed: polish", "seed: ADMM"), cells[::2], cells[1::2]):
            r = next(r for r in rows if r["interfaces"] == joints and r["config"] == config)
            ms, flops, kib = (float(x) for x in work.split(","))
            if not 0.9 < ms / float(r["median_ms"]) < 1.1: differs(f"{joints} {config}: ms", ms, r["median_ms"])
            if abs(flops / (float(r["flops"]) / 1e6) - 1) > 0.12: differs(f"{joints} {config}: Mflop", flops, r["flops"])
            if not 0.98 < kib / (float(r["bytes"]) / 1024) < 1.02: differs(f"{joints} {config}: KiB", kib, r["bytes"])
            if not 0.5 < float(omega) / float(r["omega"]) < 2: differs(f"{joints} {config}: imbalance", omega, r["omega"])


def tilt(text):
    """Walls tilted in their plane, on both sides of the limit."""
    rows = result("tilt.csv")
    for joints, *cells in table(text, "| joints | last angle that stands"):
        own = [r for r in rows if r["joints"] == joints]
        last = [r for r in own if r["verdict"] == "stable"][-1]
        first = next(r for r in own if r["verdict"] == "unstable")
        is_ = [v for r in (last, first) for v in (r["degrees"] + "°", r["factorisations"], r["interior"])]
        if cells != is_: differs(f"wall of {joints} tilted", cells, is_)


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
    names = {"arch of 11 stones, t/R 0.15, pushed": "arch of 11 stones, pushed",
             "wall of 4 courses tilted out of its plane": "wall tilted out of its plane", "the same tilted in its plane": "wall tilted in its plane"}
    columns = [("double", 1e-3), ("double", 1e-6), ("double", 1e-9), ("double", 1e-12), ("quad", 1e-15), ("float", 1e-4)]
    for cells in table(text, "| limit of a live load"):
        scene = names.get(cells[0], cells[0])
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
             "the same without": ["SP_QP_ONLY, no Dykstra, CG, polish, interior points"]}
    found = set()
    for name, *cells in table(text, "| | Cortex-M7, double | Cortex-M4F, float |"):
        key = next((k for k in names if k in name), None)
        if name.startswith("deepest stack"):
            for column, cell in enumerate(cells): rounded(name, cell.split()[0], rows["stack, bound: sp_check"][column])
        if key is None: continue
        found.add(key)
        parts = names[key]
        for column, cell in enumerate(cells):
            for part, written in zip(parts, re.findall(r"\d+", cell)):
                bytes_ = rows.get("text: " + part, rows.get("text, linked: " + part))[column]
                rounded(f"{name}, column {column + 1}", written, bytes_ / 1024)
    for need, switch, *cells in table(text, "| you want | build with"):
        text_ = {"nothing": "all", "`SP_NO_QP SP_NO_CRA SP_NO_IPM SP_NO_PLAN`": "SP_NO_QP, SP_NO_CRA, SP_NO_IPM, SP_NO_PLAN", "`SP_SMALL`": "everything, SP_SMALL",
                 "`SP_QP_ONLY`": "SP_QP_ONLY"}.get(switch)
        linked = {"to re-check": "smallest verification, interfaces given", "a verdict, joints given": "smallest check, interfaces given",
                  "a verdict, joints found": "smallest check, contacts found"}
        part = "text: " + text_ if text_ else "text, linked: " + next(v for k, v in linked.items() if need.startswith(k))
        for column, cell in enumerate(cells): rounded(f"{need}, column {column + 1}", cell.split()[0], rows[part][column] / 1024)
    for name, *cells in table(text, "| RAM in bytes |"):
        is_ = [rows[part][column] for column in (0, 1) for part in (f"arena, scene: {name}", f"arena, check: {name}, exact")]
        if [float(c) for c in cells] != is_: differs(f"RAM of {name}", cells, is_)
    if len(found) != len(names): differs("rows of the footprint", len(found), len(names))


def plan(text):
    """All effects over as planned: verdicts agree, flops, the worst of them, time, bytes."""
    rows = {r["name"]: r for r in result("plan.csv")}
    for cells in table(text, "| all effects / as planned"):
        r = rows.get(cells[0].strip("*"))
        if not r:
            differs(cells[0], "has it", "no such row")
            continue
        for key, written in zip(("scenes", "agree", "flops", "least", "time", "bytes"), cells[1:]):
            if key == "time":
                if not 0.9 < float(written) / float(r[key]) < 1.1: differs(f"{cells[0]}: {key}", written, r[key])
            else:
                rounded(f"{cells[0]}: {key}", written, float(r[key]))


def coupled(text):
    """Answers by search and truth, then by kind of sample."""
    rows = result("coupled.csv")
    truth = {"feasible": "coupled", "infeasible": "refuted"}
    for search, tol, right, refuted, wrong in table(text, "| search | tol | coupled, of"):
        own = [r for r in rows if r["search"] == search and r["tol"] == tol and r["truth"] in truth]
        is_ = [sum(r["truth"] == t and r["verdict"] == v for r in own) for t, v in truth.items()]
        is_.append(sum(r["truth"] == "feasible" and r["verdict"] == "refuted" or r["truth"] == "infeasible" and r["verdict"] == "coupled"
                       for r in own))
        if [int(right), int(refuted.split(",")[0]), int(wrong)] != is_: differs(f"{search}, {tol}", (right, refuted, wrong), is_)
    samples = [r for r in rows if r["case"].startswith("a_") and r["search"] == "default"]
    pattern = {"arch": "arch$|arch_supports", "cubes, one or two": "cube(s?|s?_.*)$|simple_cube.*", "curved": "cube-curve-.*|curve-3-blocks",
               "wedges a to d, 10 ways up": "type-.*", "stacks": "stacks?_rot.*|stack.*", "concave blocks, turned": "concave.*"}
    seen = 0
    for name, corners, *cells in table(text, "| samples | corners | coupled"):
        own = [r for r in samples if re.fullmatch(pattern.get(name, name + ".*"), r["case"][2:])]
        seen += len(own)
        n = sorted(int(r["corners"]) for r in own) or [0]
        is_ = [f"{n[0]} - {n[-1]}" if n[0] < n[-1] else str(n[0])]
        is_ += [str(sum(r["verdict"] == v for r in own) or "") for v in ("coupled", "refuted", "not found")]
        theirs = [r for r in own if r["ipopt"]]
        is_.append(f"{sum(bool(re.match('solve|feasible', r['ipopt'])) for r in theirs)} of {len(theirs)}" if theirs else "")
        if [corners] + cells != is_: differs(name, [corners] + cells, is_)
    if seen != len(samples): differs("samples of the coupled check", seen, len(samples))


def peers(text):
    """Best correct peer over ours by group of scenes: least and most, and how many reach what is aimed at."""
    rows = result("peers-check.csv")
    for name, joints, aims, *cells in table(text, "| checks | joints | aimed at"):
        group, column = name.removesuffix(", all in space"), "full_ratio" if name.endswith(", all in space") else "plan_ratio"
        first, last = (int(x) for x in (joints.split(" - ") * 2)[:2])
        for form, aim, span, reached in zip(("cone", "pyramid"), (aims.split(", ") * 2)[:2], cells[::2], cells[1::2]):
            own = [r for r in rows if r["group"] == group and r["form"] == form and first <= int(r["joints"]) <= last]
            ratios = sorted(float(r[column]) for r in own if r[column])
            if not ratios:
                differs(f"{name}, {form}", span, "no such row")
                continue
            least, most = (span.split(" - ") * 2)[:2]
            rounded(f"{name}, {form}: least", least, ratios[0])
            rounded(f"{name}, {form}: most", most, ratios[-1])
            is_ = f"{sum(x >= float(aim) for x in ratios)} of {len(own)}"
            if reached != is_: differs(f"{name}, {form}: reached", reached, is_)


def pages():
    """Every README.md of the tree."""
    top = os.path.join(HERE, "..", "..")
    return [os.path.join(d, "README.md") for d, dirs, files in os.walk(top) if "README.md" in files and "/build" not in d and "/.git" not in d]


def main():
    text = ""
    for page in sys.argv[1:] or sorted(pages()):
        with open(page, encoding="utf-8") as f:
            text += f.read() + "\n"
    for part in (bench, stages, tilt, cost, near, footprint, plan, coupled, peers):
        part(text)
    for line in said:
        print(line)
    sys.exit(1 if said else 0)


if __name__ == "__main__":
    main()
