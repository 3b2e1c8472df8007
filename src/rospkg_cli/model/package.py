"""One package: its files, and the models made of them, each once and only when asked for."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Any, TypeVar, cast

from .files import PackageFiles, Parts
from .readers import READERS
from .unreadable import Unreadable, UnreadableError

T = TypeVar("T")


@dataclass
class Package:
    files: PackageFiles

    def __post_init__(self) -> None:
        self._parts: dict[type, Parts[Any]] = {}

    @property
    def folder(self) -> str:
        return self.files.folder

    def parts(self, kind: type[T]) -> Parts[T]:
        """Return all models of a kind, and the files of that kind that can't be read."""
        if kind not in self._parts:
            self._parts[kind] = self._read(kind)
        return cast(Parts[T], self._parts[kind])

    def _read(self, kind: type[T]) -> Parts[T]:
        good: list[T] = []
        broken: list[Unreadable] = []
        try:
            for part in READERS[kind](self):
                if isinstance(part, Unreadable):
                    broken.append(part)
                else:
                    good.append(part)
        except UnreadableError as error:
            broken.append(error.unreadable)
        return Parts(tuple(good), tuple(broken))

    def unreadable(self) -> list[Unreadable]:
        """Read everything, and return what can't be read: once a file, the first complaint of each."""
        found: dict[str, Unreadable] = {}
        for kind in READERS:
            for each in self.parts(kind).broken:
                found.setdefault(each.path, each)
        return [found[path] for path in sorted(found)]
