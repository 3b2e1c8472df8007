"""Files that are installed into `share` or `lib` itself, next to the folders of packages."""

from __future__ import annotations

import posixpath
from collections.abc import Iterator
from functools import cached_property
from typing import NamedTuple

from ...languages.cmake.values import Word
from ...light_dataclasses import dataclass
from ...package.cmake.cmake_package import CMakePackage
from ...package.cmake.copied_files import CopiedFile, copied_files
from ...package.cmake.install_rule import InstallRule
from ...ros.share_layout import LAUNCH, SHARED


class MisplacedFile(NamedTuple):
    word: Word
    path: str
    """Of the installed file."""
    folder: str
    """`share` or `lib`."""

    def sentence(self, package: str) -> str:
        start = f"`{self.path}` is next to the folders of the packages in `{self.folder}`"
        looks = f"`ros2 run {package}`" if self.folder == "lib" else f"who looks in the share directory of `{package}`"
        return f"{start}: {looks} does not find it; install into `{self.folder}/${{PROJECT_NAME}}`"


@dataclass(frozen=True)
class MisplacedFiles:
    package: CMakePackage

    def all(self) -> Iterator[MisplacedFile]:
        """Yield the first such file of each rule; one that another rule installs too may be wanted there."""
        cmake, files = self.package.cmake, self.package.cmake.package_files
        rules = [rule for rule in cmake.installs if rule.kind in ("FILES", "DIRECTORY", "PROGRAMS")]
        copies = [(rule, copy) for rule in rules for copy in copied_files(rule, files)]
        sources = [copy.source for _, copy in copies]
        seen: list[InstallRule] = []
        for rule, copy in copies:
            if rule.call.maybe or rule in seen or sources.count(copy.source) > 1 or not self.is_outside(rule, copy):
                continue
            seen.append(rule)
            if any(self.is_reported(other) for each, other in copies if each.call is rule.call):
                continue
            yield MisplacedFile(copy.item, copy.destination, (rule.destination or "").rstrip("/"))

    def is_reported(self, copy: CopiedFile) -> bool:
        """Return whether a file is a launch file, which CMK101 reports, or named in one, which LCH004 reports."""
        name = posixpath.basename(copy.source)
        return LAUNCH.fullmatch(name) is not None or any(name in text for text in self.launch_texts)

    @cached_property
    def launch_texts(self) -> tuple[str, ...]:
        files = self.package.cmake.package_files
        paths = (path for path in files.paths if LAUNCH.fullmatch(posixpath.basename(path)))
        return tuple(files.readable_text(path) for path in paths)

    def is_outside(self, rule: InstallRule, copy: CopiedFile) -> bool:
        """Return whether a rule installs a file into no folder of the package, nor one of several packages."""
        folder, _, below = copy.destination.partition("/")
        if (rule.destination or "").rstrip("/") != folder or self.package.facts.name in below:
            return False
        if folder == "lib":
            return rule.kind == "DIRECTORY" and self.is_program(copy)
        return folder == "share" and below.partition("/")[0] not in SHARED

    def is_program(self, copy: CopiedFile) -> bool:
        """Return whether a file names its interpreter."""
        return self.package.cmake.package_files.readable_text(copy.source).startswith("#!")
