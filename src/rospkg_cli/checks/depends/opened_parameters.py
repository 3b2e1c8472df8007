"""Which parameter files of a package a launch file, a robot or another package may name."""

from __future__ import annotations

import re
from functools import cached_property

from ...files import PackageFiles
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.launch.launch_file import LaunchFile
from ...package.launch.live_text import live_text, without_unread
from ...package.launch.text import uncommented
from ...package.package_facts import PackageFacts
from ...package.params.named_yaml import ANY, puts_together
from ...package.plugins.unspawned_controllers import not_looked_up
from ...package.urdf.robot_file import RobotFile
from ...package.workspace import Workspace
from ...ros.names import NameKind
from ..yaml_elsewhere import is_named_elsewhere

EXAMPLE = regex(r"(?:^|[_/.-])examples?(?:[_/.-]|$)")
LOOKS = "MoveItConfigsBuilder"
USUAL = regex(
    r"kinematics|joint_limits|moveit_cpp|pilz_cartesian_limits|sensors_3d|\w*_planning(?:_pipelines)?|\w*controllers"
)
"""MoveIt looks for the files of its configs by their names alone: these, and none that is called otherwise."""
STARTING = (".py", ".sh", ".bash", ".cpp", ".cc", ".xml", ".launch", ".md", ".service", ".hpp")
STARTS = regex(r"\bros2\b|params[-_]file|LaunchService|LaunchDescription|<launch\b|launch_ros|NodeOptions")
"""Words of a text that starts nodes."""
SPAWNS = regex(r"spawner|_controllers?\b|(?:controllers|demo)_launch|IncludeLaunchDescription|<include\b|\binclude:")
"""What loads controllers in a launch file, or may: a spawner, `ros2 control`, MoveIt's own launches, other files."""


@dataclass(frozen=True)
class OpenedParameters:
    package: PackageFacts
    workspace: Workspace
    launch_files: tuple[LaunchFile, ...]
    robots: tuple[RobotFile, ...]
    """Those that something opens."""
    files: PackageFiles

    def may_have(self, path: str) -> bool:
        """Return whether something may load a file into a node; other files are examples, or left over."""
        stem = path.rpartition("/")[2].rpartition(".")[0]
        word = re.compile(rf"\b{re.escape(stem)}\b")
        found = re.compile(rf"(?:\$\(find\s+([\w-]*)|package:/+([\w-]*)|\$\{{)[^<>\"'\n]*{word.pattern}")
        is_usual = USUAL.fullmatch(stem) is not None
        opens = any((is_usual and LOOKS in text) or word.search(text) for text in self.launches)
        if opens or any(self.may_be_own(each[1] or each[2]) for text in self.texts for each in found.finditer(text)):
            return True
        return not EXAMPLE.search(path) and (self.may_put_together or self.is_named_elsewhere(stem))

    @cached_property
    def may_put_together(self) -> bool:
        """Whether the name of a parameter file may be put together: by a launch file, or by code that starts nodes.

        Other code puts the names of its own files together, as those of maps and results.
        """
        if ANY not in self.package.named_yaml:
            return False
        texts = (live_text(self.files, path) for path in self.files.paths if path.endswith(STARTING))
        return any(puts_together(text) for text in (*self.launches, *filter(STARTS.search, texts)))

    def may_be_own(self, name: str) -> bool:
        """Return whether a robot may mean this package by a name: a former one of it is known nowhere."""
        is_known = self.workspace.is_available(name) or self.workspace.kind_of(name) is NameKind.PACKAGE
        return name in ("", self.package.name) or not is_known

    def is_spawned(self, controller: str) -> bool:
        """Return whether a launch file of the package names a controller, but in a path, a topic or a look-up."""
        word = re.compile(rf"(?<![\w/.-]){not_looked_up(controller)}(?![\w/.-])")
        return any(map(word.search, self.launches))

    @cached_property
    def may_spawn(self) -> bool:
        """Whether a launch file of the package loads controllers, or includes another file that may."""
        return any(map(SPAWNS.search, self.launches))

    def is_named_elsewhere(self, stem: str) -> bool:
        """Return whether a text of another package, or one of its robots, names a file."""
        others = (facts for facts in self.workspace.packages if facts.name != self.package.name)
        in_robots = any({self.package.name, stem} <= words for facts in others for words in facts.robot_words)
        return in_robots or is_named_elsewhere(stem, self.package, self.workspace)

    @cached_property
    def launches(self) -> tuple[str, ...]:
        """The texts of launch files, without comments."""
        return tuple(map(live, self.launch_files))

    @cached_property
    def texts(self) -> tuple[str, ...]:
        """The texts of robots, which name parameter files by the packages that hold them, without comments."""
        return tuple(uncommented(robot.path, robot.source.text) for robot in self.robots)


def live(file: LaunchFile) -> str:
    if file.is_ros1:  # which ROS 2 does not start
        return ""
    return uncommented(file.path, without_unread(file.python) if file.python is not None else file.source.text)
