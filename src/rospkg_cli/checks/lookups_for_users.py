"""Packages that the functions of a library look up for those who call them: who calls has what is looked for."""

from __future__ import annotations

import ast
from collections.abc import Iterator

from ..languages.python.file import PythonFile
from ..languages.python.nodes import FunctionNode, nodes_of
from ..light_dataclasses import dataclass
from ..package.package_facts import PackageFacts
from ..package.workspace import Workspace
from ..source import Span
from .installed_modules import InstalledModules
from .reached_modules import ReachedModules
from .workspace.wanted_packages import is_used

Definition = FunctionNode | ast.ClassDef
ROUND = "; that package uses this library, to declare it here would make a circle: let those declare it who call this"
CIRCLE = "; that package starts programs of this one, to declare it here would make a circle: let a parameter give it"
THEIRS = "; this library has no program, and each package that calls this declares or uses it"


@dataclass(frozen=True)
class LookupsForUsers:
    installed: InstalledModules
    reached: ReachedModules
    workspace: Workspace
    facts: PackageFacts

    def why_mild(self, path: str, span: Span, name: str) -> str:
        """Return what is said of a look-up for another package of the workspace, in a library without programs."""
        file, other = self.installed.modules.at(path), self.workspace.named(name)
        module = self.installed.names.get(path, "")
        if file is None or other is None or not module or not self.reached.is_library:
            return ""
        users = [*self.users(file, module, span)]
        if any(each.name == name for each in users):
            return ROUND
        is_here = self.is_used_here(file, leading_names(file, span))
        is_theirs = bool(users) and not is_here and all(declares(each, name) or is_used(name, each) for each in users)
        return THEIRS if is_theirs else ""

    def users(self, file: PythonFile, module: str, span: Span) -> Iterator[PackageFacts]:
        """Yield the other packages that import what leads to a place: the module as a whole leads to all of it."""
        leading, own = leading_names(file, span), {each.name for each in definitions(file)}
        package, _, last = module.rpartition(".")
        for facts in self.workspace.packages:
            taken = facts.taken_names if facts.name != self.facts.name else ()
            if any(
                (package, last) == (home, name) or (home == module and (name in leading or name not in own))
                for home, name in taken
            ):
                yield facts

    def is_used_here(self, file: PythonFile, leading: frozenset[str]) -> bool:
        """Return whether another module of the library imports one as a whole, or what leads to the place.

        Who calls that is not seen.
        """
        last, own = file.path.rpartition("/")[2].removesuffix(".py"), {each.name for each in definitions(file)}
        others = (self.installed.modules.at(path) for path in self.installed.names if path != file.path)
        for each in (one for other in others if other is not None for one in other.imports):
            is_of_it = each.module.rpartition(".")[2] == last
            taken = [name for name in each.names if name in leading or name not in own] if is_of_it else []
            if taken or last in each.names or (is_of_it and not each.names):
                return True
        return False


def definitions(file: PythonFile) -> list[Definition]:
    return [each for each in file.tree.body if isinstance(each, Definition)]


def leading_names(file: PythonFile, span: Span) -> frozenset[str]:
    """Return the names at the top level of a module that lead to a place in a function of it."""
    around = {each.name for each in definitions(file) if file.span(each).holds(span)}
    if not around:
        return frozenset(each.name for each in definitions(file))
    while more := {each.name for each in definitions(file) if mentions(each, around)} - around:
        around |= more
    return frozenset(around)


def mentions(node: Definition, names: set[str]) -> bool:
    return any(isinstance(each, ast.Name) and each.id in names for each in nodes_of(node))


def declares(facts: PackageFacts, name: str) -> bool:
    return any(need.name == name and need.certain for need in facts.dependencies)


def starts_programs_of(facts: PackageFacts, name: str) -> bool:
    """Return whether launch files of a package start programs of another one, and so need it, declared or not."""
    return any(package == name for package, _ in facts.started_nodes)
