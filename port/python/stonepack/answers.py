"""Answers: plain objects with named fields. Forces are in N, moments in N m, lengths in m; they act on block b of a joint."""
import ctypes
from typing import TYPE_CHECKING, Any, Dict, List, NamedTuple, NoReturn, Optional, Tuple

from . import _bindings as c
from ._library import StonepackError, lib, refuse, text
from ._turns import asks

if TYPE_CHECKING:
    from .scene import Scene

Vec3 = Tuple[float, float, float]
Vec6 = Tuple[float, float, float, float, float, float]


def vec3(x: Any) -> Vec3:
    return x[0], x[1], x[2]


def no_truth(ask: str) -> NoReturn:
    """Of a __bool__: `assert scene.check()` would hold of what falls, since there is an answer."""
    raise StonepackError("an answer is neither true nor false: ask %s" % ask)


VERDICTS = {v: text(c.SP_WORDS_VERDICT, v) for v in (c.SP_STABLE, c.SP_UNSTABLE, c.SP_UNDECIDED)}
LEVELS = {v: text(c.SP_WORDS_LEVEL, v) for v in (c.SP_NONE, c.SP_ADMISSIBLE, c.SP_COUPLED)}


class Block(NamedTuple):
    """A block of a scene.

    number      from 0, in the order they were added
    mass        [kg]
    centroid    [m]
    volume      [m^3]
    fixed       held in all directions: a support; name: as given
    """
    number: int
    name: str
    mass: float
    centroid: Vec3
    volume: float
    fixed: bool


class Joint(NamedTuple):
    """A contact of two blocks.

    number      from 0, the order of Result.joints
    a, b        names of its blocks
    normal      of length 1, from a into b; t1, t2: the directions of friction, normal to it and to each other
    area        [m^2]; 0 of point and edge contacts
    mu          its friction
    points      its corners, anticlockwise seen from b [m]; the order of Result.forces
    """
    number: int
    a: str
    b: str
    normal: Vec3
    t1: Vec3
    t2: Vec3
    area: float
    mu: float
    points: List[Vec3]


class Overlap(NamedTuple):
    """Two blocks inside each other: names a, b, and their depth [m]."""
    a: str
    b: str
    depth: float


class JointForce(NamedTuple):
    """What one joint passes on, as it acts on b.

    number, a, b            as of Joint
    force                   in x y z [N]
    point                   where it acts [m]
    min_fn, max_fn          least and largest normal force of its corners [N]; > 0 presses
    utilisation             share of its friction that is used, of the joint as a whole
    corner_utilisation      and of the corner that uses most
    """
    number: int
    a: str
    b: str
    force: Vec3
    point: Vec3
    min_fn: float
    max_fn: float
    utilisation: float
    corner_utilisation: float


class Evidence(NamedTuple):
    """What the evidence of a result proves, computed anew.

    verdict             that it proves; it is verified where this is the result's
    final               of an unstable: no forces of any size would do
    imbalance           largest imbalance of the forces, relative to what acts on that block
    least_imbalance     no admissible forces come below
    level               "admissible", "coupled", else "none"
    residual            of a coupled: its largest violation, proved where <= 1
    margin              of a proof that there is no coupled one, > 0
    """
    verdict: str
    final: bool
    imbalance: float
    least_imbalance: float
    level: str
    residual: float
    margin: float

    def __bool__(self) -> bool:
        no_truth("its .verdict")


class Effect(NamedTuple):
    """One effect of a plan: on, whether it is simulated, and why; unknowns, flops, bytes: saved by leaving it out."""
    on: bool
    why: str
    unknowns: int
    flops: int
    bytes: int


class Plan(NamedTuple):
    """What a check will simulate, and what it leaves out.

    effects                 by name
    islands                 parts that do not touch and are checked one by one
    unknowns, flops, bytes  of the check as planned; bytes besides the scene
    full_unknowns, full_flops, full_bytes   of one that leaves nothing out
    """
    effects: Dict[str, Effect]
    islands: int
    unknowns: int
    flops: int
    bytes: int
    full_unknowns: int
    full_flops: int
    full_bytes: int


class Hinge(NamedTuple):
    """What the joint of blocks a and b does in a mechanism.

    kind            "hinge", "sliding", "open"
    opening, slip   [m] of the motion as scaled
    line            the two ends of a hinge or of a sliding joint [m]
    """
    a: str
    b: str
    kind: str
    opening: float
    slip: float
    line: Tuple[Vec3, Vec3]


