"""A package that a launch file needs, with the place that names it and what for."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Literal

from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.launch.launch_file import LaunchFile
from ...package.launch.text import LaunchText
from ...source import Span

NAME = regex(r"[A-Za-z][A-Za-z0-9_-]*")
FILES_OF = "looks for files of"
"""What a file does with a package whose folder it asks for."""
WATCHES = "watches a node with"
"""What a file does with a tool of developers, or with the terminal that such a tool is started in."""
OF_DESKTOP = frozenset({"gnome-terminal"})
"""Programs that every desktop of Ubuntu has, without which they show nothing."""
Failure = Literal["launch", "import", "component", "controller", "command", "program", "process"]
"""A node, or a search for files, stops the launch, and so do an import and a program that is run for its output. The
launch goes on without a component, a controller or another process, and an error is logged
(launch_ros/actions/load_composable_nodes and launch/actions/execute_local)."""


@dataclass(frozen=True, slots=True)
class PackageReference:
    """A package that a launch file needs, and where it is used."""

    name: str
    path: str
    span: Span
    does: str
    """What the file does with it, as a sentence goes on: "starts a node of"."""
    is_late: bool = True
    """Whether nothing happens before the launch reaches it; a function of Python runs when the file is loaded."""
    fails: Failure = "launch"
    """What ends where the package is not there."""
    only_with: str = ""
    """The argument without which the launch does not reach it: `sim:=true`; "" for what it does by default."""

    @property
    def is_usual(self) -> bool:
        """Whether any usual installation or desktop has it, or its name may be the user's own, or it is a tool of
        developers: it is said mildly.
        """
        return self.fails in ("command", "controller") or self.does == WATCHES or self.name in OF_DESKTOP


def package_named(file: LaunchFile, text: LaunchText | None, does: str) -> Iterator[PackageReference]:
    name = text.literal if text is not None else None
    if text is not None and name and NAME.fullmatch(name):
        yield PackageReference(name, file.path, text.span, does)
