"""For tests of packers, stackers and planners: assertions that name the stone and draw the picture.

    from stonepack.testing import assert_stands, assert_falls, assert_build_order

A failure leaves the scene and its picture in $STONEPACK_FAILURES, by default .stonepack-failures where the tests run, named
after the test; a test that fails again, as while an example is being shrunk, overwrites its own.
"""
from __future__ import annotations

import math
import os
import re
from typing import Any, Iterable, List, Optional, Set

from . import _bindings as c
from ._assembly import Name
from ._library import SceneError, StonepackError
from ._numbers import number, several
from .answers import Result, Step
from .scene import Scene

__all__ = ["Fails", "Undecided", "assert_build_order", "assert_falls", "assert_stands"]


class _Told(AssertionError):
    """Its words, the scene file and the picture are made when they are read: while an example is being shrunk no one does."""

    def __init__(self, scene: Scene, result: Result, first: str, more: Iterable[str] = ()):
        super().__init__()
        self.scene, self.result, self.first, self.more = scene, result, first, list(more)
        self.test = os.environ.get("PYTEST_CURRENT_TEST", "scene").split(" (")[0].replace("::", ".").split("/")[-1]
        self.words: Optional[str] = None

    def __str__(self) -> str:
        if self.words is None:
            self.words = "\n".join([self.first] + _report(self.scene, self.result) + self.more + self._leave())
        return self.words

    def _leave(self) -> List[str]:
        """Scene and picture of a failure; what can't be written is no failure of its own."""
        folder = os.environ.get("STONEPACK_FAILURES", ".stonepack-failures")
        base = os.path.join(folder, re.sub(r"[^A-Za-z0-9_.-]+", "_", self.test))
        try:
            os.makedirs(folder, exist_ok=True)
            self.scene.write(base + ".obj")
            self.result.svg(base + ".svg", names=True, title=self.test)
        except (OSError, StonepackError) as error:
            return ["  scene     could not be written: %s" % error]
        return ["  scene     %s.obj, for stonepack.read and the program" % base, "  picture   %s.svg" % base]


class Fails(_Told):
    """An assertion about a scene does not hold."""


class Undecided(_Told):
    """Neither forces nor a motion within tol: the scene is nearer to a limit than can be told. With Hypothesis: `reject()`."""


def _listed(names: List[str], most: int = 6) -> str:
    return ", ".join(names[:most]) + (" and %d more" % (len(names) - most) if len(names) > most else "")


def _plain(numbers: Iterable[float]) -> tuple:
    return tuple(x if abs(x) > 1e-9 else 0.0 for x in numbers)


def _report(scene: Scene, result: Result) -> List[str]:
    lines = []
    if result.unstable:
        moving = result.moving
        lines = ["  falls     '%s' first: its centre goes by (%.2g, %.2g, %.2g) as it turns by (%.2g, %.2g, %.2g)"
                 % ((moving[0],) + _plain(result.motion[moving[0]])),
                 "  moving    %s; %d of %d blocks" % (_listed(moving), len(moving), len(scene))]
    weakest = result.weakest
    if weakest is not None:
        lines.append("  weakest   joint '%s' - '%s', friction used to %.0f %%"
                     % (weakest.a, weakest.b, 100 * weakest.utilisation))
    lines.append("  evidence  %s, %s%s; imbalance %.1e, least imbalance %.1e, tol %.0e"
                 % (result.reason, "verified" if result.verified else "not verified", ", final" if result.final else "",
                    result.imbalance, result.least_imbalance, result.tol))
    return lines + (["  made by   %s" % scene.recipe] if scene.recipe else [])


def _wanted(scene: Any, margin: float = 0.0) -> None:
    """What is asserted about must be a scene: a mistake in a test is no failure of what it tests."""
    if not isinstance(scene, Scene):
        raise SceneError("a scene is wanted, not %r" % (scene,))
    if not 0 <= number(margin, "margin") < math.inf:
        raise SceneError("margin: a share from 0 is wanted, not %r" % (margin,))
    if margin > 0 and not any(scene.gravity):
        raise SceneError("margin: gravity is 0, nothing can lean")


def assert_stands(scene: Scene, *, margin: float = 0.0, **settings: Any) -> Result:
    """The scene stands, by verified forces.

    margin    above 0: also when gravity leans by this share (0.01: 1 %) towards eight azimuths, so that it is out of any tie
    settings  of Scene.check
    raises    AssertionError that names the stone that falls; Undecided
    """
    __tracebackhide__ = True
    _wanted(scene, margin)
    result = scene.check(**settings)
    if result.undecided:
        raise Undecided(scene, result, "the scene is undecided: nearer to a limit than tol can tell")
    if not (result.stable and result.verified):
        raise Fails(scene, result, "the scene does not stand: '%s' falls" % result.moving[0])
    if margin > 0:
        _assert_leaning(scene, margin, settings)
    return result


