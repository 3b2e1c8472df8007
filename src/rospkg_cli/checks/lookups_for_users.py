"""Packages that the code of a library looks up for those who use it: who comes there has what is looked for."""

from __future__ import annotations

from ..light_dataclasses import dataclass
from ..package.package_facts import PackageFacts
from ..package.workspace import Workspace
from ..source import Span
from .depends.brought_dependencies import brought_by
from .library_builds import LibraryBuilds
from .library_users import LibraryUsers
from .workspace.wanted_packages import is_used

ROUND = "; that package uses this library, to declare it here would make a circle: let those declare it who call this"
THEIRS = "; this library has no program, and each package that comes here has that one itself"
UNUSED = "; this library has no program, and no package here uses it"


@dataclass(frozen=True)
class LookupsForUsers:
    library: LibraryUsers
    workspace: Workspace
    builds: LibraryBuilds

    def why_mild(self, path: str, span: Span, name: str) -> str:
        """Return what is said of a look-up for a package, in a library without programs; "" where somebody lacks it."""
        users = self.library.of(path, span)
        if users is None:
            return ""
        if not users:
            return "" if self.builds.has(self.library.facts.name) else UNUSED
        if any(each.name == name for each in users):
            return ROUND
        return THEIRS if all(has(each, name, self.workspace) for each in users) else ""


def has(facts: PackageFacts, name: str, workspace: Workspace) -> bool:
    """Return whether a package certainly has another one: it declares it, or something that brings it, or uses it."""
    declared = [need.name for need in facts.dependencies if need.certain]
    return name in declared or is_used(name, facts) or name in brought_by(declared, workspace)
