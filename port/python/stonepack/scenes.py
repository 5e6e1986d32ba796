"""Scenes by formula: stacks, walls, rubble walls. Each stands on a support called "ground" whose top is z = 0."""
from __future__ import annotations

from typing import Collection, Optional, Sequence, Tuple

from . import meshes
from ._library import SceneError
from .scene import Scene

Size = Tuple[float, float, float]


def _recipe(scene: Scene, name: str, **told: object) -> Scene:
    """How it was made, to be pasted: what a test prints of it."""
    scene.recipe = "stonepack.scenes.%s(%s)" % (name, ", ".join("%s=%r" % each for each in told.items()))
    return scene


def stack(sizes: Sequence[Size], offsets: Sequence[Tuple[float, float]], mu: float = 0.7,
          densities: Optional[Sequence[float]] = None) -> Scene:
    """Boxes of these sizes [m], each shifted by its offset (x, y) [m] against the one below."""
    if not sizes or len(offsets) != len(sizes) or densities and len(densities) != len(sizes):
        raise SceneError("stack: as many offsets, and densities, as sizes, one at least")
    s = Scene(mu=mu)
    (a, b, _) = sizes[0]
    s.box((a, b, 0.5), (0, 0, -0.25), name="ground", fixed=True)
    x = y = z = 0.0
    for k, ((a, b, h), (dx, dy)) in enumerate(zip(sizes, offsets)):
        x, y = x + dx, y + dy
        s.box((a, b, h), (x, y, z + h / 2), name="s%d" % (k + 1), density=densities[k] if densities else None)
        z += h
    return _recipe(s, "stack", sizes=sizes, offsets=offsets, mu=mu, densities=densities)


def wall(courses: int, bricks: int, size: Size = (0.4, 0.2, 0.15), mu: float = 0.7,
         missing: Collection[Tuple[int, int]] = ()) -> Scene:
    """Running bond: every second course, c2, c4 ..., is shifted by half a brick, whole bricks only. Bricks are called after course
    and place, c2b3; missing ones as (course, brick), both from 1."""
    s = Scene(mu=mu)
    a, b, h = size
    s.box((a * (bricks + 1), b, h), (a * bricks / 2, 0, -h / 2), name="ground", fixed=True)
    for k in range(courses):
        for i in range(bricks - k % 2):
            if (k + 1, i + 1) not in missing:
                s.box(size, (a * (i + 0.5 + k % 2 / 2), 0, h * (k + 0.5)), name="c%db%d" % (k + 1, i + 1))
    return _recipe(s, "wall", courses=courses, bricks=bricks, size=size, mu=mu, missing=sorted(missing))


def rubble(cuts: Sequence[Sequence[Tuple[float, float]]], heights: Sequence[float], width: float = 2.0, depth: float = 0.4,
           mu: float = 0.7) -> Scene:
    """A wall of irregular stones: a course of each height [m], cut into stones at x = (below, above) [m], ascending."""
    if len(cuts) != len(heights):
        raise SceneError("rubble: as many cuts as heights")
    s = Scene(mu=mu)
    s.box((width, depth, 0.3), (width / 2, 0, -0.15), name="ground", fixed=True)
    z = 0.0
    for k, (course, h) in enumerate(zip(cuts, heights)):
        edges = [(0.0, 0.0)] + list(course) + [(width, width)]
        for i, ((x0, x1), (y0, y1)) in enumerate(zip(edges, edges[1:])):
            plan = [(x0, z), (y0, z), (y1, z + h), (x1, z + h)]
            s.add(*_upright(plan, depth), name="c%ds%d" % (k + 1, i + 1))
        z += h
    return _recipe(s, "rubble", cuts=cuts, heights=heights, width=width, depth=depth, mu=mu)


def _upright(outline: Sequence[Tuple[float, float]], depth: float) -> meshes.Shape:
    """A plate with that outline in x, z (anticlockwise), of that depth along y."""
    vertices, faces = meshes.prism(outline, -depth / 2, depth / 2)
    return [(x, -y, z) for x, z, y in vertices], faces
