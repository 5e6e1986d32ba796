#!/usr/bin/env python3
"""formats: models in forms of others, sound and broken ones.      formats.py [build/stonepack]

Sound ones get the verdict of the scene they hold. Broken ones give exit status 65, one line on standard error that starts with
the file's name, and nothing on standard output. Files are made in a temporary folder. The last line is `N passed, N failed`.
"""
import base64
import json
import os
import struct
import subprocess
import sys
import tempfile
import time

cli = os.path.abspath(sys.argv[1] if len(sys.argv) > 1 else "build/stonepack")
tally = {"passed": 0, "failed": 0}
each = None                                             # called in each process before the program begins
BOX = [(0, 2, 3, 1), (4, 5, 7, 6), (0, 1, 5, 4), (2, 6, 7, 3), (0, 4, 6, 2), (1, 3, 7, 5)]      # of 8 corners, bits x y z


def box(x, y, z):
    return [(x[k & 1], y[k >> 1 & 1], z[k >> 2]) for k in range(8)]


BOX_CORNERS = box((0, 1), (0, 1), (0, 1))


def ends(name, why):
    tally["failed" if why else "passed"] += 1
    if why:
        print("FAILED %s: %s" % (name, why))


def total():
    print("%d passed, %d failed" % (tally["passed"], tally["failed"]))
    sys.exit(tally["failed"] > 0)


def run(*arguments):
    p = subprocess.run([cli] + list(arguments), stdout=subprocess.PIPE, stderr=subprocess.PIPE, timeout=240, preexec_fn=each)
    return p.returncode, p.stdout.decode("utf-8", "replace"), p.stderr.decode("utf-8", "replace")


def write(path, data):
    mode = "wb" if isinstance(data, bytes) else "w"
    with open(path, mode) as out:
        out.write(data)


def sound(name, data, first, *arguments, remark="", joints=None):
    """The first line of what check says of it, and a remark."""
    write(name, data)
    status, out, err = run("check", *arguments, name)
    if not out.startswith("%s: %s" % (name, first)) or err:
        return ends(name, "%d: %s %s" % (status, out.split("\n")[0], err))
    if joints is not None and " %d joint" % joints not in out:
        return ends(name, "want %d joints:\n%s" % (joints, out))
    return ends(name, "" if remark in out else "no remark '%s':\n%s" % (remark, out))


def broken(name, data, text="", *arguments, status=65):
    write(name, data)
    got, out, err = run("check", *arguments, name)
    ends(name, "exit status %d: %s" % (got, err) if got != status else "something on standard output" if out
         else "%d lines of message: %s" % (err.count("\n"), err) if err.count("\n") != 1
         else "'%s' is not in: %s" % (text, err) if text not in err or not err.startswith(name) else "")


PARTS = [box((0, .4), (0, .4), (0, 2)), box((1.6, 2), (0, .4), (0, 2)), box((0, 2), (0, .4), (2, 2.4))]      # a doorway


def obj(blocks):
    """(name, corners, faces)..."""
    text, at = "", 1
    for name, corners, faces in blocks:
        text += "o %s\n" % name + "".join("v %.9g %.9g %.9g\n" % tuple(p) for p in corners)
        text += "".join("f " + " ".join(str(at + v) for v in f) + "\n" for f in faces)
        at += len(corners)
    return text


def joined(parts):
    corners = [p for c in parts for p in c]
    return corners, [[8 * k + v for v in f] for k in range(len(parts)) for f in BOX]


def solids():
    one = [("door", *joined(PARTS))]
    hollow = (box((-1, 3), (-1, 1.4), (2.4, 4)) + box((0, 2), (0, .4), (3, 3.5)),
              BOX + [tuple(8 + v for v in f[::-1]) for f in BOX])
    tall = box((0, .4), (0, .4), (0, 1))
    tall[7] = (.4, .4, 1.2)
    cap = [(x, y, z + 1) for x, y, z in tall]
    cap[:4] = tall[4:]
    sound("shells.obj", obj(one), "STABLE", "--fixed", "ground", remark="'door' of 3, move as one; each shell a block: --split")
    sound("split.obj", obj(one), "STABLE", "--split", "--fixed", "door.1,door.2", joints=2)
    sound("hollow.obj", obj(one + [("roof", *hollow)]), "STABLE", "--split", "--fixed", "lowest", joints=3)
    sound("warped.obj", obj([("foot", tall, BOX), ("cap", cap, BOX)]), "STABLE", "--fixed", "foot", "--mu", "2", joints=2,
          remark="3 warped faces of 2 blocks, the first 'foot', were cut into triangles")
    loose = "".join("v %g %g %g\n" % c[v] for c in PARTS for f in BOX for v in f)
    loose += "".join("f %d %d %d %d\n" % tuple(range(k, k + 4)) for k in range(1, 24 * len(PARTS), 4))
    sound("loose.obj", "o door\n" + loose, "STABLE", "--split", "--fixed", "door.1,door.2", joints=2)
    sound("loose-one.obj", "o door\n" + loose, "STABLE", "--fixed", "ground", remark="the first 'door' of 3, move as one")
    broken("loaded.obj", obj(one) + "#@ load door 0 0 -1 0 0 1\n", "tells loads of 'door'", "--split")
    broken("pressed.obj", obj([("foot", tall, BOX)]) + "#@ pressure foot 2 10\n", "out of plane")


