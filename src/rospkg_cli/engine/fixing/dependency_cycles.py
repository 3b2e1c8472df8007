"""Fixes that would make packages wait for each other: each is right alone, and colcon can't order both."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from ...finding import Edit, Finding, Fix
from ...lazy_regex import regex
from ...tree import Tree

MANIFEST = "package.xml"
NAME = regex(r"<name>\s*([^<\s]+)\s*</name>")
DEPENDENCY = regex(r"<(?!doc_)\w*depend\b[^>]*>\s*([^<\s]+)\s*<")

Graph = dict[str, set[str]]
"""The names of packages, each with those that it waits for."""


def closing_cycles(tree: Tree, folders: Sequence[str], findings: Sequence[Finding]) -> Iterator[tuple[Finding, str]]:
    """Yield the fixes that close a cycle of dependencies with those before them, each with why it is not made."""
    added = [(each, [*new_dependencies(each.fix)]) for each in findings if each.fix]
    if not any(new for _, new in added):
        return
    texts = dict(manifests(tree, folders))
    names = {path: found[1] for path, text in texts.items() if (found := NAME.search(text))}
    graph: Graph = {names[path]: {*DEPENDENCY.findall(text)} for path, text in texts.items() if path in names}
    for finding, new in added:
        edges = [(names[path], name) for path, name in new if path in names and name in graph]
        edges = [(package, name) for package, name in edges if name not in graph[package]]  # written anew, not added
        cycle = next((edge for edge in edges if waits_for(graph, edge[1], edge[0])), None)
        if cycle is not None:
            yield finding, f"`{cycle[1]}` depends on `{cycle[0]}`, or is to: colcon could build neither"
            continue
        for package, name in edges:
            graph[package].add(name)


def new_dependencies(fix: Fix | None) -> Iterator[tuple[str, str]]:
    """Yield the dependencies that a fix adds, each with the path of its package.xml."""
    for operation in fix.operations if fix else ():
        if isinstance(operation, Edit) and operation.path.rpartition("/")[2] == MANIFEST:
            yield from ((operation.path, name) for name in DEPENDENCY.findall(operation.text))


def manifests(tree: Tree, folders: Sequence[str]) -> Iterator[tuple[str, str]]:
    for folder in folders:
        path = f"{folder}/{MANIFEST}" if folder else MANIFEST
        try:
            yield path, tree.entry(path).text.text
        except (OSError, UnicodeError):
            continue


def waits_for(graph: Mapping[str, set[str]], package: str, other: str) -> bool:
    """Return whether a package waits for another one, or is it."""
    seen: set[str] = set()
    waiting = [package]
    while waiting:
        name = waiting.pop()
        if name == other:
            return True
        if name not in seen:
            seen.add(name)
            waiting += graph.get(name, ())
    return False
