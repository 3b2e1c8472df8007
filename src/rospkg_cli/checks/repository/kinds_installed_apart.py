"""Rule input: whether dependencies for the build and for the run are ever installed separately.

A release does so, a build from sources does not: `rosdep install` installs the dependencies of all tags, and colcon
builds them all first.
"""

from __future__ import annotations

from functools import cached_property

from ...files import PackageFiles
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from .linked_build import build_texts
from .released import Release

OF_SOME_TAGS = regex(
    r"\brosdep[ \t]+install\b(?:[^\n&|;\\]|\\\n)*?[ \t](?:-t|--dependency-types)[ \t=]*[\"']?(?!(?:all)\b)\w"
)
"""A command that installs the dependencies of some tags alone."""
WITHOUT_TESTS = regex(r"BUILD_TESTING(?::\w+)?=[\"']?(?i:off|0|false|no)\b")


@dataclass(frozen=True)
class KindsInstalledApart:
    release: Release
    files: PackageFiles

    @cached_property
    def are_apart(self) -> bool:
        """Whether the repository is released, or one of its files installs only the dependencies of some tags."""
        return self.release.is_made or any(map(OF_SOME_TAGS.search, build_texts(self.files)))

    @cached_property
    def are_tests_left_out(self) -> bool:
        """Whether a release, or a file that builds the repository, leaves out the tests."""
        return self.are_apart or any(map(WITHOUT_TESTS.search, build_texts(self.files)))
