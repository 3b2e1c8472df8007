"""Values that launch files and parameter files give to parameters, with their types."""

from __future__ import annotations

from collections.abc import Iterable

from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.launch.launch_file import LaunchFile
from ...package.launch.text import LaunchText
from ...package.params.parameter_file import Parameter
from ...source import Span
from .declaring_packages import is_its_own
from .rcl_types import given_type, is_number_of_rcl, type_of_text
from .unchanged_values import value_text

CONVERTED = regex(r"ParameterValue|value_type|type=")
"""What gives a value in a launch file another type than its text has."""


@dataclass(frozen=True, slots=True)
class GivenValue:
    name: str
    key: Span
    value: Span
    text: str
    type: str
    """"" where it is unknown."""
    written: Parameter | None = None
    """In a parameter file."""

    @property
    def plain(self) -> str | None:
        """What is given where it is one value: the text of a launch file, or that of a parameter file; else None."""
        return value_text(self.written.value) if self.written is not None else self.text or None


def file_value(each: Parameter) -> GivenValue:
    return GivenValue(each.name, each.key.span, each.value.span, "", given_type(each.value), each)


def launch_value(launch: LaunchFile, name: LaunchText, value: LaunchText) -> Iterable[GivenValue]:
    """Return a value under a literal name; its type is that of its text, as launch_ros reads it."""
    if not name.literal or not is_its_own(name.literal):
        return ()
    text, source = value.literal or "", launch.source
    is_written = source.slice(value.span) == text and name.span.end <= value.span.start
    before = source.text[name.span.end : value.span.start] if is_written else ""
    kind = type_of_text(text) if is_written and not CONVERTED.search(before) else ""
    kind = "" if is_cast_behind(launch, value) else kind
    if kind and launch.frontend != "xml" and before[-1:] in ("'", '"'):
        kind = "string" if launch.frontend == "python" and not is_number_of_rcl(text) else ""
    return (GivenValue(name.literal, name.span, value.span, text, kind),)


def is_cast_behind(launch: LaunchFile, value: LaunchText) -> bool:
    """Return whether XML names the type of a value behind it."""
    end = value.span.end
    return launch.frontend == "xml" and "type=" in launch.source.text[end : launch.source.text.find(">", end)]
