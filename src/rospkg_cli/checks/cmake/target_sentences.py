"""Messages on targets and exports that do not exist (CMK110)."""

from __future__ import annotations

from ...package.cmake.cmake_project import CMake
from .early_references import EarlyReference
from .met_here import by_whom
from .mistyped_links import MistypedLink
from .named_targets import TargetReference

STOPS = {
    "install": "given target … which does not exist",
    "set_target_properties": "can not find target to add properties to",
    "set_property": "could not find TARGET",
    "add_custom_command": "No TARGET … has been created in this directory",
    "add_dependencies": "Cannot add target-level dependencies to non-existent target",
    "ament_target_dependencies": "the first argument must be a valid target name",
    "rosidl_target_interfaces": "the … argument … must be a valid target name",
    "rosidl_get_typesupport_target": "is not a CMake target",
}
"""How CMake says it; the commands for targets all end their sentence in the same way."""


def mistyped(each: MistypedLink) -> str:
    text = each.link.word.text
    if each.exported is not None:
        package = text.partition("::")[0]
        there = f"`{each.exported[0]}`" if each.exported else "no target"
        advice = "link that" if each.exported else "export it there with `ament_export_targets(…)`"
        return (
            f"`{package}` exports {there}{' and others' if each.exported[1:] else ''}, not `{text}`: CMake stops with "
            f'"the target was not found"; {advice}'
        )
    return (
        f"no package makes the target `{text}` (did you mean `{each.near}`?): CMake stops with "
        '"the target was not found"; correct it'
    )


def run_together(each: TargetReference, first: str, second: str, is_met: bool) -> str:
    stops = "users of this package stop" if "export" in each.call.name else "CMake stops"
    start = f"`{each.word.text}` is no package, but `{first}` and `{second}` without a space between them"
    return by_whom(f"{start}: {stops} because it is not found; separate them", is_met)


def said(cmake: CMake, reference: TargetReference) -> str:
    name = cmake.quoted(reference.word)
    if reference.kind == "export":
        return f"no `install(… EXPORT …)` fills {name}, which `{reference.call.name}` exports"
    return f"`{reference.call.name}` names the target {name}, which nothing creates"


def made_below(cmake: CMake, early: EarlyReference) -> str:
    reference = early.reference
    name, text = cmake.quoted(reference.word), STOPS.get(reference.call.name, "which is not built by this project")
    start = f"`{reference.call.name}` names the target {name} above the `{early.maker}()` that makes it"
    return f'{start}: CMake stops with "{text}"; move it below'


def stops(reference: TargetReference) -> str:
    if reference.kind == "export":
        return f'"INSTALL(EXPORT) given unknown export"; add `EXPORT {reference.word.text}` to the `install(TARGETS …)`'
    text = STOPS.get(reference.call.name, "which is not built by this project")
    return f'"{text}"; name an existing target'
