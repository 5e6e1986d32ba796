"""port/ros: its definitions are read by rosidl, and the bridge answers as the library does, in messages of those definitions.

    PYTHONPATH=build/python python3 tests/checks/ros.py [build/stonepack]

Needs rosidl_adapter and rosidl_parser; ends with `N passed, N failed`.
"""
import pathlib
import re
import sys
import tempfile
import types
import xml.etree.ElementTree

root = pathlib.Path(__file__).resolve().parents[2] / "port/ros"
sys.path[:0] = [str(root)]
sys.dont_write_bytecode = True
from rosidl_adapter.msg import convert_msg_to_idl
from rosidl_adapter.parser import parse_message_file, parse_service_file
from rosidl_adapter.srv import convert_srv_to_idl
from rosidl_parser.definition import IdlLocator, Message, Service
from rosidl_parser.parser import parse_idl_file

import bridge
import stonepack

PACKAGE, passed, failed = "stonepack_msgs", 0, 0


def check(what, right):
    global passed, failed
    passed, failed = passed + bool(right), failed + (not right)
    if not right:
        print("FAILED  " + what)


# ------------------------------------------------------------------------------------------------------------- definitions
BASIC = {"bool": False, "string": "", "float64": 0.0}
specs = {}


def idl(path, convert, kind):
    """The .idl that rosidl makes of it is read again: how many definitions of this kind has it?"""
    sys.modules[convert.__module__].print = lambda *words, **more: None         # it tells what it reads
    with tempfile.TemporaryDirectory() as folder:
        made = convert(root, PACKAGE, path.relative_to(root), pathlib.Path(folder) / path.parent.name)
        tree = parse_idl_file(IdlLocator(pathlib.Path(folder), pathlib.Path(path.parent.name) / made.name))
    return len(tree.content.get_elements_of_type(kind))


for path in sorted(root.glob("*/*.msg")):
    specs[path.stem] = parse_message_file(PACKAGE, str(path))
    check("%s becomes a message" % path.name, idl(path, convert_msg_to_idl, Message) == 1)
for path in sorted(root.glob("*/*.srv")):
    service = parse_service_file(PACKAGE, str(path))
    specs[path.stem + "_Request"], specs[path.stem + "_Response"] = service.request, service.response
    check("%s becomes a service" % path.name, idl(path, convert_srv_to_idl, Service) == 1)

# What is made of them: an object with these fields, their defaults, and no others.
class Plain:
    __slots__ = ("x", "y", "z")

    def __init__(self, x=0.0, y=0.0, z=0.0):
        self.x, self.y, self.z = x, y, z


def value(field):
    if field.type.is_array:
        return []
    if field.default_value is not None:
        return field.default_value
    if field.type.pkg_name == "geometry_msgs":
        return Plain()
    return made[field.type.type]() if field.type.pkg_name else BASIC.get(field.type.type, 0)


def class_of(name, spec):
    def init(self, **given):
        for field in spec.fields:
            setattr(self, field.name, given.pop(field.name) if field.name in given else value(field))
        assert not given, "%s has no %s" % (name, given)
    return type(name, (), {"__slots__": tuple(f.name for f in spec.fields), "__init__": init})


made = {name: class_of(name, spec) for name, spec in specs.items()}
for spec in specs.values():
    for field in spec.fields:
        check("%s is known" % field.type, field.type.pkg_name in (None, "geometry_msgs") or field.type.type in made)

listed = set(re.findall(r'"((?:msg|srv)/\w+\.(?:msg|srv))"', (root / "CMakeLists.txt").read_text()))
there = {str(p.relative_to(root)) for kind in ("msg", "srv") for p in root.glob("%s/*.%s" % (kind, kind))}
check("CMakeLists.txt lists what is there", listed == there)
manifest = xml.etree.ElementTree.parse(root / "package.xml").getroot()
check("package.xml: format 3, its name, rosidl's group", manifest.get("format") == "3" and manifest.findtext("name") == PACKAGE
      and manifest.findtext("member_of_group") == "rosidl_interface_packages"
      and {e.text for e in manifest.iter("depend")} == {"geometry_msgs"})
