"""Repositories that a README links to, or that a page, a script, a container or a job fetches."""

from __future__ import annotations

import re
from functools import cached_property

from ...files import PackageFiles
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.missing_repositories import are_alike, telling_words
from ...package.workspace import Workspace
from .hidden_packages import HiddenPackages

READMES = ("README.md", "README.rst", "readme.md", "README.txt", "README")
README = regex(r"(?i:readme)(?:\.\w+)?")
LINK = regex(r"\bgit(?:hub|lab)\.com[/:][\w.-]+/([\w.-]{3,})")
CLONE = regex(
    r"(?i:\bclone\b)[^\n;&|]*?[:/][\w.-]+/([\w.-]{3,})(?=[\s\"'`;&|)]|$)"
    r"|(?m:^)[ \t]*repository:[ \t]*[\"']?[\w.-]+/([\w.-]{3,})"
    r"|_WORKSPACE[\"']?[ \t]*[:=][^\n]{0,400}?\b(?:github|gitlab|bitbucket):[\w.-]+/([\w.-]{3,})(?=[#\s\"']|$)"
    r"|_WORKSPACE[\"']?[ \t]*[:=][^\n]{0,400}?git\+\w+://[^\s\"']*/([\w.-]{3,})(?=[#\s\"']|$)"
    r"|\b(?:wget|curl)\b[^\n;&|]*github\.com/[\w.-]+/([\w.-]{3,})/(?:archive|tarball|zipball)/"
)
"""A command or a sentence that clones one, a job that checks one out next to its own, what industrial_ci builds as well
(`UPSTREAM_WORKSPACE: github:acme/arm_msgs#main`), and an archive that is downloaded."""
CLONE_OF_VARIABLE = regex(r"\bgit[ \t][^\n;&|]*?\bclone\b[^\n;&|]*\$")
LIST_ELSEWHERE = regex(r"https?://[^\s\"'`)>]+\.(?:repos|rosinstall)\b")
"""The address of a list of repositories, which lies in another one."""
WORD = regex(r"[a-z]+")
OF_ROS = frozenset({"ros"})


@dataclass(frozen=True)
class FetchedRepositories:
    files: PackageFiles
    workspace: Workspace
    hidden: HiddenPackages

    def may_have(self, name: str) -> bool:
        """Return whether one of them may have a package of a name: it begins so, or has its words.

        What is cloned has it by one telling word alone (`micro_ros_agent` of `micro_ros_setup`). A repository that has
        such a word of a package here may be this one, or one that lies here.
        """
        spelt, words, telling = normalized(name), words_of(name), telling_words(name)
        if self.has_cloned(name) or any(spelt.startswith(each) for each in self.linked if not self.is_around(each)):
            return True
        others = [each for each in self.linked if words <= words_of(each) and words]
        others += [each for each in self.cloned if share_word(telling, telling_words(each))]
        if any(not self.may_be_own(each) for each in others):
            return True
        word = re.compile(rf"(?<![\w-]){re.escape(name)}(?![\w-])")
        texts = self.hidden.texts
        return any(map(LIST_ELSEWHERE.search, texts)) or any(
            CLONE_OF_VARIABLE.search(text) and word.search(text) for text in texts
        )

    def is_around(self, repository: str) -> bool:
        return any(normalized(each).startswith(repository) for each in self.workspace.names)

    def may_be_own(self, repository: str) -> bool:
        words = telling_words(repository)
        return repository in self.here or any(share_word(words, telling_words(each)) for each in self.workspace.names)

    @cached_property
    def here(self) -> frozenset[str]:
        """The names of the folders of the run: a repository that is cloned into one of them is here."""
        whole = PackageFiles(self.files.whole) if self.files.whole is not None else self.files
        return frozenset(normalized(part) for place in whole.places for part in place.split("/"))

    @cached_property
    def linked(self) -> frozenset[str]:
        """The names of the repositories that READMEs here and above link to, and of those that are cloned."""
        own = [self.files.readable_text(path) for path in self.files.paths if README.fullmatch(path)]
        above = self.files.above(READMES)
        if above is not None and self.files.whole is not None:
            own.append(PackageFiles(self.files.whole).readable_text(above))
        return self.cloned | {repository_of(match[1]) for text in own for match in LINK.finditer(text)}

    @cached_property
    def cloned(self) -> frozenset[str]:
        found = (match for text in self.hidden.texts for match in CLONE.finditer(text))
        return frozenset(repository_of(next(filter(None, match.groups()))) for match in found)

    def has_cloned(self, name: str) -> bool:
        """Return whether a repository named like a package is fetched and is not here: the name is not misspelt."""
        return normalized(name) in self.cloned - self.here


def repository_of(name: str) -> str:
    return normalized(name.removesuffix(".git"))


def normalized(name: str) -> str:
    return name.replace("-", "_").lower()


def words_of(name: str) -> frozenset[str]:
    return frozenset(WORD.findall(name.lower())) - OF_ROS


def share_word(one: set[str], other: set[str]) -> bool:
    return any(are_alike(first, second) for first in one for second in other)
