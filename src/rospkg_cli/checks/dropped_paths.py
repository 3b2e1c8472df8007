"""Paths that Python joins to an absolute one: `os.path.join` drops what is before that."""

from __future__ import annotations

import ast
import posixpath
from collections.abc import Iterator, Sequence
from functools import cached_property
from typing import Annotated

from ..languages.python.file import PythonFile
from ..languages.python.nodes import nodes_of_kind
from ..lazy_regex import regex
from ..light_dataclasses import dataclass, replace
from ..package.file_role import Role
from ..package.launch.never_launched import never_launched
from ..package.launch.uncalled_functions import uncalled_functions
from ..ros.share_layout import LAUNCH
from ..source import Span
from ..unreadable import READABLE
from .launch.launch_context import LaunchContext
from .launch.unread_values import UnreadValues
from .python.run_imports import RunImports
from .reached_places import ReachedPlaces
from .why_seldom import WHY

JOINS = frozenset({"os.path.join", "path.join", "osp.join", "posixpath.join"})
CLASSES = frozenset({"Path", "PurePath", "PosixPath"})
OF_SYSTEM = regex(r"/(bin|dev|etc|home|lib|media|mnt|opt|proc|root|run|srv|sys|tmp|usr|var|Users|Volumes)(/.*|$)")
"""Paths that exist on most machines, and that are intended as they are."""
SUFFIX = regex(r"\w\.\w+$")
FOLDER = regex(
    r"(?i)share|dir|path|folder|home|root|cwd|file|data|config|maps?|model|mesh|pkg|package|(?<![^\W_])ws(?![^\W_])"
)
"""Words of what stands for a folder."""
PATTERN = regex(r"[*?\[]")


@dataclass(frozen=True, slots=True)
class DroppedPath:
    file: PythonFile
    role: Role
    span: Span
    """Of the part that begins at the root."""
    by: str
    """What joins: `os.path.join`, `/` of pathlib."""
    text: str
    """The beginning of that part, as far as it is known."""
    dropped: str
    """What stands before it, in the source."""
    why_unmet: str = ""
    """The end of a message that says why no program is known to reach it; "" where one does."""
    is_for_nothing: bool = False
    """Whether it is only in an argument of a launch file that nothing reads."""

    @property
    def is_of_system(self) -> bool:
        return OF_SYSTEM.fullmatch(self.text) is not None

    @property
    def is_of_files(self) -> bool:
        """Whether it is clearly the path of a folder or file, and no name of a topic or a frame."""
        return SUFFIX.search(self.text) is not None or FOLDER.search(self.dropped) is not None

    @property
    def is_unused(self) -> bool:
        """Whether it is for an action that a launch file never adds, or a local variable that nothing reads."""
        is_launch = LAUNCH.fullmatch(posixpath.basename(self.file.path)) is not None
        return self.is_for_nothing or (
            is_launch
            and any(value.contains(self.span) for value in (*never_launched(self.file), *uncalled_functions(self.file)))
        )


@dataclass(frozen=True)
class DroppedPaths:
    run: RunImports
    launches: Annotated[tuple[LaunchContext, ...], READABLE]
    places: ReachedPlaces | None = None

    @cached_property
    def all(self) -> tuple[DroppedPath, ...]:
        found = (each for role, file in self.run.files for each in dropped_in(file, role))
        return tuple(
            replace(each, is_for_nothing=self.is_for_nothing(each), why_unmet=self.why_unmet(each)) for each in found
        )

    def why_unmet(self, dropped: DroppedPath) -> str:
        """Return why no program is known to reach a place, in code that is no launch file."""
        if self.places is None or dropped.role != "run":
            return ""
        return WHY.get(self.places.met(dropped.file, dropped.span), "")

    def is_for_nothing(self, dropped: DroppedPath) -> bool:
        return any(each.holds(dropped.span) for each in self.unread if each.scope.file.path == dropped.file.path)

    @cached_property
    def unread(self) -> tuple[UnreadValues, ...]:
        return tuple(map(UnreadValues, self.launches))


def dropped_in(file: PythonFile, role: Role) -> Iterator[DroppedPath]:
    for by, parts in joins(file):
        absolute = [at for at, part in enumerate(parts) if leading(part).startswith("/")]
        last = absolute[-1] if absolute else 0
        before = parts[:last]
        if last and not is_kept(before, leading(parts[last])) and is_read(file, leading(parts[last])):
            dropped = file.source.slice(Span(file.span(before[0]).start, file.span(before[-1]).end))
            yield DroppedPath(file, role, file.span(parts[last]), by, leading(parts[last]), dropped)


def is_kept(before: Sequence[ast.expr], text: str) -> bool:
    """Return whether nothing may be dropped: the path begins with what stands before it, or that is unpacked."""
    if any(isinstance(part, ast.Starred) for part in before):
        return True
    words = [part.value for part in before if isinstance(part, ast.Constant) and isinstance(part.value, str)]
    return len(words) == len(before) and text.startswith(posixpath.join(*words).rstrip("/"))


def is_read(file: PythonFile, text: str) -> bool:
    """Return whether a path is one that code opens: of setup.py only patterns are, all else is where files go."""
    return file.path != "setup.py" or PATTERN.search(text) is not None


def joins(file: PythonFile) -> Iterator[tuple[str, Sequence[ast.expr]]]:
    """Yield what is joined in a file as os.path.join does it, with what joins."""
    for call in nodes_of_kind(file.tree, ast.Call):
        name = ast.unparse(call.func) if isinstance(call.func, ast.Name | ast.Attribute) else ""
        last = name.rpartition(".")[2]
        if name in JOINS or (name in CLASSES and call.args):
            yield name, call.args
        elif last == "PathJoinSubstitution" and call.args and isinstance(call.args[0], ast.List | ast.Tuple):
            yield last, call.args[0].elts
        elif last == "joinpath" and isinstance(call.func, ast.Attribute):
            yield last, [call.func.value, *call.args]
    for node in nodes_of_kind(file.tree, ast.BinOp):
        if isinstance(node.op, ast.Div):
            yield "/", [node.left, node.right]


def leading(node: ast.expr) -> str:
    """Return the text that a part certainly begins with; "" for none."""
    match node:
        case ast.Constant(value=str() as text):
            return text
        case ast.JoinedStr(values=[first, *_]) | ast.List(elts=[first, *_]):
            return leading(first)
        case ast.BinOp(left=left, op=ast.Add()):
            return leading(left)
        case ast.Call(func=ast.Name(id="TextSubstitution"), keywords=[keyword]):
            return leading(keyword.value)
    return ""
