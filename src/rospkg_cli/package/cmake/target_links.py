"""Link dependencies of targets, and which targets are needed at run time."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from functools import cached_property

from ...languages.cmake.evaluated_command import EvaluatedCommand
from ...languages.cmake.targets import Target
from ...languages.cmake.values import Word
from ...light_dataclasses import dataclass
from .cmake_project import CMake

KEYWORDS = {"PUBLIC": "PUBLIC", "PRIVATE": "PRIVATE", "INTERFACE": "INTERFACE", "LINK_PUBLIC": "PUBLIC",
            "LINK_PRIVATE": "PRIVATE", "LINK_INTERFACE_LIBRARIES": "INTERFACE"}  # fmt: skip
NO_LIBRARIES = frozenset({"debug", "optimized", "general", "SYSTEM"})


@dataclass(frozen=True)
class TargetLink:
    """One target linked with one library, or with the libraries of one package."""

    target: str
    word: Word
    scope: str
    """`PUBLIC`, `PRIVATE`, `INTERFACE`; "" for the form without keywords, which is public too."""
    package: bool
    """Whether the argument is a package's name (ament_target_dependencies)."""
    call: EvaluatedCommand

    @property
    def is_public(self) -> bool:
        return self.scope != "PRIVATE"


@dataclass(frozen=True)
class TargetLinks:
    cmake: CMake

    @cached_property
    def all(self) -> tuple[TargetLink, ...]:
        return tuple(self._all())

    def _all(self) -> Iterator[TargetLink]:
        for call in self.cmake.named("target_link_libraries", "ament_target_dependencies"):
            scope = ""
            for word in call.words[1:]:
                if word.text in KEYWORDS:
                    scope = KEYWORDS[word.text]
                elif word.text not in NO_LIBRARIES:
                    package = call.name == "ament_target_dependencies"
                    yield TargetLink(call.texts[0], word, scope, package, call)

    def of(self, target: str) -> Sequence[TargetLink]:
        return self._by_target.get(target, ())

    def with_word(self, text: str) -> Sequence[TargetLink]:
        """Return the links to a library by its name."""
        return self._by_word.get(text, ())

    @cached_property
    def _by_target(self) -> dict[str, list[TargetLink]]:
        found: dict[str, list[TargetLink]] = {}
        for link in self.all:
            found.setdefault(link.target, []).append(link)
        return found

    @cached_property
    def _by_word(self) -> dict[str, list[TargetLink]]:
        found: dict[str, list[TargetLink]] = {}
        for link in self.all:
            found.setdefault(link.word.text, []).append(link)
        return found

    @cached_property
    def installed(self) -> frozenset[str]:
        """The names of the targets that are installed."""
        named = {word.text for rule in self.cmake.installs if rule.kind == "TARGETS" for word in rule.items}
        if self.cmake.named("ament_auto_package", "autoware_ament_auto_package"):
            automatic = ("ament_auto_add_library", "ament_auto_add_executable")
            named |= {target.name for target in self.cmake.targets if target.call.name in automatic}
        components = {each.executable.text for each in self.cmake.components if each.executable is not None}
        return frozenset(named | components)

    def shared(self, target: Target) -> bool:
        """Return whether a library is loaded at run time: a shared one, or one of no type where ROS makes it shared."""
        if not target.is_library or not target.is_built or "STATIC" in target.options:
            return False
        if target.options & {"SHARED", "MODULE"}:
            return True
        return any(each.name == "ament_cmake_ros" for each in self.cmake.packages)

    def own(self, name: str) -> Target | None:
        """Return the target of the package that an argument of target_link_libraries refers to."""
        return self.cmake.target(name.rpartition("::")[2] if "::" in name else name)
