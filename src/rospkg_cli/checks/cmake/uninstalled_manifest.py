"""Packages of plain CMake that install something, and not their package.xml (CMK127)."""

from __future__ import annotations

from ...languages.cmake.evaluated_command import EvaluatedCommand
from ...package.cmake.cmake_package import CMakePackage
from ...package.cmake.foreign_commands import foreign_commands

MANIFEST = "package.xml"
OTHERS = ("ament_package", "ament_auto", "ament_generate", "catkin_", "cmake_package_", "externalproject_")
"""How commands begin that install package.xml by themselves, or may do so."""
CODE = ("CODE", "SCRIPT", "EXPORT_ANDROID_MK")


def uninstalled_manifest(package: CMakePackage) -> EvaluatedCommand | None:
    """Return the last call that installs targets, where no file names package.xml and nothing else may install it."""
    cmake = package.cmake
    is_known = cmake.is_complete and not cmake.reads_unknown_files and next(foreign_commands(cmake), None) is None
    if package.facts.build_type != "cmake" or not is_known:
        return None
    if any(MANIFEST in file.source.text for file in cmake.files):
        return None
    calls = [*cmake.calls, *cmake.unreachable]
    if any(call.name.startswith(OTHERS) or (call.name == "install" and call.texts[:1] == ("CODE",)) for call in calls):
        return None
    rules = [rule for rule in cmake.installs if not rule.call.maybe]
    is_open = any(rule.kind in CODE or any(not word.is_known for word in rule.items) for rule in rules)
    targets = [rule for rule in rules if rule.kind in ("TARGETS", "EXPORT")]
    return targets[-1].call if targets and not is_open else None