class Step(NamedTuple):
    """One step of a build order.

    block               that came, went, is held or let go
    verdict, stable     of all that is there then; reason in words
    final               of an unstable: no forces of any size would do
    falls               a block that goes, None: nothing does
    moving              blocks of the mechanism, fastest first
    imbalance           largest of the forces, relative
    hold                what must be held meanwhile, where that was asked, else None
    """
    block: str
    verdict: str
    stable: bool
    reason: str
    final: bool
    falls: Optional[str]
    moving: List[str]
    imbalance: float
    hold: Optional[List[str]]

    def __bool__(self) -> bool:
        no_truth("its .stable")


class Held(NamedTuple):
    """What to hold.

    blocks      their names
    must        of each: it falls even when all others of its island are held
    proof       whether fewer would do
    checks      how many it took
    """
    blocks: List[str]
    must: List[bool]
    proof: str
    checks: int


class Strong(NamedTuple):
    """Does it stand whatever friction does?

    kind        "strong": nothing moves; "ambiguous": it stands or goes by its history; the others say what is known
    reason      in words
    verified    the certificate check finds the same kind
    residual    of a strong: largest relative imbalance of the forces; of an ambiguous: of the motion
    moves       of an ambiguous: largest acceleration of a block, in all forces on it / its mass
    moving      of an ambiguous: acceleration of centroid and turn by block [m/s^2, rad/s^2]
    """
    kind: str
    reason: str
    verified: bool
    residual: float
    moves: float
    moving: Dict[str, Vec6]

    def __bool__(self) -> bool:
        no_truth("its .kind")


class Sliding(NamedTuple):
    """How much of the live loads friction bears that does not open joints as it slides.

    kind            "state": a sliding state was found at upper; "associative": none was, upper is that of `limit`
    reason          "state", "nothing found", or "not asked": not planar, strength in a joint, more than 400 free blocks
    verified        the certificate check finds the state, too
    upper           it may slide at this multiple; None: there is no such multiple
    associative     the upper end of `limit`, whose friction opens joints; nothing is said between the two; None: there is none
    lower           proved: it does not slide below this multiple
    lower_strong    proved: up to this multiple it stays whatever friction does; the number for safety
    residual        of a state: largest violation of its conditions, relative
    motion          of a state: displacement and rotation by block
    """
    kind: str
    reason: str
    verified: bool
    upper: Optional[float]
    associative: Optional[float]
    lower: float
    lower_strong: float
    residual: float
    motion: Dict[str, Vec6]

    def __bool__(self) -> bool:
        no_truth("its .kind")


def speeds(dq: Any, count: int) -> List[float]:
    """How fast blocks move in a motion: displacement or rotation, the larger."""
    return [max(max(abs(x) for x in dq[6 * b:6 * b + 6]), 0.0) for b in range(count)]


def motion_of(names: List[str], dq: Any) -> Dict[str, Vec6]:
    """{block: six numbers} of those that move, fastest first."""
    speed = speeds(dq, len(names))
    order = sorted((b for b in range(len(names)) if speed[b] > 0), key=lambda b: -speed[b])
    return {names[b]: tuple(dq[6 * b:6 * b + 6]) for b in order}        # type: ignore[misc]


class _Answer:
    """What answers share: a copy of all numbers of their own, and the scene they are of, as long as it is as it was asked."""

    __slots__ = ("_c", "_memory", "_scene", "_version", "_names", "_count")

    def __init__(self, scene: "Scene", numbers: Any):
        self._c = numbers
        self._scene, self._version, self._names = scene, scene._version, scene._names
        self._count = len(scene._names)             # names are only ever added
        self._memory: Any = None

    @property
    def reason(self) -> str:
        """Why, in words: of an undecided what was in the way."""
        return text(c.SP_WORDS_REASON, self._c.reason)

    @property
    def verified(self) -> bool:
        """The evidence passed the certificate check."""
        return bool(self._c.verified)

    def __copy__(self) -> Any:
        return self                                 # nothing of it changes

    def __deepcopy__(self, memo: Any) -> Any:
        return self

    def __reduce__(self) -> Any:
        raise StonepackError("an answer is not pickled: send its verdict, forces, motion, which are plain Python")

    def _there(self) -> "Scene":
        if self._scene._version != self._version:
            raise StonepackError("the scene has changed since this answer")
        return self._scene


