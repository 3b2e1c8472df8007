"""Languages of the sources of targets that no `project()` enables."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property

from ...languages.cmake.evaluated_command import EvaluatedCommand
from ...languages.cmake.targets import Target
from ...languages.cmake.values import Word
from ...light_dataclasses import dataclass
from ...package.cmake.cmake_project import CMake

DEFAULTS = frozenset({"C", "CXX"})
"""What a `project()` enables that names no language."""
VALUES = ("VERSION", "DESCRIPTION", "HOMEPAGE_URL", "COMPAT_VERSION", "SPDX_LICENSE")
NEEDED = ("C", "CXX")
"""The languages of the libraries that the interfaces of a package become."""
OF_ENDINGS = {".c": "C", ".cpp": "CXX", ".cc": "CXX", ".cxx": "CXX", ".cu": "CUDA"}
"""What a source is written in; other endings may be anybody's."""
COMPILES = ("add_executable", "add_library", "ament_auto_add_executable", "ament_auto_add_library")


@dataclass(frozen=True)
class MissingLanguage:
    language: str
    word: Word
    """The target, or the source, that is written in it."""
    call: EvaluatedCommand
    """The `project()` that leaves it out."""
    of_interfaces: bool = False
    is_only: bool = False
    """Whether no source of the target is of another language: CMake itself stops."""


@dataclass(frozen=True)
class MissingLanguages:
    cmake: CMake

    def all(self) -> Iterator[MissingLanguage]:
        """Yield each language once; nothing where a file or a command that can't be read may enable it."""
        if not self.cmake.is_complete or self.cmake.reads_unknown_files or self.enabled is None:
            return
        project, seen = self.cmake.projects[-1], set(self.enabled)
        for language in NEEDED:
            for made in self.cmake.interface_targets:
                if language not in seen and not made.call.maybe:
                    seen.add(language)
                    yield MissingLanguage(language, made.target, project, of_interfaces=True)
        for target in self.cmake.targets:
            for each in self.of(target, project):
                if each.language not in seen:
                    seen.add(each.language)
                    yield each

    @cached_property
    def enabled(self) -> frozenset[str] | None:
        """The languages that are enabled anywhere; None where that is unknown."""
        found: set[str] = set()
        never_run = [call for call in self.cmake.unreachable if call.name == "enable_language"]
        for call in (*self.cmake.named("project", "enable_language"), *never_run):
            if call.may_have_more or not all(word.is_known for word in call.words[1:]):
                return None
            found |= languages_of(call)
        return frozenset(found) if self.cmake.projects else None

    def of(self, target: Target, project: EvaluatedCommand) -> Iterator[MissingLanguage]:
        """Yield what the sources of a target are written in, and no `project()` enables."""
        is_sure = target.call.name in COMPILES and target.is_built and not (target.call.maybe or target.folder)
        if not is_sure or self.is_set(target) or not all(word.is_known for word in target.sources):
            return
        written = [(word, language_of(word.text)) for word in target.sources if not word.maybe]
        compiled = {language for _, language in written if language} & (self.enabled or set())
        for word, language in written:
            if language and language not in (self.enabled or ()):
                yield MissingLanguage(language, word, project, is_only=not compiled)

    def is_set(self, target: Target) -> bool:
        """Return whether a command sets the language of a source, or adds sources to the target."""
        is_set = any("LANGUAGE" in call.texts or "LINKER_LANGUAGE" in call.texts for call in self.cmake.calls)
        return is_set or any(target.name in call.texts for call in self.cmake.named("target_sources"))


def languages_of(call: EvaluatedCommand) -> set[str]:
    """Return the languages that a call of project() or enable_language() enables."""
    texts = list(call.texts)
    if call.name == "enable_language":
        return {text for text in texts if text != "OPTIONAL"}
    rest = texts[1:]
    has_values = any(text in VALUES for text in rest)
    if "LANGUAGES" in rest:
        named = rest[rest.index("LANGUAGES") + 1 :]
        ends = [at for at, text in enumerate(named) if text in VALUES]
        return set(named[: ends[0]] if ends else named) - {"NONE"}
    return set(DEFAULTS) if has_values or not rest else set(rest) - {"NONE"}


def language_of(text: str) -> str | None:
    return next((language for ending, language in OF_ENDINGS.items() if text.endswith(ending)), None)
