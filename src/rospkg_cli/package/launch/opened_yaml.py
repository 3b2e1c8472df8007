"""How launch files use YAML that rcl never reads: they open it for single values, or give a node its path to open."""

from __future__ import annotations

import ast
import posixpath
import re

from ...languages.python.file import PythonFile
from ...languages.python.nodes import last_name, nodes_of, nodes_of_kind
from ...lazy_regex import regex
from .file_references import FileReference
from .launch_file import LaunchFile
from .text import uncommented

OPENS = frozenset({"open", "caught"})
PARAMETERS = regex(r"(?i)param")
"""Of a controller's `params_file`, which rcl reads."""
READS = regex(
    r"open|(?:safe|full)_load|\w*(?:read|load|parse)_?\w*yaml\w*|\w*yaml_?(?:read|load|parse)\w*", re.IGNORECASE
)
"""Names of functions that open a file, or take YAML out of one."""
LOADS = regex(r"load|parse|read|config|yaml|copy|^get$|^dict$")
"""Names of functions that may return what is in a file."""
REWRITES = "RewrittenYaml"
"""It takes the path of its file, and nothing that was read."""


def is_handed_on(name: str, launch: LaunchFile, package: str) -> bool:
    """Return whether a launch file opens a file of a name in its package, and may give a node all that is in it."""
    opened = any(each.use in OPENS for each in references_to(name, launch, package)) or is_only_read(name, launch)
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
        return is_said(name, launch) and not is_only_read(name, launch)
    named = (each for each in found if each.use not in OPENS)
    return any(not any(span.contains(each.span) for span in values) for each in named)


def is_said(name: str, launch: LaunchFile) -> bool:
    """Return whether a launch file has a file's name somewhere else than in a sentence."""
    if launch.python is not None:
        return bool(texts_of(name, launch.python))
    return name in uncommented(launch.path, launch.source.text)


def is_only_read(name: str, launch: LaunchFile) -> bool:
    """Return whether a launch file gives a file's name, in whatever folder, to nothing but functions that read it."""
    texts = texts_of(name, launch.python) if launch.python is not None and name in launch.source.text else []
    if launch.python is None or not texts:
        return False
    tree = launch.python.tree
    calls = (each for each in nodes_of_kind(tree, ast.Call) if READS.fullmatch(last_name(each.func)))
    read = {id(node) for call in calls for node in nodes_of(call)}
    holding = {id(node): each for each in nodes_of_kind(tree, ast.Assign) for node in nodes_of(each.value)}
    loose = [each for each in texts if id(each) not in read]
    targets = [target for each in loose if id(each) in holding for target in holding[id(each)].targets]
    held = {each.id for each in targets if isinstance(each, ast.Name)}
    if any(id(each) not in holding for each in loose) or len(held) < len(targets):
        return False
    uses = [each for each in nodes_of_kind(tree, ast.Name) if each.id in held and isinstance(each.ctx, ast.Load)]
    return {each.id for each in uses} == held and all(id(each) in read for each in uses)


def texts_of(name: str, file: PythonFile) -> list[ast.Constant]:
    """Return the texts of Python that end a path with a file's name."""
    every = nodes_of_kind(file.tree, ast.Constant)
    texts = ((each, each.value) for each in every if isinstance(each.value, str))
    return [each for each, text in texts if posixpath.basename(text) == name and " " not in text]


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
    name = last_name(node.func) if isinstance(node, ast.Call) else ""
    return name != REWRITES and LOADS.search(name) is not None
