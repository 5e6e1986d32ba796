"""Who may touch a scene when: many ask it at once, one thread changes it, and never both, since a change moves its arrays."""
from __future__ import annotations

import threading
from functools import wraps
from typing import Any, Callable, TypeVar

from ._library import SceneError

_F = TypeVar("_F", bound=Callable[..., Any])


class Turns:
    """Questions and changes of one scene that are under way."""

    def __init__(self) -> None:
        self._lock = threading.Lock()
        self._asking = self._changing = self._changer = 0

    def ask(self, ready: Callable[[], bool]) -> bool:
        """A question begins, where the scene is ready for it."""
        with self._lock:
            self._alone()
            if not ready():
                return False
            self._asking += 1
            return True

    def asked(self) -> None:
        with self._lock:
            self._asking -= 1

    def change(self) -> None:
        with self._lock:
            if self._asking:
                raise SceneError("the scene is being asked, in another thread for instance: change a copy of it")
            self._alone()
            self._changing += 1
            self._changer = threading.get_ident()

    def changed(self) -> None:
        with self._lock:
            self._changing -= 1

    def _alone(self) -> None:
        if self._changing and self._changer != threading.get_ident():
            raise SceneError("the scene is being changed by another thread")


def asks(method: _F) -> _F:
    """A method of a scene, or of what has one as ._scene, that reads it once joints are found."""
    @wraps(method)
    def asking(self: Any, *args: Any, **words: Any) -> Any:
        scene = getattr(self, "_scene", self)
        while True:
            scene._ready()
            if scene._turns.ask(scene._is_ready):
                break
        try:
            return method(self, *args, **words)
        finally:
            scene._turns.asked()
    return asking                                       # type: ignore[return-value]


def changes(method: _F) -> _F:
    """A method of a scene that changes it."""
    @wraps(method)
    def changing(self: Any, *args: Any, **words: Any) -> Any:
        self._turns.change()
        try:
            return method(self, *args, **words)
        finally:
            self._turns.changed()
    return changing                                     # type: ignore[return-value]
