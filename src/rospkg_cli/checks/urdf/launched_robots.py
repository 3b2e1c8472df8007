"""Rule input: whether a launch file of the workspace certainly opens a robot description of a package."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Callable, Sequence
from functools import cached_property
from typing import Annotated

from ...files import PackageFiles
from ...light_dataclasses import dataclass
from ...package.launch.launch_file import LaunchFile
from ...package.package_facts import PackageFacts
from ...package.urdf.robot_words import is_launch, may_be_made, words_of
from ...package.workspace import Workspace
from ...unreadable import READABLE
from ..left_files import LeftFiles
from ..repository.pages_and_scripts import pages_and_scripts
from .including_packages import IncludingPackages, names_file
from .named_with_folder import means_inner_copy
from .opened_robots import OpenedRobots
from .opening_texts import ROBOTS
from .robot_texts import has_folders


@dataclass(frozen=True)
class LaunchedRobots:
    files: PackageFiles
    package: PackageFacts
    workspace: Workspace
    opened: OpenedRobots
    left: LeftFiles | None = None
    launch_files: Annotated[tuple[LaunchFile, ...], READABLE] = ()

    def has(self, path: str) -> bool:
        """Return whether a launch file names a file as the one it opens, or such a one includes it."""
        return path in self.paths

    def is_off(self, path: str) -> bool:
        """Return whether only actions of launch files that are off by default open a file, and no text turns one on."""
        return self.has(path) and path not in self.by_default

    @cached_property
    def including(self) -> IncludingPackages:
        return IncludingPackages(self.package, self.workspace)

    @cached_property
    def by_default(self) -> frozenset[str]:
        """The robots that launch files open with default arguments."""
        from ..launch.plain_launch import plain_texts  # what findings alone need
        from ..share.opened_elsewhere import opening_elsewhere

        others = (*pages_and_scripts(self.files), *opening_elsewhere(self.files, self.package.name, self.workspace))
        plain = plain_texts(self.launch_files, (*self.opened.texts.every, *(("", text) for text in others)))
        if not plain:
            return self.paths
        launches = tuple((path, plain.get(path, text)) for path, text in self.launches)
        return self.opened_by(launches, self.workspace.packages)

    @cached_property
    def paths(self) -> frozenset[str]:
        return self.opened_by(self.launches, self.workspace.packages)

    def opened_by(
        self,
        launches: Sequence[tuple[str, str]],
        packages: Sequence[PackageFacts],
        includes: Callable[[str, str], bool] | None = None,
    ) -> frozenset[str]:
        """Return the robots that some launch files of this package, or those of some packages, open.

        Where `includes` is given, it must also say that a text includes a file of a name.
        """
        robots = {path: text for path, text in self.opened.texts.every if path.endswith(ROBOTS)}
        waiting = [
            path for path in robots if self.is_named(path, launches, packages) or self.including.opens(path, packages)
        ]
        found = set(waiting)
        while waiting:
            by = waiting.pop()
            more = [path for path in robots if path not in found and self.opened.is_included(path, by, robots[by])]
            if includes is not None:
                more = [path for path in more if includes(robots[by], path.rpartition("/")[2])]
            found.update(more)
            waiting += more
        return frozenset(found)

    def is_named(self, path: str, launches: Sequence[tuple[str, str]], packages: Sequence[PackageFacts]) -> bool:
        """Return whether one of some launch files, of this package or others, names a robot, and no other is so."""
        name, own = path.rpartition("/")[2], self.package.name
        others = self.opened.packages.having(name)
        for _, text in launches:
            words = words_of(text)
            is_another = own not in words and any(other in words for other in others)
            is_another = is_another or self.opened.elsewhere.is_elsewhere(path, text)
            if names(words, text, name) and not is_another and self.is_this_copy(path, text):
                return True
        return any(
            names_file(words, own, name) and not self.opened.elsewhere.means_another(path, words)
            for facts in packages
            for words in (facts.robot_words if facts.name != own else ())
        )

    @cached_property
    def launches(self) -> tuple[tuple[str, str], ...]:
        """The path and the text of each launch file, but for those that nothing installs or names."""
        return tuple(each for each in self.opened.texts.every if is_launch(each[0]) and not self.is_left(each[0]))

    def is_left(self, path: str) -> bool:
        """Return whether nothing leads to a launch file or a script."""
        return self.left is not None and self.left.has(path)

    def is_this_copy(self, path: str, text: str) -> bool:
        """Return whether a text has the folders of a path in it, where the package has two files of one name."""
        folder, name = posixpath.split(path)
        again = [each for each in self.files.paths if each != path and each.rpartition("/")[2] == name]
        if not folder:  # any text has no folder: it is another one that has the folders of that
            return not any(has_folders(posixpath.dirname(each), text) for each in again)
        if again and means_inner_copy(path, text, again):
            return False
        return not again or all(re.search(rf"\b{re.escape(each)}\b", text) for each in folder.split("/"))


def names(words: frozenset[str], text: str, name: str) -> bool:
    """Return whether a launch file names a robot: in full, or by its stem in quotes and a suffix to append."""
    stem = re.escape(name.partition(".")[0])
    if name in words:
        return True
    is_made = may_be_made(name, words) or "MoveItConfigsBuilder" in text
    return is_made and re.search(rf"[\"'/]{stem}[\"']", text) is not None
