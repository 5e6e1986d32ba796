#!/usr/bin/env python3
"""bad_formats: broken models in forms of others.      bad_formats.py [build/stonepack]

Each gives exit status 65, one line on standard error that starts with the file's name, and nothing on standard output. An importer
that never ends is ended by the limit of processor time, which this script sets to one second. The last line is
`N passed, N failed`.
"""
import base64
import io
import json
import os
import resource
import struct
import sys
import tempfile
import zipfile

sys.path.insert(0, os.path.dirname(os.path.abspath(__file__)))
import formats as f
from formats import PARTS, broken, sound

SECONDS = 1
NAN, INF = float("nan"), float("inf")
MEMORY = "" if any("san" in os.path.basename(a) for a in sys.argv[1:]) else "more memory"     # ASan ends who asks for too much


# ------------------------------------------------------------------------------------------------- forms that only fail here

def glb(magic=b"glTF", version=2, size=None, text_size=None, data_size=None, **change):
    """The doorway of formats.gltf with its buffer as a chunk."""
    doc = dict(json.loads(f.gltf(PARTS)), **change)
    data = base64.b64decode(doc["buffers"][0].pop("uri").split(",")[1]) if "buffers" not in change else b"1234"
    text = json.dumps(doc).encode()
    text += b" " * (-len(text) % 4)
    data += b"\0" * (-len(data) % 4)
    return (struct.pack("<4sII", magic, version, size or 28 + len(text) + len(data))
            + struct.pack("<I4s", text_size or len(text), b"JSON") + text
            + struct.pack("<I4s", data_size or len(data), b"BIN\0") + data)


def dae(points=None, count=None, index=None, node="<instance_geometry url='#g'/>", faces=12):
    corners = PARTS[0]
    numbers = points or " ".join("%g" % x for p in corners for x in p)
    index = index or " ".join(str(v) for q in f.BOX for k in (1, 2) for v in (q[0], q[k], q[k + 1]))
    return ("<?xml version='1.0'?><COLLADA xmlns='http://www.collada.org/2005/11/COLLADASchema' version='1.4.1'>"
            "<asset><up_axis>Z_UP</up_axis></asset><library_geometries><geometry id='g'><mesh><source id='s'>"
            "<float_array id='a' count='%s'>%s</float_array><technique_common><accessor source='#a' count='8' stride='3'>"
            "<param name='X' type='float'/><param name='Y' type='float'/><param name='Z' type='float'/></accessor>"
            "</technique_common></source><vertices id='v'><input semantic='POSITION' source='#s'/></vertices>"
            "<triangles count='%s'><input semantic='VERTEX' source='#v' offset='0'/><p>%s</p></triangles></mesh></geometry>"
            "</library_geometries><library_visual_scenes><visual_scene id='w'><node id='n'>%s</node></visual_scene>"
            "</library_visual_scenes><scene><instance_visual_scene url='#w'/></scene></COLLADA>"
            % (count or 24, numbers, faces, index, node))


def model_3mf(points=None, index=None, build="<item objectid='1'/>"):
    points = points or "".join("<vertex x='%g' y='%g' z='%g'/>" % p for p in PARTS[0])
    index = index or "".join("<triangle v1='%d' v2='%d' v3='%d'/>" % (q[0], q[k], q[k + 1]) for q in f.BOX for k in (1, 2))
    return ("<?xml version='1.0'?><model unit='millimeter' xmlns='http://schemas.microsoft.com/3dmanufacturing/core/2015/02'>"
            "<resources><object id='1' type='model'><mesh><vertices>%s</vertices><triangles>%s</triangles></mesh></object>"
            "</resources><build>%s</build></model>" % (points, index, build))


def zipped(model, relations=True, name="3D/3dmodel.model"):
    out = io.BytesIO()
    with zipfile.ZipFile(out, "w", zipfile.ZIP_DEFLATED) as z:
        if relations:
            z.writestr("_rels/.rels", "<Relationships xmlns='http://schemas.openxmlformats.org/package/2006/relationships'>"
                       "<Relationship Target='/3D/3dmodel.model' Id='r' "
                       "Type='http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel'/></Relationships>")
        z.writestr(name, model)
    return out.getvalue()


def x3d():
    return ("<X3D><Scene><Shape><IndexedFaceSet coordIndex='%s'><Coordinate point='%s'/></IndexedFaceSet></Shape></Scene></X3D>"
            % (" ".join("%d %d %d %d -1" % q for q in f.BOX), " ".join("%g %g %g" % p for p in PARTS[0])))


# --------------------------------------------------------------------------------------------------------------- cases

