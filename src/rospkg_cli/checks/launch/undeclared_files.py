"""Missing files that a node gets as a parameter or argument which it is not shown to read (LCH003)."""

from __future__ import annotations

import re
from collections.abc import Iterator

from ...lazy_regex import regex
from ...package.launch.launched_parts import LaunchedNode
from ...package.package_facts import PackageFacts
from ...ros.known_nodes import known_nodes, known_parameters, newer_parameters
from ...source import Span
from .launch_context import LaunchContext
from .missing_reference import MissingReference
from .unread_arguments import why_unread

OPENED = regex(r"file|path|ya?ml|(?:^|[_./])(?:map|ur[li])(?:$|[_./])", re.IGNORECASE)
"""Names of parameters by which a node that is not known opens what it is given."""


def undeclared_for(scope: LaunchContext, missing: MissingReference) -> str:
    """Return why nothing opens a file: each place gives it to a node as a parameter that it lacks; else ""."""
    if missing.use in ("include", "open"):
        return ""
    reasons = [given_in_vain(scope, span) for span in (missing.span, *missing.other_spans)]
    return reasons[0] if all(reasons) else ""


def given_in_vain(scope: LaunchContext, place: Span) -> str:
    """Return the reason for one place, where all nodes that get the value there lack the parameter, or the word."""
    nodes = scope.file.nodes
    reasons = [lack_of(scope, node, name) for node in nodes for name in names_at(node, place)]
    given = [node for node in nodes if any(each.span.contains(place) for each in node.arguments)]
    reasons += [why_unread(scope, node, place) for node in given]
    return reasons[0] if reasons and all(reasons) else ""


def is_written_in_vain(scope: LaunchContext, place: Span) -> bool:
    """Return whether a text stands in the only node that gets it, as a parameter that the node lacks."""
    inside = any(each.span.contains(place) for each in scope.file.nodes)
    return inside and bool(given_in_vain(scope, place))


def names_at(node: LaunchedNode, place: Span) -> Iterator[str]:
    """Yield the names of the parameters that a node is given the text at a place for; "" for what is not literal."""
    for each in node.parameters:
        if each.file is not None and each.file.span.contains(place):
            yield ""
        for name, value in each.values:
            if value.span.contains(place):
                yield name.literal or ""


def lack_of(scope: LaunchContext, node: LaunchedNode, name: str) -> str:
    """Return why a node does not read a parameter; "" where it may: where its code, a table or the name says so."""
    package = node.package.literal if node.package is not None else None
    facts = scope.package if package == scope.package.name else scope.workspace.named(package or "")
    if not name:
        return ""
    if facts is not None and is_built_here(node, facts):
        is_declared = any(one.fits(name) for one in facts.parameters)
        return "" if is_declared else f"but no code of `{facts.name}` declares `{name}`"
    if facts is None and package and known_parameters(package):
        return "" if is_known_to(package, name) else f"but `{package}` has no parameter `{name}`"
    return "" if OPENED.search(name) else f"but nothing is shown to open what `{name}` is"


def is_known_to(package: str, name: str) -> bool:
    """Return whether a well-known package declares a parameter; with a dot it may be that of a plugin of another."""
    plugins = {each for packages in known_nodes().values() for each in packages} if "." in name else set()
    names = (name, name.rpartition(".")[2]) if "." in name else (name,)
    tables = (one for each in (package, *plugins) for one in (*known_parameters(each), *newer_parameters(each)))
    return any(one.fits(each) for one in tables for each in names)


def is_built_here(node: LaunchedNode, facts: PackageFacts) -> bool:
    """Return whether a node is a program or a component that the sources of a package make."""
    program = node.executable.literal if node.executable is not None else None
    component = node.plugin.literal if node.plugin is not None else None
    return program in facts.executables | facts.misplaced_executables or component in facts.components
