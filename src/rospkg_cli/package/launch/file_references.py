"""The files that launch texts name: in the share directory of a package, or relative to the launch file."""

from __future__ import annotations

import posixpath
from collections.abc import Iterator, Mapping
from typing import Literal as OneOf

from ...languages.python.evaluate.sandbox_filesystem import MAX_PATH, ROOT
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...source import Span
from .joined_path import OPEN, JoinedPath, literal_of
from .text import LaunchText, Literal, Substitution

ReferenceKind = OneOf["include", "open", "file", "default", "caught"]
"""Included by the launch file; opened by it or its xacro; else; an argument's default; opened where it may lack."""

NAME = regex(r"[A-Za-z]\w*")
BASES = frozenset({"find-pkg-share", "find-pkg-prefix", "dirname"})
OPENING = regex(r"\s*['\"]?(?:ros2 run xacro )?(?:\$\(find-exec )?(?:\S*/)?(?:xacro|cat)\b")
"""The start of a command that stops where the file that it is given is missing."""
PATTERN = regex(r"[*?\[\]{}<>$%]")
"""Characters of patterns and templates, not of file names."""

OUTPUT_FILE = regex(
    r"(^|.*[/_.-])(logs?|out|output|save|saved|record|recorded|results?|tmp|cache)([/_.-].*|$)"
    r"|.*\.(log|csv|bag|db|db3|sqlite3?|mcap|tlog|pid|tmp|engine|onnx|trt|plan|pt|pth|tflite|weights)"
)
"""What is likely written or fetched when the launch runs."""


@dataclass(frozen=True, slots=True)
class FileReference:
    span: Span
    """Of the path as it is written, if it is in one place."""
    package: str
    """Whose share directory it is in; "" where the path is relative to the launch file."""
    path: str
    """Relative to that share directory, or to the folder of package.xml."""
    use: ReferenceKind = "file"
    has_slash: bool = True
    """Whether a slash is between the share directory and the path."""

    @property
    def is_open(self) -> bool:
        """Whether a part of the path is not known."""
        return OPEN in self.path


NO_DEFAULTS: Mapping[str, str] = {}


def references_in(
    text: LaunchText,
    folder: str,
    use: ReferenceKind = "file",
    defaults: Mapping[str, str] = NO_DEFAULTS,
    *,
    is_command: bool = False,
) -> Iterator[FileReference]:
    """Yield the files that a text of a launch file in `folder` names.

    A part that is not known is `…` in a share directory; elsewhere the file is left out. `defaults` are those of the
    arguments by their names.
    """
    for at, part in enumerate(text.parts):
        here = use_in_command(text, at) if is_command else use
        if isinstance(part, Literal):
            if part.text.startswith(f"{ROOT}/"):
                yield from local_reference(literal_of(text.parts[at:], defaults), "", here, len(ROOT))
            continue
        for place, argument in enumerate(part.arguments):
            inner: ReferenceKind = "default" if part.name == "var" and place == 1 else here
            yield from references_in(argument, folder, inner, defaults, is_command=part.name == "command")
        if part.name in BASES:
            written = literal_of(text.parts[at + 1 :], defaults)
            if part.name == "dirname":
                yield from local_reference(written, folder, here)
            elif written is not None and part.arguments:
                yield from package_reference(part, literal_of(part.arguments[0].parts, defaults), written, here)


def first_in(text: LaunchText, folder: str) -> FileReference | None:
    """Return the file that an include names, as far as it is known."""
    return next((each for each in references_in(text, folder, "include") if not each.is_open), None)


def use_in_command(text: LaunchText, at: int) -> ReferenceKind:
    """Return how a command uses the file that begins with a part: xacro opens it, but not the value of an argument."""
    before = LaunchText(text.span, text.parts[:at]).shown.rstrip("'\"")
    return "open" if OPENING.match(before) and not before.endswith("=") else "file"


def package_reference(
    base: Substitution, package: JoinedPath | None, written: JoinedPath, use: ReferenceKind
) -> Iterator[FileReference]:
    if package is None or not NAME.fullmatch(package.text):
        return
    path = normal_path(written.text)
    if base.name == "find-pkg-prefix":
        share = f"share/{package.text}/"
        path = path[len(share) :] if path.startswith(share) else ""
    if is_file(path, is_read=use == "include"):
        use = "default" if written.by_default or package.by_default else use
        yield FileReference(written.span, package.text, path, use, written.text.startswith("/"))


def local_reference(
    written: JoinedPath | None, folder: str, use: ReferenceKind, skip: int = 0
) -> Iterator[FileReference]:
    if written is not None and written.text.startswith("/") and OPEN not in written.text:
        path = normal_path(f"{folder}/{written.text[skip:].lstrip('/')}")
        if is_file(path, is_read=use == "include"):
            yield FileReference(written.span, "", path, "default" if written.by_default else use)


def normal_path(text: str) -> str:
    return posixpath.normpath(text.lstrip("/")) if text.strip("/") else ""


def is_file(path: str, *, is_read: bool = False) -> bool:
    """Return whether a path is that of a file below its base: it has a suffix and does not begin with `..`.

    One that is certainly read, as an included file is, may be called as files are that a launch writes.
    """
    name = posixpath.basename(path)
    if len(path) > MAX_PATH or (not is_read and OUTPUT_FILE.fullmatch(path)):
        return False
    return "." in name.strip(".") and not path.startswith("..") and not PATTERN.search(path)
