"""Names of targets and exports that commands refer to, and which of them do not exist."""

from __future__ import annotations

from collections.abc import Collection, Iterable, Iterator
from functools import cached_property

from ...languages.cmake.evaluated_command import EvaluatedCommand
from ...languages.cmake.targets import MAKERS
from ...languages.cmake.values import UNKNOWN
from ...light_dataclasses import dataclass
from ...package.cmake.cmake_project import CMake
from .built_for_ros1 import is_built_for_ros1
from .dead_branches import DeadBranches
from .name_slips import is_clear_slip, nearest
from .named_targets import OF_INTERFACES, TargetReference, by_name, target_references

OF_TESTS = ("gtest", "gtest_main", "gmock", "gmock_main")
"""What `ament_find_gtest()` and `ament_add_gtest()` make."""


@dataclass(frozen=True)
class TargetReferences:
    cmake: CMake

    def broken(self) -> Iterator[TargetReference]:
        """Yield what is referenced and never added, each position once; nothing where a name can't be evaluated.

        Under a condition, or where other files may add targets, it must be a slip of one that the package makes.
        """
        if not self.cmake.is_complete:
            return
        seen: set[tuple[str, int, str]] = set()
        for reference in target_references(self.cmake):
            word = reference.word
            key = (word.path, word.span.start, word.text)
            if word.is_known and key not in seen and not self.is_made(reference):
                seen.add(key)
                if self.is_certain(reference) or self.is_slip(reference):
                    yield reference

    def broken_by_name(self) -> Iterable[list[TargetReference]]:
        """Return them, those to each name together."""
        return by_name(self.broken())

    def is_certain(self, reference: TargetReference) -> bool:
        """Return whether nothing that is not known may make it, and CMake certainly gets there."""
        known = self.exports if reference.kind == "export" else self.names
        unclear = reference.word.maybe or reference.call.maybe or self.cmake.reads_unknown_files
        return not unclear and UNKNOWN not in known

    def is_met_by_none(self, references: Iterable[TargetReference]) -> bool:
        """Return whether one waits for a package that nothing looks for, or the sources are all of ROS 1."""
        dead = DeadBranches(self.cmake)
        return is_built_for_ros1(self.cmake) or any(dead.package_of(each.call) for each in references)

    def is_slip(self, reference: TargetReference) -> bool:
        """Return whether a long name is one or two letters off one that the package makes."""
        known = self.targets if reference.kind == "target" else self.exports
        near = nearest(reference.word.text, known, 2)
        return near is not None and is_clear_slip(reference.word.text, near)

    def run_together(self, names: Collection[str]) -> Iterator[tuple[TargetReference, str, str]]:
        """Yield arguments that are two of some packages' names without a blank between them."""
        for call in self.cmake.named("ament_export_dependencies", "ament_target_dependencies"):
            for word in call.words[call.name != "ament_export_dependencies" :]:
                text = word.text
                halves = ((text[:at], text[at:]) for at in range(2, len(text) - 1))
                found = next((pair for pair in halves if pair[0] in names and pair[1] in names), None)
                if word.is_known and text not in names and found is not None:
                    yield TargetReference(word, call), *found

    def is_made(self, reference: TargetReference) -> bool:
        """Return whether the target or the export exists, or belongs to another package (`rclcpp::rclcpp`)."""
        if reference.kind == "export":
            return reference.word.text in self.exports
        return reference.word.text in self.names or "::" in reference.word.text

    @cached_property
    def exports(self) -> frozenset[str]:
        """The exports that an `install(… EXPORT name)` fills."""
        rules = [rule.export.text for rule in self.cmake.installs if rule.export is not None]
        foreign = (text for call in self.foreign for text in call.texts)
        return frozenset([*rules, *foreign])

    @cached_property
    def targets(self) -> frozenset[str]:
        """The targets that the package makes for certain."""
        return frozenset(target.name for target in self.cmake.targets if UNKNOWN not in target.name)

    @cached_property
    def names(self) -> frozenset[str]:
        """All names that may be targets; UNKNOWN among them where a target's name is unknown."""
        own = (UNKNOWN if UNKNOWN in target.name else target.name for target in self.cmake.targets)
        foreign = (UNKNOWN if UNKNOWN in text else text for call in self.foreign for text in call.texts)
        found = (package.name for package in self.cmake.packages)
        return frozenset([*own, *foreign, *found, *OF_TESTS])

    @cached_property
    def foreign(self) -> list[EvaluatedCommand]:
        """The calls of unknown commands: each may add a target named by any of its arguments."""
        from ...languages.cmake.commands import COMMANDS

        known = {*COMMANDS, *MAKERS, *OF_INTERFACES, *self.cmake.functions}
        return [call for call in self.cmake.calls if call.name not in known]
