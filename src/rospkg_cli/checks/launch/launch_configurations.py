"""Rule input: the launch configurations of one launch file, and where the file names and sets them."""

from __future__ import annotations

import re
from collections import Counter
from functools import cached_property
from typing import Annotated

from ...languages.python.unread_values import never_added
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.file_role import role_of
from ...package.launch.launch_file import LaunchFile
from ...package.workspace import Workspace
from ...source import Span
from ...unreadable import READABLE
from .entity_schema import entity_faults

OWN = frozenset("ros_namespace ros_params ros_remaps launch-prefix sigterm_timeout sigkill_timeout log_dir".split())
"""Those that launch and launch_ros use and set themselves."""

SETS = ("declare", "define")
"""The kinds of launch events that set a configuration."""
MENTION = regex(r"(?<!<param name=)['\"]([\w.-]+)['\"](?!\s*:)|\$\(var\s+([\w.-]+)\s*\)")
"""Where a launch configuration may be named: not as the name of a parameter, nor as the key of a dict."""


@dataclass(frozen=True)
class LaunchConfigurations:
    """A launch file, with the other launch files of its package and those of the workspace."""

    workspace: Workspace
    file: LaunchFile
    around: Annotated[tuple[LaunchFile, ...], READABLE] = ()
    """All launch files of the package that can be read."""

    @cached_property
    def is_startable(self) -> bool:
        """Whether this is a launch file for users, of which everything is known."""
        file = self.file
        is_known = file.has_entry_point and file.is_complete and file.events is not None and not file.is_ros1
        return is_known and role_of(file.path) == "launch" and not any(entity_faults(file))

    @property
    def file_name(self) -> str:
        return self.file.path.rpartition("/")[2]

    @property
    def is_included(self) -> bool:
        """Whether a launch file of the workspace includes it, or its name begins with `include`."""
        named = "include" in self.file.path.rpartition("launch/")[2]
        return named or self.file_name in self.workspace.launch.included

    @cached_property
    def inherited(self) -> frozenset[str] | None:
        """The names that all files which include this one set; None where that, or this file, is not fully known."""
        return self.workspace.launch.inherited(self.file_name) if self.is_startable else None

    @cached_property
    def mentions(self) -> Counter[str]:
        """How often each name stands in quotes or as `$(var name)`."""
        return Counter(one or other for one, other in MENTION.findall(self.file.source.text))

    def is_required(self, name: str) -> bool:
        """Return whether all that sets a name are declarations of an argument that the user has to give."""
        kinds = {
            (each.kind, each.is_optional) for each in self.file.events or () if each.name == name and each.kind in SETS
        }
        return kinds == {("declare", True)}

    @cached_property
    def may_set_any(self) -> bool:
        """Whether something in the file may set configurations of any name."""
        return any(each.kind == "open" for each in self.file.events or ())

    @cached_property
    def last_set(self) -> dict[str, dict[str, int]]:
        """The index of the last event of each kind that sets a name."""
        found: dict[str, dict[str, int]] = {"declare": {}, "define": {}}
        for index, event in enumerate(self.file.events or ()):
            if event.kind in found:
                found[event.kind][event.name] = index
        return found

    @cached_property
    def unread(self) -> tuple[Span, ...]:
        """What a Python file binds to a local name that nothing reads."""
        return tuple(never_added(self.file.python)) if self.file.python is not None else ()

    def is_read(self, span: Span) -> bool:
        return not any(each.contains(span) for each in self.unread)

    def has_other_mention(self, name: str, declared: Span, *, in_comments: bool = True) -> bool:
        """Return whether a Python file has the name in quotes at another place, which something reads.

        What is taken out for now may come back, and is no reader.
        """
        if self.file.frontend != "python":
            return False
        text = self.file.source.text
        found = re.finditer(rf"(['\"]){re.escape(name)}\1", text)
        found = (each for each in found if in_comments or not is_in_comment(text, each.start()))
        places = (Span(each.start(), each.end()) for each in found)
        return any(not declared.holds(at) and self.is_read(at) for at in places)


def is_in_comment(text: str, at: int) -> bool:
    """Return whether a place of a Python file is on a line that is a comment."""
    return text[text.rfind("\n", 0, at) + 1 : at].lstrip().startswith("#")
