"""Pictures of the program: what `check --svg` and `limit --svg` draw."""
from __future__ import annotations

import ctypes
from typing import Any, Optional

from . import _bindings as c
from ._library import FileError, files, files_lock
from ._numbers import letters, path_of
from .scene import Scene
from .scenefiles import by_file, c_names


def draw(scene: Scene, result: Any, limit: Any, path: Optional[str], names: bool, title: str) -> str:
    heading = letters(title, "title")

    def put(where: str) -> None:
        message = ctypes.create_string_buffer(512)
        with files_lock:
            failed = files().files_draw(path_of(where), ctypes.byref(scene._c), c_names(scene), heading,
                                        ctypes.byref(result), ctypes.byref(limit) if limit is not None else None, bool(names),
                                        message)
        if failed:
            raise FileError(message.value.decode(errors="replace"))
    return by_file(put, path, ".svg")


def draw_limit(scene: Scene, limit: Any, path: Optional[str], names: bool, title: str) -> str:
    """A result that has the forces and the motion of the limit alone."""
    r = c.sp_result()
    r.f, r.dq = limit.f, limit.dq
    r.verdict = c.SP_UNSTABLE if limit.upper >= 0 else c.SP_UNDECIDED
    r.extremes.weakest, r.verified, r.tol = -1, limit.verified, limit.tol
    return draw(scene, r, limit, path, names, title)
