"""Names that a Python launch file imports from a module of launch or launch_ros that does not have them (LCH013)."""

from __future__ import annotations

import ast
from collections.abc import Iterator

from ...languages.python.file import PythonFile
from ...languages.python.nodes import nodes_of, nodes_of_kind
from ...light_dataclasses import dataclass
from ...ros.launch_exports import EXPORTS, exporting_module
from ...source import Span
from ...suggest import near_names, nearest

OPEN = frozenset({"launch_ros.parameter_descriptions", "ament_index_python.packages"})
"""Modules that are one file, with whatever it imports itself."""
TOPS = frozenset({"launch", "launch_ros"})


@dataclass(frozen=True, slots=True)
class WrongImport:
    """A name that the module does not export; it is exported by `home`, or `near` is similar."""

    name: str
    module: str
    span: Span
    home: str = ""
    near: str = ""
    is_attribute: bool = False
    """Whether it is read from the module, and not imported: `launch.substitution.LaunchConfiguration`."""


def wrong_imports(file: PythonFile) -> Iterator[WrongImport]:
    """Yield imports of names that another module of launch has, or that are misspelt, and from misspelt modules."""
    optional = {each.module for each in file.imports if each.is_optional}
    for node in nodes_of(file.tree):
        if isinstance(node, ast.ImportFrom) and not node.level and node.module and node.module not in optional:
            module = node.module
            near = "" if module in EXPORTS else nearest(module, siblings(module), 2) or ""
            for alias in node.names:
                home, intended = (near if alias.name in EXPORTS.get(near, ()) else "", "")
                if module in EXPORTS and module not in OPEN and alias.name not in (*EXPORTS[module], "*"):
                    home, intended = intended_by(module, alias.name)
                if home or intended:
                    start = file.span(alias).start
                    yield WrongImport(alias.name, module, Span(start, start + len(alias.name)), home, intended)


def wrong_attributes(file: PythonFile) -> Iterator[WrongImport]:
    """Yield the misspelt modules and names behind `import launch`, of `launch` and of its modules."""
    tops = {top for each in file.imports if not each.names and (top := each.module.partition(".")[0]) in TOPS}
    for node in nodes_of_kind(file.tree, ast.Attribute) if tops else ():
        module = dotted(node.value)
        if module.partition(".")[0] in tops and (module in TOPS or module in EXPORTS):
            inside = {each[len(module) + 1 :] for each in EXPORTS if each.startswith(f"{module}.")}
            known = {*EXPORTS.get(module, ()), *(each.partition(".")[0] for each in inside)}
            alike = [each for each in known if each.islower() == node.attr.islower()]
            near = near_names(node.attr, alike, 1) if node.attr not in known else []
            if len(near) == 1:
                end = file.span(node).end
                yield WrongImport(node.attr, module, Span(end - len(node.attr), end), "", near[0], True)


def dotted(node: ast.expr) -> str:
    """Return the dotted name that an expression is; "" for anything else."""
    if isinstance(node, ast.Attribute):
        before = dotted(node.value)
        return before and f"{before}.{node.attr}"
    return node.id if isinstance(node, ast.Name) else ""


def siblings(module: str) -> list[str]:
    """Return the known modules of launch and launch_ros in the same package as one."""
    package = module.rpartition(".")[0]
    return [each for each in EXPORTS if package in TOPS and each.rpartition(".")[0] == package]


def intended_by(module: str, name: str) -> tuple[str, str]:
    """Return the module that exports a name, and else the name of this module that it is a slip of; "" for none.

    A newer launch may export what only resembles a known name.
    """
    home = exporting_module(name)
    near = [] if home or name.islower() else near_names(name, EXPORTS[module])
    return home, near[0] if len(near) == 1 else ""
