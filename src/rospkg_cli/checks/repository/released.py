"""Whether the repository of a package is visibly released itself, and is no copy of one that others release."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterator
from functools import cached_property

from ...files import PackageFiles, has_file
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.package_facts import PackageFacts
from ...package.workspace import Workspace
from .linked_build import build_files

CHANGES = "CHANGELOG.rst"
"""What bloom makes the changelogs of a release of."""
OF_BLOOM = ("tracks.yaml", ".rosinstall.release")
"""Files in the root of a repository that is released."""
RELEASES = regex(r"\bbloom-(?:generate|release)\b|\bgit-bloom-release\b|\bros_buildfarm\b|\bPRERELEASE\b|\bprerelease_")
"""What makes packages of Debian, or asks the build farm to try it."""
JOBS = ".github/"
"""Where a host looks for jobs: in the root of a repository alone."""
TITLE = regex(r"\s*(\S[^\n]*)")


@dataclass(frozen=True)
class Release:
    facts: PackageFacts
    workspace: Workspace
    files: PackageFiles

    @cached_property
    def is_made(self) -> bool:
        """Whether files of bloom, a job, or the changelogs of all packages say that the repository is released.

        A CHANGELOG.rst of another title, or next to packages without one, was copied from elsewhere.
        """
        if self.files.above(OF_BLOOM) is not None or any(map(self.files.exists, OF_BLOOM)):
            return True
        if any(map(RELEASES.search, self.texts())):
            return True
        return self.is_named_in_changes and all(self.have_changes())

    def texts(self) -> Iterator[str]:
        """Yield what builds the repository; jobs of a copy in the midst of it run nowhere."""
        for whole, path in build_files(self.files):
            top, is_job, _ = path.partition(JOBS)
            if whole.has_file(path) and not (is_job and any(not f"{each}/".startswith(top) for each in self.here)):
                yield whole.readable_text(path)

    @property
    def is_named_in_changes(self) -> bool:
        """Whether the title of the package's CHANGELOG.rst names it."""
        title, name = TITLE.match(self.files.readable_text(CHANGES)), self.facts.name
        return title is not None and re.search(rf"(?<![\w-]){re.escape(name)}(?![\w-])", title[1]) is not None

    def have_changes(self) -> Iterator[bool]:
        """Yield of each other package of the repository whether it has a CHANGELOG.rst."""
        for each in self.neighbours:
            yield self.files.whole is not None and has_file(self.files.whole, posixpath.join(each.folder, CHANGES))

    @cached_property
    def here(self) -> frozenset[str]:
        """The folders of the packages of the repository; none where it is not known."""
        return next((each for each in self.workspace.repositories if self.facts.folder in each), frozenset())

    @cached_property
    def neighbours(self) -> tuple[PackageFacts, ...]:
        """The other packages of the repository; of the run, where its repositories are not known."""
        return tuple(
            each
            for each in self.workspace.packages
            if each.folder != self.facts.folder and (not self.here or each.folder in self.here)
        )
