#!/usr/bin/python3
"""plot: pictures of a bench's CSV, as SVG.

    plot.py BENCH.csv FOLDER        writes time.svg, factorisations.svg, memory.svg, parts.svg

Needs matplotlib (Debian: python3-matplotlib).
"""
import csv
import os
import sys

import matplotlib
matplotlib.use("svg")
from matplotlib import pyplot as plt
from matplotlib.lines import Line2D
from matplotlib.ticker import LogLocator, NullFormatter

STABLE, UNSTABLE, OPEN = "#1d5fa6", "#b2182b", "#7a7a7a"
COLOR = {"stable": STABLE, "unstable": UNSTABLE, "undecided": OPEN}
MARK = {"wall": "o", "arch": "^", "dome": "s", "vault": "D"}
DASH = {"flat": "-", "tilt": "--", "inpl2": ":", "inpl": ":", "top": "-", "thick": "-", "thin": "-"}
LOADS = [("flat", STABLE, "flat wall"), ("tilt", STABLE, "out of plane, 0.6\nof overturning"),
         ("inpl2", STABLE, "in plane, 14°"), ("top", UNSTABLE, "out of plane, 1.25\nof overturning"),
         ("inpl", OPEN, "in plane, 32°, budget\nof 60 factorisations")]

LOCALISED = "unstable: with the search for where help is wanted"

plt.rcParams.update({
    "svg.fonttype": "none", "svg.hashsalt": "stonepack", "font.family": "sans-serif", "font.size": 10,
    "font.sans-serif": ["Helvetica", "Arial", "DejaVu Sans"], "axes.spines.top": False, "axes.spines.right": False,
    "axes.edgecolor": "#555555", "xtick.color": "#555555", "ytick.color": "#555555", "axes.labelcolor": "#222222",
    "axes.titleweight": "bold", "axes.titlesize": 11, "axes.titlelocation": "left", "legend.frameon": False,
    "legend.fontsize": 9, "lines.markersize": 5,
})


def read(path):
    """Rows as dictionaries, and the first comment line."""
    with open(path, encoding="utf-8") as f:
        lines = f.read().splitlines()
    said = [l[2:] for l in lines if l.startswith("# ")]
    return list(csv.DictReader(l for l in lines if not l.startswith("#"))), said[0] if said else ""


def number(row, key):
    return float(row[key])


def walls(rows, load):
    return sorted((r for r in rows if r["family"] == "wall" and r["load"] == load), key=lambda r: number(r, "interfaces"))


def sheet(title, ylabel, said, logy, right=0.75):
    fig, ax = plt.subplots(figsize=(8.6, 4.7))
    fig.subplots_adjust(left=0.085, right=right, top=0.92, bottom=0.185)
    ax.set_title(title)
    ax.set_xscale("log")
    if logy:
        ax.set_yscale("log")
        ax.yaxis.set_major_locator(LogLocator(10, numticks=12))
        ax.yaxis.set_minor_formatter(NullFormatter())
    ax.set_xlabel("interfaces")
    ax.set_ylabel(ylabel)
    ax.grid(True, color="#e4e4e4", linewidth=0.7)
    ax.set_axisbelow(True)
    ax.set_xlim(9, 14000)
    ticks = [10, 30, 100, 300, 1000, 3000, 10000]
    ax.set_xticks(ticks)
    ax.set_xticklabels([f"{t:,}".replace(",", " ") for t in ticks])
    ax.xaxis.set_minor_formatter(NullFormatter())
    fig.text(0.085, 0.03, said, fontsize=8, color="#555555")
    return fig, ax


def mark(row):
    return "X" if row["load"] == "inpl" else MARK[row["family"]]


def curves(ax, rows, key, spread=None):
    """Every check of the true cone: a curve for each family, load case and verdict."""
    for family in MARK:
        for load in DASH:
            own = [r for r in rows if r["family"] == family and r["load"] == load]
            own.sort(key=lambda r: number(r, "interfaces"))
            for verdict, color in COLOR.items():
                part = [r for r in own if r["verdict"] == verdict]
                if not part:
                    continue
                x, y = [number(r, "interfaces") for r in part], [number(r, key) for r in part]
                ax.plot(x, y, DASH[load], color=color, marker=mark(part[0]), linewidth=1.1, alpha=0.9)
                if spread:
                    ax.vlines(x, [number(r, spread) for r in part], y, color=color, linewidth=2.4, alpha=0.25)


def legend(ax, rows):
    seen = {r["verdict"] for r in rows}
    grip = [Line2D([], [], color=c, linewidth=4, label=v) for v, c in COLOR.items() if v in seen]
    grip += [Line2D([], [], color="#222222", marker=m, linestyle="none", label=f) for f, m in MARK.items()
             if any(r["family"] == f for r in rows)]
    for load, color, word in LOADS:
        if any(r["load"] == load for r in rows):
            grip.append(Line2D([], [], color=color, linestyle="none" if load == "inpl" else DASH[load],
                               marker="X" if load == "inpl" else "o", label=word))
    ax.legend(handles=grip, loc="upper left", bbox_to_anchor=(1.01, 1.02), labelspacing=0.65)


