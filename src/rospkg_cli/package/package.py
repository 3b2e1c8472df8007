"""One package: its files, and the models made of them, each once and only when asked for."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any, TypeVar, cast

from ..files import PackageFiles, ReadModels
from ..light_dataclasses import dataclass
from ..read_problem import ReadProblem
from ..source import Span
from ..unreadable import Unreadable, UnreadableError
from .readers import READERS, readers_of

T = TypeVar("T")

MODELS = {kind.__name__: kind for kind in READERS}


@dataclass
class Package:
    files: PackageFiles

    def __post_init__(self) -> None:
        self._parts: dict[type, ReadModels[Any]] = {}
        self.crashes: dict[str, str] = {}
        """The traceback of each reader that raised, by the name of its model."""

    @property
    def folder(self) -> str:
        return self.files.folder

    def parts(self, kind: type[T]) -> ReadModels[T]:
        """Return all models of a kind, and the files of that kind that can't be read."""
        if kind not in self._parts:
            self._parts[kind] = self._read(kind)
        return cast(ReadModels[T], self._parts[kind])

    def has(self, model: str) -> bool:
        """Return whether there is a model, named by its type, that could be read; the same as `parts` then says."""
        return bool(self.parts(MODELS[model]).good)

    def _read(self, kind: type[T]) -> ReadModels[T]:
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
        except Exception:  # a fault of ours in one reader leaves the package's other models as they are
            import traceback

            self.crashes[kind.__name__] = traceback.format_exc()
            crash = Unreadable("package.xml", Span(0, 0), ReadProblem.READER_CRASH, (kind.__name__,))
            return ReadModels((), (crash,))
        return ReadModels(tuple(good), tuple(broken))

    def unreadable(self, paths: Iterable[str] = ()) -> list[Unreadable]:
        """Read everything, and return what can't be read: once a file, the first complaint of each.

        Where `paths` are given, only what may read one of them is read.
        """
        found: dict[str, Unreadable] = {}
        for kind in readers_of(paths):
            parts: ReadModels[Any] = self.parts(kind)
            for each in parts.broken if kind.__name__ not in self.crashes else ():
                found.setdefault(each.path, each)
        return [found[path] for path in sorted(found)]
