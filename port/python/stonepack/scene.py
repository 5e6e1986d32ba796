"""Scenes, and the questions about them."""
from __future__ import annotations

import ctypes
import os
import threading
from concurrent.futures import ThreadPoolExecutor
from ctypes import byref
from typing import Any, Dict, Iterable, List, NoReturn, Optional, Sequence, Tuple, Union

from . import _bindings as c
from ._assembly import Assembly, Name
from ._library import SceneError, StonepackError, arena, lib, refuse, text
from ._numbers import Vector, number, several, triple, whole
from ._turns import asks
from .answers import LEVELS, VERDICTS, Effect, Evidence, Held, Limit, Plan, Result, Sliding, Step, Strong, motion_of, speeds
from .settling import Settled, settle

_ON = (c.SP_WHY_CALLED, c.SP_WHY_ASKED, c.SP_WHY_STAGES)


def _settings(tol: Optional[float] = None, coupled: bool = False, eps: Optional[float] = None, eta: Optional[float] = None,
              cone: str = "true", budget: int = 0, localise: bool = False, iterations: Optional[int] = None,
              force_bound: Optional[float] = None, without: Union[str, Sequence[str]] = (), **other: Any) -> Any:
    """sp_settings of these words; None: the default ones."""
    if other:
        raise SceneError("no setting is called %s; help(stonepack.Scene.check) tells them" % ", ".join(other))
    if not coupled and (eps is not None or eta is not None):
        raise SceneError("eps, eta belong to coupled")
    if tol is None and not coupled and cone == "true" and not budget and not localise and iterations is None \
            and force_bound is None and not without:
        return None
    s = lib.sp_settings_default()
    told = {"tol": tol, "eps": eps, "eta": eta, "cone": cone, "budget": budget or None, "iterations": iterations,
            "force_bound": force_bound}
    s.words = ", ".join("%s=%r" % each for each in told.items() if each[1] not in (None, "true"))
    if tol is not None:
        s.tol = number(tol, "tol")
    if coupled:
        s.coupled.asked = 1
        s.coupled.eps = -1 if eps is None else number(eps, "eps")
        if eps is not None and not s.coupled.eps >= 0:
            raise SceneError("eps: 0 or more is wanted, not %r" % eps)
        s.coupled.eta = 0 if eta is None else number(eta, "eta")
    if cone != "true":
        if not isinstance(cone, str) or cone[-1:] not in ("i", "c") or not (cone.isascii() and cone[:-1].isdigit()):
            raise SceneError("cone: true, or so many faces, inscribed or circumscribed: 8i, 4c; not %r" % (cone,))
        s.faces, s.inscribed = whole(int(cone[:-1]), "cone"), int(cone[-1] == "i")
    s.budget, s.localise = whole(budget, "budget", 2 ** 63 - 1), int(bool(localise))
    if iterations is not None:
        s.iterations = whole(iterations, "iterations")
    if force_bound is not None:
        s.force_bound = number(force_bound, "force_bound")
    for effect in several(without, "without"):
        try:
            s.effect[("friction", "depth", "together").index(effect)] = c.SP_WITHOUT
        except ValueError:
            raise SceneError("without: friction, depth, together; not %r" % (effect,)) from None
    return s


_KEPT: Dict[Any, Any] = {}                              # settings by their words: most callers have a few


def _settings_of(words: Dict[str, Any]) -> Tuple[Any, Any]:
    """(key, sp_settings or None for the default ones) of the words of a call; the struct is not to be written."""
    if not words:
        return (), None
    key = tuple(words.items())
    try:
        s = _KEPT.get(key, _KEPT)                       # itself: not there
    except TypeError:                                   # a list among them
        return None, _settings(**words)
    if s is _KEPT:
        if len(_KEPT) > 100:
            _KEPT.clear()
        s = _KEPT[key] = _settings(**words)
    return key, s


def _refused(status: int, settings: Any) -> SceneError:
    """The exception of a question: blocks and joints were looked at as they came, a number outside its range is a setting."""
    return refuse(status, settings.words if status == c.SP_E_RANGE and settings is not None else "")


