"""Parameter files that launch files hand to well-known ones by an argument that these lack: nothing opens them."""

from __future__ import annotations

import ast
import posixpath
import re
from collections.abc import Iterable, Iterator

from ...languages.python.nodes import nodes_of_kind
from ...languages.python.unread_values import only_read_in
from ...package.launch.file_references import first_in
from ...package.launch.launch_file import LaunchFile
from ...package.launch.launched_parts import Include
from ...package.launch.live_text import without
from ...package.launch.never_launched import never_launched
from ...package.launch.text import uncommented
from ...package.launch.uncalled_functions import uncalled_functions
from ...package.workspace import Workspace
from ...ros.known_launch_files import known_arguments
from ...source import Span
from ..yaml_elsewhere import is_named_elsewhere
from .parameter_file_use import ParameterFileUse


def is_ignored(use: ParameterFileUse, launches: Iterable[LaunchFile]) -> bool:
    """Return whether all that names a file are arguments which the included launch files do not have."""
    stem = use.file.path.rpartition("/")[2].rpartition(".")[0]
    ignoring = {each.path: spans for each in launches if (spans := list(ignored_values(each, use.workspace)))}
    if not ignoring or use.is_handed or is_named_elsewhere(stem, use.package, use.workspace):
        return False
    word = re.compile(rf"[\"'/]{re.escape(stem)}\.")
    naming = {path for path in use.files.paths if use.naming(path)}
    rest = (rest_of(each, ignoring[each.path]) for each in launches if each.path in naming & ignoring.keys())
    return bool(naming) and naming <= ignoring.keys() and not any(map(word.search, rest))


def ignored_values(launch: LaunchFile, workspace: Workspace) -> Iterator[Span]:
    """Yield the values that includes give to arguments which nothing takes: not the file, nor another that it includes.

    A launch configuration that an include sets stays for what comes behind it.
    """
    taken = [taken_by(each, launch, workspace) for each in launch.includes]
    if not all(taken):
        return
    used = {part.literal for each in launch.configurations() for part in each.arguments[:1]}
    names = frozenset().union(*taken) | used
    for include in launch.includes:
        yield from (value.span for key, value in include.arguments if key.literal and key.literal not in names)


def taken_by(include: Include, launch: LaunchFile, workspace: Workspace) -> frozenset[str]:
    """Return the arguments of an included file of a well-known package; none where they are not known."""
    named = first_in(include.file, posixpath.dirname(launch.path))
    if named is None or not named.package or workspace.named(named.package) is not None:
        return frozenset()
    return known_arguments(named.package, named.path)


def rest_of(launch: LaunchFile, ignored: Iterable[Span]) -> str:
    """Return the text of a launch file without some values, and without what is only made for them or to be printed."""
    spans = list(ignored)
    if launch.python is not None:
        spans += (launch.python.span(each) for each in nodes_of_kind(launch.python.tree, ast.Call) if is_print(each))
        spans += (*never_launched(launch.python), *uncalled_functions(launch.python))
        spans += only_read_in(launch.python, spans)
    return uncommented(launch.path, without(launch.source.text, spans))


def is_print(call: ast.Call) -> bool:
    return isinstance(call.func, ast.Name) and call.func.id == "print"
