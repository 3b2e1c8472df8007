"""What the launch files of a workspace take from those that include them, also through what they include."""

from __future__ import annotations

from collections.abc import Iterable

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
        self.targets: dict[Key, frozenset[Key] | None] = {}
        self.known: dict[Key, frozenset[str] | None] = {}
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
        key = package, source
        if key not in self.known:
            self.known[key] = self.all_taken(key)
        return self.known[key]

    def all_taken(self, start: Key) -> frozenset[str] | None:
        names: set[str] = set()
        seen, queue = {start}, [start]
        while queue:
            key = queue.pop()
            _, signature = self.by_source[key]
            included = self.included_by(key)
            if signature.may_take_others or included is None:
                return None
            names |= signature.declared
            names |= signature.used
            queue += included - seen
            seen |= included
        return frozenset(names)

    def included_by(self, key: Key) -> frozenset[Key] | None:
        """Return the files that one includes; None where one of them can't be found."""
        if key not in self.targets:
            package, signature = self.by_source[key]
            found = [self.find(package, *each) for each in dict.fromkeys(signature.includes)]
            keys = frozenset((each[0], each[1].source) for each in found if each is not None)
            self.targets[key] = None if None in found else keys
        return self.targets[key]
