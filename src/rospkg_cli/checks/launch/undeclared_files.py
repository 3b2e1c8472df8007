"""Missing files that are the value of a parameter of a node of the workspace that its code never asks for."""

from __future__ import annotations

from collections.abc import Iterator

from ...package.launch.launch_file import LaunchedNode
from ...package.package_facts import PackageFacts
from ...source import Span
from .missing_references import LaunchContext, MissingReference


def undeclared_for(scope: LaunchContext, missing: MissingReference) -> str:
    """Return why nothing opens a file: each place gives it to a node as a parameter that it lacks; else ""."""
    reasons = [given_in_vain(scope, span) for span in (missing.span, *missing.other_spans)]
    return reasons[0] if all(reasons) else ""


def given_in_vain(scope: LaunchContext, place: Span) -> str:
    """Return the reason for one place, where all nodes that get the value there lack the parameter."""
    reasons = [lack_of(scope, node, name) for node in scope.file.nodes for name in names_at(node, place)]
    return reasons[0] if reasons and all(reasons) else ""


def names_at(node: LaunchedNode, place: Span) -> Iterator[str]:
    """Yield the names of the parameters that a node is given the text at a place for; "" for what is not literal."""
    for each in node.parameters:
        if each.file is not None and each.file.span.contains(place):
            yield ""
        for name, value in each.values:
            if value.span.contains(place):
                yield name.literal or ""


def lack_of(scope: LaunchContext, node: LaunchedNode, name: str) -> str:
    """Return that the code of a node, which is here, neither declares nor gets a parameter; "" where it may."""
    package = node.package.literal if node.package is not None else None
    facts = scope.package if package == scope.package.name else scope.workspace.named(package or "")
    if not name or facts is None or not is_built_here(node, facts):
        return ""
    is_declared = any(one.fits(name) for one in facts.parameters)
    return "" if is_declared else f"but no code of `{facts.name}` declares `{name}`"


def is_built_here(node: LaunchedNode, facts: PackageFacts) -> bool:
    """Return whether a node is a program or a component that the sources of a package make."""
    program = node.executable.literal if node.executable is not None else None
    component = node.plugin.literal if node.plugin is not None else None
    return program in facts.executables | facts.misplaced_executables or component in facts.components