# -------------------------------------------------------------------------------------------------- by the importer

def triangles(parts):
    return [[c[f[0]], c[f[k]], c[f[k + 1]]] for c in parts for f in BOX for k in (1, 2)]


def stl(parts):
    """Binary: each triangle has corners of its own, shells are not told apart."""
    t = triangles(parts)
    return b"\0" * 80 + struct.pack("<I", len(t)) + b"".join(
        struct.pack("<12fH", 0, 0, 0, *[x for p in c for x in p], 0) for c in t)


def stl_text(parts):
    text = ""
    for k, c in enumerate(parts):
        text += "solid part%d\n" % k
        for t in triangles([c]):
            text += "facet normal 0 0 0\nouter loop\n" + "".join("vertex %.9g %.9g %.9g\n" % p for p in t) + "endloop\nendfacet\n"
        text += "endsolid part%d\n" % k
    return text


def ply(parts, form="ascii"):
    corners, faces = joined(parts)
    head = ("ply\nformat %s 1.0\nelement vertex %d\nproperty float x\nproperty float y\nproperty float z\n"
            "element face %d\nproperty list uchar int vertex_indices\nend_header\n" % (form, len(corners), len(faces)))
    if form == "ascii":
        return head + "".join("%.9g %.9g %.9g\n" % p for p in corners) + "".join("4 %d %d %d %d\n" % tuple(f) for f in faces)
    way = "<" if "little" in form else ">"
    return head.encode() + b"".join(struct.pack(way + "3f", *p) for p in corners) + b"".join(
        struct.pack(way + "B4i", 4, *f) for f in faces)


def off(parts):
    corners, faces = joined(parts)
    return "OFF\n%d %d 0\n" % (len(corners), len(faces)) + "".join("%g %g %g\n" % p for p in corners) + "".join(
        "4 %d %d %d %d\n" % tuple(f) for f in faces)


def gltf(parts, **change):
    """Each part a node; y is up."""
    data = b"".join(struct.pack("<3f", p[0], p[2], -p[1]) for c in parts for p in c)
    index = [v for f in BOX for k in (1, 2) for v in (f[0], f[k], f[k + 1])]
    at = len(data)
    data += struct.pack("<%dH" % len(index), *index)
    n = len(parts)
    doc = {"asset": {"version": "2.0"}, "scene": 0, "scenes": [{"nodes": list(range(n))}],
           "nodes": [{"mesh": k, "name": "part%d" % k} for k in range(n)],
           "meshes": [{"primitives": [{"attributes": {"POSITION": k}, "indices": n}]} for k in range(n)],
           "buffers": [{"byteLength": len(data), "uri": "data:application/octet-stream;base64," + base64.b64encode(data).decode()}],
           "bufferViews": [{"buffer": 0, "byteOffset": 0, "byteLength": at},
                           {"buffer": 0, "byteOffset": at, "byteLength": 2 * len(index)}],
           "accessors": [{"bufferView": 0, "byteOffset": 96 * k, "componentType": 5126, "count": 8, "type": "VEC3",
                          "min": [-9, -9, -9], "max": [9, 9, 9]} for k in range(n)]
           + [{"bufferView": 1, "componentType": 5123, "count": len(index), "type": "SCALAR"}]}
    doc.update(change)
    return json.dumps(doc)