class Result(_Answer):
    """The answer of a check. It keeps its own copy of all numbers; what needs the scene (joints, reactions, a picture) is there
    as long as the scene is as it was checked."""

    __slots__ = ("_settings",)

    def __bool__(self) -> bool:
        no_truth("its .stable")

    def __init__(self, scene: "Scene", settings: Any):
        super().__init__(scene, c.sp_result())
        self._settings = settings

    @property
    def verdict(self) -> str:
        """"stable", "unstable" or "undecided"."""
        return VERDICTS[self._c.verdict]

    @property
    def stable(self) -> bool:
        """Forces exist that hold it."""
        return self._c.verdict == c.SP_STABLE

    @property
    def unstable(self) -> bool:
        """A motion exists in which it falls."""
        return self._c.verdict == c.SP_UNSTABLE

    @property
    def undecided(self) -> bool:
        """Neither is proved; reason says why."""
        return self._c.verdict == c.SP_UNDECIDED

    @property
    def level(self) -> str:
        """How far a stable goes: "admissible" (forces exist), "coupled" (a motion explains them), else "none"."""
        return LEVELS[self._c.level]

    @property
    def final(self) -> bool:
        """Of an unstable: no forces of any size would do."""
        return bool(self._c.final)

    @property
    def imbalance(self) -> float:
        """Largest relative imbalance of the forces."""
        return self._c.imbalance

    @property
    def least_imbalance(self) -> float:
        """Proved by the motion: no admissible forces come below."""
        return self._c.least_imbalance

    @property
    def tol(self) -> float:
        """Imbalance that a stable one may have, relative; in force."""
        return self._c.tol

    @property
    def force_bound(self) -> float:
        """Of an unstable that is not final: no forces up to so much would do, in the scene's usual forces."""
        return self._c.force_bound

    @property
    def max_compression(self) -> float:
        """Largest force of a corner [N]."""
        return self._c.extremes.compression

    @property
    def max_tension(self) -> float:
        """Largest tension asked for [N]; 0 unless check(localise=True)."""
        return self._c.extremes.tension

    @property
    def max_utilisation(self) -> float:
        """Largest share of its friction that a joint uses."""
        return self._c.extremes.utilisation

    @property
    def flops(self) -> int:
        """Floating-point operations of the search."""
        return self._c.spent.total.flops

    @property
    def factorisations(self) -> int:
        """Of matrices, in the search."""
        return self._c.spent.total.factorisations

    @property
    def peak_bytes(self) -> int:
        """Memory of the check, besides the scene [byte]."""
        return self._c.spent.peak_bytes

    @property
    def f(self) -> memoryview:
        """Forces fn, ft1, ft2 of each corner, points x 3 [N]; numpy.asarray takes it without a copy."""
        count = self._there()._c.count.points
        if not count:
            return memoryview(b"").cast("B")
        at = ctypes.addressof(self._c.f.contents) - ctypes.addressof(self._memory)
        block = (ctypes.c_double * (3 * count)).from_buffer(self._memory, at)         # keeps that memory
        return memoryview(block).cast("B").cast("d", (count, 3))

    @property
    def forces(self) -> List[Vec3]:
        """The same as a list of (fn, ft1, ft2) [N]."""
        count = self._there()._c.count.points
        flat = self._c.f[0:3 * count]
        return list(zip(flat[0::3], flat[1::3], flat[2::3]))

    @property
    def motion(self) -> Dict[str, Vec6]:
        """{block: displacement of its centroid and rotation} of an unstable's mechanism, fastest first, else {}."""
        if self._c.verdict == c.SP_STABLE:
            return {}
        return motion_of(self._names[:self._count], self._c.dq)

    @property
    def moving(self) -> List[str]:
        """Names of the blocks that go, fastest first; [] unless unstable."""
        return list(self.motion) if self.unstable else []

    @property
    def joints(self) -> List[JointForce]:
        """What each joint passes on."""
        return [self._joint(k) for k in range(self._there()._c.count.joints)]

    @property
    def weakest(self) -> Optional[JointForce]:
        """The joint that is worst off: most help wanted, else most of its friction used."""
        return self._joint(self._c.extremes.weakest) if self._c.extremes.weakest >= 0 else None

    @property
    @asks
    def reactions(self) -> Dict[str, Tuple[Vec3, Vec3]]:
        """{support: (force on it [N], moment about its centroid [N m])}."""
        scene = self._there()
        out: Dict[str, Tuple[Vec3, Vec3]] = {}
        force, moment = (ctypes.c_double * 3)(), (ctypes.c_double * 3)()
        for b in range(scene._c.count.blocks):
            if scene._c.block[b].fixed == c.SP_FIXED:
                lib.sp_block_resultant(ctypes.byref(scene._c), ctypes.byref(self._c), b, force, moment)
                out[self._names[b]] = (vec3(force), vec3(moment))
        return out

    def verify(self) -> Evidence:
        """Compute anew, by other code than the search's, what the evidence proves."""
        return self._there().verify(self)

    @asks
    def svg(self, path: Optional[str] = None, *, names: bool = False, title: str = "scene") -> str:
        """The picture of `stonepack check --svg`, as text and into a file."""
        from . import pictures
        return pictures.draw(self._there(), self._c, None, path, names, title)

    @asks
    def json(self, path: Optional[str] = None, *, scene: str = "scene") -> str:
        """What `check --json --forces` tells, as text and into a file: `stonepack verify` judges it anew. scene: a name for it."""
        from . import scenefiles
        s = self._settings if self._settings is not None else lib.sp_settings_default()
        cone = "%d%s" % (s.faces, "i" if s.inscribed else "c") if s.faces else "true"
        return scenefiles.write_json(self._there(), self._c, s, cone, path, scene)

    @asks
    def _joint(self, k: int) -> JointForce:
        scene, out = self._there(), c.sp_joint_force()
        status = lib.sp_joint_resultant(ctypes.byref(scene._c), ctypes.byref(self._c), k, ctypes.byref(out))
        if status:
            raise refuse(status)
        joint = scene._c.joint[k]
        return JointForce(k, self._names[joint.a], self._names[joint.b], vec3(out.force), vec3(out.point), out.min_fn,
                          out.max_fn, out.utilisation, out.corner_utilisation)

    def __repr__(self) -> str:
        more = "" if self.stable else ", moving %s" % ", ".join(self.moving[:3]) if self.unstable else ", %s" % self.reason
        return "<%s%s%s>" % (self.verdict, "" if self.verified else ", not verified", more)


