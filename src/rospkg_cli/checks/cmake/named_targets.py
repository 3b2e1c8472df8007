"""Arguments of commands that name a target, or a set of exported targets."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from itertools import takewhile
from typing import Literal

from ...languages.cmake.evaluated_command import EvaluatedCommand
from ...languages.cmake.values import Word
from ...light_dataclasses import dataclass
from ...package.cmake.cmake_project import CMake

FIRST_IS_TARGET = (
    "target_link_libraries", "target_include_directories", "target_compile_definitions", "target_compile_features",
    "target_compile_options", "target_sources", "target_link_options", "ament_target_dependencies",
    "rosidl_target_interfaces", "add_dependencies",
)  # fmt: skip
OF_INTERFACES = ("rosidl_get_typesupport_target", "rosidl_target_interfaces")
"""Commands whose second argument is what rosidl_generate_interfaces() was given."""
EXPORTS = ("ament_export_targets", "ament_export_interfaces")


@dataclass(frozen=True)
class TargetReference:
    word: Word
    call: EvaluatedCommand
    kind: Literal["target", "export"] = "target"


def target_references(cmake: CMake) -> Iterator[TargetReference]:
    """Yield each argument that names a target or an export, in whatever command."""
    for call in cmake.named(*FIRST_IS_TARGET):
        yield from (TargetReference(word, call) for word in call.words[:1])
    for call in cmake.named("set_target_properties"):
        end = call.texts.index("PROPERTIES") if "PROPERTIES" in call.texts else 0
        yield from (TargetReference(word, call) for word in call.words[:end])
    for call in cmake.named("set_property"):
        named = call.words[1:] if call.texts[:1] == ("TARGET",) else ()
        yield from (TargetReference(word, call) for word in takewhile(is_no_keyword, named))
    for call in cmake.named("add_custom_command"):
        named = call.words[1:2] if call.texts[:1] == ("TARGET",) else ()
        yield from (TargetReference(word, call) for word in named)
    for call in cmake.named(*OF_INTERFACES):
        yield from (TargetReference(word, call) for word in call.words[1:2])
    for rule in cmake.installs:
        if rule.kind == "TARGETS":
            yield from (TargetReference(word, rule.call) for word in rule.items)
    for call in cmake.named(*EXPORTS):
        names = [w for w in call.words if w.text not in ("HAS_LIBRARY_TARGET", "NAMESPACE") and "::" not in w.text]
        yield from (TargetReference(word, call, "export") for word in names)


def is_no_keyword(word: Word) -> bool:
    return word.text not in ("APPEND", "APPEND_STRING", "PROPERTY")


def by_name(references: Iterable[TargetReference]) -> Iterable[list[TargetReference]]:
    """Return the references to each name together, in the order of the first ones: they have one cause."""
    found: dict[tuple[str, str], list[TargetReference]] = {}
    for each in references:
        found.setdefault((each.kind, each.word.text), []).append(each)
    return found.values()
