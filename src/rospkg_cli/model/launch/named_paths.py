"""The files that launch texts name: in the share directory of a package, or beside the launch file."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from itertools import pairwise
from typing import Literal as OneOf

from ...source import Span
from ..evaluate.folder import ROOT
from .text import LaunchText, Literal, Substitution

Use = OneOf["include", "default", "file"]
"""Included by the launch file; the default of an argument; anything else."""

BASES = frozenset({"find-pkg-share", "find-pkg-prefix", "dirname"})
END = re.compile(r"[\s'\",;:|]")
"""Where a path ends that stands inside of a longer text."""
OPEN = re.compile(r"[*?\[\]{}<>$%]")
"""What stands in patterns and templates, not in names of files."""

WRITTEN = re.compile(
    r"(^|.*[/_.-])(logs?|out|output|save|saved|record|recorded|results?|tmp|cache)([/_.-].*|$)"
    r"|.*\.(log|csv|bag|db3|mcap|pid|tmp|engine|onnx|trt|plan|pt|pth|tflite|weights)"
)
"""What is likely written or fetched when the launch runs."""


@dataclass(frozen=True, slots=True)
class NamedPath:
    span: Span
    """Of the path as it is written, as far as it stands in one place."""
    package: str
    """Whose share directory it is in; "" where it is reckoned from the launch file."""
    path: str
    """Relative to that share directory, or to the folder of package.xml."""
    use: Use = "file"
    parted: bool = True
    """Whether a slash stands between the share directory and the path."""


def paths_in(text: LaunchText, folder: str, use: Use = "file") -> Iterator[NamedPath]:
    """Yield the files that a text of a launch file in `folder` names, as far as they are told."""
    for at, part in enumerate(text.parts):
        if isinstance(part, Literal):
            if part.text.startswith(f"{ROOT}/"):
                yield from beside(literal_of(text.parts[at:]), "", use, len(ROOT))
            continue
        for argument in part.arguments:
            yield from paths_in(argument, folder, use if part.name != "command" else "file")
        if part.name in BASES:
            written = literal_of(text.parts[at + 1 :])
            yield from beside(written, folder, use) if part.name == "dirname" else in_package(part, written, use)


def in_package(base: Substitution, written: tuple[str, Span] | None, use: Use) -> Iterator[NamedPath]:
    package = base.arguments[0].literal if base.arguments else None
    if written is None or not package:
        return
    text, span = written
    path = clean(text)
    if base.name == "find-pkg-prefix":
        share = f"share/{package}/"
        path = path[len(share) :] if path.startswith(share) else ""
    if is_file(path):
        yield NamedPath(span, package, path, use, text.startswith("/"))


def beside(written: tuple[str, Span] | None, folder: str, use: Use, skip: int = 0) -> Iterator[NamedPath]:
    if written is not None and written[0].startswith("/"):
        path = clean(f"{folder}/{written[0][skip:].lstrip('/')}")
        if is_file(path):
            yield NamedPath(written[1], "", path, use)


def clean(text: str) -> str:
    return posixpath.normpath(text.lstrip("/")) if text.strip("/") else ""


def is_file(path: str) -> bool:
    """Return whether a path means a file of the folder it is reckoned from: one with a suffix, not above it."""
    name = posixpath.basename(path)
    if WRITTEN.fullmatch(path):
        return False
    return "." in name.strip(".") and not path.startswith("..") and not OPEN.search(path)


def literal_of(parts: Sequence[Literal | Substitution]) -> tuple[str, Span] | None:
    """Return the path that some parts begin with, and where it stands; None where a piece of it is not told."""
    found, spans = "", []
    for part in parts:
        if isinstance(part, Substitution):
            return None
        end = END.search(part.text)
        piece = part.text[: end.start()] if end else part.text
        found += piece
        as_written = part.span.end - part.span.start == len(part.text)
        spans.append(Span(part.span.start, part.span.start + len(piece)) if as_written else part.span)
        if end:
            break
    if not spans:
        return None
    wide = Span(spans[0].start, spans[-1].end)
    in_order = all(a.end <= b.start or a == b for a, b in pairwise(spans))
    return found, wide if in_order and wide.start <= wide.end else spans[-1]
