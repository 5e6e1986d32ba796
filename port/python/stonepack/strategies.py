"""Strategies for Hypothesis: blocks, stacks, walls, rubble walls, build orders.

    from hypothesis import given
    from stonepack import strategies as stones
    from stonepack.testing import assert_stands

    @given(stones.stacks(max_offset=0.4))
    def test_my_rule(scene): ...

Lengths are whole millimetres, so that examples are short; they shrink to fewer stones, no offset, equal sizes. Stacks and walls of
`standing=True` are those that stand, `standing=False` those that fall, None (default) either; each with its proof. What is
found prints as a call of stonepack.scenes, to be pasted.
"""
from __future__ import annotations

from math import ceil, floor
from typing import Any, Optional, Sequence, Tuple

try:
    from hypothesis import assume
    from hypothesis import strategies as st
except ImportError as lacks:
    raise ImportError("stonepack.strategies needs Hypothesis, pip install hypothesis (%s); stonepack.scenes and "
                      "stonepack.testing need nothing" % lacks) from None

from . import meshes, scenes
from .scene import Scene

__all__ = ["blocks", "frictions", "lengths", "orders", "rubble", "sizes", "stacks", "walls"]


def lengths(low: float = 0.05, high: float = 1.0) -> "st.SearchStrategy[float]":
    """Whole millimetres from low to high [m]."""
    return st.integers(ceil(round(low * 1000, 6)), floor(round(high * 1000, 6))).map(lambda mm: mm / 1000)


def sizes(low: float = 0.05, high: float = 1.0) -> "st.SearchStrategy[Tuple[float, float, float]]":
    """Of a box (x, y, z) [m]."""
    return st.tuples(lengths(low, high), lengths(low, high), lengths(low, high))


def frictions(low: float = 0.2, high: float = 1.0) -> "st.SearchStrategy[float]":
    """Whole hundredths."""
    return st.integers(round(low * 100), round(high * 100)).map(lambda h: h / 100)


@st.composite
def blocks(draw: Any, low: float = 0.05, high: float = 1.0) -> meshes.Shape:
    """A convex block about the origin, (vertices, faces): a box, or a prism over a regular outline of 3 to 8 corners that is
    stretched, so with level top and bottom."""
    a, b, h = draw(sizes(low, high))
    corners = draw(st.sampled_from((4, 3, 5, 6, 8)))
    if corners == 4:
        return meshes.box((a, b, h))
    return meshes.prism([(a / 2 * x, b / 2 * y) for x, y in _REGULAR[corners]], -h / 2, h / 2)


def _regular(n: int) -> Sequence[Tuple[float, float]]:
    from math import cos, pi, sin
    return [(cos(2 * pi * k / n), sin(2 * pi * k / n)) for k in range(n)]


_REGULAR = {n: _regular(n) for n in (3, 5, 6, 8)}


def _as_asked(scene: Scene, standing: Optional[bool]) -> Scene:
    if standing is not None:
        result = scene.check()
        assume(result.stable if standing else result.unstable)
    return scene


@st.composite
def stacks(draw: Any, min_blocks: int = 1, max_blocks: int = 8, max_offset: float = 0.5, mu: Optional[float] = None,
           standing: Optional[bool] = None) -> Scene:
    """Boxes one on another, shifted along x and y by up to max_offset of the smaller one's size."""
    each, mm = draw(st.lists(sizes(0.1, 1.0), min_size=min_blocks, max_size=max_blocks)), floor(round(1000 * max_offset, 6))
    shares = draw(st.lists(st.tuples(st.integers(-mm, mm), st.integers(-mm, mm)), min_size=len(each), max_size=len(each)))
    below, offsets = each[0], []
    for size, (sx, sy) in zip(each, shares):
        offsets.append((int(round(sx * min(size[0], below[0]), 6)) / 1000, int(round(sy * min(size[1], below[1]), 6)) / 1000))
        below = size
    return _as_asked(scenes.stack(each, offsets, mu if mu is not None else draw(frictions())), standing)


@st.composite
def walls(draw: Any, max_courses: int = 6, max_bricks: int = 6, max_missing: int = 4, mu: Optional[float] = None,
          standing: Optional[bool] = None) -> Scene:
    """Running bond of whole bricks, of which some are missing."""
    courses, bricks = draw(st.integers(1, max_courses)), draw(st.integers(2, max_bricks))
    size = draw(st.tuples(lengths(0.2, 0.6), lengths(0.1, 0.3), lengths(0.05, 0.3)))
    missing = draw(st.sets(st.tuples(st.integers(1, courses), st.integers(1, bricks)), max_size=max_missing))
    friction = mu if mu is not None else draw(frictions())
    return _as_asked(scenes.wall(courses, bricks, size, friction, missing), standing)


@st.composite
def rubble(draw: Any, max_courses: int = 5, max_stones: int = 6, mu: Optional[float] = None) -> Scene:
    """A wall of irregular stones: level courses of different height, cut at different places along inclined lines. It stands."""
    heights = draw(st.lists(lengths(0.1, 0.5), min_size=1, max_size=max_courses))
    cuts = []
    for _ in heights:
        places = draw(st.lists(st.integers(1, 18), max_size=max_stones - 1, unique=True))
        lean = draw(st.lists(st.integers(-40, 40), min_size=len(places), max_size=len(places)))
        cuts.append([(x / 10, round(x / 10 + dx / 1000, 3)) for x, dx in zip(sorted(places), lean)])
    return scenes.rubble(cuts, heights, 1.9, 0.4, mu if mu is not None else draw(frictions()))


def orders(scene: Scene) -> "st.SearchStrategy[Sequence[str]]":
    """Build orders of all free blocks of a scene, good or bad; the simplest is the one in which they were added."""
    return st.permutations([b.name for b in scene.blocks if not b.fixed])
