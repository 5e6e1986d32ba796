"""Scenes: blocks, joints, loads, and the questions about them."""
from __future__ import annotations

import ctypes
import os
import operator
import threading
from concurrent.futures import ThreadPoolExecutor
from ctypes import byref
from typing import Any, Callable, Dict, Iterable, List, NoReturn, Optional, Sequence, Tuple, Union

from . import _bindings as c
from . import meshes
from ._library import SceneError, StonepackError, arena, lib, refuse, text
from ._numbers import Vector, number, polygons, rows, triple, whole
from ._turns import Turns, asks, changes
from .answers import (LEVELS, VERDICTS, Block, Effect, Evidence, Held, Joint, Limit, Overlap, Plan, Result, Step, Strong,
                      motion_of, speeds, vec3)
from .settling import Settled, settle

GRAVITY = (0.0, 0.0, -9.80665)
Name = Union[str, int, Block]
Fixed = Union[bool, int, str, Iterable[str]]

# What grows: array of sp_scene, its number in sp_capacity, bytes of an entry.
_GROWS = tuple((array, number, ctypes.sizeof(getattr(c.sp_scene(), array)._type_)) for array, number in (
    ("block", "blocks"), ("vertex", "vertices"), ("face", "faces"), ("corner", "corners"), ("joint", "joints"),
    ("point", "points"), ("load", "loads")))
_DIRECTIONS = {"x": 1, "y": 2, "z": 4, "rx": 8, "ry": 16, "rz": 32}
_ON = (c.SP_WHY_CALLED, c.SP_WHY_ASKED, c.SP_WHY_STAGES)


def _held(fixed: Fixed) -> int:
    """Directions held, as sp_block.fixed."""
    if isinstance(fixed, bool) or type(fixed).__name__ in ("bool_", "bool"):                # NumPy's too
        return c.SP_FIXED if fixed else 0
    if hasattr(fixed, "__index__"):
        return whole(fixed, "fixed", c.SP_FIXED)
    try:
        return sum({_DIRECTIONS[w] for w in (fixed.split() if isinstance(fixed, str) else fixed)})
    except KeyError as wrong:
        raise SceneError("fixed: %s is not one of x y z rx ry rz" % wrong) from None
    except TypeError:
        raise SceneError("fixed: True, False or directions are wanted, not %r" % (fixed,)) from None


def _settings(tol: Optional[float] = None, coupled: bool = False, eps: Optional[float] = None, eta: Optional[float] = None,
              cone: str = "true", budget: int = 0, localise: bool = True, iterations: Optional[int] = None,
              force_bound: Optional[float] = None, without: Sequence[str] = ()) -> Any:
    """sp_settings of these words; None: the default ones."""
    if tol is None and not coupled and cone == "true" and not budget and localise and iterations is None \
            and force_bound is None and not without:
        return None
    s = lib.sp_settings_default()
    if tol is not None:
        s.tol = number(tol, "tol")
    if coupled:
        s.coupled.asked = 1
        s.coupled.eps = -1 if eps is None else number(eps, "eps")
        s.coupled.eta = 0 if eta is None else number(eta, "eta")
    if cone != "true":
        if not isinstance(cone, str) or cone[-1:] not in ("i", "c") or not (cone.isascii() and cone[:-1].isdigit()):
            raise SceneError("cone: true, or so many faces, inscribed or circumscribed: 8i, 4c; not %r" % cone)
        s.faces, s.inscribed = whole(int(cone[:-1]), "cone"), int(cone[-1] == "i")
    s.budget, s.localise = whole(budget, "budget", 2 ** 63 - 1), int(bool(localise))
    if iterations is not None:
        s.iterations = whole(iterations, "iterations")
    if force_bound is not None:
        s.force_bound = number(force_bound, "force_bound")
    for effect in without:
        try:
            s.effect[("friction", "depth", "together").index(effect)] = c.SP_WITHOUT
        except ValueError:
            raise SceneError("without: friction, depth, together; not %r" % effect) from None
    return s


_KEPT: Dict[Any, Any] = {}                              # settings by their words: most callers have a few