class Limit(_Answer):
    """How much of the live loads a scene bears."""

    __slots__ = ("_body",)

    def __bool__(self) -> bool:
        no_truth("its .multiplier or .kind")

    def __init__(self, scene: "Scene", body: Any):
        super().__init__(scene, c.sp_limit_result())
        self._body = body

    @property
    def kind(self) -> str:
        """"found", "none" (no multiple works), "unbounded" or "undecided"."""
        return text(c.SP_WORDS_LIMIT, self._c.kind)

    @property
    def multiplier(self) -> Optional[float]:
        """The largest multiple; inf where unbounded, None where there is none or it is not known."""
        if self._c.kind == c.SP_LIMIT_UNBOUNDED:
            return float("inf")
        return self._c.multiplier if self._c.kind == c.SP_LIMIT_FOUND else None

    @property
    def lower(self) -> float:
        """Proved to stand at this multiple; -1: no such end."""
        return self._c.lower

    @property
    def upper(self) -> float:
        """Proved to fall at this multiple; -1: no such end."""
        return self._c.upper

    @property
    def within(self) -> float:
        """By so much the multiplier may be off."""
        return self._c.within

    @property
    def dead(self) -> str:
        """The verdict under the dead loads alone."""
        return VERDICTS[self._c.dead]

    @property
    def motion(self) -> Dict[str, Vec6]:
        """The collapse mechanism, {block: displacement and rotation}, fastest first."""
        return motion_of(self._names[:self._count], self._c.dq) if self._c.upper >= 0 else {}

    @property
    @asks
    def hinges(self) -> List[Hinge]:
        """The joints that give way in the mechanism."""
        found: List[Hinge] = []
        scene, out = self._there(), c.sp_joint_motion()
        if self._c.upper < 0:
            return found
        for k in range(scene._c.count.joints):
            status = lib.sp_joint_moves(ctypes.byref(scene._c), self._c.dq, k, ctypes.byref(out))
            if status:
                raise refuse(status)
            if out.kind != c.SP_JOINT_RIGID:
                joint = scene._c.joint[k]
                found.append(Hinge(self._names[joint.a], self._names[joint.b], text(c.SP_WORDS_JOINT, out.kind), out.opening,
                                   out.slip, (vec3(out.a), vec3(out.b))))
        return found

    @asks
    def svg(self, path: Optional[str] = None, *, names: bool = False, title: str = "scene") -> str:
        """The picture of `stonepack limit --svg`, as text and into a file."""
        from . import pictures
        return pictures.draw_limit(self._there(), self._c, path, names, title)

    def __repr__(self) -> str:
        return "<limit %s%s>" % (self.kind if self.multiplier is None else self.multiplier,
                                 "" if self.verified else ", not verified")
