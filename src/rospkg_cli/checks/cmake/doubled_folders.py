"""Folders that are installed into one of their own name: `install(DIRECTORY launch DESTINATION …/launch)`."""

from __future__ import annotations

import posixpath
from collections.abc import Iterator

from ...languages.cmake.values import UNKNOWN, Word
from ...light_dataclasses import dataclass
from ...package.cmake.cmake_package import CMakePackage
from ...package.cmake.copied_files import CopiedFile, copied_files
from ...package.cmake.install_rule import InstallRule
from .misplaced_files import MisplacedFiles


def misplaced_folders(package: CMakePackage) -> Iterator[tuple[Word, str]]:
    """Yield what is installed next to the folders of packages, or into a folder of its own name, with a message."""
    name = package.facts.name
    yield from ((each.word, each.sentence(name)) for each in MisplacedFiles(package).all())
    for word, folder in DoubledFolders(package).all():
        place = f"share/{name}/{folder}/{folder}"
        looks = f"who looks for `{folder}/` in the share directory of `{name}` finds no file there"
        yield word, f"`{folder}` lands in `{place}`: {looks}; write `{folder}/`, with a slash"


@dataclass(frozen=True)
class DoubledFolders:
    package: CMakePackage

    def all(self) -> Iterator[tuple[Word, str]]:
        """Yield each such folder; not where its files are installed elsewhere too, or a text names the place."""
        cmake, files = self.package.cmake, self.package.cmake.package_files
        copies = [(rule, copy) for rule in cmake.installs for copy in copied_files(rule, files)]
        for rule in cmake.installs:
            for word in rule.items if rule.kind == "DIRECTORY" and not rule.call.maybe else ():
                own = [copy for other, copy in copies if other is rule and copy.item is word]
                name = posixpath.basename(word.text)
                if own and self.is_doubled(rule, name, word) and not self.is_intended(name, own, copies):
                    yield word, name

    def is_doubled(self, rule: InstallRule, name: str, word: Word) -> bool:
        place = (rule.destination or "").rstrip("/")
        is_known = bool(name) and UNKNOWN not in word.text and not word.maybe
        return is_known and place == f"share/{self.package.facts.name}/{name}"

    def is_intended(self, name: str, own: list[CopiedFile], copies: list[tuple[InstallRule, CopiedFile]]) -> bool:
        """Return whether other rules install a file too, or a launch file names it, which LCH004 reports."""
        sources = [copy.source for _, copy in copies]
        texts = [each for each in MisplacedFiles(self.package).launch_texts if self.package.facts.name in each]
        named = (f"{name}/{name}", *(posixpath.basename(copy.source) for copy in own))
        return any(sources.count(copy.source) > 1 for copy in own) or any(
            each in text for each in named for text in texts
        )
