"""Folders of the package that the compiler looks in for headers, target by target."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property

from ...languages.cmake.evaluated_command import EvaluatedCommand, path_in_package
from ...languages.cmake.values import BINARY, Word
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.cmake.cmake_package import CMakePackage
from ...package.cmake.target_links import TargetLinks
from ...suggest import near_names

FOR_ALL, FOR_ONE = "include_directories", "target_include_directories"
SCOPES = ("PUBLIC", "PRIVATE", "INTERFACE")
KEYWORDS = frozenset({*SCOPES, "SYSTEM", "BEFORE", "AFTER"})
BUILT = regex(r"\$<BUILD_INTERFACE:([^$<>]*)>")
INSTALLED = regex(r"\$<INSTALL_INTERFACE:[^<>]*>")
OF_PACKAGE = regex(r'"?\$\{(\w+?)_(?:INCLUDE_DIRS?|LIBRARIES|LIBRARY|LIBS|TARGETS)\}"?')


@dataclass(frozen=True)
class IncludeFolders:
    package: CMakePackage

    @property
    def are_named(self) -> bool:
        """Whether any command names a folder."""
        return next(iter(self.package.cmake.named(FOR_ALL, FOR_ONE)), None) is not None

    def may_reach(self, target: str, folder: str) -> bool:
        """Return whether a target may be compiled with a folder: its own, or that of a library which it links."""
        if self.names_no_target or any(self.is_it(word, call, folder) for word, call in self.for_all):
            return True
        seen, left = set[str](), [target]
        while left:
            name = left.pop()
            if name in seen:
                continue
            seen.add(name)
            if any(self.is_it(word, call, folder) for word, call in self.of(name, "" if name == target else "PRIVATE")):
                return True
            for link in self.links.of(name):
                if not link.package and not link.word.is_known and not self.is_foreign(link.word):
                    return True
                own = self.links.own(link.word.text)
                if own is None and not link.package and near_names(link.word.text, self.targets):
                    return True  # it is intended for that one: CMK110 reports it
                left += [own.name] if own is not None else []
        return False

    def is_it(self, word: Word, call: EvaluatedCommand, folder: str) -> bool:
        """Return whether an argument is the folder, or may be it."""
        built = BUILT.fullmatch(word.text)
        text = built[1] if built else word.text
        if text in KEYWORDS or INSTALLED.fullmatch(text) or self.is_foreign(word):
            return False
        if not built and not word.is_known:
            return not text.startswith(BINARY)
        return folder in (path_in_package(each, call.folder) for each in text.split(";"))

    def is_foreign(self, word: Word) -> bool:
        """Return whether an argument is a variable of another package, which has none of these folders."""
        match = OF_PACKAGE.fullmatch(self.package.cmake.source_text(word))
        names = {found.name.lower() for found in self.package.cmake.packages} - {self.package.facts.name}
        return match is not None and match[1].lower() in names

    def of(self, target: str, without: str = "") -> Iterator[tuple[Word, EvaluatedCommand]]:
        """Yield the include directories of a target, and of targets of unknown names; without those of one scope."""
        for call in self.package.cmake.named(FOR_ONE):
            if call.words and (call.texts[0] == target or not call.words[0].is_known):
                scope = ""
                for word in call.words[1:]:
                    scope = word.text if word.text in SCOPES else scope
                    if not without or scope != without:
                        yield word, call

    @cached_property
    def for_all(self) -> tuple[tuple[Word, EvaluatedCommand], ...]:
        return tuple((word, call) for call in self.package.cmake.named(FOR_ALL) for word in call.words)

    @cached_property
    def names_no_target(self) -> bool:
        """Whether a command is for a target that nothing makes: it is intended for another one."""
        calls = self.package.cmake.named(FOR_ONE, "target_link_libraries", "ament_target_dependencies")
        return any(call.words and call.words[0].is_known and call.texts[0] not in self.targets for call in calls)

    @cached_property
    def targets(self) -> frozenset[str]:
        return frozenset(target.name for target in self.package.cmake.targets)

    @cached_property
    def links(self) -> TargetLinks:
        return TargetLinks(self.package.cmake)
