#!/usr/bin/env python3
"""Write a compas_assembly or compas_cra JSON file as a stonepack scene.

  compas2obj.py [--mu X] [--density X] [--gravity X,Y,Z] [--support NODE]... [--no-contacts] [--triangulate] IN.json [OUT.obj]

Blocks are named b0 b1 ... after their nodes. Node attribute is_support (in old files is_anchor) becomes `#@ fixed`; --support
adds more, for assemblies that set them in code only. Contacts are written where every joint of the file has its polygon; else
they are left to be found. Edges run from a to b in the file; polygons are turned so that their normal points from a into b.
Accepts what COMPAS 0.x, 1.x and 2.x wrote: {"datatype"|"dtype", "data"|"value"} around anything, graph or network, flat
node/edge tables, JSON inside a string, a bare list of meshes. --triangulate fans faces that are out of plane by more than 1e-2 of their block.

Exit status: 0, 64 usage, 65 bad file, 66 can't read. Python standard library only.
"""
import argparse
import ast
import json
import math
import sys

DEFAULT_DENSITY, DEFAULT_MU = 2400.0, 0.84


class Bad(Exception):
    pass


def plain(x, depth=0):
    """Take the {dtype, data} and {datatype, value} wrappers off."""
    while isinstance(x, dict) and ("dtype" in x or "datatype" in x) and ("data" in x or "value" in x):
        x = x["data"] if "data" in x else x["value"]
        depth += 1
        if depth > 20:
            raise Bad("wrapped too deep")
    if isinstance(x, str) and x[:1] in "{[":
        try:
            return plain(json.loads(x), depth + 1)
        except ValueError:
            return x
    return x


def number(x, what):
    if isinstance(x, bool) or not isinstance(x, (int, float)) or not math.isfinite(x):
        raise Bad("%s: %r is not a finite number" % (what, x))
    return float(x)


def point(p, what):
    p = plain(p)
    if isinstance(p, dict):
        p = [p.get("x"), p.get("y"), p.get("z")]
    if not isinstance(p, (list, tuple)) or len(p) != 3:
        raise Bad("%s: a point needs three numbers" % what)
    return [number(c, what) for c in p]


def order(keys):
    """Node keys in the order of their numbers, else of their text."""
    try:
        return sorted(keys, key=lambda k: (0, int(k), ""))
    except ValueError:
        return sorted(keys, key=lambda k: (1, 0, str(k)))


def unquoted(key):
    """Keys of old files carry quotes of their own."""
    key = str(key)
    if len(key) > 1 and key[0] in "'\"" and key[-1] == key[0]:
        key = key[1:-1]
    return key


# ---------------------------------------------------------------------------------------------------------------- meshes

def mesh(block, what):
    """Vertices and faces of a COMPAS mesh: tables by key."""
    block = plain(block)
    if not isinstance(block, dict) or not isinstance(block.get("vertex"), dict) or not isinstance(block.get("face"), dict):
        raise Bad("%s has no mesh with vertex and face tables" % what)
    preset = dict({"x": 0.0, "y": 0.0, "z": 0.0}, **(plain(block.get("default_vertex_attributes", block.get("dva"))) or {}))
    index, xyz, faces = {}, [], []
    for key in order(block["vertex"]):
        at = dict(preset, **(plain(block["vertex"][key]) or {}))
        index[unquoted(key)] = len(xyz)
        xyz.append(point([at["x"], at["y"], at["z"]], "%s vertex %s" % (what, key)))
    for key in order(block["face"]):
        corners = [unquoted(c) for c in plain(block["face"][key]) or []]
        if len(corners) > 3 and corners[0] == corners[-1]:
            corners.pop()                                   # written closed by some
        missing = [c for c in corners if c not in index]
        if missing:
            raise Bad("%s face %s: no vertex %s" % (what, key, missing[0]))
        if len(corners) < 3:
            raise Bad("%s face %s has %d corners" % (what, key, len(corners)))
        faces.append([index[c] for c in corners])
    if not faces:
        raise Bad("%s has no faces" % what)
    return xyz, faces


