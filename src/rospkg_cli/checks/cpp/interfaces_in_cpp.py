"""Headers and types of messages, services and actions that C++ names and their package does not have (IDL012)."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Set
from functools import cached_property

from ...files import PackageFiles
from ...languages.cpp.code_text import code_text
from ...languages.cpp.file import CppFile
from ...lazy_regex import regex
from ...light_dataclasses import dataclass, replace
from ...package.cmake.cmake_project import CMake
from ...package.interfaces.generated_types import generated_types
from ...ros.interfaces import header_name
from ...ros.link_targets import MESSAGES
from ...source import Span
from ...suggest import near_names
from ..depends.compiled_sources import compiled_sources, harm_in
from ..depends.conditional_includes import only_under_conditions
from ..fault import Level
from ..interfaces.known_interfaces import KnownInterfaces, base_name
from .installed_headers import is_installed_header

HEADER = regex(r"([a-z]\w*)/(msg|srv|action)/(?!rosidl_)(\w+)\.(?:hpp|h)")
"""Of one interface; those of rosidl itself, which begin with its name, are left out."""
TYPE = regex(r"(?<!\w)(?<!\w::)([a-z]\w*)::(msg|srv|action)::([A-Z]\w*)")
# Linear: each looks at two or three letters; these are the two steps of rosidl's own conversion.
NAME = regex(r"[/:]")
DEFINED = r"\b(?:class|struct|enum|using)\s+"


@dataclass(frozen=True, slots=True)
class WrongInterface:
    """A header or a type of a package that has no such interface."""

    path: str
    span: Span
    text: str
    package: str
    kind: str
    meant: str
    """The header or the type that is near; "" where none is."""
    level: Level
    """How bad it is, by who compiles the file."""
    is_unlisted: bool = False
    """Whether the file of the interface is there, and CMake generates nothing of it."""

    @property
    def header_name(self) -> str:
        """What the header of the interface is called, which its type has as well: `set_mode`."""
        return header_name(NAME.split(self.text.partition(".")[0])[-1])


@dataclass(frozen=True)
class InterfacesInCpp:
    known: KnownInterfaces
    files: PackageFiles
    cmake: CMake
    sources: tuple[CppFile, ...]

    def wrong(self) -> Iterator[WrongInterface]:
        """Yield each interface once a file: at its header, else where its type is first named."""
        guarded = only_under_conditions(self.cmake, self.sources)
        for source, role in compiled_sources(self.cmake, self.sources):
            if source.path in guarded:
                continue  # the compiler may never see it
            seen: set[tuple[str, str, str]] = set()
            for each in (*self.headers(source), *self.types(source)) if role != "aside" else ():
                key = (each.package, each.kind, each.header_name)
                if key not in seen:
                    seen.add(key)
                    yield each

    def headers(self, source: CppFile) -> Iterator[WrongInterface]:
        for each in source.includes:
            found = HEADER.fullmatch(each.path)
            if found is None or each.is_conditional:
                continue
            package, kind, name = found.groups()
            names, lowered = self.names(package, kind), self.lowered(package, kind)
            if self.known.is_unlisted(package, kind, lowered.get(name, "")) and not self.is_there(each.path):
                yield replace(self.hit(source, each.span, each.path, package, kind, ""), is_unlisted=True)
            near = self.as_generated(package, name, lowered, each.path)
            if (not names and not near) or name in lowered or self.is_there(each.path):
                continue
            near = near or near_names(name, lowered, 2 if self.known.is_here(package) else 1)
            if near or self.known.is_here(package):
                header = f"{package}/{kind}/{near[0]}.{each.path.rpartition('.')[2]}" if near else ""
                yield self.hit(source, each.span, each.path, package, kind, header)

    @cached_property
    def _lowered(self) -> dict[tuple[str, str], Mapping[str, str]]:
        return {}

    def lowered(self, package: str, kind: str) -> Mapping[str, str]:
        """Return the interfaces of a kind that a package has, by the names of their headers."""
        if (package, kind) not in self._lowered:
            self._lowered[package, kind] = {header_name(known): known for known in self.names(package, kind)}
        return self._lowered[package, kind]

    def as_generated(self, package: str, name: str, lowered: Mapping[str, str], path: str) -> list[str]:
        """Return the header of a class by whose own name it is included: rosidl writes no capital letter."""
        header = header_name(name)
        if header == name:
            return []
        is_of_messages = MESSAGES.fullmatch(package) is not None and not self.known.is_here(package)
        is_generated = header in lowered if lowered else is_of_messages and path.endswith(".hpp")
        return [header] if is_generated else []

    def types(self, source: CppFile) -> Iterator[WrongInterface]:
        named = {(each.package, each.kind, each.name) for each in generated_types(source.source)}
        if not any(self.may_lack(*each) for each in named):
            return  # before the comments are found, which takes longer
        for found in TYPE.finditer(code_text(source.source.text)):
            package, kind, name = found.groups()
            name = name.rstrip("_")
            names = self.names(package, kind)
            if not names or base_name(name) in names or self.is_defined(package, name):
                continue
            if self.has_own_headers(package, kind):
                continue
            if self.known.lacks(package, kind, name):
                full_name = (self.known.intended(package, kind, name) or "").replace(".", "::")
                span = Span(found.start(), found.start(3) + len(name))
                yield self.hit(source, span, f"{package}::{kind}::{name}", package, kind, full_name)

    def may_lack(self, package: str, kind: str, name: str) -> bool:
        names = self.names(package, kind)
        return bool(names) and base_name(name.rstrip("_")) not in names

    def names(self, package: str, kind: str) -> Set[str]:
        """Return the interfaces of a kind that a package has; none where they are unknown."""
        return (self.known.of(package) or {}).get(kind, frozenset())

    def is_there(self, header: str) -> bool:
        """Return whether the package has a header of that path, wherever, or another one among its generated ones."""
        is_own = any(f"/{path}".endswith(f"/{header}") for path in self.files.paths)
        return is_own or is_installed_header(header, self.known.workspace)

    def has_own_headers(self, package: str, kind: str) -> bool:
        """Return whether a package has headers of its own among the generated ones, and so types in their namespace."""
        facts = self.known.workspace.named(package)
        return facts is not None and any(each.startswith(f"{package}/{kind}/") for each in facts.header_files)

    def is_defined(self, package: str, name: str) -> bool:
        """Return whether a file of this package seems to define a class of a name in the namespace of messages.

        That of its own messages any file may be in; that of others is opened in the same file.
        """
        import re

        pattern = re.compile(DEFINED + re.escape(name) + r"\b")
        opened = re.compile(rf"\bnamespace\s+{re.escape(package)}\b")
        own = package == self.known.package.name
        texts = (each.source.text for each in self.sources)
        return any(pattern.search(text) and (own or opened.search(text)) for text in texts)

    def hit(self, source: CppFile, span: Span, text: str, package: str, kind: str, near: str) -> WrongInterface:
        level = harm_in(self.cmake, self.sources, source.path)
        return WrongInterface(source.path, span, text, package, kind, near, level)
