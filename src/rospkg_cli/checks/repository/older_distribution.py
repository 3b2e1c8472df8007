"""Rule input: whether a repository is only for older distributions, by what its pages, scripts and workflows say."""

from __future__ import annotations

from functools import cached_property

from ...files import PackageFiles
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.file_role import role_of
from ...ros.distros import Targets
from .denied_distributions import EVERY
from .distribution_names import (
    BEFORE_DASHING,
    BEFORE_ELOQUENT,
    BEFORE_JAZZY,
    BEFORE_LYRICAL,
    OLDER,
    UNSUPPORTED,
    called,
    is_called_older,
    names_in,
    names_older,
)
from .linked_build import build_texts

STARTABLE = (".py", ".xml", ".yaml", ".yml")
OF_BRANCH = regex(rf"\bthis (?:\w+ )?branch (?:\w+ ){{1,4}}[`'\"*_]{{0,3}}({EVERY})(?![a-z])")
"""What a page says of its own branch, where it names those for other distributions too."""


@dataclass(frozen=True)
class OlderDistribution:
    files: PackageFiles
    targets: Targets = Targets()

    @cached_property
    def named(self) -> frozenset[str]:
        """The distributions that pages, scripts and workflows name, or only those that a page gives for its branch."""
        pages = [text.lower() for text in build_texts(self.files)]
        of_branch = frozenset(name for page in pages for name in OF_BRANCH.findall(page))
        return of_branch or frozenset(name for page in pages for name in names_in(page))

    @cached_property
    def intended(self) -> frozenset[str]:
        """Those named; where none is, those in other pages, launch files, docstrings and file names.

        What the package itself says of one of those named counts more than what the repository says. It reads many
        files, so only findings ask for it.
        """
        from .distribution_words import words_elsewhere, words_of_package  # what findings alone need

        if not self.named:
            return frozenset[str]().union(*words_elsewhere(self.files))
        own = words_of_package(self.files) if not self.named.isdisjoint(UNSUPPORTED) and self.names_supported else ()
        return frozenset(own) if own and self.named.issuperset(own) else self.named

    @property
    def is_only_unsupported(self) -> bool:
        """Whether the repository is for one before Humble, and for none after it."""
        return bool(self.intended) and self.intended.issubset(UNSUPPORTED)

    @property
    def is_newer_shown(self) -> bool:
        """Whether the run checks for a distribution, or the repository is only for Humble or later ones.

        Only then the removal of a name of Foxy or Galactic certainly matters.
        """
        return bool(self.targets.names) or (bool(self.intended) and self.intended.isdisjoint(UNSUPPORTED))

    @property
    def is_named_alone(self) -> bool:
        """Whether one before Galactic is named, and none after it.

        Foxy does not check the types of parameters, gives a LifecycleNode a namespace, and takes `node_executable`.
        """
        return bool(self.named) and self.named.issubset(OLDER)

    @property
    def is_before_dashing(self) -> bool:
        """Whether one before Dashing is named, and none after it: there parameters need no declaration."""
        return bool(self.named) and self.named.issubset(BEFORE_DASHING)

    @property
    def is_only_before_eloquent(self) -> bool:
        """Whether the repository is for one before Eloquent, and for none after it: publishers need no depth there."""
        return not self.targets.names and bool(self.intended) and self.intended.issubset(BEFORE_ELOQUENT)

    @property
    def is_before_humble(self) -> bool:
        """Whether one before Humble is named, and none after it: there all packages share one folder of headers."""
        return bool(self.named) and self.named.issubset(UNSUPPORTED)

    @property
    def is_before_jazzy(self) -> bool:
        """Whether one before Jazzy is named, and none after it."""
        return bool(self.named) and self.named.issubset(BEFORE_JAZZY)

    @property
    def is_before_lyrical(self) -> bool:
        """Whether the run checks for none, and the repository is only for those with CMake 3, before Lyrical."""
        return not self.targets.names and bool(self.intended) and self.intended.issubset(BEFORE_LYRICAL)

    @property
    def reaches_jazzy(self) -> bool:
        """Whether the run checks for Jazzy or a later one, or the repository is for one of them."""
        if self.targets.names:
            return not set(self.targets.names).issubset(BEFORE_JAZZY)
        return not self.intended.issubset(BEFORE_JAZZY)

    @property
    def is_from_jazzy_on(self) -> bool:
        """Whether Jazzy or a later one is named, and none before it."""
        return bool(self.named) and self.named.isdisjoint(BEFORE_JAZZY)

    def is_kept_for_older(self, path: str) -> bool:
        """Return whether the path of a launch file names one before Galactic, and that of another one does not."""
        others = (each for each in self.files.paths if role_of(each) == "launch" and each.endswith(STARTABLE))
        return names_older(path) and not all(map(names_older, others))

    def is_for_older(self, path: str) -> bool:
        """Return whether the repository, a file or a folder around the package is only for one before Galactic."""
        folder = called(self.files.folder)
        if names_older(path) or (bool(folder) and folder.issubset(OLDER)):
            return True
        return bool(self.intended) and self.intended.issubset(OLDER)

    def is_for_unsupported(self, path: str) -> bool:
        """Return whether a file is for one that is no longer supported: by its path, a folder, or the repository."""
        return is_called_older(path) or self.is_in_older_folder or self.is_only_unsupported

    @property
    def is_in_older_folder(self) -> bool:
        """Whether a folder around the package names one that is not supported, and no other."""
        found = called(self.files.folder)
        return bool(found) and found.issubset(UNSUPPORTED)

    @property
    def names_supported(self) -> bool:
        """Whether one that is supported is named, or Iron."""
        return not self.named.issubset(UNSUPPORTED)
