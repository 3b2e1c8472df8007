"""Defaults of arguments that only actions read which are off by default: RViz' config, where `use_rviz` is false."""

from __future__ import annotations

import re
from collections.abc import Iterator
from functools import cached_property

from ...languages.python.unread_values import only_read_in
from ...light_dataclasses import dataclass
from ...package.launch.launch_file import LaunchFile
from ...source import Span
from .action_conditions import conditional
from .launch_configurations import OWN, is_in_comment
from .launch_context import LaunchContext
from .missing_reference import MissingReference, defaults_of
from .unread_values import UnreadValues


@dataclass(frozen=True)
class ReadWhenOff:
    scope: LaunchContext

    def has(self, missing: MissingReference) -> bool:
        """Return whether every place that names a file is the default of an argument that no plain launch reads."""
        if missing.use != "default" or not self.off or self.scope.file.is_ros1 or self.unread.may_read_any:
            return False
        spans = (missing.span, *missing.other_spans)
        return all(any(self.is_default_of(name, around, each) for name, around in self.defaults) for each in spans)

    def is_default_of(self, name: str, around: Span, place: Span) -> bool:
        return around.contains(place) and name not in OWN and self.is_off(name)

    @cached_property
    def unread(self) -> UnreadValues:
        return UnreadValues(self.scope)

    @cached_property
    def off(self) -> tuple[Span, ...]:
        """The actions that are off by default, and the values of the variables that they alone read."""
        own = [each.around for each in conditional(self.scope.file) if each.holds is False]
        python = self.scope.file.python
        return (*own, *(only_read_in(python, own) if python is not None and own else ()))

    @cached_property
    def defaults(self) -> tuple[tuple[str, Span], ...]:
        arguments = [each for each in self.scope.file.arguments if each.name.literal]
        return tuple((each.name.literal or "", span) for each in arguments for span in defaults_of([each]))

    def is_off(self, name: str) -> bool:
        """Return whether an argument is read, and by what is off alone; what includes the file may read it, too."""
        uses = list(self.uses(name))
        if not uses or not all(self.is_hidden(each) for each in uses) or self.unread.is_read_around(name):
            return False
        shown = (each for each in self.scope.file.includes if not self.is_hidden(each.file.span))
        return not any(self.unread.is_taken(each, name) for each in shown)

    def is_hidden(self, place: Span) -> bool:
        return any(each.contains(place) for each in self.off)

    def uses(self, name: str) -> Iterator[Span]:
        return uses_of(self.scope.file, name)


def uses_of(file: LaunchFile, name: str) -> Iterator[Span]:
    """Yield where an argument is read, and where Python has its name in quotes besides its declaration."""
    yield from (each.span for each in file.configurations() if each.arguments and each.arguments[0].literal == name)
    yield from (each.span for each in file.events or () if each.kind == "use" and each.name == name)
    declared = [each.span for each in file.arguments if each.name.literal == name]
    text = file.source.text if file.frontend == "python" else ""
    for found in re.finditer(rf"(['\"]){re.escape(name)}\1", text):
        place = Span(*found.span())
        if not is_in_comment(text, place.start) and not any(each.holds(place) for each in declared):
            yield place
