"""Whether anybody tells dependencies for building from those for running: a release does, a build of sources does not.

`rosdep install` installs the dependencies of all tags, and colcon builds them all first.
"""

from __future__ import annotations

from functools import cached_property

from ..files import PackageFiles
from ..lazy_regex import regex
from ..light_dataclasses import dataclass
from ..package.package_facts import PackageFacts
from ..package.workspace import Workspace
from .setup.linked_build import build_texts

CHANGES = "CHANGELOG.rst"
"""What bloom makes the changelogs of a release of."""
TELLS = regex(
    r"\brosdep[ \t]+install\b(?:[^\n&|;\\]|\\\n)*?[ \t](?:-t|--dependency-types)[ \t=]*[\"']?(?!(?:all)\b)\w"
    r"|\bbloom-(?:generate|release)\b|\bgit-bloom-release\b"
)
"""A command that installs the dependencies of some tags alone, or that makes packages of Debian."""


@dataclass(frozen=True)
class ToldKinds:
    facts: PackageFacts
    workspace: Workspace
    files: PackageFiles

    @cached_property
    def are_told(self) -> bool:
        """Whether the package is released, or prepared for it, or a file of the repository builds with some tags."""
        is_prepared = self.files.exists(CHANGES) or self.is_in_index(self.facts.name)
        return (is_prepared and self.is_among_its_own) or any(map(TELLS.search, build_texts(self.files)))

    @property
    def is_among_its_own(self) -> bool:
        """Whether half of the repository's packages are released, or it is no copy of a released one.

        Who copies a released package beside packages of their own builds it from source.
        """
        here = next((each for each in self.workspace.repositories if self.facts.folder in each), None)
        names = [each.name for each in self.workspace.packages if here is None or each.folder in here]
        known = sum(map(self.is_in_index, names))
        return known * 2 >= len(names) or known == 0

    def is_in_index(self, name: str) -> bool:
        return self.workspace.index.is_package(name)
