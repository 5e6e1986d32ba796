"""The shared libraries beside this file, and what their statuses become."""
from __future__ import annotations

import ctypes
import os
import threading

from . import _bindings as c

_HERE = os.path.dirname(os.path.abspath(__file__))


class StonepackError(Exception):
    """What the library or the reader of files refused."""


class SceneError(StonepackError, ValueError):
    """A scene or a question that makes no sense.

    status  the library's number, SP_E_...; 0 where Python refused
    block   name of the block it is about, or None
    """

    def __init__(self, message: str, status: int = 0, block: str | None = None):
        super().__init__(message)
        self.status = status
        self.block = block


class FileError(StonepackError):
    """A scene file that can't be read or written: `file:line: message`."""


def _load(name: str) -> ctypes.CDLL:
    return ctypes.CDLL(os.path.join(_HERE, name))           # CDLL lets other threads run while a call is under way


lib = _load("libstonepack.so.%d.%d" % (c.SP_VERSION_MAJOR, c.SP_VERSION_MINOR))
for _name, (_result, _arguments) in c.CALLS.items():
    _call = getattr(lib, _name)
    _call.restype, _call.argtypes = _result, _arguments

__version__ = "%d.%d.%d" % (c.SP_VERSION_MAJOR, c.SP_VERSION_MINOR, c.SP_VERSION_PATCH)

_P, _S, _I = ctypes.c_void_p, ctypes.c_char_p, ctypes.c_int
_FILES_CALLS = {
    "files_new": (_P, []), "files_free": (None, [_P]), "files_option": (_I, [_P, _S, _S]),
    "files_read": (_I, [_P, _S, _S, ctypes.c_size_t]), "files_error": (_S, [_P]), "files_name": (_S, [_P, ctypes.c_int32]),
    "files_parts": (ctypes.POINTER(c.sp_scene), [_P]), "files_remark": (_S, [_P, ctypes.c_int32]),
    "files_found": (_I, [_P, ctypes.POINTER(c.sp_contact_settings), ctypes.POINTER(ctypes.c_int32),
                         ctypes.POINTER(ctypes.POINTER(c.sp_overlap))]), "files_mu": (ctypes.c_double, [_P]),
    "files_density": (ctypes.c_double, [_P]),
    "files_write": (_I, [_S, ctypes.POINTER(c.sp_scene), ctypes.POINTER(_S), ctypes.c_char_p]),
    "files_draw": (_I, [_S, ctypes.POINTER(c.sp_scene), ctypes.POINTER(_S), _S, ctypes.POINTER(c.sp_result),
                        ctypes.POINTER(c.sp_limit_result), _I, ctypes.c_char_p]),
    "files_json": (_I, [_S, ctypes.POINTER(c.sp_scene), ctypes.POINTER(_S), _S, ctypes.POINTER(c.sp_result),
                        ctypes.POINTER(c.sp_settings), _S, ctypes.c_char_p]),
}
_files = None
files_lock = threading.Lock()                           # the reader and the pictures are made for one caller at a time


def files() -> ctypes.CDLL:
    """The reader of scene files, loaded when it is first asked."""
    global _files
    if _files is None:
        loaded = _load("libstonepack_files.so")
        for name, (result, arguments) in _FILES_CALLS.items():
            call = getattr(loaded, name)
            call.restype, call.argtypes = result, arguments
        _files = loaded
    return _files


_settle = None


def settling() -> ctypes.CDLL:
    """Where stones come to rest, loaded when it is first asked: there where this was built with Bullet, and Bullet is here."""
    global _settle
    if _settle is None:
        try:
            loaded = _load("libstonepack_settle.so")
        except OSError as missing:
            raise StonepackError("settle needs Bullet, here and where this was built (Debian: libbullet-dev): %s" % missing) from None
        for name, (result, arguments) in c.SETTLE_CALLS.items():
            call = getattr(loaded, name)
            call.restype, call.argtypes = result, arguments
        _settle = loaded
    return _settle


def text(words: int, value: int) -> str:
    return lib.sp_text(words, value).decode()


def refuse(status: int, what: str = "", block: str | None = None) -> SceneError:
    """The exception of a status."""
    said = text(c.SP_WORDS_STATUS, status)
    return SceneError("%s: %s" % (what, said) if what else said, status, block)


def arena(size: int):
    """(memory, sp_arena) of that many bytes, aligned."""
    memory = (ctypes.c_char * (size + c.SP_ALIGN))()
    base = (ctypes.addressof(memory) + c.SP_ALIGN - 1) & -c.SP_ALIGN
    return memory, c.sp_arena(base, size, 0, 0)
