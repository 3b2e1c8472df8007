"""Messages on names that are no packages (CMK117)."""

from __future__ import annotations

from .mistyped_package import MistypedPackage

EXPORT = "ament_export_dependencies"
STOPS = {
    "ament_target_dependencies": '`ament_target_dependencies` stops CMake with "the passed package name … was not '
    'found before"',
    EXPORT: "packages that build against this one stop, since they do not find it",
}

ELSEWHERE = ", unless what is not here brings it"
"""What is added where a package may exist that is neither here nor in the index."""

DOUBTS = {
    "variable": ", unless it is empty",
    "imported": ", though without REQUIRED CMake goes on",
}
"""Kind → what is added where it is not certain that CMake stops."""


def with_doubt(each: MistypedPackage, is_open: bool) -> str:
    """Return the message, with what may keep CMake from stopping."""
    if each.is_certain and not is_open:
        return message(each)
    return message(each) + DOUBTS.get(each.kind, ELSEWHERE)


def message(each: MistypedPackage) -> str:
    name, stops = each.word.text, STOPS.get(each.call.name)
    if each.kind == "target":
        advice = "link it with `target_link_libraries`" if "target" in each.call.name else "remove it"
        return f"`{name}` is a target of this package, and no package: {stops}; {advice}"
    if each.kind == "keyword":
        start = f"`{each.call.name}` takes no `{name}` here, only PUBLIC or INTERFACE before the packages"
        return f"{start}: CMake stops; link the targets of the packages with `target_link_libraries` instead"
    if each.kind == "imported":
        return f"`{name}` is the name of a target: no package is called so, and none is found; write `{each.near}`"
    if each.kind == "own":
        return f"`{name}` looks for itself: on a clean machine CMake stops, as it is not installed yet; remove the line"
    if each.kind == "variable":
        return f"`{each.variable}` holds no packages: {stops}; write `{each.near}`"
    if each.kind == "nowhere":
        return f"nothing finds or declares `{name}`: {stops}; find and declare it, or remove it"
    if each.kind == "case":
        start = f"`{name}` is found as `{each.near}`, and names of packages differ by case"
        return f"{start}: {stops}, unless another package finds it so; write `{each.near}`"
    near = f"(did you mean `{each.near}`?)"
    if stops is None:
        stops = 'CMake stops with "Could not find a package configuration file"'
        return f"no package is called `{name}` {near}: {stops}; correct the name"
    return f"no `find_package` finds `{name}` {near}: {stops}; correct it"
