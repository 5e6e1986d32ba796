#!/usr/bin/env python3
"""concept: the drawing of block, joint, corner and force, and of what "stands" means.      concept.py > concept.svg

Left a block lifted off its support, so that the joint can be seen; right two stacks seen from the side, with forces to scale.
Standard library only.
"""
import math

INK, GREY, STONE, SIDE, TOP_ = "#333333", "#666666", "#d9cdb8", "#b3a792", "#e6dcca"
ORANGE, BLUE, GREEN, RED = "#d9780f", "#1d5fa6", "#1f7a3d", "#b2182b"
MU = 0.6
out = []


def say(x, y, words, size=13, anchor="start", color=INK, weight="normal"):
    out.append(f"<text x='{x:.1f}' y='{y:.1f}' font-size='{size}' text-anchor='{anchor}' fill='{color}' font-weight='{weight}'>{words}</text>")


def shape(points, fill, stroke=INK, more=""):
    at = " ".join(f"{x:.1f},{y:.1f}" for x, y in points)
    out.append(f"<polygon points='{at}' fill='{fill}' stroke='{stroke}' stroke-linejoin='round' {more}/>")


def line(a, b, color=GREY, width=1.0, more=""):
    out.append(f"<line x1='{a[0]:.1f}' y1='{a[1]:.1f}' x2='{b[0]:.1f}' y2='{b[1]:.1f}' stroke='{color}' stroke-width='{width}' {more}/>")


def dot(at, color=ORANGE, r=3.6):
    out.append(f"<circle cx='{at[0]:.1f}' cy='{at[1]:.1f}' r='{r}' fill='{color}'/>")


def arrow(a, b, color=BLUE, width=2.4):
    length = math.hypot(b[0] - a[0], b[1] - a[1])
    u = ((b[0] - a[0]) / length, (b[1] - a[1]) / length)
    back = (b[0] - 9 * u[0], b[1] - 9 * u[1])
    line(a, back, color, width)
    shape([b, (back[0] - 4.2 * u[1], back[1] + 4.2 * u[0]), (back[0] + 4.2 * u[1], back[1] - 4.2 * u[0])], color, color)


def hull(points):
    """Convex hull, anticlockwise, by Andrew's monotone chain."""
    points = sorted(set(points))

    def chain(run):
        kept = []
        for p in run:
            while len(kept) > 1 and ((kept[-1][0] - kept[-2][0]) * (p[1] - kept[-2][1])
                                     - (kept[-1][1] - kept[-2][1]) * (p[0] - kept[-2][0])) <= 0:
                kept.pop()
            kept.append(p)
        return kept[:-1]
    return chain(points) + chain(points[::-1])


# ---------------------------------------------------------------------------------------------------------- left: in space

SCALE, AT = 118, (30, 330)


def see(x, y, z):
    """Parallel projection: x to the right, y to the back, z up."""
    return AT[0] + SCALE * (x + 0.46 * y), AT[1] - SCALE * (z + 0.30 * y)


def box(low, high, more=""):
    (a, b, c), (d, e, f) = low, high
    shape([see(a, b, c), see(d, b, c), see(d, b, f), see(a, b, f)], STONE, INK, more)
    shape([see(d, b, c), see(d, e, c), see(d, e, f), see(d, b, f)], SIDE, INK, more)
    shape([see(a, b, f), see(d, b, f), see(d, e, f), see(a, e, f)], TOP_, INK, more)


def hatched(low, high):
    box(low, high)
    (a, b, c), (d, _, f) = low, high
    shape([see(a, b, c), see(d, b, c), see(d, b, f), see(a, b, f)], "url(#hatch)")


def cone(at, height):
    rim = [see(at[0] + MU * height * math.cos(t), at[1] + MU * height * math.sin(t), at[2] + height)
           for t in [2 * math.pi * k / 60 for k in range(60)]]
    shape(hull([see(*at)] + rim), BLUE, "none", "fill-opacity='0.13'")
    shape(rim, "none", BLUE, "stroke-opacity='0.45' stroke-width='0.8'")


