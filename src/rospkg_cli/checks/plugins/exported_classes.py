"""The classes that a package's sources export for pluginlib or class_loader."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator

from ...languages.cpp.file import CppFile
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...source import Span

MACROS = frozenset(
    {
        "PLUGINLIB_EXPORT_CLASS", "PLUGINLIB_EXPORT_CLASS_WITH_MESSAGE", "PLUGINLIB_REGISTER_CLASS",
        "CLASS_LOADER_REGISTER_CLASS", "CLASS_LOADER_REGISTER_CLASS_WITH_MESSAGE",
    }
)  # fmt: skip
"""The first argument is the class, the second its base; both are kept as they are written."""

CLASS = regex(r"(::)?[A-Za-z_]\w*(::[A-Za-z_]\w*)*(<.*>)?")
MACRO_NAME = regex(r"_*[A-Z][A-Z0-9_]*_*")


@dataclass(frozen=True)
class ExportedClass:
    type: str
    """As it is written in the macro: pluginlib looks for exactly this text."""
    base: str
    path: str
    span: Span
    """Of the class, in the macro."""
    is_conditional: bool


def exported_classes(files: Iterable[CppFile]) -> Iterator[ExportedClass]:
    for file in files:
        for call in file.calls_to(*MACROS):
            if call.arguments and len(call.arguments) > 1:
                kind, base = call.arguments[:2]
                yield ExportedClass(kind.text, base.text, file.path, kind.span, call.is_conditional)


def wraps_export(file: CppFile) -> bool:
    """Return whether a file defines a macro that exports classes, whose names it may compose."""
    return any(name in each.body for each in file.defines for name in MACROS)


def is_plain(name: str) -> bool:
    """Return whether a name is that of a class, and not of a macro for one."""
    return CLASS.fullmatch(name) is not None and not any(MACRO_NAME.fullmatch(part) for part in name.split("::"))


def tail(name: str) -> str:
    """Return a class's name without its namespaces and template arguments."""
    return name.partition("<")[0].rpartition("::")[2].rpartition("/")[2]


def spaceless(name: str) -> str:
    """Return the name of a class without blanks, so that `A<B >` and `A<B>` compare as equal."""
    return "".join(name.split())


def is_registered_otherwise(files: Iterable[CppFile], name: str) -> bool:
    """Return whether an unknown macro has a class (or its template) as an argument: it may export it."""
    tails = [tail(each) for each in re.findall(r"[\w:]+", name)]
    named = "|".join(map(re.escape, tails))
    pattern = re.compile(rf"\b(?!{HARMLESS})([A-Z][A-Z0-9]*_[A-Z0-9_]+)\s*\([^;{{}}()]*\b(?:{named})\b")
    texts = (file.source.text for file in files if any(each in file.source.text for each in tails))
    return any(match.group(1) not in MACROS for text in texts for match in pattern.finditer(text))


HARMLESS = r"(?:RCLCPP|RCUTILS|ROS|EXPECT|ASSERT|TEST|INSTANTIATE|GTEST)_"
"""Macros that log, or that test."""
