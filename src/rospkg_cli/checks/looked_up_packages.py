"""Packages whose share directory or prefix installed code looks for, and that package.xml does not declare (DEP116)."""

from __future__ import annotations

import ast
from collections.abc import Iterable, Iterator

from ..languages.python.guarded_nodes import guarded_nodes
from ..languages.python.nodes import last_name, nodes_of, nodes_of_kind
from ..lazy_regex import regex
from ..light_dataclasses import dataclass, replace
from ..package.file_role import role_of
from ..package.launch.asked_packages import asked_in
from ..package.workspace import Workspace
from ..ros.names import NameKind
from ..source import Span
from .cpp.share_names import share_names
from .depends.declared_dependencies import DeclaredDependencies
from .depends.undeclared_imports import ImportDependencies
from .depends.undeclared_launch_packages import LaunchDependencies
from .lookups_for_users import LookupsForUsers
from .share_lookup_calls import CATCHES, LOOKUPS, literal_of
from .share_lookups import ShareLookups
from .unstarted_programs import UNSTARTED

NAME = regex(r"[a-z][a-z0-9_]+")
LEFT, UNCOMPILED = "; nothing starts or imports this module", "; no target compiles this file"


@dataclass(frozen=True, slots=True)
class LookUp:
    path: str
    span: Span
    is_chosen: bool = False
    """Whether an `else` looks for another package in its place."""
    why_seldom: str = ""
    """The end of a message that says why a place matters less: it seldom runs, only those who have the package run it,
    or no target compiles it; "" for others.
    """


@dataclass(frozen=True)
class LookedUpPackages:
    lookups: ShareLookups
    imports: ImportDependencies
    launch: LaunchDependencies
    users: LookupsForUsers | None = None

    @property
    def declared(self) -> DeclaredDependencies:
        return self.imports.declared

    def is_unstarted(self, path: str) -> bool:
        """Return whether a file is only of programs that nothing starts, while others are started."""
        return self.imports.programs is not None and self.imports.programs.has(path)

    def undeclared(self) -> dict[str, list[LookUp]]:
        """Return each package with its places, but for what is imported, included or launched as well.

        An unknown package counts where a listed repository is not here, as that may hold it.
        """
        workspace = self.declared.workspace
        found: dict[str, list[LookUp]] = {}
        for name, place in self.all() if self.declared.is_checked else ():
            kind = workspace.kind_of(name)
            is_elsewhere = may_be_elsewhere(workspace, name)
            if (kind is NameKind.PACKAGE or is_elsewhere) and not self.declared.has_to_run(name):
                found.setdefault(name, []).append(place)
        if not found:
            return found
        found = {name: self.met_first(places) for name, places in found.items()}
        others = self.imports.undeclared("run").keys() | self.launch.missing(tests=False).keys() | self.included
        return {name: places for name, places in found.items() if name not in others}

    def met_first(self, places: list[LookUp]) -> list[LookUp]:
        """Return places, first those that run; one under a switch that is off does not."""
        off = ((each, each.why_seldom or self.lookups.why_off(each.path, each.span)) for each in places)
        places = [replace(each, why_seldom=why) for each, why in off]
        return sorted(places, key=lambda each: bool(each.why_seldom))

    def all(self) -> Iterator[tuple[str, LookUp]]:
        """Yield the literal names that modules and C++ look for, unless they catch that a package is not there."""
        for file in self.lookups.modules:
            chosen, asked = set(alternatives(file.tree)), tuple(asked_in(file))
            caught = set(guarded_nodes(file.tree.body, CATCHES)) if role_of(file.path) == "run" else None
            for call in nodes_of_kind(file.tree, ast.Call) if caught is not None else ():
                name = literal_of(call) if last_name(call.func) in LOOKUPS and id(call) not in (caught or ()) else None
                if name is not None and not is_asked_for(str(name.value), file.span(name), asked):
                    span = file.span(name)
                    why = LEFT if self.lookups.is_left(file.path) else self.lookups.why_seldom(file.path, span)
                    why = why or (UNSTARTED if self.is_unstarted(file.path) else "")
                    why = why or self.why_mild(file.path, span, str(name.value))
                    yield str(name.value), LookUp(file.path, span, id(call) in chosen, why)
        for source in self.lookups.sources:
            why = UNCOMPILED if self.lookups.is_uncompiled(source.path) else ""
            for text, span in share_names(source) if role_of(source.path) == "run" else ():
                yield text, LookUp(source.path, span, why_seldom=why or self.why_mild(source.path, span, text))

    def why_mild(self, path: str, span: Span, name: str) -> str:
        """Return the end of a message that says why those who run a look-up have the package; "" where they may not."""
        return self.users.why_mild(path, span, name) if self.users else ""

    @property
    def included(self) -> set[str]:
        return {each.path.partition("/")[0] for source in self.lookups.sources for each in source.includes}


def is_asked_for(name: str, span: Span, asked: Iterable[tuple[Span, frozenset[str]]]) -> bool:
    """Return whether code asks first whether a package is there that it looks for at a span."""
    return any(part.holds(span) and name in names for part, names in asked)


def alternatives(tree: ast.AST) -> Iterator[int]:
    """Yield the identity of each look-up under an `if` whose other branch looks for other packages alone."""
    for choice in nodes_of_kind(tree, ast.If):
        found = [[call for each in branch for call in lookups_in(each)] for branch in (choice.body, choice.orelse)]
        names = [{str(name.value) for call in calls if (name := literal_of(call))} for calls in found]
        if all(names) and names[0].isdisjoint(names[1]):
            yield from (id(call) for calls in found for call in calls)


def lookups_in(statement: ast.AST) -> list[ast.Call]:
    return [each for each in nodes_of(statement) if isinstance(each, ast.Call) and last_name(each.func) in LOOKUPS]


def may_be_elsewhere(workspace: Workspace, name: str) -> bool:
    """Return whether a package that no index has may be in a repository that is listed and not here."""
    is_unknown = workspace.index.kind_of(name) is NameKind.UNKNOWN and not workspace.is_available(name)
    return is_unknown and not workspace.is_complete and bool(NAME.fullmatch(name))
