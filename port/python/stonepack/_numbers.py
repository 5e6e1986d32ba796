"""Numbers as people have them, lists or arrays, as the library takes them."""
from __future__ import annotations

import ctypes
import operator
import os
from array import array
from itertools import chain
from typing import Any, List, Optional, Sequence, Tuple

from ._library import FileError, SceneError

Vector = Sequence[float]                                # three numbers


def triple(values: Vector, what: str) -> Any:
    """Three numbers as C has them."""
    try:
        x, y, z = values
        return (ctypes.c_double * 3)(x, y, z)
    except (TypeError, ValueError, OverflowError):
        raise SceneError("%s: three numbers are wanted, not %r" % (what, values)) from None


def number(value: Any, what: str) -> float:
    """One number as C has it."""
    try:
        return ctypes.c_double(value).value
    except (TypeError, OverflowError):
        raise SceneError("%s: a number is wanted, not %r" % (what, value)) from None


def whole(value: Any, what: str, most: int = 2 ** 31 - 1) -> int:
    """One whole number from 0; C would cut off what is beyond."""
    try:
        k = operator.index(value)
    except TypeError:
        k = -1
    if not 0 <= k <= most:
        raise SceneError("%s: a whole number from 0 to %d is wanted, not %r" % (what, most, value))
    return k


def several(values: Any, what: str) -> List[Any]:
    """All of a list; a word alone is one of them, not its letters."""
    if isinstance(values, str):
        return [values]
    try:
        return list(values)
    except TypeError:
        raise SceneError("%s: a list is wanted, not %r" % (what, values)) from None


def path_of(path: Any) -> bytes:
    """A path as C has it."""
    try:
        raw = os.fsencode(path)
    except (TypeError, UnicodeEncodeError):
        raw = b"\0"
    if b"\0" in raw:                                    # C would read up to there
        raise FileError("a path is wanted, not %r" % (path,))
    return raw


def letters(value: Any, what: str) -> bytes:
    """Text as C has it."""
    try:
        raw = value.encode()
    except (AttributeError, UnicodeEncodeError):
        raw = b"\0"
    if b"\0" in raw:
        raise SceneError("%s: text is wanted, not %r" % (what, value))
    return raw


def rows(values: Any, what: str) -> Tuple[int, Any]:
    """(n, n x 3 doubles) of an n x 3 array or a list of points."""
    try:
        view: Optional[memoryview] = memoryview(values)                    # an array of NumPy, or whatever has a buffer
    except TypeError:
        view = None
    if view is not None and view.format == "d" and view.ndim == 2 and view.c_contiguous \
            and view.shape is not None and view.shape[1] == 3 and view.shape[0]:
        count = view.shape[0]
        return count, (ctypes.c_double * (3 * count)).from_buffer_copy(view.cast("B"))
    try:
        if view is not None and "Z" in view.format:     # complex: half of it would be lost
            raise ValueError
        points = list(values)
        if set(map(len, points)) - {3}:
            raise ValueError
        flat = array("d", chain.from_iterable(points))
    except (TypeError, ValueError, OverflowError):
        raise SceneError("%s: points of three numbers are wanted, n x 3" % what) from None
    if not flat:
        raise SceneError("%s: no points" % what)
    return len(points), (ctypes.c_double * len(flat)).from_buffer(flat)


def polygons(faces: Any, what: str) -> Tuple[int, Any, Any, int]:
    """(faces, their sizes, their corners, corners) of an m x k array or lists of vertex numbers."""
    try:
        each = faces.tolist() if hasattr(faces, "tolist") else [list(f) for f in faces]
        sizes = array("i", [len(f) for f in each])
        corners = array("i", chain.from_iterable(each))
    except (TypeError, ValueError, OverflowError):
        raise SceneError("%s: faces are wanted as lists of vertex numbers from 0" % what) from None
    n, k = len(sizes), len(corners)
    if not k:
        raise SceneError("%s: no faces" % what)
    return n, (ctypes.c_int32 * n).from_buffer(sizes), (ctypes.c_int32 * k).from_buffer(corners), k