def _settings_of(words: Dict[str, Any]) -> Tuple[Any, Any]:
    """(key, sp_settings or None for the default ones) of the words of a call; the struct is not to be written."""
    if not words:
        return (), None
    key = tuple(words.items())
    try:
        return key, _KEPT[key]
    except KeyError:
        if len(_KEPT) > 100:
            _KEPT.clear()
        _KEPT[key] = _settings(**words)
        return key, _KEPT[key]
    except TypeError:                                   # a list among them
        return None, _settings(**words)


class Scene:
    """An assembly of rigid blocks.

    mu          friction of joints that have none of their own, and of those that are found
    density     of blocks that have none of their own [kg/m^3]
    gravity     [m/s^2]

    Joints are found from the meshes unless some are given; blocks that are added later are found with all others.
    One scene may be asked by several threads at once; a change meanwhile is refused: change a copy.
    """

    def __init__(self, *, mu: float = 0.84, density: float = 2400.0, gravity: Vector = GRAVITY):
        self.mu, self.density = mu, density
        self.remarks: List[str] = []                # of the file it was read from
        self.recipe: Optional[str] = None           # the call that made it, by stonepack.scenes
        self._c = c.sp_scene()
        self._memory: Any = None
        self._names: List[str] = []
        self._index: Dict[str, int] = {}
        self._version = 0
        self._given = False                         # joints were given, not found
        self._found: Any = None                     # how joints were found: settings; None: not yet
        self._overlaps: List[Overlap] = []
        self._needs: Dict[Any, int] = {}            # bytes of a check by its settings
        self._lock = threading.Lock()               # one thread finds joints, others wait for them
        self._turns = Turns()
        self._create(c.sp_capacity(8, 64, 48, 192, 16, 64, 4))
        self.gravity = gravity                      # type: ignore[assignment]

    # ------------------------------------------------------------------------------------------------------------ memory

    def _create(self, capacity: Any) -> None:
        memory, a = arena(lib.sp_scene_memory(byref(capacity)))
        new = c.sp_scene()
        status = lib.sp_scene_create(byref(new), byref(capacity), byref(a))
        if status:
            raise refuse(status, "a scene of %d blocks" % capacity.blocks)
        self._c, self._memory = new, memory

    def _room(self, **more: int) -> None:
        """Room for so much more; arrays are moved to larger ones, which double."""
        count, have = self._c.count, self._c.capacity
        lack = [k for k, n in more.items() if getattr(count, k) + n > getattr(have, k)]
        if not lack:
            return
        capacity = c.sp_capacity.from_buffer_copy(have)
        for k in lack:
            setattr(capacity, k, max(2 * getattr(have, k), getattr(count, k) + more[k]))
        self._copy_of(self._c, self._memory, capacity)

    def _copy_of(self, old: Any, kept: Any, capacity: Any) -> None:
        """This scene as a copy of another, in room of its own; kept: what the other's arrays lie in."""
        self._create(capacity)
        new = self._c
        for array, number, size in _GROWS:
            n = getattr(old.count, number)
            if n:
                ctypes.memmove(getattr(new, array), getattr(old, array), n * size)
        new.count, new.live = old.count, old.live
        new.gravity[:], new.body[:] = old.gravity[:], old.body[:]

    def __reduce__(self) -> NoReturn:
        raise StonepackError("a scene is not pickled: send scene.to_obj(), and stonepack.parse it there")

    def _touched(self, recipe: Optional[str] = None) -> None:
        """Something changed: answers before this are of another scene, which no recipe makes."""
        self._version += 1
        self._needs.clear()
        self.recipe = recipe

    # ------------------------------------------------------------------------------------------------------------ blocks

    @changes
    def add(self, vertices: Any, faces: Any = None, *, name: Optional[str] = None, density: Optional[float] = None,
            fixed: Fixed = False) -> str:
        """Add a block; returns its name.

        vertices  n x 3 [m]; or anything with .vertices and .faces (trimesh and others), a mesh of COMPAS, a pair
        faces     vertex numbers from 0, a list per face, anticlockwise seen from outside; m x k arrays too
        density   [kg/m^3]
        fixed     True: a support; "x z ry": held in these directions only
        """
        label = self._label(name)
        what = "block '%s'" % label
        if faces is None:
            vertices, faces = meshes.of(vertices)
        nv, xyz = rows(vertices, what)
        nf, sizes, corners, nc = polygons(faces, what)
        return self._add_mesh(label, c.sp_mesh(nv, nf, xyz, sizes, corners), nc, density, fixed)

    @changes
    def box(self, size: Vector, at: Vector = (0, 0, 0), *, name: Optional[str] = None, density: Optional[float] = None,
            fixed: Fixed = False) -> str:
        """Add a box of that size (x, y, z) [m] about the centre `at` [m]; returns its name."""
        return self._add_mesh(self._label(name), meshes.box_mesh(size, at), 24, density, fixed)

    def _add_mesh(self, label: str, mesh: Any, corners: int, density: Optional[float], fixed: Fixed) -> str:
        self._room(blocks=1, vertices=mesh.vertices, faces=mesh.faces, corners=corners)
        kg = number(self.density if density is None else density, "block '%s': density" % label)
        status = lib.sp_scene_block(byref(self._c), byref(mesh), kg, _held(fixed), None)
        if status:
            raise refuse(status, "block '%s'" % label, label)
        return self._named(label)

    @changes
    def body(self, mass: float, centroid: Vector, *, name: Optional[str] = None, fixed: Fixed = False) -> str:
        """Add a block without a mesh, known by its mass [kg] and centroid [m]; what it touches must be given."""
        label = self._label(name)
        self._room(blocks=1)
        status = lib.sp_scene_body(byref(self._c), number(mass, "block '%s': mass" % label),
                                   triple(centroid, "block '%s'" % label), _held(fixed), None)
        if status:
            raise refuse(status, "block '%s'" % label, label)
        return self._named(label)

    def _label(self, name: Optional[str]) -> str:
        label = "b%d" % len(self._names) if name is None else "_".join(str(name).split())      # as in files
        if not label:
            raise SceneError("a name of a block is empty")
        if "\0" in label or any("\ud800" <= letter <= "\udfff" for letter in label):
            raise SceneError("block %r: no file can hold this name" % label, 0, label)
        if label in self._index:
            raise SceneError("block '%s': there is one of this name" % label, 0, label)
        return label

    def _named(self, label: str) -> str:
        self._index[label] = len(self._names)
        self._names.append(label)
        self._touched()
        return label

    def number(self, block: Name) -> int:
        """Number of a block, by its name, its number or as `blocks` tells it."""
        if isinstance(block, Block):
            block = block.name
        if isinstance(block, str):
            try:
                return self._index[block]
            except KeyError:
                raise SceneError("no block is called '%s'" % block, c.SP_E_INDEX, block) from None
        try:
            k = operator.index(block)
        except TypeError:
            raise SceneError("a block is told by its name or number, not %r" % (block,), c.SP_E_INDEX) from None
        if not 0 <= k < len(self._names):
            raise SceneError("no block has number %d" % k, c.SP_E_INDEX)
        return k

    @property
    def names(self) -> List[str]:
        """Of its blocks, by number."""
        return list(self._names)

    @property
    def blocks(self) -> List[Block]:
        """All blocks, in the order in which they were added."""
        out = []
        for k, name in enumerate(self._names):
            b = self._c.block[k]
            out.append(Block(k, name, b.mass, vec3(b.centroid), b.volume, b.fixed == c.SP_FIXED))
        return out

    def mesh(self, block: Name) -> meshes.Shape:
        """(vertices, faces) of a block; empty of one without a mesh."""
        s, b = self._c, self._c.block[self.number(block)]
        vertices = [tuple(s.vertex[k]) for k in range(b.vertex, b.vertex + b.vertices)]
        faces = [tuple(k - b.vertex for k in s.corner[s.face[i].corner:s.face[i].corner + s.face[i].corners])
                 for i in range(b.face, b.face + b.faces)]
        return vertices, faces

    # ------------------------------------------------------------------------------------------------------------ joints

    def _strength(self, mu: Optional[float], cohesion: float, tension: float, crushing: float) -> Any:
        told = ("mu", self.mu if mu is None else mu), ("cohesion", cohesion), ("tension", tension), ("crushing", crushing)
        return c.sp_strength(*[number(x, what) for what, x in told])

    @changes
    def joint(self, a: Name, b: Name, polygon: Any, *, mu: Optional[float] = None, cohesion: float = 0, tension: float = 0,
              crushing: float = 0) -> int:
        """Add a contact polygon, n x 3 corners anticlockwise seen from b [m]; returns its number. Strength in Pa."""
        i, j, what = self.number(a), self.number(b), "joint '%s' '%s'" % (self._label_of(a), self._label_of(b))
        n, xyz = rows(polygon, what)
        strength = self._strength(mu, cohesion, tension, crushing)
        return self._append(n, what, self._label_of(b),
                            lambda: lib.sp_scene_joint(byref(self._c), i, j, n, xyz, byref(strength), None))

    @changes
    def points(self, a: Name, b: Name, normal: Vector, points: Any, *, mu: Optional[float] = None) -> int:
        """Add a point or edge contact: n x 3 points [m] that share a normal from a into b; returns its number."""
        i, j, what = self.number(a), self.number(b), "contact '%s' '%s'" % (self._label_of(a), self._label_of(b))
        n, xyz = rows(points, what)
        along, strength = triple(normal, what), self._strength(mu, 0, 0, 0)
        return self._append(n, what, self._label_of(b),
                            lambda: lib.sp_scene_points(byref(self._c), i, j, along, n, xyz, byref(strength), None))

    def _label_of(self, block: Name) -> str:
        return self._names[self.number(block)]

    def _append(self, points: int, what: str, block: str, call: Callable[[], int]) -> int:
        """One more joint. From the first that is given on, those that were found are gone."""
        self._room(joints=1, points=points)
        count = self._c.count
        before = count.joints, count.points
        if not self._given:
            count.joints = count.points = 0
        status = call()
        if status:
            count.joints, count.points = before
            raise refuse(status, what, block)
        self._given, self._found = True, None
        self._touched()
        return count.joints - 1

    @changes
    def find_contacts(self, *, distance: Optional[float] = None, share: Optional[float] = None, angle: Optional[float] = None,
                      mu: Optional[float] = None, cohesion: float = 0, tension: float = 0,
                      crushing: float = 0) -> List[Overlap]:
        """Find what touches what, with other settings than a check would; joints there were are gone.

        distance  faces nearer than this touch [m]; or share: of the smaller block's diameter, 1e-6 if neither is told
        angle     largest sine of the angle between touching faces; without it faces may rise by 8 distances where one is told
        returns   blocks that are inside each other
        """
        s = lib.sp_contact_settings_default()
        if distance is not None and share is not None:
            raise SceneError("distance and share exclude each other")
        if distance is not None:
            s.distance, s.absolute, s.angle = number(distance, "distance"), 1, -8
        if share is not None:
            s.distance, s.angle = number(share, "share"), -8
        if angle is not None:
            s.angle = number(angle, "angle")
        s.strength = self._strength(mu, cohesion, tension, crushing)
        self._given = False
        self._find(s)
        return self.overlaps

    @changes
    def _find(self, settings: Any) -> None:
        s, scene = settings, self._c
        need = ctypes.c_size_t()
        scene.count.joints = scene.count.points = 0
        status = lib.sp_memory(byref(scene), c.SP_FOR_CONTACTS, None, c.sp_arena(), byref(need))
        if status:
            raise refuse(status, "contacts")
        kept, scratch = arena(need.value)
        report = c.sp_contact_report()
        status = lib.sp_contacts_find(byref(scene), byref(s), scratch, byref(report))
        over = None
        if status == c.SP_E_CAPACITY or (not status and report.overlaps):
            over = (c.sp_overlap * report.overlaps)()
            scene.count.joints = scene.count.points = 0
            self._room(joints=report.joints, points=report.points)
            scene = self._c
            report = c.sp_contact_report(0, 0, 0, report.overlaps, over)
            status = lib.sp_contacts_find(byref(scene), byref(s), scratch, byref(report))
        if status:
            raise refuse(status, "contacts")
        self._overlaps = [Overlap(self._names[o.a], self._names[o.b], o.depth) for o in over] if over else []
        self._touched(self.recipe)                      # finding joints is part of it
        self._found = (self._version, s)

    def _is_ready(self) -> bool:
        return self._given or (self._found is not None and self._found[0] == self._version)

    def _ready(self) -> None:
        """Joints are there: given, or found of the blocks as they are."""
        if self._is_ready():
            return
        with self._lock:
            if self._found is None:
                s = lib.sp_contact_settings_default()
                s.strength = self._strength(None, 0, 0, 0)
                self._find(s)
            elif self._found[0] != self._version:
                self._find(self._found[1])

    @property
    @asks
    def joints(self) -> List[Joint]:
        """All joints; they are found if none was given."""
        out = []
        for k in range(self._c.count.joints):
            j = self._c.joint[k]
            points = [vec3(self._c.point[i]) for i in range(j.point, j.point + j.points)]
            out.append(Joint(k, self._names[j.a], self._names[j.b], vec3(j.n), vec3(j.t1), vec3(j.t2), j.area,
                             j.strength.mu, points))
        return out

    @property
    def overlaps(self) -> List[Overlap]:
        """Blocks inside each other, where joints were found."""
        self._ready()
        return list(self._overlaps)

    @changes
    def friction(self, mu: float) -> None:
        """One friction coefficient for every joint."""
        self._ready()
        status = lib.sp_scene_friction(byref(self._c), number(mu, "friction"))
        if status:
            raise refuse(status, "friction")
        self.mu = mu
        self._numbers_changed()
        if self._found:
            self._found[1].strength.mu = mu

    def _numbers_changed(self) -> None:
        """Joints stay what they are, and most often the bytes of a check; answers before this do not."""
        found = self._found is not None and self._found[0] == self._version
        self._version += 1
        self.recipe = None
        if found:
            self._found = (self._version, self._found[1])

    # ------------------------------------------------------------------------------------------------------------- loads

    @changes
    def load(self, block: Name, force: Vector = (0, 0, 0), at: Optional[Vector] = None, *, couple: Vector = (0, 0, 0),
             mass: float = 0, live: bool = False) -> None:
        """Add a load: force [N] and mass [kg] at a point [m] (None: the centroid) that goes with the block, couple [N m].
        live: counts `live` times, and is what `limit` scales."""
        k, what = self.number(block), "load on '%s'" % self._label_of(block)
        point = self._c.block[k].centroid if at is None else triple(at, what)
        each = c.sp_load(k, int(live), point, triple(force, what), triple(couple, what), number(mass, what))
        self._room(loads=1)
        status = lib.sp_scene_load(byref(self._c), byref(each), None)
        if status:
            raise refuse(status, what, self._label_of(block))
        self._numbers_changed()

    @changes
    def pressure(self, block: Name, face: int, pressure: float, *, live: bool = False) -> None:
        """Press on a face (its number within the block) [Pa]; below 0 it pulls."""
        what = "pressure on '%s'" % self._label_of(block)
        self._room(loads=1)
        status = lib.sp_scene_pressure(byref(self._c), self.number(block), whole(face, what + ": face"),
                                       number(pressure, what), int(live), None)
        if status:
            raise refuse(status, what, self._label_of(block))
        self._numbers_changed()

    @property
    def gravity(self) -> Any:
        """[m/s^2]"""
        return tuple(self._c.gravity)

    @gravity.setter
    @changes
    def gravity(self, g: Vector) -> None:
        self._c.gravity = triple(g, "gravity")
        self._numbers_changed()

    @property
    def live(self) -> float:
        """Multiple at which live loads act."""
        return self._c.live

    @live.setter
    @changes
    def live(self, multiple: float) -> None:
        self._c.live = number(multiple, "live")
        self._numbers_changed()

    @property
    def live_acceleration(self) -> Any:
        """Acceleration of every block and of the mass of loads that counts `live` times [m/s^2]."""
        return tuple(self._c.body)

    @live_acceleration.setter
    @changes
    def live_acceleration(self, a: Vector) -> None:
        self._c.body = triple(a, "live_acceleration")
        self._numbers_changed()

    # --------------------------------------------------------------------------------------------------------- questions

    def _bytes(self, what: int, settings: Any, scene: Any = None) -> int:
        """Bytes that a call takes."""
        here, p, need = byref(scene or self._c), (byref(settings) if settings is not None else None), ctypes.c_size_t()
        if what in (c.SP_FOR_VERIFY, c.SP_FOR_PLAN, c.SP_FOR_LIMIT_VERIFY, c.SP_FOR_STRONG, c.SP_FOR_STRONG_VERIFY):
            kept, scratch = None, c.sp_arena()
        else:
            kept, scratch = arena(lib.sp_memory_scratch(here, what, p))
        status = lib.sp_memory(here, what, p, scratch, byref(need))
        if status:
            raise refuse(status)
        return need.value

    @asks
    def check(self, **settings: Any) -> Result:
        """Does it stand?

        tol         accuracy of the evidence, relative imbalance per block: 1e-9
        coupled     ask for a motion that explains the forces, too; eps, eta [m]: how much joints give, how far they may move
        cone        "true", or a pyramid: "8i" inscribed, "4c" circumscribed
        budget      flops it may spend; 0: no limit
        localise    False: don't ask where help is wanted, where it does not stand
        without     effects to leave out: "friction", "depth", "together"
        """
        key, s = _settings_of(settings)
        p, result = (byref(s) if s is not None else None), Result(self, s)
        need = self._needs.get(key)
        if need is not None:
            result._memory, a = arena(need)
            status = lib.sp_check(byref(self._c), p, byref(a), byref(result._c))
        if need is None or status == c.SP_E_MEMORY:     # not asked before, or numbers changed so that it takes more
            need = self._needs[key] = self._bytes(c.SP_FOR_CHECK, s)
            result._memory, a = arena(need)
            status = lib.sp_check(byref(self._c), p, byref(a), byref(result._c))
        if status:
            raise refuse(status)
        return result

    @asks
    def verify(self, result: Result) -> Evidence:
        """What the evidence of a result proves, computed anew from the scene."""
        p = byref(result._settings) if result._settings is not None else None
        result._there()
        kept, scratch = arena(self._bytes(c.SP_FOR_VERIFY, None))
        out = c.sp_evidence()
        status = lib.sp_verify(byref(self._c), p, byref(result._c), scratch, byref(out))
        if status:
            raise refuse(status)
        return Evidence(VERDICTS[out.verdict], bool(out.final), out.imbalance, out.least_imbalance, LEVELS[out.level],
                        out.residual, out.margin)

    @asks
    def limit(self, body: Optional[Vector] = None, **settings: Any) -> Limit:
        """How much more until it falls: the largest multiple of the live loads.

        body      a live load of every block's weight times this vector: (1, 0, 0) asks for an earthquake's share of gravity
        settings  tol, cone, budget, iterations, force_bound, as of check
        """
        s = _settings(**settings) if settings else None
        scene = c.sp_scene.from_buffer_copy(self._c)        # numbers of its own, the same arrays
        if body is not None:
            g = sum(x * x for x in self._c.gravity) ** 0.5
            scene.body = triple([g * x for x in triple(body, "body")], "body")
        need = self._bytes(c.SP_FOR_LIMIT, s, scene)
        limit = Limit(self, body)
        limit._memory, a = arena(need)
        status = lib.sp_limit(byref(scene), byref(s) if s is not None else None, byref(a), byref(limit._c))
        if status:
            raise refuse(status)
        return limit

    @asks
    def plan(self, **settings: Any) -> Plan:
        """What will a check simulate, what not, and why?"""
        s, out = _settings(**settings) if settings else None, c.sp_outlook()
        kept, scratch = arena(self._bytes(c.SP_FOR_PLAN, s))
        status = lib.sp_plan(byref(self._c), byref(s) if s is not None else None, scratch, byref(out))
        if status:
            raise refuse(status)
        effects = {text(c.SP_WORDS_EFFECT, k): Effect(e.why in _ON, text(c.SP_WORDS_EFFECT_WHY, e.why), e.unknowns, e.flops,
                                                      e.bytes) for k, e in enumerate(out.effect)}
        return Plan(effects, out.islands, out.unknowns, out.flops, out.bytes, out.full_unknowns, out.full_flops, out.full_bytes)

    @asks
    def strong(self, **settings: Any) -> Strong:
        """Does it stand whatever friction does, or by its history only?"""
        result = self.check(**settings)
        still = self.check(**dict(settings, without=("friction",), localise=False))
        p = byref(result._settings) if result._settings is not None else None
        out = c.sp_strong_result()
        kept, a = arena(self._bytes(c.SP_FOR_STRONG, result._settings))
        status = lib.sp_strong(byref(self._c), p, None, result._c.f, still._c.f if still.stable else None, byref(a), byref(out))
        if status:
            raise refuse(status)
        proved = ctypes.c_int()
        kept_too, scratch = arena(self._bytes(c.SP_FOR_STRONG_VERIFY, None))
        status = lib.sp_strong_verify(byref(self._c), p, byref(out), scratch, byref(proved))
        return Strong(text(c.SP_WORDS_STRONG, out.kind), text(c.SP_WORDS_STRONG_REASON, out.reason),
                      not status and proved.value == out.kind, out.residual, out.moves,
                      motion_of(self._names, out.a) if out.kind == c.SP_STRONG_AMBIGUOUS else {})

    def sequence(self, order: Optional[Iterable[Name]] = None, *, hold: bool = False, **settings: Any) -> List[Step]:
        """Does it stand at every step of a build order? order: blocks as they come; None: as they were added, without supports.
        hold: also ask what must be held at each step that does not stand."""
        under_way = BuildOrder(self, **settings)
        if order is None:
            order = [k for k in range(len(self._names)) if self._c.block[k].fixed != c.SP_FIXED]
        return [under_way.add(block, ask_hold=hold) for block in order]

    def building(self, **settings: Any) -> "BuildOrder":
        """A build order under way: add, remove, hold and let go of stones one by one."""
        return BuildOrder(self, **settings)

    # ------------------------------------------------------------------------------------------------------------- files

    @asks
    def settle(self, *, confirm: bool = False, **settings: Any) -> Settled:
        """Let the stones fall into place, simulated by Bullet, where this was built with it. No proof: compare verdicts.

        confirm   True: does the scene, as it is, keep still? `held` tells, lengths measured in mean stones
        settings  those of settle/settle.h by name: steps=3000, container=(1, 1, 1), lift=0, dt=1 / 1200 ...
        """
        return settle(self, confirm, settings)

    @asks
    def write(self, path: str) -> None:
        """Write a scene file (OBJ with `#@` comments) that reads back as the same scene, joints with it."""
        from . import scenefiles
        scenefiles.write(self, path)

    @asks
    def to_obj(self) -> str:
        """The text of that file."""
        from . import scenefiles
        return scenefiles.text_of(self)

    def copy(self) -> "Scene":
        """A scene of its own with the same blocks, joints and loads."""
        new = Scene(mu=self.mu, density=self.density)
        self._turns.ask(lambda: True)
        try:
            new._copy_of(self._c, self._memory, c.sp_capacity.from_buffer_copy(self._c.capacity))
        finally:
            self._turns.asked()
        new._names, new._index = list(self._names), dict(self._index)
        new._given, new._overlaps, new.remarks = self._given, list(self._overlaps), list(self.remarks)
        new.recipe = self.recipe
        if self._found is not None:
            new._found = (new._version if self._found[0] == self._version else -1,
                          c.sp_contact_settings.from_buffer_copy(self._found[1]))
        return new

    __copy__ = copy

    def __deepcopy__(self, memo: Any) -> "Scene":
        return self.copy()

    @asks
    def part(self, blocks: Iterable[Name]) -> "Scene":
        """A scene of its own of these blocks alone, with the joints between them and the loads on them."""
        chosen = sorted({self.number(b) for b in blocks})
        new, old = Scene(mu=self.mu, density=self.density, gravity=self.gravity), self._c
        number: Dict[int, int] = {}
        for k in chosen:
            b, number[k] = old.block[k], len(number)
            if b.faces:
                new.add(*self.mesh(k), name=self._names[k], density=b.density, fixed=b.fixed)
            else:
                new.body(b.mass, tuple(b.centroid), name=self._names[k], fixed=b.fixed)
        for j in self.joints:
            a, b, s = old.joint[j.number].a, old.joint[j.number].b, old.joint[j.number].strength
            if a in number and b in number and j.area > 0:
                new.joint(number[a], number[b], j.points, mu=s.mu, cohesion=s.cohesion, tension=s.tension, crushing=s.crushing)
            elif a in number and b in number:
                new.points(number[a], number[b], j.normal, j.points, mu=s.mu)
        new._given, new._c.live = True, old.live
        for k in range(old.count.loads):
            each = old.load[k]
            if each.block in number:
                new.load(number[each.block], tuple(each.force), tuple(each.point), couple=tuple(each.couple), mass=each.mass,
                         live=bool(each.live))
        return new

    def __len__(self) -> int:
        return len(self._names)

    def __repr__(self) -> str:
        return self.recipe or "<scene of %d blocks, %d joints>" % (len(self._names), self._c.count.joints)


