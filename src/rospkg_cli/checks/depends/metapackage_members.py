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
FEW = 2
WITH_CONTENT = regex(
    r".*_(?:msgs?|interfaces|srvs|actions?|bringup|launch|description|gazebo|sim|simulation|nav\w*|moveit\w*|drivers?|agent|"
    r"config\w*|utils?|common|core|py|cpp|control|hardware|resources?|maps?|worlds?|cmake)"
)
"""Names of packages that have something, or will."""


@dataclass(frozen=True)
class MetapackageMembers:
    declared: DeclaredDependencies

    def missing(self) -> list[PackageFacts]:
        """Return the packages that the metapackage does not bring, where it names nearly all of the others, or is
        clearly there to name all."""
        named = [facts for facts in self.neighbours if facts.name in self.names]
        if len(named) < MIN_NAMED and not self.stands_for_family:
            return []
        there = self.needed_by(self.names)
        found = [facts for facts in self.neighbours if facts.name not in there and not self.is_left_out(facts)]
        is_nearly_whole = len(found) * PARTS <= len(named) and (
            self.has_no_content(self.declared.facts) or self.names_interfaces
        )
        return found if self.stands_for_family or is_nearly_whole else []

    @cached_property
    def stands_for_family(self) -> bool:
        """Whether it has nothing of its own, as no other package of its repository, and nearly all of these begin with
        the same word as its name does. One that names none of them may still wait for its content, among few."""
        own, others = self.declared.facts, self.neighbours
        first = own.name.partition("_")[0]
        strangers = [facts for facts in others if facts.name.partition("_")[0] != first]
        if own.name.endswith("_vendor") or any(facts.is_metapackage for facts in others):
            return False
        if own.is_metapackage and any(facts.name in self.names for facts in others):
            return len(others) >= FEW and len(strangers) * PARTS <= len(others)
        return self.is_blank and not strangers and len(others) > FEW and not any(map(self.has_no_content, others))

    @property
    def is_blank(self) -> bool:
        """Whether it has nothing, not even a dependency of what it would run or build, nor a name of what will."""
        own, needs = self.declared.facts, self.declared.manifest.dependencies
        has_needs = any(each.tag not in ("buildtool_depend", "test_depend") for each in needs)
        has_needs = has_needs or WITH_CONTENT.fullmatch(own.name) is not None
        return own.build_type == "ament_cmake" and not has_needs and self.has_no_content(own)

    @property
    def names_interfaces(self) -> bool:
        """Whether it and all others have interfaces, and it needs those that it names only to run."""
        names = {facts.name for facts in self.neighbours}
        kinds = {each.tag for each in self.declared.manifest.dependencies if each.name in names}
        own = (self.declared.facts, *self.neighbours)
        return kinds == {"exec_depend"} and all(facts.interfaces for facts in own)

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
        """The tag under which it names most of what it needs to run."""
        tags = [each.tag for each in self.declared.manifest.dependencies if each.tag in ("depend", "exec_depend")]
        return Counter(tags or ["exec_depend"]).most_common(1)[0][0]

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
