"""Limits of joints for MoveIt and ros2_control, under names that nothing reads: `mix_position`."""

from __future__ import annotations

import posixpath
from collections.abc import Iterator

from ...files import PackageFiles
from ...languages.yaml.nodes import MappingNode, ScalarNode, YamlNode, documents
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.file_role import role_of
from ...package.package_facts import PackageFacts
from ...package.workspace import Workspace
from ...source import Span
from ...suggest import near_names
from ...unreadable import UnreadableError
from ..yaml_elsewhere import is_named_elsewhere

FILE = regex(r"(?:.*[/_])?joint_limits\.ya?ml")
TOP = "joint_limits"
OF_MOVEIT = "moveit_configs_utils"
"""Its MoveItConfigsBuilder opens `config/joint_limits.yaml`."""
UNCHANGED = frozenset({"false", "False", "0", "0.0", "0.", ""})
"""What says no more than that there is no limit."""
KNOWN = frozenset({
    "angle_wraparound", "has_acceleration_limits", "has_deceleration_limits", "has_effort_limits", "has_jerk_limits",
    "has_position_limits", "has_soft_limits", "has_velocity_limits", "k_position", "k_velocity", "max_acceleration",
    "max_deceleration", "max_effort", "max_jerk", "max_position", "max_velocity", "min_position", "soft_lower_limit",
    "soft_upper_limit",
})  # fmt: skip
"""What is read of each joint. (moveit_ros_planning, pilz_industrial_motion_planner, joint_limits)"""


Unread = tuple[ScalarNode, ScalarNode, tuple[str, ...]]
"""A name that nothing reads, its value, and the names that may be intended."""


@dataclass(frozen=True, slots=True)
class MistypedLimit:
    path: str
    span: Span
    name: str
    intended: tuple[str, ...]
    others: tuple[Span, ...]
    """Where the same name is given for other joints."""
    is_met: bool = True
    """Whether something is shown to open the file, and a value is more than what stands there by default."""


@dataclass(frozen=True)
class JointLimits:
    files: PackageFiles
    package: PackageFacts
    workspace: Workspace

    def mistyped(self) -> Iterator[MistypedLimit]:
        """Yield each name one letter from a limit that is read and that the joint does not have; once for each file."""
        for path in self.files.paths:
            if FILE.fullmatch(path) and role_of(path) not in ("test", "aside"):
                found: dict[str, list[Unread]] = {}
                for each in self.unread(path):
                    found.setdefault(each[0].text, []).append(each)
                for name, same in found.items():
                    (key, _, intended), *others = same
                    is_met = self.is_opened(path) and not all(value.text in UNCHANGED for _, value, _ in same)
                    again = tuple(each.span for each, _, _ in others)
                    yield MistypedLimit(path, key.span, name, intended, again, is_met)

    def is_opened(self, path: str) -> bool:
        """Return whether something names the file, or MoveIt looks for it by its usual name."""
        stem = posixpath.splitext(posixpath.basename(path))[0]
        if is_named_elsewhere(stem, self.package, self.workspace) or stem in self.package.named_yaml:
            return True
        needing = (self.package, *self.workspace.needing(self.package.name))
        return stem == TOP and any(each.name == OF_MOVEIT for facts in needing for each in facts.dependencies)

    def unread(self, path: str) -> Iterator[Unread]:
        try:
            roots = documents(self.files.source(path))
        except UnreadableError:
            return
        for joint in (each for root in roots for top in named(root, TOP) for each in values(top)):
            names = {key.text for key, _ in joint.entries if isinstance(key, ScalarNode)}
            for key, value in joint.entries:
                if isinstance(key, ScalarNode) and isinstance(value, ScalarNode) and key.text not in KNOWN:
                    near = near_names(key.text, KNOWN - names, 1)
                    if near:
                        yield key, value, tuple(sorted(near))


def named(node: YamlNode, name: str) -> Iterator[YamlNode]:
    """Yield what a mapping has under a name."""
    for key, value in node.entries if isinstance(node, MappingNode) else ():
        if isinstance(key, ScalarNode) and key.text == name:
            yield value


def values(node: YamlNode) -> Iterator[MappingNode]:
    for _, value in node.entries if isinstance(node, MappingNode) else ():
        if isinstance(value, MappingNode):
            yield value
