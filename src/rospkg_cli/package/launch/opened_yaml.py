"""How launch files use YAML that rcl never reads: they open it for single values, or give a node its path to open."""

from __future__ import annotations

import ast
import posixpath

from ...languages.python.file import PythonFile
from ...languages.python.nodes import last_name, nodes_of, nodes_of_kind
from ...lazy_regex import regex
from .file_references import FileReference
from .launch_file import LaunchFile
from .text import uncommented

OPENS = frozenset({"open", "caught"})
PARAMETERS = regex(r"(?i)param")
"""Of a controller's `params_file`, which rcl reads."""
LOADS = regex(r"load|parse|read|config|yaml|copy|^get$|^dict$")
"""Names of functions that may return what is in a file."""


def is_handed_on(name: str, launch: LaunchFile, package: str) -> bool:
    """Return whether a launch file opens a file of a name in its package, and may give a node all that is in it."""
    opened = any(each.use in OPENS for each in references_to(name, launch, package))
    return opened and launch.python is not None and hands_on(launch.python)


def is_given(name: str, launch: LaunchFile, package: str) -> bool:
    """Return whether a launch file gives anything the path of a file, other than a parameter for what a node opens."""
    values = tuple(
        value.span
        for node in launch.nodes
        for entry in node.parameters
        for key, value in entry.values
        if key.literal and not PARAMETERS.search(key.literal)
    )
    found = references_to(name, launch, package)
    if not found:
        return name in uncommented(launch.path, launch.source.text)
    named = (each for each in found if each.use not in OPENS)
    return any(not any(span.contains(each.span) for span in values) for each in named)


def references_to(name: str, launch: LaunchFile, package: str) -> list[FileReference]:
    paths = (*launch.every_path, *launch.caught_paths)
    return [each for each in paths if each.package in ("", package) and posixpath.basename(each.path) == name]


def hands_on(file: PythonFile) -> bool:
    """Return whether a node may get all that is in a file: as the dict, by `**`, or as what a function returns."""
    bound = {
        target.id: each.value
        for each in nodes_of_kind(file.tree, ast.Assign)
        for target in each.targets
        if isinstance(target, ast.Name)
    }
    given = (each.value for each in nodes_of_kind(file.tree, ast.keyword) if each.arg == "parameters")
    return any(may_be_whole(entry, bound) for value in given for entry in entries_of(value))


def entries_of(value: ast.expr) -> list[ast.expr]:
    if isinstance(value, ast.BinOp):
        return [*entries_of(value.left), *entries_of(value.right)]
    return value.elts if isinstance(value, ast.List | ast.Tuple) else [value]


def may_be_whole(entry: ast.expr, bound: dict[str, ast.expr]) -> bool:
    match entry:
        case ast.Dict(keys=keys):
            return None in keys
        case ast.Subscript() | ast.Starred() | ast.ListComp():
            return True
        case ast.Name(id=name):
            value = bound.get(name)
            return value is None or any(holds_yaml(each) for each in (value, *nodes_of(value)))
        case ast.Call():
            return holds_yaml(entry)
    return False


def holds_yaml(node: ast.AST) -> bool:
    if isinstance(node, ast.Subscript):
        return True
    return isinstance(node, ast.Call) and LOADS.search(last_name(node.func)) is not None
