"""Rule input: packages that code looks up and that do not exist, where the name is near to that of one that does."""

from __future__ import annotations

import ast
from collections.abc import Iterator

from ..languages.cpp.file import CppFile
from ..languages.python.guarded_nodes import guarded_nodes
from ..languages.python.nodes import last_name, nodes_of
from ..languages.python.unreached_places import is_unreached
from ..light_dataclasses import dataclass
from ..package.file_role import role_of
from ..package.package_facts import PackageFacts
from ..package.workspace import Workspace
from ..ros.names import NameKind
from ..source import Span
from ..suggest import near_names, nearest, slips
from .cpp.share_names import all_share_names
from .python.run_imports import RunImports
from .share_lookup_calls import CATCHES, LOOKUPS, literal_of, looking_up

SHORTEST = len("nav2")
"""Of a package's name that is compared with all known ones."""


@dataclass(frozen=True, slots=True)
class UnknownShare:
    path: str
    span: Span
    """Of the package's name, between its quotes."""
    name: str
    near: str
    is_caught: bool = False
    """Whether code goes on without the package."""


@dataclass(frozen=True)
class UnknownSharePackages:
    run: RunImports
    facts: PackageFacts
    workspace: Workspace
    sources: tuple[CppFile, ...] = ()

    def found(self) -> Iterator[UnknownShare]:
        yield from self.unknown_in_cpp()
        for file in looking_up(self.run):
            caught = set(guarded_nodes(file.tree.body, CATCHES))
            for node in nodes_of(file.tree):
                if not isinstance(node, ast.Call) or last_name(node.func) not in LOOKUPS:
                    continue
                name, is_caught = literal_of(node), id(node) in caught
                near = self.intended(str(name.value), is_caught) if name is not None else None
                if name is not None and near and not is_unreached(file, file.span(name)):
                    whole = Span(file.span(name).start + 1, file.span(name).end - 1)
                    yield UnknownShare(file.path, whole, str(name.value), near, is_caught)

    def unknown_in_cpp(self) -> Iterator[UnknownShare]:
        for source in self.sources:
            for name, span, is_caught in all_share_names(source) if role_of(source.path) == "run" else ():
                if near := self.intended(name, is_caught):
                    yield UnknownShare(source.path, span, name, near, is_caught)

    def intended(self, name: str, is_caught: bool) -> str | None:
        """Return the package that is probably intended by a name.

        Where code goes on without the package, only one of the workspace counts, for a plain typing error.
        """
        near = self.near_package(name)
        here = (self.facts.name, *(each.name for each in self.workspace.packages))
        return near if near and not (is_caught and slips(name, here) != [near]) else None

    def near_package(self, name: str) -> str | None:
        """Return the package whose name is near to an unknown one; None where the name is known, or near to none or
        several.
        """
        known = {*self.workspace.names, *(each.name for each in self.facts.dependencies), self.facts.name}
        is_own = name == self.facts.name.lower().replace("-", "_")  # what its name should be: XML101
        if is_own or name in known or self.workspace.is_available(name) or self.workspace.is_listed(name):
            return None
        if self.workspace.index.kind_of(name) is NameKind.PACKAGE or self.workspace.is_marked(name):
            return None
        if near := nearest(name, known):
            return near
        found = near_names(name, self.workspace.index.packages, 1) if len(name) > SHORTEST else []
        return found[0] if len(found) == 1 else None
