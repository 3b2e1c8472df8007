"""Libraries that are not installed, where a list of targets to install has the name of another one twice."""

from __future__ import annotations

from collections.abc import Iterator
from functools import cached_property

from ...languages.cmake.targets import Target
from ...languages.cmake.values import UNKNOWN, Word
from ...light_dataclasses import dataclass
from ...package.cmake.cmake_project import CMake
from ...package.cmake.install_rule import InstallRule
from ...package.cmake.uninstalled_targets import UninstalledTargets


@dataclass(frozen=True)
class DoubledName:
    word: Word
    """The second place of the name."""
    first: Word
    target: Target
    """The library whose name is intended there."""


@dataclass(frozen=True)
class DoubledNames:
    cmake: CMake

    def all(self) -> Iterator[DoubledName]:
        """Yield each name once; nothing where an install rule can't be evaluated."""
        rules = [rule for rule in self.cmake.installs if rule.kind in ("TARGETS", "CODE")]
        is_known = all(rule.kind != "CODE" and all(word.is_known for word in rule.items) for rule in rules)
        if not is_known or not self.cmake.is_complete or self.cmake.reads_unknown_files:
            return
        seen: set[str] = set()
        for rule in rules:
            for each in self.of(rule):
                if each.target.name not in seen:
                    seen.add(each.target.name)
                    yield each

    def of(self, rule: InstallRule) -> Iterator[DoubledName]:
        firsts: dict[str, Word] = {}
        for word in rule.items:
            first = firsts.setdefault(word.text, word)
            if first is word or word.maybe or first.maybe or (first.path, first.span) == (word.path, word.span):
                continue
            near = [target for target in self.left_out if self.is_between(target, first, word)]
            if len(near) == 1 and near[0].word.span.start < word.span.start:
                yield DoubledName(word, first, near[0])

    @cached_property
    def left_out(self) -> list[Target]:
        """The libraries that are made for sure, and that nothing installs, uses or is linked with."""
        targets = UninstalledTargets(self.cmake)
        found = []
        for each in targets.candidates():
            is_sure = each.is_library and not (each.call.maybe or each.call.function or "STATIC" in each.options)
            is_used = any(call is not each.call for call in targets.users.get(each.name, ()))
            if is_sure and not is_used and not targets.links.with_word(each.name):
                found.append(each)
        return found

    def is_between(self, target: Target, first: Word, second: Word) -> bool:
        """Return whether a library is made after the first place of a name, or right after the target of that name."""
        made = target.word
        if not made.path == first.path == second.path or UNKNOWN in made.text:
            return False
        if first.span.start < made.span.start < second.span.start:
            return True
        names = [each.name for each in self.cmake.targets]
        return names.index(target.name) - 1 == names.index(first.text) if first.text in names else False
