"""From messages of stonepack_msgs to the worker and back.

Whatever has the fields of msg/*.msg will do as a message: the classes that rosidl makes, or any object. The package `stonepack`
(make python) builds the scene, finds its joints and knows the layout; the check is made by `stonepack worker`, a process of its
own that is ended when it takes too long. No ROS is imported here.
"""
import struct
import subprocess
import threading
import zlib

import stonepack
from stonepack import _bindings as c
from stonepack._library import lib, text

MAGIC, VERSION, REQUEST, RESULT, ERROR = b"STPK", 2, 1, 2, 3
ALONG = ((1.0, 0.0), (-1.0, 0.0), (0.0, 1.0), (0.0, -1.0))


class Refused(Exception):
    """No verdict: a message that is no scene, a worker that ended or was late."""


# ------------------------------------------------------------------------------------------------------- messages to scenes

def _xyz(v):
    return (v.x, v.y, v.z)


def scene_of(msg):
    """stonepack.Scene of a Scene message. Weightless, which is what a message says that was not filled in, everything would stand."""
    if not any(_xyz(msg.gravity)):
        raise Refused("gravity is 0: say where down is, (0, 0, -9.80665) for one")
    scene = stonepack.Scene(mu=msg.mu, gravity=_xyz(msg.gravity))
    for block in msg.blocks:
        add_block(scene, block)
    for j in msg.joints:
        scene.joint(int(j.a), int(j.b), [_xyz(p) for p in j.points], mu=j.mu, cohesion=j.cohesion, tension=j.tension,
                    crushing=j.crushing)
    for l in msg.loads:
        scene.load(int(l.block), _xyz(l.force), _xyz(l.point), couple=_xyz(l.couple), mass=l.mass)
    if not msg.joints and msg.distance > 0:
        scene.find_contacts(distance=msg.distance, mu=msg.mu)
    return scene


def add_block(scene, block):
    """A Block message into a scene; returns its name."""
    name = block.name or None
    if not len(block.vertices):
        return scene.body(block.mass, _xyz(block.centroid), name=name, fixed=bool(block.fixed))
    if sum(block.sizes) != len(block.corners):
        raise Refused("block '%s': its sizes are of %d corners, it has %d" % (block.name, sum(block.sizes), len(block.corners)))
    faces, at = [], 0
    for size in block.sizes:
        faces.append([int(k) for k in block.corners[at:at + size]])
        at += size
    return scene.add([_xyz(p) for p in block.vertices], faces, name=name, density=block.density, fixed=bool(block.fixed))


# ------------------------------------------------------------------------------------------------- scenes to bytes and back

def _message(kind, body):
    head = MAGIC + struct.pack("<HHII", VERSION, kind, 0, len(body)) + body
    return head + struct.pack("<I", zlib.crc32(head))


def request_of(scene, tol=0.0, push=(0.0, 0.0)):
    """A request of the worker: blob.h has the form. push: acceleration to the side, a share of gravity along x and y."""
    scene.joints                                            # found, if none was given
    s, set_, out = scene._c, lib.sp_settings_default(), []
    n, g = s.count, sum(x * x for x in s.gravity) ** 0.5

    def put(form, *values):
        out.append(struct.pack("<" + form, *values))
    put("7i", n.blocks, n.vertices, n.faces, n.corners, n.joints, n.points, n.loads)
    put("7d", *s.gravity, 1.0, push[0] * g, push[1] * g, 0.0)
    put("5iq", set_.faces, set_.inscribed, set_.penalty.net, 0, set_.iterations, set_.budget)
    put("8i", set_.stage_count, *set_.stage[:], 0)
    put("4i", set_.coupled.asked, set_.coupled.box, set_.coupled.rounds, set_.coupled.nodes)
    put("6d", tol or set_.tol, set_.force_bound, set_.penalty.gamma, set_.penalty.tau, set_.coupled.eps, set_.coupled.eta)
    put("3i", *set_.effect[:])
    for b in s.block[:n.blocks]:
        put("3i5d", b.fixed, b.vertices, b.faces, b.density, b.mass, *b.centroid)
    for v in s.vertex[:n.vertices]:
        put("3d", *v)
    for f in s.face[:n.faces]:
        put("i", f.corners)
    for b in s.block[:n.blocks]:
        for f in s.face[b.face:b.face + b.faces]:
            put("%di" % f.corners, *(k - b.vertex for k in s.corner[f.corner:f.corner + f.corners]))
    for j in s.joint[:n.joints]:
        r = j.strength
        put("4i13d", j.a, j.b, j.points, j.area > 0, r.mu, r.cohesion, r.tension, r.crushing, *j.n, *j.t1, *j.t2)
    for p in s.point[:n.points]:
        put("3d", *p)
    for l in s.load[:n.loads]:
        put("2i10d", l.block, l.live, *l.point, *l.force, *l.couple, l.mass)
    return _message(REQUEST, b"".join(out))


