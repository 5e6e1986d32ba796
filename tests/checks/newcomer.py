#!/usr/bin/env python3
"""newcomer: from an export of Blender's kind to a verdict and a picture, with nothing but --help.

    newcomer.py [build/stonepack]

The model is a gateway of bricks: y up, millimetres, groups without objects, quads with normals, no supports. Its truth is the same
gateway as a scene file. The last line is `N passed, N failed`.
"""
import json
import os
import re
import shlex
import subprocess
import sys
import tempfile
import xml.etree.ElementTree

cli = os.path.abspath(sys.argv[1] if len(sys.argv) > 1 else "build/stonepack")
tally = {"passed": 0, "failed": 0}
FACES = [(1, 3, 4, 2), (5, 6, 8, 7), (1, 2, 6, 5), (3, 7, 8, 4), (1, 5, 7, 3), (2, 4, 8, 6)]        # corners: bits x y z


def part(name, why):
    tally["failed" if why else "passed"] += 1
    if why:
        print("FAILED %s: %s" % (name, why))


def run(*arguments):
    p = subprocess.run([cli] + list(arguments), stdout=subprocess.PIPE, stderr=subprocess.PIPE, timeout=120)
    return p.returncode, p.stdout.decode("utf-8", "replace"), p.stderr.decode("utf-8", "replace")


def gateway(tail):
    """Two piers of four courses, on each a stone from `tail` inwards beyond it, and one that both carry: x y z in m."""
    bricks = []
    for course in range(4):
        cuts = (0, .5, 1) if course % 2 else (0, .3, .7, 1)
        for x in 0, 2:
            bricks += [((x + a, x + b), (0, .4), (.25 * course, .25 * course + .25)) for a, b in zip(cuts, cuts[1:])]
    bricks += [((tail, 1.4), (0, .4), (1, 1.3)), ((1.6, 3 - tail), (0, .4), (1, 1.3)), ((1.2, 1.8), (0, .4), (1.3, 1.6))]
    return bricks


def corners(b):
    return [(b[0][k & 1], b[1][k >> 1 & 1], b[2][k >> 2]) for k in range(8)]


def export(path, bricks, named="Brick"):
    """As Blender writes it: y up, in mm."""
    with open(path, "w") as out:
        out.write("# Blender v3.4.1 OBJ File: 'gateway.blend'\n# www.blender.org\nmtllib gateway.mtl\n")
        for i, b in enumerate(bricks):
            out.write("g %s %03d_Cube.%03d\n" % ("support" if named == "support" and b[2][0] == 0 else "Brick", i, i))
            out.writelines("v %f %f %f\n" % (1000 * x, 1000 * z, -1000 * y) for x, y, z in corners(b))
            out.write("vt 0.625000 0.500000\nvn 0.0000 1.0000 0.0000\nusemtl Stone\ns off\n")
            out.writelines("f " + " ".join("%d/%d/%d" % (8 * i + v, i + 1, i + 1) for v in f) + "\n" for f in FACES)


def scene(path, bricks, ground):
    """The same as a scene file, on the ground or with its lowest stones fixed."""
    with open(path, "w") as out:
        parts = bricks + ([((-1, 4), (-1, 2), (-1, 0))] if ground else [])
        for i, b in enumerate(parts):
            out.write("o s%d\n%s" % (i, "#@ fixed\n" if i == len(bricks) or (not ground and b[2][0] == 0) else ""))
            out.writelines("v %r %r %r\n" % p for p in corners(b))
            out.writelines("f " + " ".join(str(8 * i + v) for v in f) + "\n" for f in FACES)


def answer(path, *options):
    status, out, err = run("check", "--json", *options, path)
    found = json.loads(out) if out else {}
    return found.get("verdict", err), found.get("interfaces"), found.get("max_compression", 0), found.get("remarks", [])


def differs(got, want):
    """Verdict and joints; of forces half a per mille."""
    if got[:2] != want[:2] or abs(got[2] - want[2]) > 5e-4 * want[2]:
        return "got %s, want %s" % (got[:3], want[:3])
    return "remarks: %s" % got[3] if got[3] else ""


def in_one_line(tail, verdict):
    export("gateway.obj", gateway(tail))
    scene("truth.obj", gateway(tail), True)
    options = ["--unit", "mm", "--up", "y", "--fixed", "ground"]
    want = answer("truth.obj")
    part("truth is %s" % verdict, "" if want[0] == verdict else str(want))
    part("export, %s" % verdict, differs(answer("gateway.obj", *options), want))
    status, out, err = run("check", *options, "--svg", "picture.svg", "gateway.obj")
    part("picture, %s" % verdict, err or illegible("picture.svg", out))