def in_space():
    joint = [(0.35, 0.15, 0.5), (1.75, 0.15, 0.5), (1.75, 1.05, 0.5), (0.35, 1.05, 0.5)]
    hatched((0, 0, 0), (2.1, 1.2, 0.5))
    shape([see(*p) for p in joint], ORANGE, ORANGE, "fill-opacity='0.35' stroke-width='2'")
    for x, y, z in joint:
        line(see(x, y, z), see(x, y, 1.45), GREY, 0.8, "stroke-dasharray='3 4'")
    for p in (joint[3], joint[2], joint[0], joint[1]):
        cone(p, 0.42)
    for p, (ft1, ft2, fn) in zip(joint, ((0.10, 0.05, 0.62), (-0.12, 0.04, 0.52), (-0.04, -0.10, 0.40), (0.06, -0.06, 0.46))):
        arrow(see(*p), see(p[0] + ft1, p[1] + ft2, p[2] + fn))
        dot(see(*p))
    box((0.35, 0.15, 1.45), (1.75, 1.05, 1.95), "fill-opacity='0.94'")
    say(*see(1.05, 0.15, 1.65), "block B", 15, "middle", weight="bold")
    say(*see(1.05, 0, 0.19), "block A, fixed", 15, "middle", weight="bold")
    x, y = see(2.62, 0.9, 0.98)
    say(x, y - 26, "force on B at a corner,", 14, color=BLUE)
    say(x, y - 10, "inside its friction cone", 14, color=BLUE)
    line((x - 5, y - 18), see(1.80, 0.98, 0.90), BLUE)
    say(x, y + 36, "joint: the polygon", 14, color=ORANGE)
    say(x, y + 52, "that A and B share", 14, color=ORANGE)
    line((x - 5, y + 42), see(1.6, 0.7, 0.5), ORANGE)
    say(x, y + 88, "corner of the joint", 14, color=ORANGE)
    line((x - 5, y + 84), see(1.77, 0.15, 0.5), ORANGE)
    say(see(0.35, 0, 0)[0] - 50, 36, "B is lifted here, so that the joint shows", 13, color=GREY)


# --------------------------------------------------------------------------------------------- right: two stacks from the side

def side(x, y, dx, base, color, unit=62):
    """A block 2 wide on a support that begins dx further right.     returns its corners of contact"""
    def at(u, v):
        return x + unit * u, y - unit * v
    shape([at(dx, -0.45), at(2.55, -0.45), at(2.55, 0), at(dx, 0)], STONE)
    shape([at(dx, -0.45), at(2.55, -0.45), at(2.55, 0), at(dx, 0)], "url(#hatch)")
    shape([at(0, 0), at(2, 0), at(2, base), at(0, base)], TOP_)
    line(at(dx, 0), at(2, 0), ORANGE, 3)
    for u in (dx, 2):
        shape([at(u, 0), at(u - MU * 0.42, 0.42), at(u + MU * 0.42, 0.42)], BLUE, "none", "fill-opacity='0.13'")
    weight = 0.85
    arrow(at(1, base / 2), at(1, base / 2 - weight), INK)
    say(at(1, base / 2)[0] + 7, at(1, base / 2)[1] + 2, "weight", 12)
    dot(at(1, base / 2), INK, 2.8)
    if dx < 1:                                          # moments about either corner: the lever rule
        for u, share in ((dx, (2 - 1) / (2 - dx)), (2, (1 - dx) / (2 - dx))):
            arrow(at(u, 0), at(u, share * weight))
    else:
        c, s = math.cos(math.radians(13)), math.sin(math.radians(13))
        turned = [at(dx + (u - dx) * c - v * s, (u - dx) * s + v * c) for u, v in ((0, 0), (2, 0), (2, base), (0, base))]
        shape(turned, "none", color, "stroke-width='1.8' stroke-dasharray='6 4'")
    for u in (dx, 2):
        dot(at(u, 0))


def main():
    in_space()
    line((572, 24), (572, 360), "#dcd6c8")
    side(604, 104, 0.6, 0.8, GREEN)
    say(790, 48, "It stands:", 16, color=GREEN, weight="bold")
    for k, words in enumerate(("there are forces that", "balance every block,", "and each stays inside", "its cone.")):
        say(790, 71 + 19 * k, words, 14)
    line((600, 178), (960, 178), "#dcd6c8")
    side(604, 296, 1.25, 0.8, RED)
    say(790, 222, "It falls:", 16, color=RED, weight="bold")
    for k, words in enumerate(("there are none. A motion", "proves it: the weight does", "work, and no forces in the", "cones can take it up.")):
        say(790, 245 + 19 * k, words, 14)
    print("<svg xmlns='http://www.w3.org/2000/svg' viewBox='0 0 980 384' width='980' height='384' "
          "font-family=\"Helvetica, Arial, 'DejaVu Sans', sans-serif\">")
    print("<defs><pattern id='hatch' width='7' height='7' patternUnits='userSpaceOnUse' patternTransform='rotate(45)'>"
          "<path d='M0 0V7' stroke='#2f3942' stroke-width='1.3' stroke-opacity='0.4'/></pattern></defs>")
    print("<rect width='980' height='384' fill='#fcfbf8'/>")
    print("\n".join(out))
    print("</svg>")


if __name__ == "__main__":
    main()
