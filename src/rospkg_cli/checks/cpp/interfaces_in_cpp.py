"""Headers and types of messages, services and actions that C++ names and their package does not have (IDL012)."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property

from ...files import PackageFiles
from ...languages.cpp.code_text import code_text
from ...languages.cpp.file import CppFile
from ...lazy_regex import regex
from ...light_dataclasses import dataclass, replace
from ...package.cmake.cmake_project import CMake
from ...package.interfaces.generated_types import generated_types
from ...ros.interfaces import header_name
from ...source import Span
from ...suggest import near_names
from ..depends.compiled_sources import compiled_sources, harm_in
from ..depends.conditional_includes import only_under_conditions
from ..fault import Level
from ..interfaces.known_interfaces import KnownInterfaces, base_name
from .interface_names import InterfaceNames

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
        """Yield the includes of headers that no interface has."""
        for each in source.includes:
            found = HEADER.fullmatch(each.path)
            if found is None or each.is_conditional:
                continue
            package, kind, name = found.groups()
            names, lowered = self.interfaces.names(package, kind), self.interfaces.lowered(package, kind)
            if self.known.is_unlisted(package, kind, lowered.get(name, "")) and not self.interfaces.is_there(each.path):
                yield replace(self.hit(source, each.span, each.path, package, kind, ""), is_unlisted=True)
            near = self.interfaces.as_generated(package, name, lowered, each.path)
            if (not names and not near) or name in lowered or self.interfaces.is_there(each.path):
                continue
            near = near or near_names(name, lowered, 2 if self.known.is_here(package) else 1)
            if (near or self.known.is_here(package)) and not self.may_be_generated(each.path):
                header = f"{package}/{kind}/{near[0]}.{each.path.rpartition('.')[2]}" if near else ""
                yield self.hit(source, each.span, each.path, package, kind, header)

    def types(self, source: CppFile) -> Iterator[WrongInterface]:
        """Yield the types that no interface has."""
        named = {(each.package, each.kind, each.name) for each in generated_types(source.source)}
        if not any(self.interfaces.may_lack(*each) for each in named):
            return  # before the comments are found, which takes longer
        for found in TYPE.finditer(code_text(source.source.text)):
            package, kind, name = found.groups()
            name = name.rstrip("_")
            names = self.interfaces.names(package, kind)
            if not names or base_name(name) in names or self.is_defined(package, name):
                continue
            if self.interfaces.has_own_headers(package, kind):
                continue
            if self.known.lacks(package, kind, name):
                full_name = (self.known.intended(package, kind, name) or "").replace(".", "::")
                span = Span(found.start(), found.start(3) + len(name))
                yield self.hit(source, span, f"{package}::{kind}::{name}", package, kind, full_name)

    def may_be_generated(self, header: str) -> bool:
        """Return whether the build of the package may make a header itself."""
        from .generated_message_headers import may_be_generated  # few headers are of no message

        return may_be_generated(header, self.cmake)

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

    @cached_property
    def interfaces(self) -> InterfaceNames:
        return InterfaceNames(self.known, self.files)

    def hit(self, source: CppFile, span: Span, text: str, package: str, kind: str, near: str) -> WrongInterface:
        level = harm_in(self.cmake, self.sources, source.path)
        return WrongInterface(source.path, span, text, package, kind, near, level)
