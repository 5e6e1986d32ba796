#!/usr/bin/env python3
"""The models of this folder, as programs of others export them.      make.py, here; standard library only"""
import json
import math

BOX = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]      # of 8 corners, bits x y z


def box(x, y, z):
    return [(x[k & 1], y[k >> 1 & 1], z[k >> 2]) for k in range(8)]


def y_up(p): return (p[0], p[2], -p[1])                     # as exporters turn z up into y up


def write(path, head, blocks, line, face):
    """blocks: (name, corners); face: how a corner is written, of its number and of its face's normal."""
    with open(path, "w", newline="\n") as out:
        out.write(head)
        at = 1
        for name, corners in blocks:
            out.write(line % {"name": name})
            for p in corners:
                out.write("v %.6f %.6f %.6f\n" % y_up(p))
            for f in BOX:
                out.write("f " + " ".join(face % (at + k) for k in f) + "\n")
            at += len(corners)


def voussoir(k, n, inner, outer, depth):
    a = [math.pi * (k + i) / n for i in (1, 0)]             # from the right springing to the left
    return [(r * math.cos(t), y, r * math.sin(t)) for r in (inner, outer) for y in (0, depth) for t in a]


def arch():
    """Eleven stones over 4 m and two springers, in mm."""
    stones = []
    for k in range(11):
        v = voussoir(k, 11, 2000.0, 2500.0, 600.0)          # bits: angle, depth, radius
        stones.append(("Voussoir_%02d" % (k + 1), v))
    for name, x in (("Springer_R", (2000.0, 2500.0)), ("Springer_L", (-2500.0, -2000.0))):
        stones.append((name, box(x, (0.0, 600.0), (-800.0, 0.0))))
    write("arch.obj", "# Rhino\n\n", stones, "o %(name)s\n", "%d")


def wall():
    """Three courses of bricks with a doorway and its lintel, in m."""
    bricks = []
    for row in range(6):
        z = (0.2 * row, 0.2 * row + 0.2)
        for side in (0.0, 1.8):
            cuts = [0.0, 0.4, 0.8] if row % 2 == 0 else [0.0, 0.2, 0.6, 0.8]
            for a, b in zip(cuts, cuts[1:]):
                bricks.append(("Cube.%03d" % len(bricks), box((side + a, side + b), (0.0, 0.2), z)))
    bricks.append(("Lintel", box((0.4, 2.2), (0.0, 0.2), (1.2, 1.45))))
    head = "# Blender 3.6.0\n# www.blender.org\nmtllib wall.mtl\nvt 0.000000 0.000000\nvn 0.0000 1.0000 0.0000\n"
    write("wall.obj", head, bricks, "o %(name)s\ng %(name)s_Stone\nusemtl Stone\ns off\n", "%d/1/1")


def scanned():
    """Twelve stones of a wall as a scanner gives them, y up, in m, one cloud of triangles: no two faces meet, gaps and overlaps
    up to 0.1 mm."""
    state = 1
    corners, faces = [], []
    for row in range(4):
        for k in range(3):
            x = 0.5 * k + (0.25 if row % 2 else 0.0)
            faces += [[len(corners) + v for v in (f[0], f[i], f[i + 1])] for f in BOX for i in (1, 2)]
            for p in box((x, x + 0.5), (0.0, 0.3), (0.3 * row, 0.3 * row + 0.3)):
                moved = []
                for c in p:
                    state = state * 16807 % 2147483647      # the same everywhere
                    moved.append(c + 5e-5 * (2.0 * state / 2147483647 - 1.0))
                corners.append(y_up(moved))
    with open("scanned.ply", "w", newline="\n") as out:
        out.write("ply\nformat ascii 1.0\ncomment scanned\nelement vertex %d\n" % len(corners))
        out.write("property float x\nproperty float y\nproperty float z\n")
        out.write("element face %d\nproperty list uchar int vertex_indices\nend_header\n" % len(faces))
        out.writelines("%.6f %.6f %.6f\n" % p for p in corners)
        out.writelines("3 %d %d %d\n" % tuple(f) for f in faces)


def ears(p):
    """Triangles of a plane polygon that runs anticlockwise: ears are cut off until three corners are left."""
    def turn(a, b, c): return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])

    left, found = list(range(len(p))), []
    while len(left) > 3:
        for k in range(len(left)):
            a, b, c = left[k - 1], left[k], left[(k + 1) % len(left)]
            inside = [v for v in left if v not in (a, b, c) and turn(p[a], p[b], p[v]) >= 0 and turn(p[b], p[c], p[v]) >= 0
                      and turn(p[c], p[a], p[v]) >= 0]
            if turn(p[a], p[b], p[c]) > 0 and not inside:
                found.append((a, b, c))
                del left[k]
                break
    return found + [tuple(left)]


def puzzle():
    """Three printed pieces, in mm, z up: a post with a groove, a bar whose foot is held in it, a saddle over the bar's end, with
    clearances of 0.1 mm."""
    c = 0.1
    post = [(0, 0), (40, 0), (40, 30), (10, 30), (10, 50 + 2 * c), (40, 50 + 2 * c), (40, 70), (0, 70)]
    bar = [(10 + c, 30 + c), (120, 30 + c), (120, 50 + c), (10 + c, 50 + c)]
    saddle = [(-5, 20), (5 - c, 20), (5 - c, 50 + 2 * c), (25 + c, 50 + 2 * c), (25 + c, 20), (35, 20), (35, 60), (-5, 60)]
    text = "solid puzzle\n"
    for outline, ends, place in ((post, (0, 30), lambda u, v, w: (u, w, v)), (bar, (5, 25), lambda u, v, w: (u, w, v)),
                                 (saddle, (110, 90), lambda u, v, w: (w, u, v))):
        n = len(outline)
        sides = [((k, 0), (i, 0), (i, 1)) for i, k in zip(range(n), [*range(1, n), 0])]
        sides += [((k, 0), (i, 1), (k, 1)) for i, k in zip(range(n), [*range(1, n), 0])]
        flat = ears(outline)
        for t in sides + [tuple((v, 0) for v in f) for f in flat] + [tuple((v, 1) for v in f[::-1]) for f in flat]:
            text += "facet normal 0 0 0\nouter loop\n"
            text += "".join("vertex %.4f %.4f %.4f\n" % place(*outline[v], ends[side]) for v, side in t)
            text += "endloop\nendfacet\n"
    with open("puzzle.stl", "w", newline="\n") as out:
        out.write(text + "endsolid puzzle\n")


def doorway():
    """Two posts and a beam, as compas_assembly 1.x stores them: no supports in the file."""
    deep = (0.0, 0.4)
    parts = [box((0.0, 0.4), deep, (0.0, 2.0)), box((1.6, 2.0), deep, (0.0, 2.0)), box((0.0, 2.0), deep, (2.0, 2.4))]
    node = {}
    for k, corners in enumerate(parts):
        vertex = {str(i): dict(zip("xyz", p)) for i, p in enumerate(corners)}
        data = {"vertex": vertex, "face": {str(i): list(f) for i, f in enumerate(BOX)}}
        node[str(k)] = {"block": {"dtype": "compas_assembly.datastructures/Block", "value": data}, "is_support": False}
    graph = {"dtype": "compas.datastructures/Graph", "value": {"node": node, "edge": {}, "dna": {}, "dea": {}}}
    with open("doorway.json", "w", newline="\n") as out:
        json.dump({"dtype": "compas_assembly.datastructures/Assembly", "value": {"graph": graph}}, out, indent=1)
        out.write("\n")


arch()
wall()
scanned()
puzzle()
doorway()
