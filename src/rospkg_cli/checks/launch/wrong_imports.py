"""What a Python launch file imports from launch and launch_ros, against what these export."""

from __future__ import annotations

import ast
from collections.abc import Iterator

from ...languages.python.file import PythonFile
from ...languages.python.nodes import nodes_of
from ...light_dataclasses import dataclass
from ...ros.launch_exports import EXPORTS, exporting_module
from ...source import Span
from ...suggest import nearest

OPEN = frozenset({"launch_ros.parameter_descriptions", "ament_index_python.packages"})
"""Modules that are one file, with whatever it imports itself."""


@dataclass(frozen=True, slots=True)
class WrongImport:
    """A name that the module does not export; it is exported by `home`, or `near` is similar."""

    name: str
    module: str
    span: Span
    home: str = ""
    near: str = ""


def wrong_imports(file: PythonFile) -> Iterator[WrongImport]:
    """Yield imports of names that another module of launch has, or that are misspelt."""
    meant: dict[tuple[str, str], tuple[str, str]] = {}
    optional = {each.module for each in file.imports if each.is_optional}
    for node in nodes_of(file.tree):
        if not isinstance(node, ast.ImportFrom) or node.level or not node.module:
            continue
        module = node.module
        if module not in EXPORTS or module in OPEN or module in optional:
            continue
        for alias in node.names:
            if alias.name in EXPORTS[module] or alias.name == "*":
                continue
            start = file.span(alias).start
            span = Span(start, start + len(alias.name))
            if (module, alias.name) not in meant:
                meant[module, alias.name] = meant_by(module, alias.name)
            home, near = meant[module, alias.name]
            if home or near:
                yield WrongImport(alias.name, module, span, home, near)


def meant_by(module: str, name: str) -> tuple[str, str]:
    """Return the module that exports a name, and else the name of this module that is nearest; "" for none."""
    home = exporting_module(name)
    return home, "" if home or name.islower() else nearest(name, EXPORTS[module], 1) or ""