def save(fig, folder, name):
    path = os.path.join(folder, name)
    fig.savefig(path, format="svg", metadata={"Date": None, "Creator": None})
    plt.close(fig)
    print(path)


def slope(ax, row, key, power):
    """A light guide of the given power through a row."""
    x0, y0 = number(row, "interfaces"), number(row, key)
    x = [60, 11000]
    ax.plot(x, [y0 * (v / x0) ** power for v in x], color="#bbbbbb", linewidth=4, alpha=0.45, zorder=0)
    ax.annotate(f"interfaces$^{{{power:g}}}$", (1000, y0 * (1000 / x0) ** power), color="#888888", ha="left", va="top",
                xytext=(6, -6), textcoords="offset points", fontsize=9)


def time_figure(rows, said, folder):
    fig, ax = sheet("Time of a check", "median CPU time [ms]", said, True)
    curves(ax, rows, "median_ms", "best_ms")
    flat = walls(rows, "flat")
    if flat:
        slope(ax, flat[len(flat) // 2], "best_ms", 1.5)
    legend(ax, rows)
    ax.text(0.99, 0.02, "shades reach down to the best run; " + LOCALISED, transform=ax.transAxes, ha="right", fontsize=8, color="#777777")
    save(fig, folder, "time.svg")


def factor_figure(rows, said, folder):
    fig, ax = sheet("Factorisations of a check", "factorisations of the 6b × 6b Hessian", said, True)
    curves(ax, rows, "factorisations")
    ticks = [1, 2, 4, 6, 10, 20, 40, 80]
    ax.set_yticks(ticks)
    ax.set_yticklabels([str(t) for t in ticks])
    ax.axhline(6, color="#bbbbbb", linewidth=4, alpha=0.45, zorder=0)
    ax.text(13500, 6.25, "aim for plain walls", ha="right", va="bottom", fontsize=9, color="#888888")
    legend(ax, rows)
    ax.text(0.99, 0.02, LOCALISED, transform=ax.transAxes, ha="right", fontsize=8, color="#777777")
    save(fig, folder, "factorisations.svg")


def memory_figure(rows, said, folder):
    rows = [r for r in rows if r["verdict"] != "undecided" and r["load"] in ("flat", "thick")]
    fig, ax = sheet("Memory of a check: its whole arena, forces included", "bytes per contact vertex", said, False, 0.96)
    curves(ax, rows, "bytes_per_vertex")
    for family in MARK:
        own = [r for r in rows if r["family"] == family]
        if own:
            last = max(own, key=lambda r: number(r, "interfaces"))
            ax.annotate(family, (number(last, "interfaces"), number(last, "bytes_per_vertex")), xytext=(6, -14) if family == "vault" else (0, 9),
                        textcoords="offset points", ha="center", color=STABLE)
    ax.plot([9, 500], [350, 350], color="#bbbbbb", linewidth=4, alpha=0.45, zorder=0)
    ax.text(9.5, 335, "aim to 500 interfaces", va="top", fontsize=9, color="#888888")
    ax.set_ylim(0, None)
    save(fig, folder, "memory.svg")


PARTS = [("contacts", "", "finding the contacts", "#4d9221", "s"), ("check", "true", "check, true cone", STABLE, "o"),
         ("check", "8 inscribed", "check, pyramid of 8", "#6baed6", "v"), ("verify", "hint", "verify", "#222222", "D"),
         ("verify", "alone", "verify without the\nhint y0", "#9a9a9a", "d"),
         ("symbolic", "", "order and pattern\nalone", "#b8860b", "^")]


def parts_figure(rows, said, folder):
    fig, ax = sheet("A flat wall, part by part", "median CPU time [ms]", said, True)
    for kind, config, label, color, mark in PARTS:
        own = walls([r for r in rows if r["kind"] == kind and r["config"] == config], "flat")
        if own:
            ax.plot([number(r, "interfaces") for r in own], [number(r, "median_ms") for r in own], color=color, marker=mark,
                    linewidth=1.2, label=label)
    ax.legend(loc="upper left", bbox_to_anchor=(1.01, 1.02), labelspacing=0.65)
    ax.set_xlim(50, 12500)
    save(fig, folder, "parts.svg")


def main():
    if len(sys.argv) != 3:
        sys.exit(__doc__)
    rows, said = read(sys.argv[1])
    folder = sys.argv[2]
    os.makedirs(folder, exist_ok=True)
    checks = [r for r in rows if r["kind"] == "check" and r["config"] == "true"]
    time_figure(checks, said, folder)
    factor_figure(checks, said, folder)
    memory_figure(checks, said, folder)
    parts_figure(rows, said, folder)


if __name__ == "__main__":
    main()
