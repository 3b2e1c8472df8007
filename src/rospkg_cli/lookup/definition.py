"""Where what a file names is defined."""

from __future__ import annotations

import re
from collections.abc import Iterator

from ..package.cmake.cmake_project import CMake
from ..package.install_table import InstalledFile
from ..package.package_facts import PackageFacts
from ..package.params.declared_parameter import DeclaredParameter
from ..source import Span
from .mention import Mention
from .world import DefinitionSite, LookupWorld

Found = DefinitionSite | None


def definitions(world: LookupWorld, folder: str, mention: Mention) -> list[DefinitionSite]:
    """Return the places that define what the package in a folder mentions; none where it is not of this workspace."""
    facts = world.facts(mention.name if mention.kind == "package" else mention.package, folder)
    if facts is None:
        return []
    finder = FINDERS.get(mention.kind)
    return list(dict.fromkeys(place for place in finder(world, facts, mention.name) if place)) if finder else []


def of_package(world: LookupWorld, facts: PackageFacts, _: str) -> Iterator[Found]:
    yield world.place(facts, "package.xml", facts.name_span)


def of_executable(world: LookupWorld, facts: PackageFacts, name: str) -> Iterator[Found]:
    for row in world.rows(facts):
        if row.what == "executable" and row.destination.rpartition("/")[2] == name:
            yield from of_row(world, facts, row, name)


def of_row(world: LookupWorld, facts: PackageFacts, row: InstalledFile, name: str) -> Iterator[Found]:
    """Yield the function, the script, or the first source of the program that a row installs."""
    if row.entry:
        yield from of_function(world, facts, row.entry)
    elif row.source:
        yield world.place(facts, row.source)
    else:
        yield from of_target(world, facts, name, row)


def of_target(world: LookupWorld, facts: PackageFacts, name: str, row: InstalledFile) -> Iterator[Found]:
    cmake = world.package(facts.folder).parts(CMake).only
    target = cmake.target(name) if cmake else None
    sources = [word.text for word in target.sources if word.is_known] if target else []
    found = next((place for path in sources if (place := world.place(facts, path))), None)
    yield found or world.place(facts, row.path, row.span)


def of_function(world: LookupWorld, facts: PackageFacts, entry: str) -> Iterator[Found]:
    """Yield the function of `module:attribute`, else the module."""
    module, _, attribute = entry.partition(":")
    stem = module.replace(".", "/")
    for path in (f"{stem}.py", f"{stem}/__init__.py", f"src/{stem}.py"):
        if place := world.place(facts, path):
            first = attribute.partition(".")[0]
            pattern = rf"^(?:async +)?(?:def|class) +({re.escape(first)})\b|^({re.escape(first)}) *="
            found = re.search(pattern, world.source(place.path).text, re.MULTILINE) if first else None
            yield DefinitionSite(place.path, Span(*found.span(found.lastindex or 0))) if found else place
            return


def of_component(world: LookupWorld, facts: PackageFacts, name: str) -> Iterator[Found]:
    cmake = world.package(facts.folder).parts(CMake).only
    for component in cmake.components if cmake else ():
        if component.plugin.is_known and component.plugin.text == name and cmake:
            last = name.rpartition("::")[2]
            target = cmake.target(component.target.text)
            for word in target.sources if target else ():
                place = world.place(facts, word.text) if word.is_known else None
                found = re.search(rf"\b{re.escape(last)}\b", world.source(place.path).text) if place else None
                if place and found:
                    yield DefinitionSite(place.path, Span(*found.span()))
                    return


def of_file(world: LookupWorld, facts: PackageFacts, path: str) -> Iterator[Found]:
    """Yield the source of what is installed there, else the file of the package itself."""
    share = f"share/{facts.name}/{path}"
    rows = [row for row in world.rows(facts) if row.destination == share and row.source]
    yield next((world.place(facts, row.source) for row in rows), None) or world.place(facts, path)


def of_interface(world: LookupWorld, facts: PackageFacts, name: str) -> Iterator[Found]:
    kind = name.partition("/")[0]
    yield world.place(facts, f"{name}.{kind}")


def of_parameter(world: LookupWorld, facts: PackageFacts, name: str) -> Iterator[Found]:
    """Yield where code of the package, else of another, declares a parameter of that name."""
    others = [each for each in world.workspace.packages if each is not facts]
    for each in (facts, *others):
        for declared in each.parameters:
            if declared.fits(name):
                yield declaration_site(world, each, declared)


def declaration_site(world: LookupWorld, facts: PackageFacts, declared: DeclaredParameter) -> Found:
    """Return where a package names a parameter that it declares: a prefix may be put before it when it runs."""
    place = world.place(facts, declared.path)
    if place is None:
        return None
    name = re.escape(declared.name.strip("."))
    quoted = re.search(rf"""["'](\.?{name})["']""", world.source(place.path).text)
    return DefinitionSite(place.path, Span(*quoted.span(1))) if quoted else place


FINDERS = {
    "package": of_package,
    "executable": of_executable,
    "component": of_component,
    "file": of_file,
    "interface": of_interface,
    "function": of_function,
    "parameter": of_parameter,
}
