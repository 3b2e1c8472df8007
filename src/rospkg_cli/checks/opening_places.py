"""Whether something live is shown to open a world, a robot or a behavior tree: it names the file, and its place."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterator
from functools import cached_property
from typing import Annotated

from ..files import PackageFiles
from ..lazy_regex import regex
from ..light_dataclasses import dataclass
from ..package.package_facts import PackageFacts
from ..package.params.parameter_file import ParameterFile
from ..package.urdf.robot_words import is_launch, words_of
from ..package.workspace import Workspace
from ..source import Span
from ..unreadable import READABLE
from .launch.launch_context import LaunchContext
from .launch.unread_values import UnreadValues
from .left_files import LeftFiles
from .opened_in_share import OpenedInShare
from .params.launch_overrides import is_overridden
from .params.path_readers import PathReaders
from .repository.pages_and_scripts import pages_and_scripts
from .share.joined_shares import JoinedShares
from .share_uses import ShareUses
from .urdf.launched_robots import names
from .urdf.met_robots import OUTPUT
from .urdf.named_with_folder import means_inner_copy
from .urdf.robot_texts import COMMAND, has_folders
from .yaml_elsewhere import is_named_yaml

YAML = (".yaml", ".yml")
ROBOTS = (".urdf", ".xacro", ".sdf", ".world")

ROBOT = regex(r"<(?:robot|sdf)\b")
"""What includes a file opens it only where something opens that one."""


@dataclass(frozen=True)
class OpeningPlaces:
    files: PackageFiles
    package: PackageFacts
    workspace: Workspace
    left: LeftFiles | None = None
    launches: Annotated[tuple[LaunchContext, ...], READABLE] = ()
    parameters: Annotated[tuple[ParameterFile, ...], READABLE] = ()

    def has(self, path: str) -> bool:
        """Return whether a launch file, code, YAML that a node reads or a typed command names a file with its place.

        A bare name may be another file: Gazebo has an `empty.sdf` of its own, and looks for others on its paths alone.
        """
        return any(self.opens(own, text, path) for own, text in self.texts if own != path) or self.is_typed(path)

    def opens(self, own: str, text: str, path: str) -> bool:
        name = posixpath.basename(path)
        if name.partition(".")[0] not in text or own.endswith(ROBOTS) or (not own and ROBOT.search(text)):
            return False
        if not own:  # that package may have a file of this name, too
            return self.is_joined(text, name)
        if own.endswith(YAML) and not is_launch(own):
            return self.is_read_in(own, text, name) and self.is_placed(path, text)
        return self.is_written(name, text, is_launch(own)) and self.is_placed(path, text)

    def is_written(self, name: str, text: str, may_be_made: bool) -> bool:
        """Return whether a text has the name of a file in full; in a launch file its suffix may be put behind it."""
        return whole(name).search(text) is not None or (may_be_made and names(words_of(text), text, name))

    def is_placed(self, path: str, text: str) -> bool:
        """Return whether a text has the folder of a file, too, or joins its name to the share of the package."""
        folder, name = posixpath.split(path)
        last = posixpath.basename(folder)
        if folder and means_inner_copy(path, text, self.files.paths):
            return False
        return (bool(last) and has_folders(last, text)) or self.is_joined(text, name)

    def is_joined(self, text: str, name: str) -> bool:
        return JoinedShares(text, self.package.name).join(rf"{re.escape(name)}(?![\w.-])")

    def is_read_in(self, own: str, text: str, name: str) -> bool:
        """Return whether a parameter of YAML has the name of a file, and something is shown to read it."""
        if name not in text:
            return False
        source = self.files.readable_text(own)
        launches = tuple(each.file for each in self.launches)
        return any(
            self.readers.has(own, each, source) and not is_overridden(own, each, self.parameters, launches)
            for each in (Span(*found.span()) for found in whole(name).finditer(source))
        )

    @cached_property
    def readers(self) -> PathReaders:
        return PathReaders(self.files, self.workspace, self.parameters)

    def is_typed(self, path: str) -> bool:
        """Return whether a command of a page or a script opens a file by its place, and does not write it."""
        typed, place = re.compile(COMMAND), "/".join(path.split("/")[-2:])
        named = re.compile(rf"(?<![\w-]){re.escape(place)}(?![\w.-])")
        texts = pages_and_scripts(self.files) if "/" in place else ()
        lines = (line for text in texts if place in text for line in text.splitlines() if typed.search(line))
        return any(named.search(OUTPUT.sub("", line)) for line in lines)

    @cached_property
    def texts(self) -> tuple[tuple[str, str], ...]:
        """What may open files, each with its path in this package; without what nothing leads to, or reads."""
        shares = OpenedInShare(ShareUses(self.files, self.package.name, self.workspace))
        return tuple(self.live(shares.texts))

    def live(self, texts: tuple[tuple[str, str], ...]) -> Iterator[tuple[str, str]]:
        scopes = {each.file.path: each for each in self.launches}
        for own, text in texts:
            if own == "package.xml" or (own and not self.is_led_to(own)):
                continue
            scope = scopes.get(own)
            yield own, text if scope is None else UnreadValues(scope).read_text

    def is_led_to(self, path: str) -> bool:
        """Return whether something leads to a file that may open others; to YAML, that names it."""
        if path.endswith(YAML) and not is_launch(path):
            return is_named_yaml(path, self.package, self.workspace)
        return self.left is None or not self.left.has(path)


def whole(name: str) -> re.Pattern[str]:
    return re.compile(rf"(?<![\w.-]){re.escape(name)}(?![\w-]|\.\w)")
