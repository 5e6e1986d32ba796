"""What a scene is made of: blocks, joints and loads, in memory that grows with them."""
from __future__ import annotations

import ctypes
import math
import operator
import threading
from ctypes import byref
from typing import Any, Callable, Dict, Iterable, List, NoReturn, Optional, Union

from . import _bindings as c
from . import meshes
from ._library import SceneError, StonepackError, arena, lib, refuse
from ._numbers import Vector, number, polygons, rows, triple, whole
from ._turns import Turns, asks, changes
from .answers import Block, Joint, Overlap, vec3

GRAVITY = (0.0, 0.0, -9.80665)
Name = Union[str, int, Block]
Fixed = Union[bool, int, str, Iterable[str]]

# What grows: array of sp_scene, its number in sp_capacity, bytes of an entry.
_GROWS = tuple((array, number, ctypes.sizeof(getattr(c.sp_scene(), array)._type_)) for array, number in (
    ("block", "blocks"), ("vertex", "vertices"), ("face", "faces"), ("corner", "corners"), ("joint", "joints"),
    ("point", "points"), ("load", "loads")))
_DIRECTIONS = {"x": 1, "y": 2, "z": 4, "rx": 8, "ry": 16, "rz": 32}


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


class Assembly:
    """A scene without its questions: see Scene."""

    __slots__ = dict.fromkeys(("_mu", "_c", "_memory", "_names", "_index", "_version", "_given", "_found", "_overlaps", "_needs", "_lock",
                               "_turns", "__weakref__"), "")    # and no others: `scene.gravty = ...` is a mistake
    __slots__.update(
        density="Of blocks that have none of their own [kg/m^3].",
        remarks="What of the file it was read from looks mistaken.",
        recipe="The call of stonepack.scenes that made it; None: something else did.")

    def __init__(self, *, mu: float = 0.84, density: float = 2400.0, gravity: Vector = GRAVITY):
        self._mu, self.density = number(mu, "mu"), number(density, "density")
        if not (0 <= self._mu < math.inf and 0 < self.density < math.inf):
            raise SceneError("mu is 0 or more, density more, both finite; not %g, %g" % (self._mu, self.density))
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
        if label[0] in "#\"" or label[-1] == "\\":            # a comment, a line that goes on
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

    def _joints_kept(self) -> Any:
        """Joints as they are, for a call that is refused: it may have written over them."""
        s = self._c
        return (self._given, self._found, s.count.joints, s.count.points,
                bytes(ctypes.string_at(s.joint, s.count.joints * ctypes.sizeof(c.sp_joint))) if s.count.joints else b"",
                bytes(ctypes.string_at(s.point, 24 * s.count.points)) if s.count.points else b"")

    def _joints_again(self, kept: Any) -> None:
        s = self._c
        self._given, self._found, s.count.joints, s.count.points, joint, point = kept
        ctypes.memmove(s.joint, joint, len(joint))
        ctypes.memmove(s.point, point, len(point))

    def _append(self, points: int, what: str, block: str, call: Callable[[], int]) -> int:
        """One more joint. From the first that is given on, those that were found are gone."""
        self._room(joints=1, points=points)
        count, kept = self._c.count, self._joints_kept() if not self._given else None
        before = count.joints, count.points
        if not self._given:
            count.joints = count.points = 0
        status = call()
        if status:
            count.joints, count.points = before
            if kept:
                self._joints_again(kept)
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
        kept = self._joints_kept()
        self._given = False
        try:
            self._find(s)
        except StonepackError:
            self._joints_again(kept)
            raise
        self.recipe = None                              # it finds them otherwise
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
        self._mu = number(mu, "friction")
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

    @property
    def mu(self) -> float:
        """Friction of joints that have none of their own, and of those that are found."""
        return self._mu

    @mu.setter
    @changes
    def mu(self, mu: float) -> None:
        new = number(mu, "mu")
        if not 0 <= new < math.inf:
            raise SceneError("mu is 0 or more, and finite; not %g" % new)
        if self._found and self._found[1].strength.mu == self._mu != new:
            self._found[1].strength.mu = new            # to be found anew
            self._touched()
        self._mu = new

    # ------------------------------------------------------------------------------------------------------------- loads

    @changes
    def load(self, block: Name, force: Vector = (0, 0, 0), at: Optional[Vector] = None, *, couple: Vector = (0, 0, 0),
             mass: float = 0, live: bool = False) -> None:
        """Add a load: force [N] and mass [kg] at a point [m] (None: the centroid) that goes with the block, couple [N m].
        live: counts `live` times, and is what `limit` scales."""
        k, what = self.number(block), "load on '%s'" % self._label_of(block)
        point = self._c.block[k].centroid if at is None else triple(at, what)
        each = c.sp_load(k, int(bool(live)), point, triple(force, what), triple(couple, what), number(mass, what))
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
                                       number(pressure, what), int(bool(live)), None)
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