check("package.xml: version of the library", manifest.findtext("version") == stonepack.__version__)

# ------------------------------------------------------------------------------------------------------------------ bridge
msgs = types.SimpleNamespace(**made)
program = sys.argv[1] if len(sys.argv) > 1 else "build/stonepack"
worker = bridge.Worker([program, "worker"])
FACES = [(3, 2, 1, 0), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7)]


def box(name, x, y, z, at, fixed=False):
    (l, w, h), (a, b, d) = (x, y, z), at
    corners = [Plain(a + i * l, b + j * w, d + k * h) for k in (0, 1) for i, j in ((0, 0), (1, 0), (1, 1), (0, 1))]
    return msgs.Block(name=name, fixed=fixed, vertices=corners, sizes=[4] * 6, corners=[k for f in FACES for k in f])


def call(name, **request):
    return getattr(served, name.lower())(made[name + "_Request"](**request), made[name + "_Response"]())


def scene(*blocks, **more):
    return msgs.Scene(gravity=Plain(0.0, 0.0, -9.80665), blocks=list(blocks), **more)


ground = box("ground", 3, 2, 0.2, (-1, -1, -0.2), True)
stone, far = box("stone", 0.4, 0.2, 0.15, (0, 0, 0)), box("far", 0.4, 0.2, 0.15, (0.25, 0, 0.15))
served = bridge.Bridge(msgs, worker)

got = call("Check", scene=scene(ground, stone, mu=0.5))
check("a stone on the ground is stable", got.ok and got.verdict.verdict == msgs.Verdict().verdict + 1 and got.verdict.verified)
weight = 2400 * 0.4 * 0.2 * 0.15 * 9.80665
check("its joint carries its weight", len(got.verdict.forces) == 1
      and abs(got.verdict.forces[0].force.z - weight) < 1e-6 * weight and abs(got.verdict.forces[0].point.x - 0.2) < 1e-9 and got.verdict.forces[0].a == 0)
got = call("Check", scene=scene(ground, stone, far))
check("one too far out falls, by name", got.ok and got.verdict.verdict == 2 and got.verdict.falling == ["far"]
      and got.verdict.motion[0].block == 2 and got.verdict.motion[0].linear.z < 0 and got.verdict.final)
given = scene(msgs.Block(name="a", fixed=True, mass=1.0), msgs.Block(name="b", mass=10.0, centroid=Plain(0.0, 0.0, 1.0)))
given.joints = [msgs.Joint(a=0, b=1, points=[Plain(-1, -1, 0), Plain(1, -1, 0), Plain(1, 1, 0), Plain(-1, 1, 0)])]
given.loads = [msgs.Load(block=1, point=Plain(0, 0, 1), force=Plain(20.0, 0.0, 0.0))]
got = call("Check", scene=given)
check("joints, masses and loads that are given", got.ok and got.verdict.verdict == 1
      and abs(got.verdict.forces[0].force.x + 20) < 1e-6 and abs(got.verdict.forces[0].utilisation - 20 / (0.84 * 98.0665)) < 1e-6)

# The worker says what the library says, at every forces' bit.
for name in sorted(pathlib.Path("tests/scenes").glob("*.obj")):
    read = stonepack.read(str(name))
    here, there = read.check(), bridge.answer_of(worker.ask(bridge.request_of(read)), read)
    flat = [x for triple in here.forces for x in triple]
    verdict = ("undecided", "stable", "unstable")[there["verdict"]]
    check("%s: the worker's forces" % name.name, here.verdict == verdict and flat == list(there["f"]))