_COST = "q3i"
_HEAD = struct.Struct("<6i4d3i5di" + 7 * _COST + "2idi3d4id" + _COST + "8i" + "2i2Qd3i")


def answer_of(message, scene):
    """A dict of a result: verdict, reason, final, verified, imbalance, tol, weakest, seconds, forces f, motion dq."""
    if len(message) < 20 or message[:4] != MAGIC or struct.pack("<I", zlib.crc32(message[:-4])) != message[-4:]:
        raise Refused("what the worker said is no answer")
    version, kind, flags, _ = struct.unpack_from("<HHII", message, 4)
    if version != VERSION or flags or kind not in (RESULT, ERROR):
        raise Refused("the worker speaks version %d, kind %d, flags %d" % (version, kind, flags))
    body = message[16:-4]
    if kind == ERROR:
        status = text(c.SP_WORDS_STATUS, struct.unpack_from("<i", body)[0])
        raise Refused("%s: %s" % (status, body[4:].decode("ascii", "replace")))
    head, n = _HEAD.unpack_from(body), scene._c.count
    f = struct.unpack_from("<%dd" % (3 * n.points), body, _HEAD.size)
    dq = struct.unpack_from("<%dd" % (6 * n.blocks), body, _HEAD.size + 24 * n.points)
    return {"verdict": head[0], "reason": text(c.SP_WORDS_REASON, head[2]), "final": bool(head[3]), "verified": bool(head[4]),
            "tol": head[6], "imbalance": head[8], "weakest": head[18], "seconds": head[-4], "f": f, "dq": dq}


class Worker:
    """`stonepack worker`, started when it is first asked, and anew after it ended; one request at a time."""

    def __init__(self, command=("stonepack", "worker"), seconds=10.0):
        self.command, self.seconds, self._process, self._lock = list(command), seconds, None, threading.Lock()

    def ask(self, request):
        with self._lock:
            if self._process is None or self._process.poll() is not None:
                try:
                    self._process = subprocess.Popen(self.command, stdin=subprocess.PIPE, stdout=subprocess.PIPE)
                except OSError as wrong:
                    raise Refused("no worker: %s" % wrong) from None
            late = threading.Timer(self.seconds, self._process.kill)
            late.start()
            try:
                self._process.stdin.write(request)
                self._process.stdin.flush()
                head = self._process.stdout.read(16)
                rest = struct.unpack_from("<I", head, 12)[0] + 4 if len(head) == 16 else 0
                answer = head + self._process.stdout.read(rest)
            except OSError:
                answer = b""
            finally:
                late.cancel()
            if len(answer) < 20:
                self.close()
                raise Refused("the worker ended without an answer, or took more than %g s" % self.seconds)
            return answer

    def close(self):
        if self._process:
            self._process.kill()
            self._process.stdin.close()
            self._process.stdout.close()
            self._process.wait()
            self._process = None


# --------------------------------------------------------------------------------------------------------------- the services

