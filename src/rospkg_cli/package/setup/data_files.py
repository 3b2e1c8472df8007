"""data_files: which file is installed where below the prefix.

distutils copies each source into its destination under its own name; colcon wants a list of tuples of a relative
destination and a list of relative sources, and knows a source once: where it is named twice, the last one counts.
"""

from __future__ import annotations

import posixpath
from collections.abc import Iterator
from typing import Literal

from ...languages.python.evaluate.sandbox_filesystem import ROOT, OutsideError, SandboxFilesystem
from ...languages.python.evaluate.values import Constant, GlobResult, Sequence, Text, Unknown, Value
from ...light_dataclasses import dataclass
from ...source import Span
from .setup_text import SetupText

Shape = Literal["", "list-entry", "text-sources", "tuple-sources", "nested-list", "length", "path"]


@dataclass(frozen=True)
class DataFile:
    """One source of an entry."""

    setup_text: SetupText
    position: Span
    """Its position in the list of sources."""
    source: str | None
    """Relative to the package; None where it leads out of it."""
    destination: str
    """The path of the installed file, relative to the prefix."""
    entry: int
    """Which entry it is of."""
    is_absolute: bool = False
    """Whether it was written as an absolute path that is not the package's own."""


@dataclass(frozen=True)
class DataEntry:
    """One tuple of data_files."""

    path: str
    span: Span
    position: Span
    """Its position in the list."""
    destination: SetupText | None
    """None where it is unknown, or where the entry is a bare file name."""
    sources: Sequence | None
    files: tuple[DataFile, ...] = ()
    unknown: tuple[Unknown, ...] = ()
    shape: Shape = ""
    glob: GlobResult | None = None
    """The glob that made the list of sources as a whole."""

    @property
    def folder(self) -> str:
        """The destination as a normalized path."""
        return posixpath.normpath(self.destination.text) if self.destination and self.destination.text else ""


def from_value(path: str, value: Value, folder: SandboxFilesystem, cwd: str = ROOT) -> Iterator[DataEntry | Unknown]:
    """Yield the entries in setup(data_files=…), and the parts of them that are unknown."""
    if isinstance(value, Constant) and not value.value:
        return
    if not isinstance(value, Sequence):
        yield value if isinstance(value, Unknown) else Unknown(value.span, "it can't be evaluated")
        return
    for index, (item, place) in enumerate(zip(value.items, value.places, strict=True)):
        if isinstance(item, Sequence):
            yield entry(path, item, place, index, folder, cwd)
        elif isinstance(item, Text):
            source_text = SetupText.of(path, item)
            file = DataFile(source_text, place, inside(item.text, folder, cwd), posixpath.basename(item.text), index)
            yield DataEntry(path, item.span, place, None, None, (file,))
        else:
            yield item if isinstance(item, Unknown) else Unknown(item.span, "it can't be evaluated")


def entry(path: str, item: Sequence, place: Span, index: int, folder: SandboxFilesystem, cwd: str) -> DataEntry:
    shape: Shape = "list-entry" if item.kind == "list" else ""
    if len(item.items) != 2:
        unknown = tuple(each for each in item.items if isinstance(each, Unknown))
        return DataEntry(path, item.span, place, None, None, unknown=unknown, shape="" if unknown else "length")
    target, sources = item.items
    destination = SetupText.of(path, target) if isinstance(target, Text) else None
    unknown = () if destination else (unknown_value(target),)
    if isinstance(sources, Text):
        texts, places, shape = [sources], [sources.span], "text-sources"
    elif isinstance(sources, Sequence):
        listed = list(flat(sources))
        texts = [each for each, _ in listed if isinstance(each, Text)]
        places = [where for each, where in listed if isinstance(each, Text)]
        unknown += tuple(unknown_value(each) for each, _ in listed if not isinstance(each, Text))
        nested = any(isinstance(each, Sequence) for each in sources.items)
        shape = shape or ("nested-list" if nested else "tuple-sources" if sources.kind == "tuple" else "")
    else:
        texts, places, unknown = [], [], (*unknown, unknown_value(sources))
    if not shape and any(isinstance(each, Text) and each.is_path for each in (target, *texts)):
        shape = "path"
    files = [
        file(path, each, where, destination, index, folder, cwd) for each, where in zip(texts, places, strict=True)
    ]
    sequence = sources if isinstance(sources, Sequence) else None
    glob = sequence.origin if sequence else None
    return DataEntry(path, item.span, place, destination, sequence, tuple(files), unknown, shape, glob)


def file(
    path: str, source: Text, place: Span, into: SetupText | None, index: int, folder: SandboxFilesystem, cwd: str
) -> DataFile:
    name = posixpath.basename(source.text)
    target = posixpath.normpath(posixpath.join(into.text, name)) if into else ""
    own = inside(source.text, folder, cwd)
    absolute = source.text.startswith("/") and own is None
    return DataFile(SetupText.of(path, source), place, own, target, index, absolute)


def flat(sources: Sequence) -> Iterator[tuple[Value, Span]]:
    """Yield the items of a list of sources with their positions, those of a list in it in its place."""
    for item, place in zip(sources.items, sources.places, strict=True):
        if isinstance(item, Sequence):
            yield from zip(item.items, item.places, strict=True)
        else:
            yield item, place


def unknown_value(value: Value) -> Unknown:
    return value if isinstance(value, Unknown) else Unknown(value.span, "it can't be evaluated")


def inside(text: str, folder: SandboxFilesystem, cwd: str) -> str | None:
    try:
        return folder.inside(text, cwd)
    except OutsideError:
        return None
