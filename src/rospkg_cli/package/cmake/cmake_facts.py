"""The components that CMake registers, and the targets that it has and exports, for PackageFacts."""

from __future__ import annotations

from ...files import ReaderInput
from ...languages.cmake.evaluated_command import EvaluatedCommand
from .build import is_built_with_cmake
from .cmake_project import CMake
from .foreign_commands import foreign_commands, may_make_targets
from .project_name import PACKAGE_ENDS

SEARCHES = ("ament_auto_find_build_dependencies", "autoware_package")
"""Commands that look for all that package.xml declares."""
ANY = "*"


def registered_components(reading: ReaderInput) -> tuple[frozenset[str], bool]:
    """Return the class names of the components of a package, and whether these are all."""
    if not is_built_with_cmake(reading):
        return frozenset(), True
    cmake = reading.parts(CMake).only
    if cmake is None:
        return frozenset(), False
    plugins = [component.plugin for component in cmake.components]
    known = frozenset(plugin.text for plugin in plugins if plugin.is_known)
    return known, cmake.is_complete and all(plugin.is_known for plugin in plugins)


def may_register_more(reading: ReaderInput) -> bool:
    """Return whether macros or files that can't be read here may register components."""
    cmake = reading.parts(CMake).only if is_built_with_cmake(reading) else None
    return cmake is not None and (cmake.includes_unknown_files or may_make_targets(cmake))


def has_targets(reading: ReaderInput) -> bool:
    """Return whether a package has libraries or programs of its own, or may have such."""
    cmake = reading.parts(CMake).only
    return cmake is None or bool(cmake.targets) or not cmake.is_complete


def sought_packages(reading: ReaderInput) -> frozenset[str]:
    """Return the packages that CMake looks for; ANY is all that package.xml declares, or what is unknown."""
    cmake = reading.parts(CMake).only
    if cmake is None or not cmake.is_complete or cmake.reads_unknown_files or cmake.named(*SEARCHES):
        return frozenset({ANY})
    if next(foreign_commands(cmake), None) is not None:
        return frozenset({ANY})
    return frozenset(each.name if each.word.is_known else ANY for each in cmake.packages)


def exported_targets(reading: ReaderInput) -> tuple[tuple[str, ...], bool]:
    """Return the targets that a package exports, as others name them (`pkg::library`), and whether these are all."""
    cmake = reading.parts(CMake).only
    if cmake is None:
        return (), not is_built_with_cmake(reading)
    exports = cmake.exports
    names = {text for call in exports for text in call.texts}
    spaces = [call.texts[call.texts.index("NAMESPACE") + 1] for call in exports if "NAMESPACE" in call.texts[:-1]]
    space = spaces[0] if spaces else f"{cmake.project_name}::"
    found = [
        f"{space}{cmake.export_names.get(word.text, word.text)}"
        for rule in cmake.installs
        if rule.export is not None and rule.export.text in names
        for word in rule.items
        if word.is_known
    ]
    return tuple(dict.fromkeys(found)), are_all_exports_known(cmake)


def are_all_exports_known(cmake: CMake) -> bool:
    """Return whether a package exports no other targets than those of `ament_export_targets()`.

    Others come with interfaces, files of its own that its users include, or commands that export by themselves.
    """
    if not cmake.is_complete or cmake.reads_unknown_files or not cmake.ends_a_package or cmake.interface_targets:
        return False
    own = any("CONFIG_EXTRAS" in text for call in cmake.named(*PACKAGE_ENDS) for text in call.texts)
    exports = any(rule.kind in ("EXPORT", "CODE") for rule in cmake.installs) or any(map(may_export, cmake.calls))
    scopes = [rule.items for rule in cmake.installs if rule.export is not None]
    is_clear = all(word.is_known for items in scopes for word in items)
    return is_clear and not own and not exports and next(foreign_commands(cmake), None) is None


def may_export(call: EvaluatedCommand) -> bool:
    """Return whether a command may export targets under names that are not known."""
    if call.name == "install":
        return "EXPORT" in call.texts[:1] or any(text.endswith(".cmake") for text in call.texts)
    is_clear = call.name not in EXPORTS or all(word.is_known and not word.maybe for word in call.words)
    return call.name in EXPORTING or not is_clear or (call.name in EXPORTS and (call.maybe or bool(call.folder)))


EXPORTS = ("ament_export_targets", "ament_export_interfaces")
EXPORTING = frozenset({
    "export", "ament_auto_package", "autoware_ament_auto_package", "ament_vendor", "externalproject_add",
    "configure_package_config_file", "fetchcontent_makeavailable", "add_subdirectory",
})  # fmt: skip
