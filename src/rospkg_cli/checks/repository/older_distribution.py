"""Rule input: whether a repository is for older distributions alone, by the files that tell how to build."""

from __future__ import annotations

from functools import cached_property, lru_cache

from ...files import PackageFiles
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.file_role import role_of
from ...ros.distros import Targets
from .denied_distributions import EVERY, without_denied
from .linked_build import build_texts

STARTABLE = (".py", ".xml", ".yaml", ".yml")
BEFORE_DASHING = ("bouncy", "crystal")
"""Words of their own, which count behind `ros` alone."""
BEFORE_ELOQUENT = (*BEFORE_DASHING, "dashing")
OLDER = (*BEFORE_ELOQUENT, "eloquent", "foxy")
UNSUPPORTED = (*OLDER, "galactic")
BEFORE_JAZZY = (*UNSUPPORTED, "humble", "iron")
BEFORE_LYRICAL = (*BEFORE_JAZZY, "jazzy", "kilted")
NAMES = regex(rf"(?<![a-z])({EVERY})(?![a-z])")
EARLY = regex(rf"\bros[ _-]?2?(?:_?distro)?[\s:=/_-]{{0,3}}[\"']?({'|'.join(BEFORE_DASHING)})\b")
OF_BRANCH = regex(rf"\bthis (?:\w+ )?branch (?:\w+ ){{1,4}}[`'\"*_]{{0,3}}({EVERY})(?![a-z])")
"""What a page says of its own branch, where it names those for other distributions too."""
SLIPS = {"elequent": "eloquent", "eloquant": "eloquent", "galatic": "galactic", "galictic": "galactic"}
IN_PATHS = regex(rf"(?<![a-z])({'|'.join(SLIPS)}|{EVERY})(?![a-z])")


@dataclass(frozen=True)
class OlderDistribution:
    files: PackageFiles
    targets: Targets = Targets()

    @cached_property
    def named(self) -> frozenset[str]:
        """The distributions that pages, scripts and workflows name, or those of which a page says so of this branch."""
        pages = [text.lower() for text in build_texts(self.files)]
        of_branch = frozenset(name for page in pages for name in OF_BRANCH.findall(page))
        return of_branch or frozenset(name for page in pages for name in names_in(page))

    @cached_property
    def meant(self) -> frozenset[str]:
        """Those named; where none is, those that other pages, launch files, docstrings and names of files tell.

        The package's own word on one of those named counts more than what else the repository has them for. Only asked
        of what is a finding: it reads many a file.
        """
        from .distribution_words import words_elsewhere, words_of_package  # what findings alone need

        if not self.named:
            return frozenset[str]().union(*words_elsewhere(self.files))
        own = words_of_package(self.files) if not self.named.isdisjoint(UNSUPPORTED) and self.names_supported else ()
        return frozenset(own) if own and self.named.issuperset(own) else self.named

    @property
    def is_meant_unsupported(self) -> bool:
        """Whether one before Humble is meant, and none after it."""
        return bool(self.meant) and self.meant.issubset(UNSUPPORTED)

    @property
    def is_newer_shown(self) -> bool:
        """Whether the run checks for a distribution, or those that are meant are Humble or later ones alone.

        Only then somebody surely meets that a name of Foxy or Galactic is gone.
        """
        return bool(self.targets.names) or (bool(self.meant) and self.meant.isdisjoint(UNSUPPORTED))

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
    def is_meant_before_eloquent(self) -> bool:
        """Whether one before Eloquent is meant, and none after it: there publishers take no depth, or need none."""
        return not self.targets.names and bool(self.meant) and self.meant.issubset(BEFORE_ELOQUENT)

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
        """Whether no distribution is asked for, and all that are meant have CMake 3, as those before Lyrical do."""
        return not self.targets.names and bool(self.meant) and self.meant.issubset(BEFORE_LYRICAL)

    @property
    def reaches_jazzy(self) -> bool:
        """Whether the run checks for Jazzy or a later one, or one of them is meant."""
        if self.targets.names:
            return not set(self.targets.names).issubset(BEFORE_JAZZY)
        return not self.meant.issubset(BEFORE_JAZZY)

    @property
    def is_from_jazzy_on(self) -> bool:
        """Whether Jazzy or a later one is named, and none before it."""
        return bool(self.named) and self.named.isdisjoint(BEFORE_JAZZY)

    def is_kept_for_older(self, path: str) -> bool:
        """Return whether a launch file is called as being for one before Galactic, and another one is for the rest."""
        others = (each for each in self.files.paths if role_of(each) == "launch" and each.endswith(STARTABLE))
        return names_older(path) and not all(map(names_older, others))

    def is_for_older(self, path: str) -> bool:
        """Return whether one before Galactic is meant alone, or a file or a folder is called as being for one."""
        folder = called(self.files.folder)
        if names_older(path) or (bool(folder) and folder.issubset(OLDER)):
            return True
        return bool(self.meant) and self.meant.issubset(OLDER)

    def is_for_unsupported(self, path: str) -> bool:
        """Return whether none that is supported is meant, or a file or a folder is called as being for an older one."""
        return is_called_older(path) or self.is_in_older_folder or self.is_meant_unsupported

    @property
    def is_in_older_folder(self) -> bool:
        """Whether a folder around the package is called as being for one that is not supported, and for no other."""
        found = called(self.files.folder)
        return bool(found) and found.issubset(UNSUPPORTED)

    @property
    def names_supported(self) -> bool:
        """Whether one that is supported is named, or Iron."""
        return not self.named.issubset(UNSUPPORTED)


@lru_cache(maxsize=1000)
def names_in(text: str) -> frozenset[str]:
    """Return the distributions that a text names, in lower case, and does not deny: one page for all packages."""
    text = without_denied(text)
    return frozenset((*NAMES.findall(text), *EARLY.findall(text)))


def names_older(path: str) -> bool:
    """Return whether a file or its folder is called as being for a distribution before Galactic alone."""
    found = called(path)
    return bool(found) and found.issubset(OLDER)


def is_called_older(path: str) -> bool:
    """Return whether a file is called as being for a distribution that is no longer supported."""
    return not called(path).isdisjoint(UNSUPPORTED)


def called(path: str) -> frozenset[str]:
    """Return the distributions that a path names, right or with a known slip."""
    return frozenset(SLIPS.get(name, name) for name in IN_PATHS.findall(path.lower()))