def _level(g: Any) -> List[Any]:
    """Eight directions square to gravity, as long as it."""
    size = math.sqrt(sum(x * x for x in g))
    k = min(range(3), key=lambda i: abs(g[i]))
    a = [(i == k) - g[k] * g[i] / size ** 2 for i in range(3)]
    length = math.sqrt(sum(x * x for x in a))
    a = [x * size / length for x in a]
    b = [(g[(i + 1) % 3] * a[(i + 2) % 3] - g[(i + 2) % 3] * a[(i + 1) % 3]) / size for i in range(3)]
    turns = [(math.cos(math.pi * i / 4), math.sin(math.pi * i / 4)) for i in range(8)]
    return [[p * x + q * y for x, y in zip(a, b)] for p, q in turns]


def _assert_leaning(scene: Scene, margin: float, settings: Any) -> None:
    __tracebackhide__ = True
    for way in _level(scene.gravity):
        leaning = scene.copy()
        leaning.gravity = [g + margin * w for g, w in zip(scene.gravity, way)]
        result = leaning.check(**settings)
        if not result.stable:
            which = "'%s' falls" % result.moving[0] if result.unstable else "undecided"
            raise Fails(leaning, result, "the scene stands, but not when gravity leans by %g: %s" % (margin, which))


def assert_falls(scene: Scene, *, margin: float = 0.0, **settings: Any) -> Result:
    """The scene falls, by a verified motion.

    margin    above 0: the motion proves that no forces balance every block to within this share of what acts on it
    raises    AssertionError that names the weakest joint; Undecided
    """
    __tracebackhide__ = True
    _wanted(scene, margin)
    result = scene.check(**settings)
    if result.undecided:
        raise Undecided(scene, result, "the scene is undecided: nearer to a limit than tol can tell")
    if not (result.unstable and result.verified):
        raise Fails(scene, result, "the scene stands")
    if result.least_imbalance < margin:
        raise Fails(scene, result, "the scene falls, but by %.1e only, not %g" % (result.least_imbalance, margin))
    return result


def assert_build_order(scene: Scene, order: Optional[Iterable[Name]] = None, *, held: Iterable[Name] = (),
                       **settings: Any) -> List[Step]:
    """Everything stands at every step of a build order, blocks being laid one by one on the supports.

    order     all free blocks, None: as they were added
    held      blocks that are held in place from their step on, by a robot or a prop
    raises    AssertionError that names the step, the stone that falls, and what must be held; Undecided
    """
    __tracebackhide__ = True
    _wanted(scene)
    names, props = scene.names, {scene.number(b) for b in several(held, "held")}
    free = [k for k, block in enumerate(scene.blocks) if not block.fixed]
    laid = free if order is None else [scene.number(b) for b in several(order, "order")]
    if sorted(laid) != free:
        lack = [names[k] for k in free if k not in laid]
        twice = [names[k] for k in set(laid) if laid.count(k) > 1 or k not in free]
        raise AssertionError("the order does not lay every free block once: %s"
                             % ("missing " + _listed(lack) if lack else "too often " + _listed(twice)))
    under_way, steps = scene.building(**settings), []
    for n, k in enumerate(laid):
        step = under_way.hold(k) if k in props else under_way.add(k)
        steps.append(step)
        if not step.stable:
            _fail_step(scene, props, laid[:n + 1], n, step, under_way.must_hold().blocks, len(laid), settings)
    return steps


def _fail_step(scene: Scene, props: Set[int], laid: List[int], n: int, step: Step, hold: List[str], steps: int, settings: Any) -> None:
    __tracebackhide__ = True
    present = [k for k, block in enumerate(scene.blocks) if block.fixed or k in laid]
    part = scene.part(present)
    for k in props & set(laid):                         # what is held is a support
        part._c.block[part.number(scene.names[k])].fixed = c.SP_FIXED
    result = part.check(**settings)
    goes = "'%s' falls" % (step.moving[0] if step.moving else step.falls) if step.verdict == "unstable" else "undecided"
    first = "step %d of %d, laying '%s': %s" % (n + 1, steps, step.block, goes)
    kind = Fails if step.verdict == "unstable" else Undecided
    raise kind(part, result, first, ["  order     %s" % _listed([scene.names[k] for k in laid], 12),
                                     "  to hold   %s" % (_listed(hold) or "nothing helps")])
