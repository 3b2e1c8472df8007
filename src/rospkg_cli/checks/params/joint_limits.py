"""Limits of joints for MoveIt and ros2_control, under names that nothing reads: `mix_position`."""

from __future__ import annotations

from collections.abc import Iterator

from ...files import PackageFiles
from ...languages.yaml.nodes import MappingNode, ScalarNode, YamlNode, documents
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.file_role import role_of
from ...source import Span
from ...suggest import near_names
from ...unreadable import UnreadableError

FILE = regex(r"(?:.*[/_])?joint_limits\.ya?ml")
TOP = "joint_limits"
KNOWN = frozenset({
    "angle_wraparound", "has_acceleration_limits", "has_deceleration_limits", "has_effort_limits", "has_jerk_limits",
    "has_position_limits", "has_soft_limits", "has_velocity_limits", "k_position", "k_velocity", "max_acceleration",
    "max_deceleration", "max_effort", "max_jerk", "max_position", "max_velocity", "min_position", "soft_lower_limit",
    "soft_upper_limit",
})  # fmt: skip
"""What is read of each joint. (moveit_ros_planning, pilz_industrial_motion_planner, joint_limits)"""


@dataclass(frozen=True, slots=True)
class MistypedLimit:
    path: str
    span: Span
    name: str
    meant: tuple[str, ...]
    others: tuple[Span, ...]
    """Where the same name stands for other joints."""


@dataclass(frozen=True)
class JointLimits:
    files: PackageFiles

    def mistyped(self) -> Iterator[MistypedLimit]:
        """Yield each name that is a letter off those that are read, and that the joint does not have; once a file."""
        for path in self.files.paths:
            if FILE.fullmatch(path) and role_of(path) not in ("test", "aside"):
                found: dict[str, list[tuple[Span, tuple[str, ...]]]] = {}
                for key, near in self.unread(path):
                    found.setdefault(key.text, []).append((key.span, near))
                for name, ((span, meant), *others) in found.items():
                    yield MistypedLimit(path, span, name, meant, tuple(each for each, _ in others))

    def unread(self, path: str) -> Iterator[tuple[ScalarNode, tuple[str, ...]]]:
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
                        yield key, tuple(sorted(near))


def named(node: YamlNode, name: str) -> Iterator[YamlNode]:
    """Yield what a mapping has under a name."""
    for key, value in node.entries if isinstance(node, MappingNode) else ():
        if isinstance(key, ScalarNode) and key.text == name:
            yield value


def values(node: YamlNode) -> Iterator[MappingNode]:
    for _, value in node.entries if isinstance(node, MappingNode) else ():
        if isinstance(value, MappingNode):
            yield value
