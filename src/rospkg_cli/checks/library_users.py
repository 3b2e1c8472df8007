"""Rule input: who uses a package that has libraries alone, and so comes to what their code does."""

from __future__ import annotations

import re
from collections.abc import Iterator
from functools import cached_property

from ..languages.cpp.file import CppFile
from ..languages.python.file import PythonFile
from ..lazy_regex import regex
from ..light_dataclasses import dataclass
from ..package.cmake.cmake_facts import ANY
from ..package.package_facts import PackageFacts
from ..package.workspace import Workspace
from ..source import Span
from .python.installed_modules import InstalledModules
from .python.leading_names import definitions, leading_names
from .reached_modules import ReachedModules

LOADED = regex(r"\b\w+_(?:EXPORT|REGISTER|ADD)_\w+|\b(?:PYBIND11|BOOST_PYTHON)_MODULE|\bextern\s+\"C\"")
"""Macros of what others load by a name: no package that links the library is needed for that."""
SETUPS = ("setup.py", "setup.cfg", "pyproject.toml")


@dataclass(frozen=True)
class LibraryUsers:
    installed: InstalledModules
    reached: ReachedModules
    workspace: Workspace
    facts: PackageFacts
    sources: tuple[CppFile, ...] = ()

    def of(self, path: str, span: Span) -> tuple[PackageFacts, ...] | None:
        """Return the other packages here that may come to a place in a library; None where others may come to it.

        So it is where the package has programs, or launch files that use its modules, or where it is loaded by a name.
        """
        if not path.endswith(".py"):
            return tuple(self.linking()) if self.is_linked else None
        file, module = self.installed.modules.at(path), self.installed.names.get(path, "")
        if file is None or not module or not self.is_imported:
            return None
        leading = leading_names(file, span)
        if self.is_used_here(file, leading):
            tops = self.installed.tops
            return tuple(each for each in self.others if any(m.partition(".")[0] in tops for m, _ in each.taken_names))
        users = tuple(self.importing(file, module, leading))
        is_open = "__main__" in file.source.text or self.reached.is_wanted(path)
        return users if users or not is_open else None

    @property
    def others(self) -> Iterator[PackageFacts]:
        return (each for each in self.workspace.packages if each.name != self.facts.name)

    @cached_property
    def is_imported(self) -> bool:
        """Whether the package's modules are for those who import them: no entry point or launch file names one."""
        if not self.reached.is_library or self.facts.plugins:
            return False
        tops, files = "|".join(map(re.escape, sorted(self.installed.tops))), self.installed.files
        entry = re.compile(rf"(?<![\w.])(?:{tops})(?:\.\w+)*\s*:\s*[A-Za-z_]")
        if any(entry.search(files.readable_text(each)) for each in SETUPS if files.exists(each)):
            return False
        outer = (file for role, file in self.reached.run.files if role == "launch")
        names = (
            name
            for file in outer
            for each in file.imports
            for name in self.reached.imports.imported_by(each, file.path)
        )
        return self.installed.sources.keys().isdisjoint(names)

    @cached_property
    def is_linked(self) -> bool:
        """Whether the package's libraries are for those who link them: it offers headers, and nothing loads it."""
        facts = self.facts
        is_known = facts.unknown.isdisjoint(("executables", "components", "plugins", "modules"))
        others = (facts.executables, facts.misplaced_executables, facts.components, facts.plugins, facts.modules)
        is_loaded = any(others) or any(LOADED.search(each.source.text) for each in self.sources)
        return is_known and bool(facts.header_files) and not is_loaded

    def linking(self) -> Iterator[PackageFacts]:
        """Yield the packages that compile something and look for this one, or include a header of it."""
        name, offered = self.facts.name, self.facts.header_files
        for each in self.others:
            is_declared = any(need.name == name for need in each.dependencies)
            is_sought = each.is_ament and each.is_compiled and not each.sought_packages.isdisjoint((name, ANY))
            if (is_declared and is_sought) or offered & each.included_headers - each.header_files:
                yield each

    def importing(self, file: PythonFile, module: str, leading: frozenset[str]) -> Iterator[PackageFacts]:
        """Yield the packages that import what leads to a place: the module as a whole leads to all of it."""
        own = {each.name for each in definitions(file)}
        package, _, last = module.rpartition(".")
        for facts in self.others:
            if any(
                (package, last) == (home, name) or (home == module and (name in leading or name not in own))
                for home, name in facts.taken_names
            ):
                yield facts

    def is_used_here(self, file: PythonFile, leading: frozenset[str]) -> bool:
        """Return whether another module of the library imports one as a whole, or what leads to the place.

        Then whoever imports any part of the library may come to it.
        """
        last, own = file.path.rpartition("/")[2].removesuffix(".py"), {each.name for each in definitions(file)}
        others = (self.installed.modules.at(path) for path in self.installed.names if path != file.path)
        for each in (one for other in others if other is not None for one in other.imports):
            is_of_it = each.module.rpartition(".")[2] == last
            taken = [name for name in each.names if name in leading or name not in own] if is_of_it else []
            if taken or last in each.names or (is_of_it and not each.names):
                return True
        return False
