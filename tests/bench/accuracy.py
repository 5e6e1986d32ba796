#!/usr/bin/env python3
"""accuracy: one picture of accuracy against time, from cost.csv.      accuracy.py COST.csv [SCENE] > accuracy.svg

What each stage alone makes of one scene, with the true cone: the imbalance it leaves over the time it takes, one mark for each
tolerance that was asked. Filled marks are verdicts, hollow ones undecided. Standard library only.
"""
import csv
import math
import sys

WIDTH, HEIGHT = 760, 400
LEFT, RIGHT, TOP, BOTTOM = 92, 20, 64, 58               # margins of the frame
TIME, OMEGA = (1, 300), (1e-16, 1)                      # its axes [ms, 1]
FONT = "font-family='Helvetica, Arial, DejaVu Sans, sans-serif'"
SERIES = (("double", "exact", "#1d5fa6", "exact stage, the default", (12, 4, "start")),
          ("float", "exact", "#5aa0dc", "exact stage in float", (12, 4, "start")),
          ("double", "polish", "#4d9221", "alternating projections", (14, 4, "start")),
          ("double", "ADMM", "#8e44ad", "ADMM (the penalty form)", (12, -14, "end")),
          ("double", "least squares", "#b8860b", "least squares", (12, 4, "start")))


def x(ms):
    return LEFT + (WIDTH - LEFT - RIGHT) * math.log(ms / TIME[0]) / math.log(TIME[1] / TIME[0])


def y(omega):
    return TOP + (HEIGHT - TOP - BOTTOM) * math.log(OMEGA[1] / omega) / math.log(OMEGA[1] / OMEGA[0])


def text(at_x, at_y, words, size=13, anchor="start", color="#333333", more=""):
    return f"<text x='{at_x:.1f}' y='{at_y:.1f}' font-size='{size}' text-anchor='{anchor}' fill='{color}'{more}>{words}</text>"


def frame(title, lines):
    out = [text(24, 26, title, 15, more=" font-weight='bold'"), text(24, 46, lines, 12, color="#555555")]
    for k in range(0, 17, 4):
        at = y(10.0 ** -k)
        out.append(f"<line x1='{LEFT}' y1='{at:.1f}' x2='{WIDTH - RIGHT}' y2='{at:.1f}' stroke='#e2ded4'/>")
        out.append(text(LEFT - 8, at + 4, f"1e-{k}" if k else "1", 12, "end", "#555555"))
    for ms in (1, 3, 10, 30, 100, 300):
        out.append(f"<line x1='{x(ms):.1f}' y1='{TOP}' x2='{x(ms):.1f}' y2='{HEIGHT - BOTTOM}' stroke='#efece4'/>")
        out.append(text(x(ms), HEIGHT - BOTTOM + 18, str(ms), 12, "middle", "#555555"))
    out.append(text((LEFT + WIDTH - RIGHT) / 2, HEIGHT - 14, "time [ms]", 12, "middle", "#555555"))
    middle = (TOP + HEIGHT - BOTTOM) / 2
    out.append(text(26, middle, "imbalance left, of a block's forces", 12, "middle", "#555555", f" transform='rotate(-90 26 {middle:.0f})'"))
    return out


def series(rows, real, stage, color, words, label):
    own = [r for r in rows if (r["real"], r["stage"], r["cone"]) == (real, stage, "true")]
    points = sorted((1e3 * float(r["seconds"]), max(float(r["omega"]), OMEGA[0]), r["is"] == "right") for r in own)
    points = [p for p in points if p[0] <= TIME[1]]
    line = " ".join(f"{x(t):.1f},{y(o):.1f}" for t, o, _ in points)
    out = [f"<polyline points='{line}' fill='none' stroke='{color}' stroke-width='1.2' opacity='0.5'/>"]
    for t, o, right in points:
        out.append(f"<circle cx='{x(t):.1f}' cy='{y(o):.1f}' r='4.5' stroke='{color}' stroke-width='1.5' fill='{color if right else '#fcfbf8'}'/>")
    end = points[4] if stage == "polish" else points[-1]
    at = x(end[0]) + label[0], y(end[1]) + label[1]
    return out + [text(*at, words, 12.5, label[2], color)]


def main():
    if len(sys.argv) < 2:
        sys.exit(__doc__)
    scene = sys.argv[2] if len(sys.argv) > 2 else "wall-500"
    with open(sys.argv[1], encoding="utf-8") as f:
        rows = [r for r in csv.DictReader(f) if r["scene"] == scene]
    body = frame("What accuracy costs", f"A wall of {rows[0]['interfaces']} joints, each method alone, one mark per tolerance; "
                 "filled: it gives a verdict, hollow: undecided")
    for s in SERIES:
        body += series(rows, *s)
    print(f"<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 {WIDTH} {HEIGHT}' width='{WIDTH}' height='{HEIGHT}' {FONT}>")
    print(f"<rect width='{WIDTH}' height='{HEIGHT}' fill='#fcfbf8'/>")
    print("\n".join(body))
    print("</svg>")


if __name__ == "__main__":
    main()
