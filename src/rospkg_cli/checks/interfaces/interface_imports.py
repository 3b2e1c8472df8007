"""Imports of messages, services and actions that their package does not have (IDL011)."""

from __future__ import annotations

from collections.abc import Iterator

from ...languages.python.alias_span import alias_span
from ...languages.python.file import PythonFile
from ...languages.python.imports import Import
from ...light_dataclasses import dataclass, replace
from ...package.package_facts import PackageFacts
from ...package.workspace import Workspace
from ...ros.interfaces import KINDS
from ...source import Span
from ..python.run_imports import RunImports
from ..reached_modules import ReachedModules
from ..reached_places import ReachedPlaces
from ..repository.older_distribution import OlderDistribution
from .known_interfaces import KnownInterfaces

OLDER = "; the older distribution that this is for may have it"


@dataclass(frozen=True, slots=True)
class WrongInterfaceImport:
    """An import that ends with an exception."""

    path: str
    span: Span
    package: str
    kind: str
    """The module that is asked for: `msg`, or a word that is none of the kinds."""
    name: str
    """What is taken out of the module; "" where that is not there."""
    intended: str
    """`package.kind.Name`, or `package.kind` where the module is not there; "" where nothing is near."""
    is_local: bool
    """Whether it is in a function, which may not be called, or in a branch."""
    is_left: bool
    """Whether it is in a module that nothing starts or imports, in a package that has programs."""
    is_uninstalled: bool = False
    is_unlisted: bool = False
    """Whether the file of the interface is there, and CMake generates nothing of it."""
    why: str = ""
    """Why an import seldom or never runs, as the end of a sentence."""


@dataclass(frozen=True)
class InterfaceImports:
    known: KnownInterfaces
    run: RunImports
    workspace: Workspace
    reached: ReachedModules | None = None
    places: ReachedPlaces | None = None
    distribution: OlderDistribution | None = None

    def wrong(self) -> Iterator[WrongInterfaceImport]:
        for file, each in self.run.certain:
            yield from self.of_import(file, each)
        for file, each in self.run.uninstalled:
            if self.known.is_here(each.module.partition(".")[0]):
                yield from (replace(wrong, is_uninstalled=True) for wrong in self.of_import(file, each) if wrong.name)

    def of_import(self, file: PythonFile, each: Import) -> Iterator[WrongInterfaceImport]:
        package, _, rest = each.module.partition(".")
        if each.level:
            return
        kind, _, deeper = rest.partition(".")
        found: list[WrongInterfaceImport] = []
        if not deeper:
            found += self.of_package(file, each, package, kind)
        if kind in KINDS and not deeper:
            found += self.of_kind(file, each, package, kind)
        elif kind and (intended := self.intended_module(package, kind)):
            found.append(self.hit(file, each, each.span, package, kind, "", f"{package}.{intended}"))
        if found and not self.has_module(each.module):  # last, as it looks through all packages
            yield from found

    def of_package(self, file: PythonFile, each: Import, package: str, rest: str) -> Iterator[WrongInterfaceImport]:
        """Yield interfaces that are imported from a package itself, not from its module `msg`, `srv` or `action`."""
        known = self.known.of(package)
        for name in (each.names if not rest else () if each.names else (rest,)) if known else ():
            kinds = [kind for kind in KINDS if known and name in known.get(kind, ())]
            if kinds:
                span = each.span if rest else alias_span(file, each, name)
                yield self.hit(file, each, span, package, "", name, f"{package}.{kinds[0]}.{name}")

    def has_module(self, module: str) -> bool:
        """Return whether a package of the workspace installs a module of that name itself, or may do so.

        One that generates such a module is not likely to have another of the name.
        """
        top, _, kind = module.partition(".")
        named = self.workspace.named(top)
        installing = [*self.workspace.having("modules", top), *([named] if named is not None else ())]
        return any(
            module in facts.modules or not (facts.knows("modules") or makes(facts, kind)) for facts in installing
        )

    def intended_module(self, package: str, word: str) -> str | None:
        facts = self.workspace.named(package)
        if facts is not None and f"{package}.{word}" in facts.modules:
            return None
        return self.known.intended_kind(package, word)

    def of_kind(self, file: PythonFile, each: Import, package: str, kind: str) -> Iterator[WrongInterfaceImport]:
        known = self.known.of(package)
        if known is not None and not known.get(kind) and self.known.is_here(package):
            names = [name for name in each.names if name != "*"]
            intended = self.known.intended(package, kind, names[0]) if names else None
            yield self.hit(file, each, each.span, package, kind, "", intended or "")
            return
        for name in each.names:
            if name[:1] not in ("_", "*") and self.known.lacks(package, kind, name):
                intended = self.known.intended(package, kind, name)
                hit = self.hit(file, each, alias_span(file, each, name), package, kind, name, intended or "")
                yield replace(hit, why=OLDER) if self.may_be_older(hit) else hit
            elif self.known.is_unlisted(package, kind, name):
                hit = self.hit(file, each, alias_span(file, each, name), package, kind, name, "")
                yield replace(hit, is_unlisted=True)

    def may_be_older(self, hit: WrongInterfaceImport) -> bool:
        """Return whether an interface has another kind now, and only unsupported distributions are named here."""
        is_other = hit.intended.split(".")[1:2] not in ([], [hit.kind])
        is_outside = is_other and not self.known.is_here(hit.package)
        return is_outside and self.distribution is not None and self.distribution.is_only_unsupported

    def hit(
        self, file: PythonFile, each: Import, span: Span, package: str, kind: str, name: str, intended: str
    ) -> WrongInterfaceImport:
        is_left = self.reached is not None and self.reached.is_left(file.path)
        why = self.places.why_seldom(file.path, each.span) if self.places is not None and not is_left else ""
        is_local = each.is_local or (self.places is not None and self.places.is_conditional(file.path, each.span))
        return WrongInterfaceImport(file.path, span, package, kind, name, intended, is_local, is_left, why=why)


def makes(facts: PackageFacts, kind: str) -> bool:
    """Return whether a package generates a module `msg`, `srv` or `action`."""
    return any(each.startswith(f"{kind}/") for each in facts.interfaces)
