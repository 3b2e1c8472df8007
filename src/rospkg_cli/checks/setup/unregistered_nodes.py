"""Rule input: nodes with a `main` that no entry point starts (SET106)."""

from __future__ import annotations

import ast
import posixpath
import re
from collections.abc import Iterator
from functools import cached_property

from ...files import PackageFiles
from ...languages.python.evaluate.values import Mapping, Sequence
from ...languages.python.file import PythonFile
from ...languages.python.nodes import nodes_of
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.file_role import role_of
from ...source import Span
from .missing_modules import MissingModules
from .module_exports import absolute
from .python_package import PythonPackage

SCRIPTS = "console_scripts"
ASIDE = regex(r"(?:^|_)(?:tests?|demos?|examples?|utils?|tools?|old|backup|bak|copy)(?:_|\d*$)|^_")
"""Names of modules that are for import, or for developers."""
TRIED = regex(r"(?:^|_)(?:tests?|demos?|examples?)(?:_|\d*$)")
"""Those of these names that the main node of a package may have, if it has no other."""
TESTS = regex(r"^(?:def test_|(?:import|from) (?:unittest|pytest)\b)", re.MULTILINE)

RUNS = tuple(".md .rst .txt .sh .bash .py .xml .yaml .yml .cfg .toml .service Makefile Dockerfile".split())


@dataclass(frozen=True, slots=True)
class UnregisteredNode:
    """A node without an entry point."""

    module: str
    path: str
    main: Span
    """Of the name `main` in its definition."""


@dataclass(frozen=True)
class UnregisteredNodes:
    package: PythonPackage
    files: PackageFiles

    @property
    def starts_nothing(self) -> bool:
        """Whether the package has no entry point at all, so that none of its nodes can be started."""
        return not self.package.setup.entry_points

    @cached_property
    def scripts(self) -> Sequence | None:
        """The list of console scripts, as it is written out in setup.py."""
        value = self.package.setup.value("entry_points")
        found = value.get(SCRIPTS) if isinstance(value, Mapping) else None
        return found if isinstance(found, Sequence) else None

    def found(self) -> Iterator[UnregisteredNode]:
        setup = self.package.setup
        if self.scripts is None or not setup.knows("entry_points") or self.package.extends_command_line:
            return
        if any(each.fault or each.intended_group for each in setup.entry_points):
            return
        known = {entry.module for entry in setup.entry_points}
        modules = MissingModules(self.package)
        missing = (module for module in known if module and modules.has(module))
        intended = set(map(modules.suggestion, missing))  # which SET101 reports
        nodes = {m: main for m in setup.modules if m not in known and (main := self.main_of(m)) is not None}
        for module, main in nodes.items():
            folder = module.rpartition(".")[0]
            if module in intended or self.is_started(module.rpartition(".")[2]):
                continue
            has_others = any(each.module.rpartition(".")[0] == folder for each in self.package.nodes)
            file = self.package.modules.at(setup.modules[module])
            if file is not None and (has_others or not known) and not self.is_used(module):
                yield UnregisteredNode(module, file.path, main)

    def is_started(self, name: str) -> bool:
        """Return whether a launch file of the workspace starts an executable: LCH002 reports one that is not there."""
        return bool(self.package.workspace.having("started_nodes", self.package.name, name))

    def main_of(self, module: str) -> Span | None:
        """Return where a module that is a node defines `main`."""
        file = self.package.modules.at(self.package.setup.modules[module])
        return file.functions.get("main") if file is not None and self.package.is_node(module) else None

    def is_used(self, module: str) -> bool:
        """Return whether a module is for import or for developers, or another file names it."""
        path = self.package.setup.modules[module]
        if module in self.imported or (ASIDE.search(module.rpartition(".")[2]) and not self.is_all(module, path)):
            return True
        return any(posixpath.basename(path) in text for text in self.texts)

    def is_all(self, module: str, path: str) -> bool:
        """Return whether a node that is named like a test, and holds no test, is the only purpose of a package."""
        rest, count = TRIED.subn("x", module.rpartition(".")[2])
        is_tried = self.starts_nothing and count > 0 and not ASIDE.search(rest)
        return is_tried and not TESTS.search(self.files.readable_text(path))

    @cached_property
    def imported(self) -> frozenset[str]:
        """The modules that others of the package import."""
        found: set[str] = set()
        for path in self.package.on_disk.values():
            file = self.package.modules.at(path)
            for each in file.imports if file is not None else ():
                module = absolute(each, path, self.package.setup)
                found |= {module, *(f"{module}.{name}" for name in each.names)}
        return frozenset(found)

    @cached_property
    def texts(self) -> tuple[str, ...]:
        """The texts that may start a file by its name."""
        paths = (path for path in self.files.paths if path.endswith(RUNS) and role_of(path) != "test")
        return tuple(map(self.files.readable_text, paths))


def starts_itself(file: PythonFile) -> bool:
    """Return whether a file calls `main` where it is run as a script."""
    for node in file.tree.body:
        if isinstance(node, ast.If) and any(
            isinstance(e, ast.Name) and e.id == "__name__" for e in nodes_of(node.test)
        ):
            calls = (each.func for each in nodes_of(node) if isinstance(each, ast.Call))
            return any(isinstance(each, ast.Name) and each.id == "main" for each in calls)
    return False