call("Start", scene=scene(ground, mu=0.5))
got = call("Insert", block=stone)
check("it may be let go of, and is inserted", got.ok and got.release and got.inserted)
got = call("Margin", resolution=0.001)
check("its margin is friction, from both sides", got.ok and got.margin <= 0.5 <= got.refused <= got.margin + 0.0011)
got = call("Insert", block=far)
check("one too far out is not, and is not inserted", got.ok and not got.release and not got.inserted
      and got.verdict.verdict == 2)
got = call("Insert", block=far, anyway=True)
check("nor is it when it is inserted all the same", got.ok and not got.release and got.inserted)
got = call("Margin")
check("then there is no margin", got.ok and got.margin < 0)
got = call("Undo")
check("it is taken out again", got.ok and got.name == "far" and got.blocks == 2)
got = call("Margin", resolution=0.001)
check("and the margin is as it was", got.ok and got.margin <= 0.5 <= got.refused)
got = call("Insert", block=box("inside", 0.2, 0.1, 0.1, (0.1, 0.05, 0.05)))
check("one inside another is refused, by name", not got.ok and "inside" in got.message)
got = call("Insert", block=msgs.Block(name="flat", vertices=stone.vertices[:3], sizes=[3], corners=[0, 1, 2]))
check("one that is no stone is refused, by name", not got.ok and "flat" in got.message)
short = msgs.Block(name="short", vertices=stone.vertices, sizes=[4] * 6, corners=stone.corners[:-1])
got = call("Insert", block=short)
check("one whose faces don't fit is refused, by name", not got.ok and "short" in got.message)
got = call("Start", scene=msgs.Scene(blocks=[ground]))
check("gravity that was not filled in is refused", not got.ok and "gravity" in got.message)
call("Undo")
got = call("Undo")
check("what was there from the start stays", not got.ok and got.message == "nothing was inserted")

# The node of README.md, but for ROS: stand-ins for rclpy and for what rosidl makes.
offered = {}


class Node:
    def __init__(self, name):
        offered["name"] = name

    def create_service(self, kind, name, call):
        offered[name] = kind, call


def module(name, **has):
    sys.modules[name] = types.ModuleType(name)
    sys.modules[name].__dict__.update(has)
    return sys.modules[name]


services = {n: n for n in ("Check", "Start", "Insert", "Margin", "Undo")}
module("rclpy", init=lambda: None, spin=lambda node: None), module("rclpy.node", Node=Node)
module("stonepack_msgs", msg=module("stonepack_msgs.msg", **made), srv=module("stonepack_msgs.srv", **services))
exec(re.search(r"```python\n(.*?)```", (root / "README.md").read_text(), re.S).group(1), {})
check("the node offers its five services", set(offered) == {"name"} | {"~/" + n.lower() for n in services}
      and all(kind == n for n in services for kind, _ in [offered["~/" + n.lower()]]))
offered["~/check"][1].__self__.worker = worker
got = offered["~/check"][1](made["Check_Request"](scene=scene(ground, stone)), made["Check_Response"]())
check("and answers", got.ok and got.verdict.verdict == 1)

worker.close()
late = bridge.Bridge(msgs, bridge.Worker(["sleep", "60"], seconds=0.2))
got = late.check(made["Check_Request"](scene=scene(ground, stone)), made["Check_Response"]())
check("a worker that is late is ended", not got.ok and "0.2 s" in got.message and got.verdict.verdict == 0)
none = bridge.Bridge(msgs, bridge.Worker(["/nonexistent"]))
got = none.check(made["Check_Request"](scene=scene(ground, stone)), made["Check_Response"]())
check("no worker is told", not got.ok and "no worker" in got.message)
answer = bytearray(bridge._message(bridge.ERROR, b"\xff\xff\xff\xff"))
answer[17] ^= 1
try:
    bridge.answer_of(bytes(answer), stonepack.Scene())
    check("a wrong checksum is no answer", False)
except bridge.Refused:
    check("a wrong checksum is no answer", True)

print("%d passed, %d failed" % (passed, failed))
sys.exit(failed > 0)
