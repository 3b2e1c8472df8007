"""What the launch files of a workspace take from those that include them, also through what they include."""

from __future__ import annotations

from collections.abc import Callable, Iterable

from .launch_signature import LaunchSignature

Target = tuple[str, LaunchSignature]
"""A launch file and the name of its package."""

Key = tuple[str, str]
"""The name of a package, and the source of a launch file in it."""


class IncludedArguments:
    """Launch files by how includes name them; what a file takes is found out once."""

    def __init__(self, files: Iterable[Target]) -> None:
        self.by_source: dict[Key, Target] = {}
        self.by_place: dict[Key, Target] = {}
        self.targets: dict[Key, tuple[frozenset[Key], bool]] = {}
        self.known: dict[Key, tuple[frozenset[str], bool]] = {}
        for target in files:
            package, signature = target
            self.by_source.setdefault((package, signature.source), target)
            for place in signature.places:
                self.by_place.setdefault((package, place), target)

    def find(self, own: str, package: str, path: str) -> Target | None:
        """Return a launch file by the package that includes it, and by how it is named there."""
        return self.by_place.get((package, path)) if package else self.by_source.get((own, path))

    def takes(self, package: str, source: str) -> frozenset[str] | None:
        """Return all that a file and what it includes declare or use; None where that is unknown."""
        names, is_complete = self.names_in(package, source)
        return names if is_complete else None

    def names_in(self, package: str, source: str) -> tuple[frozenset[str], bool]:
        """Return what a file and those of its includes that are here declare or use, and whether that is all."""
        key = package, source
        if key not in self.known:
            self.known[key] = self.all_taken(key)
        return self.known[key]

    def reads(self, package: str, source: str, name: str, foreign: Callable[[str, str], frozenset[str]]) -> bool:
        """Return whether a file or one that it includes, which sees all its arguments, does more than pass one on.

        `foreign` says what a launch file takes that is not here.
        """
        waiting, seen = [((package, source), name)], set[tuple[Key, str]]()
        while waiting:
            each = key, asked = waiting.pop()
            own, signature = self.by_source[key]
            if signature.reads(asked):
                return True
            names = {asked, *(argument for passed, argument in signature.passed if passed == asked)}
            others = [include for include in signature.includes if include[0] and self.find(own, *include) is None]
            if any(not names.isdisjoint(foreign(*include)) for include in others):
                return True
            seen.add(each)
            more = {(target, one) for target in self.included_by(key)[0] for one in names}
            waiting += more - seen
        return False

    def foreign_in(self, package: str, source: str) -> tuple[frozenset[Key], bool]:
        """Return what a file and its includes that are here include of other packages, and whether one may take more.

        An included file is a package and a path there.
        """
        queue, found, is_open = [(package, source)], set[Key](), False
        seen = {*queue}
        while queue:
            key = queue.pop()
            own, signature = self.by_source[key]
            is_open = is_open or signature.may_take_others
            found |= {each for each in signature.includes if each[0] and self.find(own, *each) is None}
            queue += self.included_by(key)[0] - seen
            seen |= self.included_by(key)[0]
        return frozenset(found), is_open

    def all_taken(self, start: Key) -> tuple[frozenset[str], bool]:
        names: set[str] = set()
        seen, queue, is_complete = {start}, [start], True
        while queue:
            key = queue.pop()
            _, signature = self.by_source[key]
            included, all_found = self.included_by(key)
            is_complete = is_complete and all_found and not signature.may_take_others
            names |= signature.declared
            names |= signature.used
            queue += included - seen
            seen |= included
        return frozenset(names), is_complete

    def included_by(self, key: Key) -> tuple[frozenset[Key], bool]:
        """Return the files that one includes, and whether all of them are found."""
        if key not in self.targets:
            package, signature = self.by_source[key]
            found = [self.find(package, *each) for each in dict.fromkeys(signature.includes)]
            keys = frozenset((each[0], each[1].source) for each in found if each is not None)
            self.targets[key] = keys, None not in found
        return self.targets[key]
