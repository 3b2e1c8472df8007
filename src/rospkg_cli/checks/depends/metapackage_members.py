"""Packages of a repository that its metapackage does not name (DEP205)."""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable
from functools import cached_property

from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.package_facts import PackageFacts
from .declared_dependencies import DeclaredDependencies

LEFT_OUT_ON_PURPOSE = regex(
    r"(?:^|.*_)(?:tests?|testing|examples?|demos?|tutorials?|benchmark\w*|performance|rqt)(?:_.*|$)"
)
"""Packages that a metapackage leaves out on purpose."""

MIN_NAMED = 4
PARTS = 4
"""There are at least so many times as many names as are missing."""


@dataclass(frozen=True)
class MetapackageMembers:
    declared: DeclaredDependencies

    def missing(self) -> list[PackageFacts]:
        """Return the few packages that neither it nor what it names needs, where it names nearly all of the others."""
        named = [facts for facts in self.neighbours if facts.name in self.names]
        if not self.has_no_content(self.declared.facts) or len(named) < MIN_NAMED:
            return []
        there = self.needed_by(self.names)
        found = [facts for facts in self.neighbours if facts.name not in there and not self.is_left_out(facts)]
        return found if len(found) * PARTS <= len(named) else []

    def has_no_content(self, facts: PackageFacts) -> bool:
        """Return whether a package is a metapackage, or installs nothing of its own but an empty Python package."""
        own = (
            facts.executables
            or facts.modules - {facts.name}
            or facts.headers
            or facts.cmake_targets
            or facts.components
        )
        share = facts.share_files - {"package.xml"} if facts.knows("share_files") else True
        return facts.is_metapackage or not (own or facts.interfaces or share)

    @property
    def names(self) -> frozenset[str]:
        return frozenset(each.name for each in self.declared.manifest.dependencies)

    @property
    def tag(self) -> str:
        """The tag under which it names most."""
        return Counter(each.tag for each in self.declared.manifest.dependencies).most_common(1)[0][0]

    @cached_property
    def neighbours(self) -> tuple[PackageFacts, ...]:
        """The other packages of its repository."""
        own, workspace = self.declared.facts.folder, self.declared.workspace
        folders = next((each for each in workspace.repositories if own in each), frozenset())
        return tuple(workspace.at(folder) for folder in sorted(folders - {own}))

    def is_left_out(self, facts: PackageFacts) -> bool:
        """Return whether a package is not one to be named: a test, a metapackage, or one that needs this one."""
        return (
            facts.is_metapackage
            or LEFT_OUT_ON_PURPOSE.fullmatch(facts.name) is not None
            or self.declared.is_needed_by(facts.name)
        )

    def needed_by(self, names: Iterable[str]) -> set[str]:
        """Return some names, and all that they need but for tests."""
        found: set[str] = set()
        waiting = list(names)
        while waiting:
            name = waiting.pop()
            if name not in found:
                found.add(name)
                facts = self.declared.workspace.named(name)
                waiting += [need.name for need in facts.dependencies if need.tag != "test_depend"] if facts else []
        return found
