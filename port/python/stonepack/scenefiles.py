"""Scene files as the program reads them: OBJ with `#@` comments, JSON of COMPAS."""
from __future__ import annotations

import ctypes
import os
import tempfile
from typing import Any, Iterable, Optional, Union

from . import _bindings as c
from ._library import FileError, SceneError, files, files_lock
from ._numbers import Vector, letters, number, path_of, several, triple
from .answers import Overlap
from .scene import Scene

Names = Union[str, Iterable[str]]


def _options(fixed: Names, up: Optional[str], unit: Optional[str], gravity: Optional[Vector], contact_distance: Any,
             contact_angle: Optional[float], split: bool, mu: Optional[float]) -> list:
    names = [name for name in several(fixed, "fixed") if name != ""]
    if all(isinstance(name, str) for name in names):    # one list: the reader takes 64 of them
        names = [",".join(names)] if names else []
    told = [("fixed", name) for name in names]
    told += [(k, v) for k, v in (("up", up), ("unit", unit), ("contact-distance", contact_distance),
                                 ("contact-angle", contact_angle), ("mu", mu)) if v is not None]
    if gravity is not None:
        told += [("gravity-" + axis, "%.17g" % x) for axis, x in zip("xyz", triple(gravity, "gravity"))]
    if split:
        told.append(("split", ""))
    return told


def _option(name: str, value: Any) -> bytes:
    try:
        return letters(value if isinstance(value, str) else "%.17g" % number(value, name), name)
    except SceneError:
        raise FileError("%s: %r is not understood" % (name, value)) from None


def _read(path: bytes, raw: Optional[bytes], told: list) -> Scene:
    with files_lock:
        return _read_alone(files(), path, raw, told)


def _bytes(content: Union[str, bytes], path: str) -> bytes:
    try:
        return content if isinstance(content, bytes) else content.encode()
    except (AttributeError, UnicodeEncodeError) as wrong:
        raise FileError("%s: no text: %s" % (path, wrong)) from None


def _read_alone(reader: Any, path: bytes, raw: Optional[bytes], told: list) -> Scene:
    handle = reader.files_new()
    if not handle:
        raise MemoryError
    try:
        kept = []                                       # the reader keeps the strings while it reads
        for name, value in told:
            text = _option(name, value)
            kept.append(text)
            if not reader.files_option(handle, name.encode(), text):
                raise FileError("%s: %r is not understood" % (name, value))
        if reader.files_read(handle, path, raw, len(raw) if raw is not None else 0):
            raise FileError(reader.files_error(handle).decode(errors="replace"))
        return _scene_of(reader, handle)
    finally:
        reader.files_free(handle)


def _scene_of(reader: Any, handle: Any) -> Scene:
    scene, parts = Scene(mu=reader.files_mu(handle), density=reader.files_density(handle)), reader.files_parts(handle).contents
    capacity = c.sp_capacity.from_buffer_copy(parts.count)
    capacity.blocks = max(capacity.blocks, 1)
    scene._copy_of(parts, None, capacity)
    scene._names = [reader.files_name(handle, k).decode(errors="replace") for k in range(parts.count.blocks)]
    scene._index = {name: k for k, name in enumerate(scene._names)}
    _contacts_of(reader, handle, scene)
    k = 0
    while True:
        said = reader.files_remark(handle, k)
        if said is None:
            break
        scene.remarks.append(said.decode(errors="replace"))
        k += 1
    return scene


def _contacts_of(reader: Any, handle: Any, scene: Scene) -> None:
    """Joints of the file are there, given or found; those that were found are found anew when blocks are added."""
    how, count, overlap = c.sp_contact_settings(), ctypes.c_int32(), ctypes.POINTER(c.sp_overlap)()
    scene._touched()
    scene._given = not reader.files_found(handle, ctypes.byref(how), ctypes.byref(count), ctypes.byref(overlap))
    if not scene._given:
        scene._found = (scene._version, how)
        scene._overlaps = [Overlap(scene._names[o.a], scene._names[o.b], o.depth) for o in overlap[0:count.value]]


def read(path: Union[str, "os.PathLike[str]"], *, fixed: Names = (), up: Optional[str] = None, unit: Optional[str] = None,
         gravity: Optional[Vector] = None, contact_distance: Union[float, str, None] = None,
         contact_angle: Optional[float] = None, split: bool = False, mu: Optional[float] = None) -> Scene:
    """Read a scene file: OBJ, or JSON of compas_assembly, compas_cra, compas_dem; PATH.stonepack beside it counts.

    fixed             supports: names, patterns (`foot*`), "lowest", "ground"
    up, unit          "y", "-x" ...; "mm", "cm", "m", "in"
    gravity           [m/s^2]
    contact_distance  faces nearer than this touch [m], or "0.1%" of the smaller block; contact_angle [degree]
    split             each shell of an object is a block
    mu                friction instead of all that the file says
    """
    return _read(path_of(path), None, _options(fixed, up, unit, gravity, contact_distance, contact_angle, split, mu))


def parse(content: Union[str, bytes], name: str = "text", *, fixed: Names = (), up: Optional[str] = None, unit: Optional[str] = None,
          gravity: Optional[Vector] = None, contact_distance: Union[float, str, None] = None,
          contact_angle: Optional[float] = None, split: bool = False, mu: Optional[float] = None) -> Scene:
    """The same from text, as `read`: a scene file, or JSON, compas.json_dumps(assembly) for instance. name is for messages."""
    return _read(path_of(name), _bytes(content, name), _options(fixed, up, unit, gravity, contact_distance, contact_angle, split, mu))


def c_names(scene: Scene) -> Any:
    return (ctypes.c_char_p * len(scene))(*[name.encode() for name in scene.names])


def write(scene: Scene, path: Union[str, "os.PathLike[str]"]) -> None:
    message = ctypes.create_string_buffer(512)
    with files_lock:
        failed = files().files_write(path_of(path), ctypes.byref(scene._c), c_names(scene), message)
    if failed:
        raise FileError(message.value.decode(errors="replace"))


def write_json(scene: Scene, result: Any, settings: Any, cone: str, path: Optional[str], name: str) -> str:
    """The text of `check --json --forces`."""
    told = letters(name, "scene")

    def put(where: str) -> None:
        message = ctypes.create_string_buffer(512)
        with files_lock:
            failed = files().files_json(path_of(where), ctypes.byref(scene._c), c_names(scene), told, ctypes.byref(result),
                                        ctypes.byref(settings), cone.encode(), message)
        if failed:
            raise FileError(message.value.decode(errors="replace"))
    return by_file(put, path, ".json")


def by_file(put: Any, path: Optional[str], suffix: str) -> str:
    """What put(path) writes, as text; the file stays if it was named."""
    if path is not None:
        put(path)
        with open(path, encoding="utf-8") as file:
            return file.read()
    with tempfile.TemporaryDirectory() as folder:
        return by_file(put, os.path.join(folder, "out" + suffix), suffix)


def text_of(scene: Scene) -> str:
    return by_file(lambda path: write(scene, path), None, ".obj")