class BuildOrder:
    """A build order under way; the scene must stay as it is. In the beginning only supports are there."""

    def __init__(self, scene: Scene, **settings: Any):
        scene._ready()
        self._scene, self._version = scene, scene._version
        self._settings = _settings(**settings) if settings else None
        self._memory, a = arena(scene._bytes(c.SP_FOR_SEQUENCE, self._settings))
        self._c = ctypes.POINTER(c.sp_sequence)()
        status = lib.sp_sequence_open(byref(scene._c), byref(self._settings) if self._settings is not None else None, byref(a),
                                      byref(self._c))
        if status:
            raise refuse(status)

    def add(self, block: Name, *, ask_hold: bool = False) -> Step:
        """A stone comes, or one that was held is let go."""
        return self._set(block, c.SP_PRESENT, ask_hold)

    def remove(self, block: Name, *, ask_hold: bool = False) -> Step:
        """A stone is taken away."""
        return self._set(block, c.SP_ABSENT, ask_hold)

    def hold(self, block: Name, *, ask_hold: bool = False) -> Step:
        """A stone comes and is held in place, by a robot, a prop, centring."""
        return self._set(block, c.SP_HELD, ask_hold)

    @asks
    def must_hold(self, budget: int = 0) -> Held:
        """The smallest set of blocks to hold now; budget: flops after which the best so far is taken."""
        out, names = c.sp_held(), self._scene._names
        status = lib.sp_sequence_hold(self._here(), whole(budget, "budget", 2 ** 63 - 1), byref(out))
        if status:
            raise refuse(status)
        return Held([names[k] for k in out.block[0:out.count]], [bool(m) for m in out.must[0:out.count]],
                    text(c.SP_WORDS_HELD_PROOF, out.proof), out.checks)

    @asks
    def suggest(self, *, add: bool = True, budget: int = 0) -> Optional[str]:
        """A next stone to lay (or to take away) after which everything stands; None: there is none."""
        out = c.sp_suggestion()
        status = lib.sp_sequence_suggest(self._here(), int(add), whole(budget, "budget", 2 ** 63 - 1), byref(out))
        if status:
            raise refuse(status)
        return self._scene._names[out.block] if out.block >= 0 else None

    def __reduce__(self) -> NoReturn:
        raise StonepackError("a build order under way is not pickled")

    def _here(self) -> Any:
        if self._scene._version != self._version:
            raise SceneError("the scene has changed since this build order began")
        return self._c

    @asks
    def _set(self, block: Name, presence: int, ask_hold: bool) -> Step:
        out, names, k = c.sp_step(), self._scene._names, self._scene.number(block)
        status = lib.sp_sequence_set(self._here(), k, presence, byref(out))
        if status:
            raise refuse(status, "step '%s'" % names[k], names[k])
        speed = speeds(out.dq, len(names)) if out.verdict == c.SP_UNSTABLE else []
        moving = [names[b] for b in sorted(range(len(speed)), key=lambda b: -speed[b]) if speed[b] > 0]
        step = Step(names[k], VERDICTS[out.verdict], out.verdict == c.SP_STABLE, text(c.SP_WORDS_REASON, out.reason),
                    bool(out.final), names[out.block] if out.block >= 0 else None, moving, out.imbalance, None)
        if ask_hold:
            step = step._replace(hold=[] if step.stable else self.must_hold().blocks)
        return step


def check_many(scenes: Iterable[Scene], *, threads: Optional[int] = None, **settings: Any) -> List[Result]:
    """Check many scenes at once over threads (None: one per processor); results in their order.
    A scene that is refused raises."""
    every = list(scenes)
    count = min(threads or os.cpu_count() or 1, len(every)) or 1
    if count == 1:
        return [s.check(**settings) for s in every]
    size = max(1, len(every) // (8 * count))
    pieces = [every[k:k + size] for k in range(0, len(every), size)]
    with ThreadPoolExecutor(count) as pool:
        return [r for piece in pool.map(lambda piece: [s.check(**settings) for s in piece], pieces) for r in piece]
