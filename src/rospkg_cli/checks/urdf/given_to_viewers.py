"""Whether a launch file passes a robot to nodes that read meshes by their URLs, or to Gazebo alone (URD002)."""

from __future__ import annotations

from collections.abc import Iterable

from ...lazy_regex import regex
from ...light_dataclasses import replace
from ...package.package_facts import PackageFacts

READERS = regex(r"(?i)robot_state_publisher|move_?it|move_?group|\brviz2?\b")
"""Programs that publish a robot for RViz, and programs that read it themselves."""
NAMED_SO = regex(r"(?i)description|rsp|state_pub|urdf")
"""In the names of launch files of other packages that publish the robot they are given."""
PUBLISHERS = frozenset({"robot_state_publisher", "rviz2", "move_group", "moveit_ros_move_group"})
SPAWNERS = frozenset({"ros_gz_sim", "ros_ign_gazebo", "gazebo_ros", "spawn_entity"})


def hands_on(texts: Iterable[str]) -> bool:
    """Return whether a launch file, with what it includes, starts a reader of robots other than Gazebo."""
    return any(READERS.search(text) is not None for text in texts)


def without_spawned(facts: PackageFacts) -> PackageFacts:
    """Return a package without the texts that name a robot for a spawner of Gazebo, and start no other reader."""
    kept = tuple(words for words in facts.robot_words if not is_for_gazebo(words))
    return facts if len(kept) == len(facts.robot_words) else replace(facts, robot_words=kept)


def is_for_gazebo(words: frozenset[str]) -> bool:
    return not SPAWNERS.isdisjoint(words) and PUBLISHERS.isdisjoint(words)
