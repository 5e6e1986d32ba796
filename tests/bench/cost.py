#!/usr/bin/python3
"""cost: pictures of what accuracy costs, from lines of `stonepack cost --json`.

    cost.py COSTS.jsonl FOLDER CAPTION      writes cost.csv, cost-work.svg, cost-time.svg, cost-verdicts.svg

Prints the table in words. Needs matplotlib (Debian: python3-matplotlib).
"""
import csv
import json
import math
import os
import re
import sys

import matplotlib
matplotlib.use("svg")
from matplotlib import pyplot as plt
from matplotlib.lines import Line2D

STAGES = {"least squares": "#b8860b", "polish": "#4d9221", "ADMM": "#8e44ad", "exact": "#1d5fa6"}
CONES = ["true", "4i", "4c", "8i", "8c", "16i", "16c", "32i", "32c"]
REALS = ("double", "mixed", "float")
WRONG = "#b2182b"

plt.rcParams.update({
    "svg.fonttype": "none", "svg.hashsalt": "stonepack", "font.family": "sans-serif", "font.size": 9,
    "font.sans-serif": ["Helvetica", "Arial", "DejaVu Sans"], "axes.spines.top": False, "axes.spines.right": False,
    "axes.edgecolor": "#555555", "xtick.color": "#555555", "ytick.color": "#555555", "axes.titlesize": 9.5,
    "axes.titlelocation": "left", "legend.frameon": False,
})


def read(path):
    """Checks of all scenes; the truth of a scene is what double says, for the others, too."""
    rows, truth = [], {}
    with open(path, encoding="utf-8") as f:
        tables = [json.loads(line) for line in f]
    for t in tables:
        name = os.path.splitext(os.path.basename(t["scene"]))[0]
        if t["real"] == "double":
            truth[name] = t["verdict"]
        for c in t["checks"]:
            stage = "ADMM" if c["stage"].lower() == "admm" else c["stage"]
            rows.append(dict(c, scene=name, real=t["real"], stage=stage, interfaces=t["interfaces"]))
    for r in rows:
        v = truth[r["scene"]]
        r["is"] = "right" if r["verdict"] == v else "undecided" if r["verdict"] == "undecided" else "wrong"
    return rows, truth


def table(rows, path):
    keys = ["scene", "interfaces", "real", "stage", "cone", "tol", "verdict", "is", "reason", "omega", "least_imbalance", "flops",
            "factorisations", "iterations", "peak_bytes", "seconds"]
    with open(path, "w", encoding="utf-8", newline="") as f:
        w = csv.DictWriter(f, keys, extrasaction="ignore", lineterminator="\n")
        w.writeheader()
        for r in rows:
            w.writerow({k: f"{v:.4g}" if isinstance(v, float) else v for k, v in r.items()})


def shape(cone):
    return {"e": "o", "i": "s", "c": "D"}[cone[-1]]


def legend(fig, anchor):
    grip = [Line2D([], [], color=c, marker="o", linestyle="none", label=s) for s, c in STAGES.items()]
    grip += [Line2D([], [], color="#444444", marker=m, linestyle="none", label=w) for m, w in
             (("o", "true cone"), ("s", "pyramid inside"), ("D", "pyramid around"))]
    grip += [Line2D([], [], color="#444444", marker="o", fillstyle="none", linestyle="none", label="undecided"),
             Line2D([], [], color=WRONG, marker="x", linestyle="none", label="another verdict"),
             Line2D([], [], color="#aaaaaa", marker="o", markersize=3.6, linestyle="none", label="small: mixed"),
             Line2D([], [], color="#aaaaaa", marker="o", markersize=2.2, linestyle="none", label="smallest: float")]
    fig.legend(handles=grip, loc="lower center", ncol=5, bbox_to_anchor=anchor)


def panels(rows, key, label, title, caption, path):
    """One panel a scene: imbalance over work or time."""
    scenes = sorted({r["scene"] for r in rows}, key=lambda s: ("wall" not in s, next(r["interfaces"] for r in rows if r["scene"] == s)))
    fig, axes = plt.subplots(3, 3, figsize=(10.4, 9.6), sharey=True)
    fig.subplots_adjust(left=0.07, right=0.985, top=0.93, bottom=0.135, hspace=0.34, wspace=0.07)
    fig.suptitle(title, x=0.07, ha="left", fontweight="bold", fontsize=12)
    for ax, scene in zip(axes.flat, scenes):
        own = [r for r in rows if r["scene"] == scene]
        ax.set_title(f"{scene}, {own[0]['interfaces']} joints")
        ax.set_xscale("log")
        ax.set_yscale("log")
        ax.set_ylim(1e-17, 4)
        ax.grid(True, color="#e8e8e8", linewidth=0.6)
        marks = {}
        for r in own:
            x, y = r[key] * (1e3 if key == "seconds" else 1), min(max(r["omega"], 2e-17), 1)
            color = WRONG if r["is"] == "wrong" else STAGES[r["stage"]]
            marker = "x" if r["is"] == "wrong" else shape(r["cone"])
            style = (r["real"], color, marker, "none" if r["is"] == "undecided" else "full")
            marks.setdefault(style, []).append((float(f"{max(x, 1e-9):.2g}"), float(f"{y:.1g}")))
        for (real, color, marker, fill), points in marks.items():
            x, y = zip(*sorted(set(points)))            # what would lie on each other is drawn once
            size, alpha = {"double": (5, 0.8), "mixed": (3.4, 0.6), "float": (2.2, 0.45)}[real]
            ax.plot(x, y, marker=marker, color=color, fillstyle=fill, markersize=size, alpha=alpha,
                    markeredgewidth=0.9, linestyle="none", zorder=3 if color == WRONG else 2)
    for ax in axes[-1]:
        ax.set_xlabel(label)
    for ax in axes[:, 0]:
        ax.set_ylabel("omega, relative imbalance")
    legend(fig, (0.5, 0.028))
    fig.text(0.07, 0.012, caption, fontsize=7.5, color="#555555")
    save(fig, path)