def fbx(parts, up, factor):
    """Text, 7.4: each part a mesh and a node; its unit is so many centimetres."""
    objects, links = "", ""
    for k, c in enumerate(parts):
        p = [(x, z, -y) if up == 1 else (x, y, z) for x, y, z in c]
        v = ",".join("%.9g" % (100 / factor * x) for q in p for x in q)
        i = ",".join("%d,%d,%d,%d" % (f[0], f[1], f[2], -f[3] - 1) for f in BOX)
        objects += ('\tGeometry: %d, "Geometry::part%d", "Mesh" {\n\t\tVertices: *24 {\n\t\t\ta: %s\n\t\t}\n\t\tPolygonVertexIndex: '
                    '*24 {\n\t\t\ta: %s\n\t\t}\n\t\tGeometryVersion: 124\n\t}\n\tModel: %d, "Model::part%d", "Mesh" {\n\t\tVersion: 232\n'
                    '\t}\n' % (100 + k, k, v, i, 200 + k, k))
        links += '\tC: "OO",%d,%d\n\tC: "OO",%d,0\n' % (100 + k, 200 + k, 200 + k)
    return ('; FBX 7.4.0 project file\nFBXHeaderExtension:  {\n\tFBXHeaderVersion: 1003\n\tFBXVersion: 7400\n}\nGlobalSettings:  {\n'
            '\tVersion: 1000\n\tProperties70:  {\n\t\tP: "UpAxis", "int", "Integer", "",%d\n\t\tP: "UpAxisSign", "int", "Integer", "",1\n'
            '\t\tP: "UnitScaleFactor", "double", "Number", "",%g\n\t}\n}\nObjects:  {\n%s}\nConnections:  {\n%s}\n'
            % (up, factor, objects, links))


def upright(parts):
    """The same with y up."""
    return [[(x, z, -y) for x, y, z in c] for c in parts]


def x3d(parts):
    shapes = "".join("<Shape DEF='part%d'><IndexedFaceSet coordIndex='%s'><Coordinate point='%s'/></IndexedFaceSet></Shape>" % (
        k, " ".join("%d %d %d %d -1" % f for f in BOX), ", ".join("%.9g %.9g %.9g" % p for p in c)) for k, c in enumerate(parts))
    return "<?xml version='1.0'?><X3D version='3.3'><Scene>%s</Scene></X3D>" % shapes


def studio(parts):
    """3DS, z up: chunks of a mesh in an object in an editor."""
    chunk = lambda kind, data: struct.pack("<HI", kind, 6 + len(data)) + data
    objects = b""
    for k, c in enumerate(parts):
        faces = triangles([BOX_CORNERS])
        at = {p: i for i, p in enumerate(BOX_CORNERS)}
        mesh = chunk(0x4110, struct.pack("<H", 8) + b"".join(struct.pack("<3f", *p) for p in c))
        mesh += chunk(0x4120, struct.pack("<H", len(faces)) + b"".join(struct.pack("<4H", *[at[p] for p in f], 0) for f in faces))
        objects += chunk(0x4000, b"part%d\0" % k + chunk(0x4100, mesh))
    return chunk(0x4d4d, chunk(0x3d3d, objects))


def dae(parts):
    """Nodes with an id of their own beside their name, z up."""
    shapes = "".join("<geometry id='g%d'><mesh><source id='p%d'><float_array id='a%d' count='24'>%s</float_array><technique_common>"
                     "<accessor source='#a%d' count='8' stride='3'><param name='X' type='float'/><param name='Y' type='float'/>"
                     "<param name='Z' type='float'/></accessor></technique_common></source><vertices id='v%d'><input "
                     "semantic='POSITION' source='#p%d'/></vertices><polylist count='6'><input semantic='VERTEX' source='#v%d' "
                     "offset='0'/><vcount>4 4 4 4 4 4</vcount><p>%s</p></polylist></mesh></geometry>" % (
                         k, k, k, " ".join("%.9g" % x for p in c for x in p), k, k, k, k, " ".join("%d" % v for f in BOX for v in f))
                     for k, c in enumerate(parts))
    nodes = "".join("<node id='n-%d' name='part%d'><instance_geometry url='#g%d'/></node>" % (k, k, k) for k in range(len(parts)))
    return ("<?xml version='1.0'?><COLLADA xmlns='http://www.collada.org/2005/11/COLLADASchema' version='1.4.1'><asset>"
            "<unit meter='1'/><up_axis>Z_UP</up_axis></asset><library_geometries>%s</library_geometries><library_visual_scenes>"
            "<visual_scene id='s'>%s</visual_scene></library_visual_scenes><scene><instance_visual_scene url='#s'/></scene>"
            "</COLLADA>" % (shapes, nodes))


def amf(parts):
    text = ""
    for k, c in enumerate(parts):
        text += "<object id='%d'><mesh><vertices>" % k
        text += "".join("<vertex><coordinates><x>%.9g</x><y>%.9g</y><z>%.9g</z></coordinates></vertex>" % p for p in c)
        text += "</vertices><volume>" + "".join("<triangle><v1>%d</v1><v2>%d</v2><v3>%d</v3></triangle>" % (f[0], f[i], f[i + 1])
                                                 for f in BOX for i in (1, 2)) + "</volume></mesh></object>"
    return "<?xml version='1.0'?><amf>%s</amf>" % text