class Bridge:
    """The services of srv/*.srv, each a method (request, response) -> response as rclpy's create_service wants them.

    types   what makes messages: .Verdict, .JointForce, .BlockMotion (stonepack_msgs.msg)
    """

    def __init__(self, types, worker=None):
        self.types, self.worker, self.scene, self.distance = types, worker or Worker(), stonepack.Scene(), 0.0
        self._names = []                                    # what was inserted, in that order
        self._turn = threading.Lock()                       # executors of several threads: one request after the other

    def check_scene(self, scene, tol=0.0, push=(0.0, 0.0)):
        return answer_of(self.worker.ask(request_of(scene, tol, push)), scene)

    def stands(self, scene, push):
        """The first of four directions in which it does not stand, pushed so far; None: it does in all."""
        for x, y in ALONG if push else ALONG[:1]:
            if self.check_scene(scene, 0.0, (push * x, push * y))["verdict"] != c.SP_STABLE:
                return (x, y, 0.0)
        return None

    def fill(self, verdict, a, scene):
        """A Verdict message of an answer."""
        verdict.verdict, verdict.reason, verdict.verified, verdict.final = a["verdict"], a["reason"], a["verified"], a["final"]
        verdict.imbalance, verdict.tol, verdict.weakest, verdict.seconds = a["imbalance"], a["tol"], a["weakest"], a["seconds"]
        if a["verdict"] == c.SP_STABLE:
            verdict.forces = [self._force(j, a["f"], scene._c.joint[j.number]) for j in scene.joints]
        if a["verdict"] == c.SP_UNSTABLE:
            for k, name in enumerate(scene.names):
                move = a["dq"][6 * k:6 * k + 6]
                if any(move):
                    verdict.falling.append(name)
                    verdict.motion.append(self._motion(k, move))
        return verdict

    def _force(self, joint, f, raw):
        out = self.types.JointForce()
        each = [f[3 * i:3 * i + 3] for i in range(raw.point, raw.point + raw.points)]
        fn, f1, f2 = (sum(e[k] for e in each) for k in range(3))
        share = [abs(e[0]) for e in each]
        total = sum(share) or 1.0
        share = [s / total for s in share] if sum(share) else [1.0 / len(each)] * len(each)
        out.a, out.b = raw.a, raw.b
        for axis, k in (("x", 0), ("y", 1), ("z", 2)):
            setattr(out.force, axis, fn * joint.normal[k] + f1 * joint.t1[k] + f2 * joint.t2[k])
            setattr(out.point, axis, sum(s * p[k] for s, p in zip(share, joint.points)))
        out.utilisation = (f1 * f1 + f2 * f2) ** 0.5 / (joint.mu * fn) if fn > 0 and joint.mu > 0 else 0.0
        return out

    def _motion(self, k, move):
        out = self.types.BlockMotion()
        out.block = k
        for axis, i in (("x", 0), ("y", 1), ("z", 2)):
            setattr(out.linear, axis, move[i])
            setattr(out.angular, axis, move[3 + i])
        return out

    def _answered(self, response, what):
        """Do it; what is refused is told in the response."""
        try:
            with self._turn:
                what()
            response.ok = True
        except (Refused, stonepack.StonepackError) as wrong:
            response.ok, response.message = False, str(wrong)
        return response

    def check(self, request, response):
        def do():
            scene = scene_of(request.scene)
            self.fill(response.verdict, self.check_scene(scene, request.tol), scene)
        return self._answered(response, do)

    def start(self, request, response):
        def do():
            self.scene, self.distance, self._names = scene_of(request.scene), request.scene.distance, []
        return self._answered(response, do)

    def _with(self, block):
        """The scene with a stone more: joints are found anew."""
        scene = self.scene.copy()
        name = add_block(scene, block)
        if self.distance > 0:
            scene.find_contacts(distance=self.distance, mu=scene.mu)
        if any(name in (o.a, o.b) for o in scene.overlaps):
            raise Refused("%s is inside another block" % name)
        return scene, name

    def insert(self, request, response):
        def do():
            scene, name = self._with(request.block)
            a = self.check_scene(scene)
            self.fill(response.verdict, a, scene)
            response.release = a["verdict"] == c.SP_STABLE and self.stands(scene, request.margin) is None
            if response.release or request.anyway:
                self.scene, response.inserted = scene, True
                self._names.append(name)
        return self._answered(response, do)

    def margin(self, request, response):
        def do():
            low, high, step = -1.0, 0.0, max(request.resolution, 1e-4)
            along = self.stands(self.scene, 0.0)
            if along is None:
                low, high = 0.0, step
                while high < 16:                            # up in doubling steps, then halving between
                    along = self.stands(self.scene, high)
                    if along:
                        break
                    low, high = high, 2 * high
                while along and high - low > step:
                    middle = (low + high) / 2
                    fails = self.stands(self.scene, middle)
                    low, high, along = (low, middle, fails) if fails else (middle, high, along)
            response.margin, response.refused = low, high
            response.direction.x, response.direction.y, response.direction.z = along or (0.0, 0.0, 0.0)
        return self._answered(response, do)

    def undo(self, request, response):
        def do():
            if not self._names:
                raise Refused("nothing was inserted")
            response.name = self._names.pop()
            left = self.scene.part([n for n in self.scene.names if n != response.name])
            left._given = bool(self.scene._given)           # joints that were found are found anew
            if not left._given:
                left.find_contacts(**({"distance": self.distance} if self.distance > 0 else {}), mu=left.mu)
            self.scene, response.blocks = left, len(left)
        return self._answered(response, do)