def sub(a, b): return [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
def dot(a, b): return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
def cross(a, b): return [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]


def mean(points):
    return [sum(p[c] for p in points) / len(points) for c in range(3)]


def newell(points):
    n = [0.0, 0.0, 0.0]
    for a, b in zip(points[1:], points[2:]):
        c = cross(sub(a, points[0]), sub(b, points[0]))
        n = [n[k] + c[k] for k in range(3)]
    return n


def volume6(xyz, faces):
    """Six times the volume, about a vertex; negative: the faces look inward."""
    o = xyz[0]
    return sum(dot(sub(xyz[f[0]], o), cross(sub(xyz[a], o), sub(xyz[b], o))) for f in faces for a, b in zip(f[1:], f[2:]))


def warped(xyz, face):
    """Largest distance of a corner from the face's mean plane."""
    p = [xyz[v] for v in face]
    n = newell(p)
    size = math.sqrt(dot(n, n))
    m = mean(p)
    return max(abs(dot(sub(q, m), n)) for q in p) / size if size > 0 else 0.0


def tidy(xyz, faces, triangulate):
    """Faces outward; those too far out of plane as triangles if asked for."""
    if volume6(xyz, faces) < 0:
        faces = [f[::-1] for f in faces]
    if triangulate:
        d = math.sqrt(sum((max(p[c] for p in xyz) - min(p[c] for p in xyz)) ** 2 for c in range(3)))
        faces = [g for f in faces
                 for g in ([[f[0], a, b] for a, b in zip(f[1:], f[2:])] if len(f) > 3 and warped(xyz, f) > 1e-2 * d else [f])]
    return xyz, faces


# ----------------------------------------------------------------------------------------------------------------- graph

def tables(doc):
    """Node and edge tables, and the defaults of nodes."""
    doc = plain(doc)
    if isinstance(doc, list):
        return dict((str(k), {"block": block}) for k, block in enumerate(doc)), {}, {}, {}
    for _ in range(6):
        if not isinstance(doc, dict):
            break
        if isinstance(doc.get("node"), dict):
            return (doc["node"], plain(doc.get("edge")) or {}, plain(doc.get("default_node_attributes", doc.get("dna"))) or {},
                    plain(doc.get("blocks")) or {})
        for key in ("graph", "network", "assembly", "data"):
            if key in doc:
                inner = plain(doc[key])
                if isinstance(inner, dict) and "blocks" in doc and "blocks" not in inner:
                    inner = dict(inner, blocks=doc["blocks"])
                doc = inner
                break
        else:
            if isinstance(doc.get("vertex"), dict) and "blocks" in doc:     # compas_assembly before 0.2: a network of blocks
                return doc["vertex"], plain(doc.get("edge")) or {}, plain(doc.get("dva")) or {}, plain(doc["blocks"])
            break
    raise Bad("no assembly: neither node nor graph tables")


def edges(table):
    """(a, b, attributes) of {a: {b: attributes}} or {"a-b": attributes} or {"(a, b)": attributes}."""
    for key in order(table):
        value = plain(table[key])
        name = unquoted(key)
        if name[:1] == "(":
            try:
                a, b = ast.literal_eval(name)
            except (ValueError, SyntaxError, TypeError):
                raise Bad("edge %s" % name)
            yield unquoted(a), unquoted(b), value or {}
        elif isinstance(value, dict):
            for other in order(value):
                yield name, unquoted(other), plain(value[other]) or {}


def polygons(attributes):
    """The polygons of an edge; None if it is a joint without one."""
    joints = plain(attributes.get("interfaces"))
    if not joints:
        joints = plain(attributes.get("interface"))
    if not joints:
        joints = attributes if attributes.get("interface_points") else None
    if not joints:
        return None
    found = []
    for j in joints if isinstance(joints, list) else [joints]:
        j = plain(j)
        if not isinstance(j, dict):
            return None
        points = plain(j.get("points", j.get("_points", j.get("interface_points"))))
        if points is None:
            points = plain(j.get("polygon"))
            points = points.get("points") if isinstance(points, dict) else points
        if not points:
            return None
        found.append([point(p, "interface") for p in points])
    return found


def read(doc, a):
    node, edge, preset, blocks = tables(doc)
    names, scene, supports = {}, [], set(a.support)
    for key in order(node):
        attributes = dict(preset, **(plain(node[key]) or {}))
        name = unquoted(key)
        block = attributes.get("block")
        if block is None:
            block = blocks.get(key, blocks.get(name)) if isinstance(blocks, dict) else None
        if block is None:
            raise Bad("node %s has no block" % name)
        names[name] = "b" + "".join(c if c.isalnum() or c in "-_." else "_" for c in name)
        fixed = bool(attributes.get("is_support") or attributes.get("is_anchor")) or name in supports
        supports.discard(name)
        scene.append((names[name], fixed, tidy(*mesh(block, "block %s" % name), triangulate=a.triangulate)))
    if supports:
        raise Bad("no node %s to support" % sorted(supports)[0])
    if len(set(names.values())) < len(names):
        raise Bad("two nodes have the same name")
    if not scene:
        raise Bad("the assembly has no blocks")
    return scene, contacts(edge, names, dict((n, s) for n, _, s in scene)) if not a.no_contacts else []


def contacts(edge, names, solids):
    """(a, b, points) of every joint, or nothing if one of them lacks its polygon."""
    found = []
    for a, b, attributes in edges(edge):
        if a not in names or b not in names:
            raise Bad("edge %s %s: no such node" % (a, b))
        joints = polygons(attributes) if isinstance(attributes, dict) else None
        if joints is None:
            sys.stderr.write("compas2obj: edge %s %s has no interface polygon: contacts are left to be found\n" % (a, b))
            return []
        for p in joints:
            if len(p) > 3 and p[0] == p[-1]:
                p = p[:-1]
            na, nb = names[a], names[b]
            if inside_first(solids[na], solids[nb], p) < 0:
                p = p[::-1]
            found.append((na, nb, p))
    return found


def nearest_normal(solid, p, n):
    """Outward normal (unit) of the block's face that lies best in the polygon's plane, along n: its sign is what counts."""
    xyz, faces = solid
    m = mean(p)
    best, sign = None, 0.0
    for f in faces:
        q = [xyz[v] for v in f]
        k = newell(q)
        size = math.sqrt(dot(k, k))
        if size == 0:
            continue
        c = dot(k, n) / size
        away = abs(dot(sub(m, q[0]), k)) / size
        score = away / (abs(c) + 1e-9) + (1 - abs(c))
        if best is None or score < best:
            best, sign = score, c
    return sign


def inside_first(a, b, p):
    """> 0 if the polygon's normal leaves a and enters b: by the faces in its plane, which holds for concave blocks too."""
    n = newell(p)
    size = math.sqrt(dot(n, n))
    if size == 0:
        return 1.0
    n = [c / size for c in n]
    s = nearest_normal(a, p, n) - nearest_normal(b, p, n)
    return s if abs(s) > 0.5 else dot(n, sub(mean(b[0]), mean(a[0])))


# ---------------------------------------------------------------------------------------------------------------- output

def write(out, scene, joints, a):
    triple = "%r %r %r"
    out.write("#@ mu %r\n" % a.mu)
    out.write("#@ density %r\n" % a.density)
    if a.gravity:
        out.write("#@ gravity " + triple % tuple(a.gravity) + "\n")
    first = 1
    for name, fixed, (xyz, faces) in scene:
        out.write("o %s\n" % name)
        if fixed:
            out.write("#@ fixed\n")
        for p in xyz:
            out.write("v " + triple % tuple(p) + "\n")
        for f in faces:
            out.write("f " + " ".join(str(first + v) for v in f) + "\n")
        first += len(xyz)
    for na, nb, p in joints:
        out.write("#@ interface %s %s %s\n" % (na, nb, " ".join(triple % tuple(q) for q in p)))


class Parser(argparse.ArgumentParser):
    def error(self, message):
        self.exit(64, "compas2obj: %s\n" % message)


def vector(text):
    v = [float(c) for c in text.split(",")]
    if len(v) != 3 or not all(math.isfinite(c) for c in v):
        raise argparse.ArgumentTypeError("needs X,Y,Z")
    return v


def positive(text):
    x = float(text)
    if not (math.isfinite(x) and x > 0):
        raise argparse.ArgumentTypeError("needs a positive number")
    return x


def not_negative(text):
    x = float(text)
    if not (math.isfinite(x) and x >= 0):
        raise argparse.ArgumentTypeError("needs a number, 0 or more")
    return x


def main():
    p = Parser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    p.add_argument("--mu", type=not_negative, default=DEFAULT_MU)
    p.add_argument("--density", type=positive, default=DEFAULT_DENSITY)
    p.add_argument("--gravity", type=vector)
    p.add_argument("--support", action="append", default=[], metavar="NODE")
    p.add_argument("--no-contacts", action="store_true")
    p.add_argument("--triangulate", action="store_true")
    p.add_argument("input")
    p.add_argument("output", nargs="?", default="-")
    a = p.parse_args()
    try:
        with (sys.stdin.buffer if a.input == "-" else open(a.input, "rb")) as f:
            raw = f.read()
    except OSError as e:
        sys.stderr.write("%s: can't read: %s\n" % (a.input, e.strerror))
        return 66
    try:
        scene, joints = read(json.loads(raw.decode("utf-8-sig")), a)
    except Bad as e:
        sys.stderr.write("%s: %s\n" % (a.input, e))
        return 65
    except (ValueError, RecursionError) as e:
        sys.stderr.write("%s: no JSON: %s\n" % (a.input, e))
        return 65
    except (KeyError, TypeError, AttributeError) as e:
        sys.stderr.write("%s: not laid out as an assembly (%s: %s)\n" % (a.input, type(e).__name__, e))
        return 65
    try:
        if a.output == "-":
            write(sys.stdout, scene, joints, a)
        else:
            with open(a.output, "w") as out:
                write(out, scene, joints, a)
    except OSError as e:
        sys.stderr.write("%s: can't write: %s\n" % (a.output, e.strerror))
        return 70
    return 0


if __name__ == "__main__":
    sys.exit(main())
