"""Plugins of rqt: those in Python are found by package.xml alone, those in C++ by what CMake exports."""

from __future__ import annotations

from collections.abc import Iterator

from ...light_dataclasses import dataclass
from ...package.file_role import is_set_aside, role_of
from ...package.manifest import Manifest
from ...package.package_facts import PackageFacts
from ...package.plugins.description import PluginDescription
from ..enumeration import in_ticks

PYTHON = {"rqt_gui_py::": "rqt_gui", "qt_gui_py::": "qt_gui"}
"""The namespace of the base class, and the tag under which package.xml has the description."""
CPP = "rqt_gui_cpp::"


@dataclass(frozen=True)
class RqtPlugins:
    manifest: Manifest
    facts: PackageFacts
    descriptions: tuple[PluginDescription, ...]

    def hidden(self) -> Iterator[tuple[PluginDescription, str]]:
        """Yield the descriptions of plugins in Python that package.xml lacks, and the tag that they want."""
        if self.facts.build_type == "catkin":
            return
        exported = {each.type.value for one in self.descriptions if one.is_for_rqt for each in one.classes}
        for description in self.descriptions:
            python = [each for each in description.classes if each.base.value.startswith(tuple(PYTHON))]
            types = {each.type.value for each in python}
            if types and not description.is_for_rqt and not types & exported and role_of(description.file) == "run":
                yield description, PYTHON[python[0].base.value.partition("::")[0] + "::"]

    def idle(self, description: PluginDescription) -> str:
        """Return why plugins need not be in the menu of rqt: unused or not installed; "" where they should be."""
        if is_set_aside(description.file):
            return "; the file is laid aside"
        modules = {each.type.value.rpartition(".")[0] for each in description.classes}
        if self.facts.knows("modules") and modules.isdisjoint(self.facts.modules):
            return f"; but {in_ticks(sorted(modules))} is not installed either"
        return ""

    def odd(self) -> Iterator[tuple[PluginDescription, list[PluginDescription]]]:
        """Yield the descriptions in C++ that CMake alone exports, where package.xml has all others of the package."""
        cpp = [
            each
            for each in self.descriptions
            if each.is_indexed and any(found.base.value.startswith(CPP) for found in each.classes)
        ]
        listed = [each for each in cpp if each.is_for_rqt]
        for description in cpp:
            if listed and not description.is_for_rqt:
                yield description, listed
