"""Removed arguments and words of commands in all launch files of a package, each reported once (LCH005)."""

from __future__ import annotations

from collections.abc import Hashable, Iterator
from typing import Annotated

from ...light_dataclasses import dataclass, replace
from ...package.launch.launch_file import LaunchFile
from ...package.workspace import Workspace
from ...unreadable import READABLE
from ..fault import Fault, Level, TextRepair, softer_advice
from .call_errors import LaunchCalls
from .idle_actions import IN_BRANCH, NO_ENTRY, level_at
from .one_cause import CausedPlace, reported_in
from .removed_arguments import LATER, removed_arguments, renaming_texts
from .removed_commands import removed_commands
from .who_meets import level_met, why_python_stops


@dataclass(frozen=True, slots=True)
class RemovedWord:
    fault: Fault
    """As it is reported where it is the only one."""
    names: tuple[str, ...] = ()
    """The keywords that launch took in Foxy, where they can be renamed."""
    when: tuple[tuple[Level, str], ...] = ()
    """Why it is not at the rule's level; "" where nothing is said of that."""

    @property
    def cause(self) -> Hashable:
        return LATER if self.names else self.fault.message

    @property
    def at_its_level(self) -> Fault:
        """The fault with the level, and the reason for it, of where the word stands."""
        fault = self.fault
        for level, why in self.when:
            least: Level = "info" if fault.level == "info" else level
            fault = softer_advice(fault, least, why) if why else replace(fault, level=least)
        return fault


@dataclass(frozen=True)
class RemovedWords:
    calls: LaunchCalls
    workspace: Workspace
    around: Annotated[tuple[LaunchFile, ...], READABLE] = ()
    """All launch files of the package that can be read."""

    def together(self) -> Iterator[tuple[Fault, list[CausedPlace[RemovedWord]]]]:
        """Yield what is reported in this file, and its places in the package; the worst is first."""
        own = self.calls.file
        here = list(self.words_of(own))
        files = [each for each in self.around if each.path != own.path] if here else []
        words = [(own.path, word) for word in here]
        words += [(file.path, word) for file in files for word in self.words_of(file)]
        places = (CausedPlace(word.cause, word.at_its_level.level, path, word.fault.span, word) for path, word in words)
        for alike in reported_in(own.path, places):
            first, names = alike[0].item, tuple(dict.fromkeys(name for each in alike for name in each.item.names))
            if set(names) != set(first.names):
                message, title = renaming_texts(names)
                first = replace(first, fault=replace(first.fault, message=message, repair=TextRepair(title, ())))
            yield first.at_its_level, alike

    def words_of(self, file: LaunchFile) -> Iterator[RemovedWord]:
        """Yield the removed arguments of a file, and then the words; none of one that is kept for Foxy."""
        is_python, distribution = file.frontend == "python", self.calls.distribution
        if is_python and distribution.is_kept_for_older(file.path):
            return
        for fault in removed_arguments(file):
            when: list[tuple[Level, str]] = []
            is_later = is_python and fault.message.startswith(LATER)
            level, why = level_at(file, fault.span)
            if is_later and self.is_for_older(file, is_info=level == "info"):
                when.append(("info", "but not in Foxy"))
            if why in (NO_ENTRY, IN_BRANCH):  # a condition of launch does not help: Python refuses to make the action
                when.append(("warning", why))
            elif level == "info":
                when.append((level, ""))
            elif lacked := why_python_stops(file, fault.span, self.workspace):
                when.append(("info", lacked))
            edits = fault.repair.edits if is_later and fault.repair else ()
            yield RemovedWord(fault, tuple(dict.fromkeys(file.source.slice(span) for span, _ in edits)), tuple(when))
        for fault in removed_commands(file):
            level, why = level_met(file, fault.span, self.workspace)
            is_older = distribution.is_for_unsupported(file.path)
            is_older = is_older or self.is_for_older(file, is_info="info" in (level, fault.level))
            older: list[tuple[Level, str]] = [("info", "but not in Foxy and Galactic")] if is_older else []
            yield RemovedWord(fault, (), (*older, *([(level, why)] if level else ())))

    def is_for_older(self, file: LaunchFile, *, is_info: bool) -> bool:
        """Return whether a file is for Foxy; for what is no info anyway, also whether it may be."""
        distribution = self.calls.distribution
        return distribution.is_for_older(file.path) or not (is_info or distribution.is_newer_shown)