def texts(svg):
    """(text, left, top, right, bottom, size) of each; letters are some 0.58 of their size wide."""
    found = []

    def walk(e, size, anchor):
        size, anchor = float(e.get("font-size", size)), e.get("text-anchor", anchor)
        if e.tag.endswith("}text"):
            word = "".join(e.itertext())
            wide = .58 * size * len(word)
            x = float(e.get("x")) - {"start": 0, "middle": .5, "end": 1}[anchor] * wide
            y = float(e.get("y"))
            found.append((word, x, y - .75 * size, x + wide, y + .2 * size, size, e.get("class")))
        for child in e:
            walk(child, size, anchor)
    walk(svg, 16, "start")
    return found


def unreadable(svg):
    """Letters too small, beyond the edge, over each other."""
    wide, high = [float(x) for x in svg.get("viewBox").split()[2:]]
    words = texts(svg)
    for w in words:
        if w[5] < 9 or w[1] < 0 or w[3] > wide or w[2] < 0 or w[4] > high:
            return "'%s' of size %g at %g .. %g, %g .. %g of %g x %g" % (w[:1] + (w[5], w[1], w[3], w[2], w[4], wide, high))
    for i, a in enumerate(words):
        for b in words[:i]:
            if a[1] < b[3] and b[1] < a[3] and a[2] < b[4] and b[2] < a[4]:
                return "'%s' lies over '%s'" % (a[0], b[0])
    return ""


def illegible(path, out):
    """What can't be read, names of blocks told of that are missing, a picture that lies on its side."""
    svg = xml.etree.ElementTree.parse(path).getroot()
    wide, high = [float(x) for x in svg.get("viewBox").split()[2:]]
    words = texts(svg)
    if unreadable(svg):
        return unreadable(svg)
    told = re.findall(r"Brick_\d+_Cube\.\d+", " ".join(x for x in out.split("\n") if re.match("  (weakest|moving)", x)))
    shown = " ".join(w[0] for w in words)
    if not told or not all(t in shown for t in told[:2]):
        return "told of %s, names in the picture are: %s" % (told, shown)
    high = (high - 200) / (2 if any("to move" in w[0] for w in words) else 1)       # of each picture, without the words
    return "" if 1.2 < wide / high < 3 else "a gateway wider than high is %g x %g" % (wide, high)


def kinds():
    """Words of every kind of picture, of five blocks and of 160."""
    for name, words in ("tower", ["n=4", "lean=0.05"]), ("wall", ["rows=10", "bricks=15"]):
        with open(name + ".obj", "w") as out:
            out.write(run("gen", name, *words)[1])
        for kind in (["check"], ["check", "--tilt", "30"], ["check", "--coupled"], ["check", "--strong"], ["limit", "--body", "1,0,0"],
                     ["limit", "--tilt-margin"], ["cost"]):
            status, out, err = run(*kind, "--svg", "kind.svg", name + ".obj")
            why = err or unreadable(xml.etree.ElementTree.parse("kind.svg").getroot())
            part("words of %s, %s" % (" ".join(kind), name), why)
            os.remove("kind.svg")


def by_remarks():
    """Whoever types the file's name alone is told what is missing, and with which option."""
    export("gateway.obj", gateway(0))
    scene("truth.obj", gateway(0), True)
    options = []
    for turn in range(4):
        told = [r["option"] for r in answer("gateway.obj", *options)[3] if r["option"]]
        if not told:
            break
        for o in told:
            name, value = re.split(", | or ", o)[0 if o.startswith("--unit") else -1].split() if " or " in o else o.split()
            options += [name, value.rstrip(",")]
    got = differs(answer("gateway.obj", *options), answer("truth.obj"))
    part("remarks lead to the answer", "%s with %s" % (got, options) if got or turn == 3 else "")


def by_help():
    """The command that --help shows, with the file's name in it."""
    export("model.obj", gateway(0), "support")
    scene("truth.obj", gateway(0), False)
    shown = [line for line in run("--help")[1].split("\n") if re.match(" +stonepack check .*model.obj$", line)]
    if len(shown) != 1:
        return part("help", "shows %s" % shown)
    words = shlex.split(shown[0])[1:]
    status, out, err = run(*words)
    drawn = words[words.index("--svg") + 1] if "--svg" in words else ""
    right = status == 0 and out.startswith("model.obj: STABLE") and "remark" not in out and os.path.exists(drawn)
    part("the command of --help", "" if right else "%d: %s%s" % (status, out, err))
    part("its answer", differs(answer("model.obj", "--unit", "mm", "--up", "y", "--fixed", "support*"), answer("truth.obj")))
    return None


def main():
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        in_one_line(0, "stable")
        in_one_line(.8, "unstable")
        by_remarks()
        by_help()
        kinds()
        os.chdir("/")
    print("%d passed, %d failed" % (tally["passed"], tally["failed"]))
    sys.exit(tally["failed"] > 0)


if __name__ == "__main__":
    main()
