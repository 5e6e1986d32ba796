"""Where stones come to rest, by Bullet: poses, and whether an assembly keeps still."""
import ctypes
import math
from ctypes import byref
from typing import TYPE_CHECKING, Any, Dict, List, NamedTuple, Optional

from . import _bindings as c
from ._library import SceneError, settling
from ._numbers import number, triple, whole
from .answers import Vec3, no_truth, vec3

if TYPE_CHECKING:
    from .scene import Scene

_KEPT = ("watch", "user", "pair", "pairs", "gravity", "mu")      # set by the scene


class Pose(NamedTuple):
    """Where a stone is: x' = R (x - c) + t of its points x as they were.

    R           by rows
    c, t        its centroid as it was, as it is [m]
    moved       how far that is [m]
    turned      by what angle [degree]
    settled     fixed, or not below the settings' `lowest`
    """
    R: List[Vec3]
    c: Vec3
    t: Vec3
    moved: float
    turned: float
    settled: bool


class Settled(NamedTuple):
    """What came of a simulation.

    held            no stone moved or turned by more than the settings' `moved`, `turned`
    moved, turned   most of any stone [m, degree]
    settled         how many stones did, fixed ones too
    steps           of the simulation
    energy          kinetic, at the end; where confirmed of a scene of unit stones [J]
    penetration     deepest at the end [m]
    poses           by block
    scene           as it came to rest, joints to be found anew
    """
    held: bool
    moved: float
    turned: float
    settled: int
    steps: int
    energy: float
    penetration: float
    poses: Dict[str, Pose]
    scene: "Scene"

    def __bool__(self) -> bool:
        no_truth("its .held")


def _settings(lib: Any, scene: "Scene", confirm: bool, words: Dict[str, Any]) -> Any:
    s = lib.settle_confirm_default() if confirm else lib.settle_default()
    g = list(scene._c.gravity)
    scale = 9.81 / math.hypot(*g) if confirm and any(g) else 1      # lengths and masses are scaled, and so is gravity
    s.gravity[:] = [scale * x for x in g]
    s.mu = scene.mu
    for name, value in words.items():
        if name in _KEPT or not hasattr(s, name):
            raise SceneError("settle has no setting '%s'" % name)
        field = getattr(s, name)
        wanted: Any = triple if isinstance(field, ctypes.Array) else number if isinstance(field, float) else whole
        setattr(s, name, wanted(value, name))
    return s


def _frictions(scene: "Scene", mu: float) -> Any:
    """Joints with a friction of their own."""
    other = [c.settle_pair(j.a, j.b, j.strength.mu) for j in scene._c.joint[:scene._c.count.joints] if j.strength.mu != mu]
    return (c.settle_pair * len(other))(*other)


def _pose(p: Any, scale: float) -> Pose:
    return Pose([vec3(p.R[k:k + 3]) for k in (0, 3, 6)], vec3([x / scale for x in p.c]), vec3([x / scale for x in p.t]),
                p.moved / scale, p.turned, bool(p.settled))


def _at_rest(scene: "Scene", poses: Dict[str, Pose]) -> "Scene":
    new = type(scene)(mu=scene.mu, density=scene.density, gravity=list(scene.gravity))
    for k, (name, p) in enumerate(poses.items()):
        b, (vertices, faces) = scene._c.block[k], scene.mesh(name)
        if not b.fixed:
            vertices = [tuple(sum(r * (x - o) for r, x, o in zip(row, v, p.c)) + t for row, t in zip(p.R, p.t)) for v in vertices]
        new.add(vertices, faces, name=name, density=b.density if b.density > 0 else None, fixed=b.fixed)
    return new


def settle(scene: "Scene", confirm: bool, words: Dict[str, Any]) -> Settled:
    lib, assembly, found = settling(), c.settle_assembly(), c.settle_result()
    s = _settings(lib, scene, confirm, words)
    pairs = _frictions(scene, s.mu)
    s.pairs, s.pair = len(pairs), pairs
    try:
        status = lib.settle_from_scene(byref(scene._c), int(bool(confirm)), byref(assembly))
        if not status:
            status = lib.settle_run(assembly.stones, assembly.stone, byref(s), byref(found))
        if status:
            block: Optional[str] = scene._names[assembly.block] if assembly.block >= 0 else None
            raise SceneError("%s%s" % ("block '%s': " % block if block else "", lib.settle_status_text(status).decode()), status, block)
        scale = assembly.scale
        poses = {name: _pose(found.pose[k], scale) for k, name in enumerate(scene._names)}
        return Settled(bool(found.held), found.moved / scale, found.turned, found.settled, found.steps, found.energy,
                       found.penetration / scale, poses, _at_rest(scene, poses))
    finally:
        lib.settle_result_free(byref(found))
        lib.settle_assembly_free(byref(assembly))