def verdicts(rows, caption, path):
    """How many scenes each choice decides, over what it takes."""
    fig, axes = plt.subplots(1, 3, figsize=(10.4, 4.6), sharey=True)
    fig.subplots_adjust(left=0.07, right=0.985, top=0.88, bottom=0.25, wspace=0.06)
    fig.suptitle("Verdicts over nine scenes: what a choice of cone, stage and tol decides", x=0.07, ha="left", fontweight="bold")
    for ax, real in zip(axes, REALS):
        groups, marks = {}, {}
        for r in rows:
            if r["real"] == real:
                groups.setdefault((r["stage"], r["cone"], r["tol"]), []).append(r)
        for (stage, cone, _), own in groups.items():
            x = math.exp(sum(math.log(max(r["flops"], 1)) for r in own) / len(own))
            right, wrong = sum(r["is"] == "right" for r in own), sum(r["is"] == "wrong" for r in own)
            marks.setdefault((shape(cone), STAGES[stage], 0.6), []).append((x, right))
            if wrong:
                marks.setdefault(("x", WRONG, 1), []).append((x, -wrong))
        for (marker, color, alpha), points in marks.items():
            ax.plot(*zip(*points), marker=marker, color=color, markersize=5, alpha=alpha, linestyle="none")
        ax.set_title(real)
        ax.set_xscale("log")
        ax.set_ylim(-4.5, 9.5)
        ax.axhline(0, color="#888888", linewidth=0.8)
        ax.grid(True, color="#e8e8e8", linewidth=0.6)
        ax.set_xlabel("geometric mean of the work [flop]")
    axes[0].set_ylabel("scenes decided right (up),\nof another verdict (down)")
    legend(fig, (0.5, 0.03))
    fig.text(0.07, 0.015, caption, fontsize=7.5, color="#555555")
    save(fig, path)


def save(fig, path):
    """As SVG; markers of one look have it once, not each, and a tenth of a point is near enough."""
    fig.savefig(path, format="svg", metadata={"Date": None, "Creator": None})
    plt.close(fig)
    with open(path, encoding="utf-8") as f:
        text = f.read()
    text = re.sub(r'x="([\d.]+)" y="([\d.]+)" style=', lambda m: f'x="{float(m[1]):.1f}" y="{float(m[2]):.1f}" style=', text)

    def once(m):
        return f'{m[1]} style="{m[3]}">' + m[2].replace(f' style="{m[3]}"', "") + m[4]

    text = re.sub(r'(<g clip-path="[^"]*")>((?:\s*<use [^>]* style="([^"]*)"/>)(?:\s*<use [^>]* style="\3"/>)*)(\s*</g>)', once, text)
    with open(path, "w", encoding="utf-8") as f:
        f.write(text)
    print(path)


def words(rows):
    """The table in words: counts and work only, which are the same on every machine."""
    scenes = len({r["scene"] for r in rows})

    def pick(**want):
        return [r for r in rows if all(r[k] == v for k, v in want.items())]

    def mean(own):
        return math.exp(sum(math.log(max(r["flops"], 1)) for r in own) / len(own))

    tols = sorted({r["tol"] for r in rows if r["real"] == "double"})
    base = mean(pick(real="double", stage="exact", cone="true", tol=1e-9))
    for tol in tols:
        own = pick(real="double", stage="exact", cone="true", tol=tol)
        print(f"exact, true cone, tol {tol:.0e}: {mean(own) / base:.2f} times the work of 1e-9; "
              f"{sum(r['is'] == 'right' for r in own)} of {scenes} right, {sum(r['is'] == 'wrong' for r in own)} wrong")
    for cone in CONES[1:]:
        c = math.cos(math.pi / int(cone[:-1]))
        share = 100 * (1 - c) if cone[-1] == "i" else 100 * (1 / c - 1)
        own = pick(real="double", stage="exact", cone=cone, tol=1e-9)
        print(f"{cone}: {'costs' if cone[-1] == 'i' else 'adds up to'} {share:.1f} % of friction, {mean(own) / base:.2f} times the work, "
              f"{sum(r['is'] == 'wrong' for r in own)} other verdicts of {scenes}")
    for real in REALS:
        for stage in STAGES:
            for tol in sorted({r["tol"] for r in pick(real=real)}):
                own = pick(real=real, stage=stage, cone="true", tol=tol)
                print(f"{real}, {stage}, true cone, tol {tol:.0e}: {sum(r['is'] == 'right' for r in own)} right, "
                      f"{sum(r['is'] == 'wrong' for r in own)} wrong, {mean(own) / base:.2f} times the work of exact at 1e-9 in double")


def main():
    if len(sys.argv) != 4:
        sys.exit(__doc__)
    rows, _ = read(sys.argv[1])
    folder = sys.argv[2]
    table(rows, os.path.join(folder, "cost.csv"))
    panels(rows, "flops", "work [flop]", "What accuracy costs: imbalance over work", sys.argv[3], os.path.join(folder, "cost-work.svg"))
    panels(rows, "seconds", "time [ms]", "What accuracy costs: imbalance over time", sys.argv[3], os.path.join(folder, "cost-time.svg"))
    verdicts(rows, sys.argv[3], os.path.join(folder, "cost-verdicts.svg"))
    words(rows)


if __name__ == "__main__":
    main()