def axes():
    """Which way is up, names, units, digits: as the form has them, or told."""
    feet = ("--fixed", "lowest")
    sound("door.x3d", x3d(upright(PARTS)), "STABLE", "--split", *feet, joints=2, remark="y up")
    sound("door.3ds", studio(PARTS), "STABLE", *feet, joints=2)
    sound("door.dae", dae(PARTS), "STABLE", "--fixed", "part0,part1", joints=2)
    sound("door.amf", amf(PARTS), "STABLE", *feet, joints=2, remark="are millimetres in most such files")
    away = [[(x + 4e6, y, z) for x, y, z in c] for c in PARTS]
    sound("far.ply", ply(away).replace("float", "double"), "", *feet, "--split", remark="such files are read to 24 bits")
    sound("far.obj", obj([("part%d" % k, c, BOX) for k, c in enumerate(away)]), "STABLE", "--fixed", "part0,part1", joints=2)


def units():
    """FBX tells unit and axis up: the same forces whatever they are."""
    write("si.obj", obj([("part%d" % k, c, BOX) for k, c in enumerate(PARTS)]))
    want = json.loads(run("check", "--json", "--fixed", "part0,part1", "si.obj")[1])["max_compression"]
    for name, up, factor in ("cm", 1, 1), ("mm", 1, .1), ("m", 2, 100), ("inch", 1, 2.54), ("foot", 2, 30.48):
        path = name + ".fbx"
        sound(path, fbx(PARTS, up, factor), "STABLE", "--fixed", "part0*,part1*", joints=2, remark="the axis up that the file tells")
        out = run("check", "--json", "--fixed", "part0*,part1*", path)[1]
        got = json.loads(out)["max_compression"] if out else 0
        ends(path + ", forces", "" if abs(got - want) < 1e-5 * want else "%g N, want %g" % (got, want))
    broken("none.fbx", fbx(PARTS, 1, -3), "UnitScaleFactor")
    start = time.time()
    broken("cut.ply", ply(PARTS)[:60], "no end_header")
    ends("cut.ply, at once", "%.1f s" % (time.time() - start) if time.time() - start > 2 else "")


def has_importer():
    write("probe.off", off(PARTS))
    return run("check", "probe.off")[0] != 69          # 69: built without it


def meshes():
    feet = ("--split", "--fixed", "*.1,*.2")
    apart = PARTS[:2] + [box((-.1, 2.1), (-.1, .5), (2, 2.4))]          # no corner meets another
    sound("door.stl", stl(apart), "STABLE", *feet, joints=2)
    sound("text.stl", stl_text(PARTS), "STABLE", "--fixed", "part0*,part1*", joints=2)
    for form in "ascii", "binary_little_endian", "binary_big_endian":
        sound(form + ".ply", ply(apart, form), "STABLE", *feet, joints=2)
    sound("door.off", off(apart), "STABLE", *feet, joints=2)
    sound("door.gltf", gltf(PARTS), "STABLE", "--fixed", "part0*,part1*", joints=2, remark="y up, in metres")
    sound("nodes.gltf", gltf(PARTS), "STABLE", "--fixed", "part0,part1", joints=2)     # without the number behind them
    for word in "ground", "lowest":                                                    # words, unless a node is called so
        sound(word + ".gltf", gltf(PARTS).replace("part0", word), "STABLE", "--fixed", word + ",part1", joints=2,
              remark="'%s' is a block of this model" % word)
    broken("number.gltf", gltf(PARTS), "no block has such a name", "--fixed", "part", status=64)
    for told in "up", "gravity":
        status, out, err = run("check", "--" + told, "z" if told == "up" else "0,0,-9.8", "--fixed", "part0", "nodes.gltf")
        ends("nodes.gltf, %s told" % told, "a remark:\n" + out if status > 2 or "y up" in out else "")
    sound("touching.stl", stl(PARTS), "STABLE", *feet, joints=2)       # corners and edges of posts and lintel are one
    stack = [box((x, x + 1), (0, 1), (z, z + 1)) for z in range(3) for x in range(3)]
    sound("stack.stl", stl(stack), "STABLE", "--split", "--fixed", "lowest", joints=10)     # whole faces are shared
    sound("told.stl", stl(apart), "UNSTABLE", remark="separate shells")


def main():
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        solids()
        if has_importer():
            meshes()
            units()
            axes()
        os.chdir("/")
    total()


if __name__ == "__main__":
    main()
