"""Whether a launch file opens a robot of another package that includes a file of this one."""

from __future__ import annotations

from collections.abc import Sequence

from ...light_dataclasses import dataclass
from ...package.package_facts import PackageFacts
from ...package.urdf.robot_words import LAUNCH, may_be_made
from ...package.workspace import Workspace


@dataclass(frozen=True)
class IncludingPackages:
    package: PackageFacts
    workspace: Workspace

    def opens(self, path: str, packages: Sequence[PackageFacts]) -> bool:
        """Return whether a robot of another package includes a file, and a launch file opens that robot."""
        return any(self.is_reached(*each, packages) for each in self.including(self.package.name, path))

    def including(self, package: str, path: str) -> list[tuple[str, str]]:
        """Return the files of other packages that include one, each with its package."""
        return [
            (facts.name, by)
            for facts in self.workspace.packages
            for owner, included, by in (facts.robot_includes if facts.name != self.package.name else ())
            if owner == package and included == path
        ]

    def is_reached(self, package: str, path: str, packages: Sequence[PackageFacts]) -> bool:
        """Return whether a launch file opens a file of another package, or one that includes it, in a few steps."""
        waiting, seen = [(package, path)], {(package, path)}
        while waiting:
            owner, inner = waiting.pop()
            name = inner.rpartition("/")[2]
            for facts in packages:
                if any(names_file(words, owner, name, is_own=facts.name == owner) for words in facts.robot_words):
                    return True
            more = [each for each in self.including(owner, inner) if each not in seen]
            seen.update(more)
            waiting += more
        return False


def names_file(words: frozenset[str], package: str, name: str, *, is_own: bool = False) -> bool:
    """Return whether words are those of a launch file that names a file of a package."""
    stem = name.partition(".")[0]
    is_there = name in words or (may_be_made(name, words) and stem in words)
    return LAUNCH in words and is_there and (is_own or package in words)
