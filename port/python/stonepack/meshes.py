"""Shapes of blocks: what others have, and a few by formula. A shape is (vertices, faces): n x 3 [m], lists of vertex numbers,
anticlockwise seen from outside."""
from __future__ import annotations

import ctypes
from typing import Any, List, Sequence, Tuple

from . import _bindings as c
from ._library import SceneError

Shape = Tuple[Sequence[Sequence[float]], Sequence[Sequence[int]]]

_BOX = ((3, 2, 1, 0), (4, 5, 6, 7), (0, 1, 5, 4), (1, 2, 6, 5), (2, 3, 7, 6), (3, 0, 4, 7))
_BOX_SIZES = (ctypes.c_int32 * 6)(*[4] * 6)
_BOX_CORNERS = (ctypes.c_int32 * 24)(*[k for face in _BOX for k in face])
_BOX_XYZ = ctypes.c_double * 24


def of(thing: Any) -> Shape:
    """(vertices, faces) of whatever has them: attributes .vertices and .faces (trimesh, pyvista-like), a method
    to_vertices_and_faces (a mesh of COMPAS), or a pair."""
    if hasattr(thing, "to_vertices_and_faces"):
        return thing.to_vertices_and_faces()
    if hasattr(thing, "vertices") and hasattr(thing, "faces"):
        vertices, faces = thing.vertices, thing.faces
        return (vertices() if callable(vertices) else vertices), (faces() if callable(faces) else faces)
    try:
        vertices, faces = thing
        return vertices, faces
    except (TypeError, ValueError):
        raise SceneError("%s has neither .vertices and .faces nor to_vertices_and_faces()" % type(thing).__name__) from None


def _halves(size: Sequence[float], at: Sequence[float]) -> Tuple[float, float, float, float, float, float]:
    try:
        (a, b, h), (x, y, z) = size, at
        a, b, h = a / 2, b / 2, h / 2
        return float(x - a), float(x + a), float(y - b), float(y + b), float(z - h), float(z + h)
    except (TypeError, ValueError, OverflowError):
        raise SceneError("box: size and at are three numbers each") from None


def box(size: Sequence[float], at: Sequence[float] = (0, 0, 0)) -> Shape:
    """A box of that size (x, y, z) [m] about the centre `at` [m]."""
    x, X, y, Y, z, Z = _halves(size, at)
    return [(x, y, z), (X, y, z), (X, Y, z), (x, Y, z), (x, y, Z), (X, y, Z), (X, Y, Z), (x, Y, Z)], _BOX


def box_mesh(size: Sequence[float], at: Sequence[float]) -> Any:
    """The same as sp_mesh."""
    x, X, y, Y, z, Z = _halves(size, at)
    xyz = _BOX_XYZ(x, y, z, X, y, z, X, Y, z, x, Y, z, x, y, Z, X, y, Z, X, Y, Z, x, Y, Z)
    return c.sp_mesh(8, 6, xyz, _BOX_SIZES, _BOX_CORNERS)


def prism(outline: Sequence[Sequence[float]], low: float, high: float) -> Shape:
    """An upright prism over a convex or concave outline in x, y (anticlockwise), from z = low to high [m]."""
    n = len(outline)
    vertices = [(x, y, low) for x, y in outline] + [(x, y, high) for x, y in outline]
    sides: List[Sequence[int]] = [(k, (k + 1) % n, n + (k + 1) % n, n + k) for k in range(n)]
    return vertices, [tuple(range(n - 1, -1, -1)), tuple(range(n, 2 * n))] + sides
