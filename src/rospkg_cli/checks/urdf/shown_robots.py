"""Rule input: whether RViz or MoveIt shows a robot, as far as the launch files that open it say.

Gazebo, to which a launch file may give a model all the same, takes absolute paths.
"""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterable
from functools import cached_property
from typing import Annotated

from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.launch.configuration_events import file_name
from ...package.launch.launch_file import LaunchFile
from ...package.package_facts import PackageFacts
from ...package.urdf.robot_words import LAUNCH, words_of
from ...unreadable import READABLE
from ..launch.started_viewers import OF_MOVEIT, is_on, shows, started_viewers
from .given_to_viewers import NAMED_SO, hands_on, without_spawned
from .launched_robots import LaunchedRobots
from .xacro_includes import COMPUTED, INCLUDED

SHOWING = regex(r"rviz|display|view|move_?group|moveit")
"""In the names of launch files of other packages that show a robot."""
MOST = 4
"""The most parts of the name of an include; more take too long to compare."""


@dataclass(frozen=True)
class ShownRobots:
    launched: LaunchedRobots
    files: Annotated[tuple[LaunchFile, ...], READABLE] = ()

    def has(self, path: str) -> bool:
        """Return whether a launch file opens a robot that starts RViz or move_group, or runs together with one."""
        return path in self.paths

    @cached_property
    def paths(self) -> frozenset[str]:
        launched = self.launched
        launches = [each for each in launched.launches if posixpath.basename(each[0]) in self.together]
        launches = [each for each in launches if self.is_handed_on(posixpath.basename(each[0]))]
        packages = [without_spawned(each) for each in launched.workspace.packages if self.is_showing(each)]
        words = [words_of(text) for _, text in launches]
        others = (each for facts in packages if facts.name != launched.package.name for each in facts.robot_words)
        words += [each for each in others if LAUNCH in each and launched.package.name in each]
        return launched.opened_by(launches, packages, lambda text, name: is_named_include(text, name, words))

    @cached_property
    def together(self) -> frozenset[str]:
        """The names of the launch files of the package that run where RViz or move_group does."""
        included = self.included
        showing = {posixpath.basename(each.path) for each in self.files if self.starts(each)}
        found = set[str]()
        for name in included:
            run = reached(name, included)
            found |= run if run & showing else set()
        others = (each for each in self.launched.workspace.packages if each.name != self.launched.package.name)
        named = {name for facts in others if shows(facts) for each in facts.launch_summaries for name in each.includes}
        return frozenset(found | {name for top in named & set(included) for name in reached(top, included)})

    @cached_property
    def included(self) -> dict[str, frozenset[str]]:
        """The names of the files that each launch file of the package includes."""
        return {posixpath.basename(each.path): includes_of(each) for each in self.files if not each.is_ros1}

    def is_handed_on(self, name: str) -> bool:
        """Return whether a launch file, or what it includes, starts a reader of the robots that it names.

        A file that is not read here counts where its name says so.
        """
        run = reached(name, self.included)
        texts = (text for path, text in self.launched.launches if posixpath.basename(path) in run)
        others = run - set(self.included)
        return hands_on(texts) or any(SHOWING.search(each.lower()) or NAMED_SO.search(each) for each in others)

    def starts(self, file: LaunchFile) -> bool:
        """Return whether a launch file starts RViz or move_group, or includes a file of another package that does."""
        included = (each.span for each in file.includes if self.is_shown_by(file_name(each.file)))
        spans = [*started_viewers(file), *included]
        return OF_MOVEIT in file.source.text or any(is_on(file, each) for each in spans)

    def is_shown_by(self, name: str) -> bool:
        """Return whether another package that is here shows robots and has a file of a name, or it is called so."""
        known = [
            facts
            for facts in self.launched.workspace.packages
            if any(each.name == name for each in facts.launch_summaries)
        ]
        if not known:
            return SHOWING.search(name.lower()) is not None
        return any(shows(facts) for facts in known if facts.name != self.launched.package.name)

    def is_showing(self, facts: PackageFacts) -> bool:
        """Return whether a package shows what its launch files open."""
        if facts.name == self.launched.package.name:
            return bool(self.together)
        own = {posixpath.basename(each.path) for each in self.files if self.starts(each)}
        return shows(facts) or any(not own.isdisjoint(each.includes) for each in facts.launch_summaries)


def is_named_include(text: str, name: str, words: Iterable[frozenset[str]]) -> bool:
    """Return whether a robot includes a file; one of a computed name where it or a launch file names what it takes."""
    for found in INCLUDED.finditer(text):
        parts = COMPUTED.split(found.group(1).rpartition("/")[2])
        taken = re.fullmatch("(.*)".join(map(re.escape, parts)), name) if len(parts) <= MOST else None
        given = taken.groups() if taken is not None else ()
        if taken is not None and all(any(each in known for known in (words_of(text), *words)) for each in given):
            return True
    return False


def includes_of(file: LaunchFile) -> frozenset[str]:
    return frozenset(file_name(each.file) for each in file.includes) - {""}


def reached(name: str, included: dict[str, frozenset[str]]) -> set[str]:
    """Return a launch file with all that it includes, by their names."""
    found, waiting = {name}, [name]
    while waiting:
        more = included.get(waiting.pop(), frozenset()) - found
        found |= more
        waiting += more
    return found