class Scene(Assembly):
    """An assembly of rigid blocks.

    mu          friction of joints that have none of their own, and of those that are found
    density     of blocks that have none of their own [kg/m^3]
    gravity     [m/s^2]

    Joints are found from the meshes unless some are given; blocks that are added later are found with all others.
    One scene may be asked by several threads at once; a change meanwhile is refused: change a copy.
    """

    __slots__ = ()

    # --------------------------------------------------------------------------------------------------------- questions

    def _bytes(self, what: int, settings: Any, scene: Any = None) -> int:
        """Bytes that a call takes."""
        here, p, need = byref(scene or self._c), (byref(settings) if settings is not None else None), ctypes.c_size_t()
        if what in (c.SP_FOR_VERIFY, c.SP_FOR_PLAN, c.SP_FOR_LIMIT_VERIFY, c.SP_FOR_STRONG, c.SP_FOR_STRONG_VERIFY,
                    c.SP_FOR_SLIDING, c.SP_FOR_SLIDING_VERIFY):
            kept, scratch = None, c.sp_arena()
        else:
            kept, scratch = arena(lib.sp_memory_scratch(here, what, p))
        status = lib.sp_memory(here, what, p, scratch, byref(need))
        if status:
            raise _refused(status, settings)
        return need.value

    @asks
    def check(self, **settings: Any) -> Result:
        """Does it stand?

        tol         accuracy of the evidence, relative imbalance per block: 1e-9
        coupled     ask for a motion that explains the forces, too; eps, eta [m]: how much joints give, how far they may move
        cone        "true", or a pyramid: "8i" inscribed, "4c" circumscribed
        budget      flops it may spend; 0: no limit
        localise    True: where it does not stand, ask where help is wanted; takes up to twice as long
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
            raise _refused(status, s)
        return result

    @asks
    def verify(self, result: Result) -> Evidence:
        """What the evidence of a result proves, computed anew from the scene."""
        if not isinstance(result, Result):
            raise SceneError("verify: an answer of check is wanted, not %r" % (result,))
        p = byref(result._settings) if result._settings is not None else None
        asked, here = result._there()._c.count, self._c.count
        if (asked.blocks, asked.joints, asked.points) != (here.blocks, here.joints, here.points):
            raise SceneError("verify: this is the answer of another scene")
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
        return self._limit(self._shaken(body), body, _settings(**settings) if settings else None)

    def _shaken(self, body: Optional[Vector]) -> Any:
        """The scene with a live load of every block's weight times a vector: numbers of its own, the same arrays."""
        scene = c.sp_scene.from_buffer_copy(self._c)
        if body is not None:
            g = sum(x * x for x in self._c.gravity) ** 0.5
            scene.body = triple([g * x for x in triple(body, "body")], "body")
        return scene

    def _limit(self, scene: Any, body: Optional[Vector], s: Any) -> Limit:
        need = self._bytes(c.SP_FOR_LIMIT, s, scene)
        limit = Limit(self, body)
        limit._memory, a = arena(need)
        status = lib.sp_limit(byref(scene), byref(s) if s is not None else None, byref(a), byref(limit._c))
        if status:
            raise _refused(status, s)
        return limit

    @asks
    def sliding(self, body: Optional[Vector] = None, *, starts: int = 8, work: int = 90, seed: int = 1, **settings: Any) -> Sliding:
        """How much more until it slides, of a planar scene: friction as it is, which does not open joints as `limit` has it.

        body      as of limit
        starts    histories that are followed, 0 to 32; work: flops at most, in those of the limit; seed: of the first history
        settings  tol, budget, force_bound, as of check
        """
        scene, s = self._shaken(body), _settings(**settings) if settings else None
        limit, p = self._limit(scene, body, s), (byref(s) if s is not None else None)
        how, out = c.sp_sliding_settings(whole(starts, "starts"), whole(work, "work"), whole(seed, "seed")), c.sp_sliding_result()
        kept, a = arena(self._bytes(c.SP_FOR_SLIDING, s, scene))
        status = lib.sp_sliding(byref(scene), p, byref(how), byref(limit._c), byref(a), byref(out))
        if status:
            raise refuse(status, "starts=%d, work=%d" % (starts, work) if status == c.SP_E_RANGE else "")
        proved = c.sp_sliding_evidence()
        kept_too, scratch = arena(self._bytes(c.SP_FOR_SLIDING_VERIFY, None, scene))
        status = lib.sp_sliding_verify(byref(scene), p, byref(out), scratch, byref(proved))
        if status:
            raise refuse(status)
        is_state = out.kind == c.SP_SLIDING_STATE
        return Sliding("state" if is_state else "associative", ("state", "nothing found", "not asked")[out.reason],
                       bool(is_state and proved.state), out.upper if out.upper >= 0 else None,
                       out.associative if out.associative >= 0 else None, proved.lower, proved.lower_strong, out.residual,
                       motion_of(self._names, out.v) if is_state else {})

    @asks
    def plan(self, **settings: Any) -> Plan:
        """What will a check simulate, what not, and why?"""
        s, out = _settings(**settings) if settings else None, c.sp_outlook()
        kept, scratch = arena(self._bytes(c.SP_FOR_PLAN, s))
        status = lib.sp_plan(byref(self._c), byref(s) if s is not None else None, scratch, byref(out))
        if status:
            raise _refused(status, s)
        effects = {text(c.SP_WORDS_EFFECT, k): Effect(e.why in _ON, text(c.SP_WORDS_EFFECT_WHY, e.why), e.unknowns, e.flops,
                                                      e.bytes) for k, e in enumerate(out.effect)}
        return Plan(effects, out.islands, out.unknowns, out.flops, out.bytes, out.full_unknowns, out.full_flops, out.full_bytes)

    @asks
    def strong(self, *, corners: bool = False, **settings: Any) -> Strong:
        """Does it stand whatever friction does, or by its history only? corners: pressure is at the corners that joints list."""
        result = self.check(**settings)
        still = self.check(**dict(settings, without=("friction",), localise=False))
        p = byref(result._settings) if result._settings is not None else None
        out, how = c.sp_strong_result(), c.sp_strong_settings(256, int(bool(corners)))
        kept, a = arena(self._bytes(c.SP_FOR_STRONG, result._settings))
        status = lib.sp_strong(byref(self._c), p, byref(how), result._c.f, still._c.f if still.stable else None, byref(a), byref(out))
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
        return [under_way.add(block, ask_hold=hold) for block in several(order, "order")]

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
        chosen = sorted({self.number(b) for b in several(blocks, "part")})
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
        new._c.body[:] = old.body[:]
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
        self._scene, self._lock = scene, threading.RLock()
        self._settings = _settings(**settings) if settings else None
        self._open()

    @asks
    def _open(self) -> None:
        scene = self._scene
        self._version = scene._version
        self._memory, a = arena(scene._bytes(c.SP_FOR_SEQUENCE, self._settings))
        self._c = ctypes.POINTER(c.sp_sequence)()
        status = lib.sp_sequence_open(byref(scene._c), byref(self._settings) if self._settings is not None else None, byref(a),
                                      byref(self._c))
        if status:
            raise _refused(status, self._settings)

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
        with self._lock:
            status = lib.sp_sequence_hold(self._here(), whole(budget, "budget", 2 ** 63 - 1), byref(out))
            if status:
                raise refuse(status)
            return Held([names[k] for k in out.block[0:out.count]], [bool(m) for m in out.must[0:out.count]],
                        text(c.SP_WORDS_HELD_PROOF, out.proof), out.checks)

    @asks
    def suggest(self, *, add: bool = True, budget: int = 0) -> Optional[str]:
        """A next stone to lay (or to take away) after which everything stands; None: there is none."""
        out = c.sp_suggestion()
        with self._lock:
            status = lib.sp_sequence_suggest(self._here(), int(bool(add)), whole(budget, "budget", 2 ** 63 - 1), byref(out))
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
        with self._lock:                                # a step changes the build order, and its motion lies in it
            return self._set_alone(block, presence, ask_hold)

    def _set_alone(self, block: Name, presence: int, ask_hold: bool) -> Step:
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
    every = several(scenes, "check_many")
    for each in every:
        if not isinstance(each, Scene):
            raise SceneError("check_many: scenes are wanted, not %r" % (each,))
    count = min(whole(threads or 0, "threads") or os.cpu_count() or 1, len(every)) or 1
    if count == 1:
        return [s.check(**settings) for s in every]
    size = max(1, len(every) // (8 * count))
    pieces = [every[k:k + size] for k in range(0, len(every), size)]
    with ThreadPoolExecutor(count) as pool:
        return [r for piece in pool.map(lambda piece: [s.check(**settings) for s in piece], pieces) for r in piece]