def cut(whole):
    """Each form whole, cut at shares of its length, and nothing at all."""
    for name, data in whole.items():
        sound("whole-" + name, data, "STABLE", "--fixed", "*")
        data = data if isinstance(data, bytes) else data.encode()
        broken("empty-" + name, b"")
        for share in 10, 50, 90:
            broken("cut-%d-%s" % (share, name), data[:len(data) * share // 100])


def bad_stl():
    good = f.stl(PARTS)
    broken("nan.stl", good[:96] + struct.pack("<f", NAN) * 9 + good[132:], "no finite number")
    broken("inf.stl", good[:96] + struct.pack("<f", INF) * 9 + good[132:], "no finite number")
    broken("huge.stl", good[:96] + struct.pack("<f", 3e38) * 9 + good[132:], "no finite number")
    broken("many.stl", good[:80] + struct.pack("<I", 0xffffffff) + good[84:])
    broken("more.stl", good[:80] + struct.pack("<I", 37) + good[84:])
    broken("none.stl", good[:80] + struct.pack("<I", 0))
    broken("fewer.stl", good[:80] + struct.pack("<I", 35) + good[84:])
    broken("big-endian.stl", good[:80] + struct.pack(">I", 36) + good[84:])
    broken("swapped.stl", good[:84] + b"".join(struct.pack(">12fH", *struct.unpack("<12fH", good[k:k + 50]))
                                               for k in range(84, len(good), 50)))
    text = f.stl_text(PARTS)
    broken("nan-text.stl", text.replace("vertex 2 ", "vertex nan ", 1))
    broken("inf-text.stl", text.replace("vertex 2 ", "vertex 1e999 ", 1))
    broken("words.stl", text.replace("vertex 2 ", "vertex two ", 1))
    broken("two-corners.stl", text.replace("vertex 2 0 2\n", "", 1))
    broken("solid.stl", "solid\n")
    broken("endless.stl", "solid " + "x" * 1000000)


def bad_ply():
    text, little, big = (f.ply(PARTS, form) for form in ("ascii", "binary_little_endian", "binary_big_endian"))
    at = little.index(b"end_header") + 11
    broken("corner.ply", text.replace("4 0 2 3 1", "4 0 2 3 999"))
    broken("below.ply", text.replace("4 0 2 3 1", "4 0 2 3 -7"))
    broken("nan.ply", text.replace("\n2 0 2\n", "\nnan 0 2\n"))
    broken("inf.ply", text.replace("\n2 0 2\n", "\ninf 0 2\n"))
    broken("words.ply", text.replace("\n2 0 2\n", "\ntwo 0 2\n"))
    broken("vertices.ply", text.replace("vertex 24", "vertex 4000000000"), MEMORY)
    broken("faces.ply", text.replace("face 18", "face 4000000000"))
    broken("less.ply", text.replace("face 18", "face 17"))
    broken("negative.ply", text.replace("vertex 24", "vertex -24"))
    broken("no-format.ply", text.replace("format ascii 1.0\n", ""))
    broken("no-z.ply", text.replace("property float z\n", ""))
    broken("no-end.ply", text.replace("end_header\n", ""))
    broken("type.ply", text.replace("property float z", "property quaternion z"))
    broken("points.ply", text[:text.index("4 0 2 3 1")].replace("element face 18", "element face 0"))
    broken("vertices-binary.ply", little.replace(b"vertex 24", b"vertex 4000000000"), MEMORY)
    broken("faces-binary.ply", little.replace(b"face 18", b"face 4000000000"))
    broken("corners-binary.ply", little[:at + 288] + b"\xff" + little[at + 289:])
    broken("nan-binary.ply", little[:at] + struct.pack("<f", NAN) + little[at + 4:], "no finite number")
    broken("big-as-little.ply", big.replace(b"big", b"little"))
    broken("little-as-big.ply", little.replace(b"little", b"big"))
    broken("text-as-binary.ply", text.replace("ascii", "binary_little_endian"))
    broken("binary-as-text.ply", little.replace(b"binary_little_endian", b"ascii"))


def bad_off():
    text = f.off(PARTS)
    broken("nan.off", text.replace("\n2 0 2\n", "\nnan 0 2\n"))
    broken("corner.off", text.replace("4 0 2 3 1", "4 0 2 3 999"))
    broken("below.off", text.replace("4 0 2 3 1", "4 0 2 3 -1"))
    broken("vertices.off", text.replace("24 18 0", "4000000000 18 0"))
    broken("faces.off", text.replace("24 18 0", "24 4000000000 0"))
    broken("polygon.off", text.replace("4 0 2 3 1", "4000000 0 2 3 1"))


def bad_gltf():
    good = json.loads(f.gltf(PARTS))

    def changed(name, path, value, text=""):
        doc = json.loads(json.dumps(good))
        at = doc
        for k in path[:-1]:
            at = at[k]
        at[path[-1]] = value
        broken(name + ".gltf", json.dumps(doc), text)

    uri = good["buffers"][0]["uri"]
    changed("node", ["scenes"], [{"nodes": [55]}])
    changed("mesh", ["nodes", 0, "mesh"], 77)
    changed("cycle", ["nodes", 0, "children"], [0])
    changed("accessor", ["meshes", 0, "primitives", 0, "attributes", "POSITION"], 99)
    changed("indices", ["meshes", 0, "primitives", 0, "indices"], 99)
    changed("no-position", ["meshes", 0, "primitives", 0, "attributes"], {})
    changed("count", ["accessors", 0, "count"], 4000000000)
    changed("overlong", ["accessors", 3, "count"], 100000)
    changed("offset", ["accessors", 0, "byteOffset"], 4000000)
    changed("component", ["accessors", 0, "componentType"], 12345)
    changed("view", ["accessors", 0, "bufferView"], 44)
    changed("view-length", ["bufferViews", 0, "byteLength"], 4000000)
    changed("stride", ["bufferViews", 0, "byteStride"], 100000000)
    changed("buffer-length", ["buffers", 0, "byteLength"], 4000000000)
    changed("buffer-missing", ["buffers", 0, "uri"], "gone.bin")
    changed("buffer-cut", ["buffers", 0, "uri"], uri[:len(uri) // 2])
    changed("no-base64", ["buffers", 0, "uri"], "data:application/octet-stream;base64,????")
    changed("version", ["asset"], {"version": "7.0"})
    changed("no-scene", ["scene"], 12)
    changed("empty", ["nodes"], [])
    broken("nan.gltf", f.gltf(PARTS, nodes=[{"mesh": 0, "translation": [1e39, 0, 0]}], scenes=[{"nodes": [0]}]))
    broken("no-json.gltf", "{\"asset\": {\"version\": \"2.0\"")
    broken("deep.gltf", "[" * 200000)
    broken("list.gltf", "[1, 2, 3]")
    broken("magic.glb", glb(magic=b"GLTF"))
    broken("version.glb", glb(version=9))
    broken("size.glb", glb(size=0xffffffff)[:-40])
    broken("text.glb", glb(text_size=0xfffffff0))
    broken("data.glb", glb(data_size=4000000))
    broken("buffer.glb", glb(buffers=[{"byteLength": 4000000}]))


def bad_xml():
    broken("nothing.dae", "<COLLADA></COLLADA>")
    broken("not-xml.dae", "solid\n")
    broken("nan.dae", dae(points="nan " * 24))
    broken("count.dae", dae(count=4000000000))
    broken("points.dae", dae(points="1 2 3"))
    broken("corner.dae", dae(index="0 1 999 " * 12))
    broken("triangles.dae", dae(faces=4000000000))
    broken("geometry.dae", dae(node="<instance_geometry url='#none'/>"))
    broken("cycle.dae", dae(node="<instance_geometry url='#g'/><instance_node url='#n'/>"))
    broken("deep.dae", dae(node="<node>" * 20000 + "</node>" * 20000))
    laughs = "".join("<!ENTITY a%d '%s'>" % (k, "&a%d;" % (k - 1) * 10 if k else "ha") for k in range(12))
    broken("laughs.dae", "<?xml version='1.0'?><!DOCTYPE x [%s]><COLLADA>&a11;</COLLADA>" % laughs)
    broken("nothing.x3d", "<X3D></X3D>", "holds no mesh")
    broken("nothing.amf", "<amf></amf>")


def bad_3mf():
    good = zipped(model_3mf())
    sound("SHOUTED.3MF", good, "STABLE", "--fixed", "lowest", remark="millimetres in most such files")
    broken("corner.3mf", zipped(model_3mf(index="<triangle v1='0' v2='1' v3='999'/>")))
    broken("nan.3mf", zipped(model_3mf(points="<vertex x='nan' y='0' z='0'/>" * 8)))
    broken("no-triangles.3mf", zipped(model_3mf(index=" ")))
    broken("no-build.3mf", zipped(model_3mf(build="")))
    broken("object.3mf", zipped(model_3mf(build="<item objectid='9'/>")))
    broken("no-model.3mf", zipped("", name="other.txt"))
    broken("no-relations.3mf", zipped(model_3mf(), relations=False))
    broken("not-zip.3mf", model_3mf())
    broken("crc.3mf", good[:200] + bytes(b ^ 0x55 for b in good[200:260]) + good[260:])
    broken("bomb.3mf", zipped("<model>" + " " * (300 << 20)))


def main():
    with tempfile.TemporaryDirectory() as folder:
        os.chdir(folder)
        if f.has_importer():
            f.each = lambda: resource.setrlimit(resource.RLIMIT_CPU, (SECONDS, SECONDS))
            os.environ["ASAN_OPTIONS"] = "max_allocation_size_mb=2000:hard_rss_limit_mb=2000"
            cut({"a.stl": f.stl(PARTS), "text.stl": f.stl_text(PARTS), "text.ply": f.ply(PARTS),
                 "little.ply": f.ply(PARTS, "binary_little_endian"), "big.ply": f.ply(PARTS, "binary_big_endian"),
                 "a.off": f.off(PARTS), "a.gltf": f.gltf(PARTS), "a.glb": glb(), "a.dae": dae(),
                 "a.3mf": zipped(model_3mf()), "a.x3d": x3d()})
            for bad in bad_stl, bad_ply, bad_off, bad_gltf, bad_xml, bad_3mf:
                bad()
        os.chdir("/")
    f.total()


if __name__ == "__main__":
    main()
