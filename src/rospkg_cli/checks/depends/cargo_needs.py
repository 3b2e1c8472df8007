"""Packages of interfaces that Cargo.toml takes from a workspace of ROS, and that package.xml does not declare."""

from __future__ import annotations

import re
from collections.abc import Iterator

from ...files import PackageFiles
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...ros.interfaces import OF_INTERFACES
from ...ros.names import NameKind
from ...source import Span
from .declared_dependencies import DeclaredDependencies

CARGO, CONFIG = "Cargo.toml", (".cargo/config.toml", ".cargo/config")
TABLE = regex(r"^[ \t]*\[(?P<name>[^\[\]\n]+)\][ \t]*(?:#.*)?$", re.MULTILINE)
OF_CRATES = regex(r"(?P<dev>dev-)?dependencies(?:\.(?P<crate>[\w-]+))?")
LINE = regex(r"^[ \t]*(?P<crate>[\w-]+)(?P<value>[ \t]*=[ \t]*[^\n#]+|\.version[ \t]*=[ \t]*[^\n#]+)", re.MULTILINE)
ANY = regex(r'"\*"')
ELSEWHERE = regex(r"\b(?:path|git|package|workspace|registry)\b\s*=|\boptional\s*=\s*true")
"""What takes a crate from a place of its own, or leaves it out by default."""
PATCHED = regex(r"^\s*\[patch\b", re.MULTILINE)


@dataclass(frozen=True, slots=True)
class CargoNeed:
    name: str
    span: Span
    tag: str


@dataclass(frozen=True)
class CargoNeeds:
    declared: DeclaredDependencies
    files: PackageFiles

    def missing(self) -> Iterator[CargoNeed]:
        """Yield the packages of interfaces in any version, each once, that nothing in the package provides."""
        if self.declared.facts.build_type != "ament_cargo" or not self.files.has_file(CARGO):
            return
        text = self.files.readable_text(CARGO)
        configs = [self.files.readable_text(path) for path in CONFIG if self.files.has_file(path)]
        seen: set[str] = set()
        for need in crates(text) if not PATCHED.search(text) else ():
            is_known = self.declared.workspace.kind_of(need.name) is NameKind.PACKAGE
            is_new = need.name not in seen and not any(need.name in each for each in configs)
            if is_new and is_known and not self.declared.has([need.name]):
                seen.add(need.name)
                yield need


def crates(text: str) -> Iterator[CargoNeed]:
    """Yield the crates with the names of packages of interfaces, for which any version will do."""
    tables = [*TABLE.finditer(text)]
    ends = [*(each.start() for each in tables[1:]), len(text)]
    for table, end in zip(tables, ends, strict=True):
        found = OF_CRATES.fullmatch(table["name"].strip())
        if found is None:
            continue
        tag = "test_depend" if found["dev"] else "depend"
        if found["crate"]:
            start = table.start("name") + table["name"].index(found["crate"])
            yield from of_crate(found["crate"], start, text[table.end() : end], tag)
        for line in LINE.finditer(text, table.end(), end) if not found["crate"] else ():
            yield from of_crate(line["crate"], line.start("crate"), line["value"], tag)


def of_crate(name: str, start: int, value: str, tag: str) -> Iterator[CargoNeed]:
    if OF_INTERFACES.fullmatch(name) and ANY.search(value) and not ELSEWHERE.search(value):
        yield CargoNeed(name, Span(start, start + len(name)), tag)
