"""Packages of known names that are not here: a list of repositories, or a clone, may bring another one."""

from __future__ import annotations

import pytest

from rospkg_cli.engine.run.scope import Scope
from rospkg_cli.engine.run.session import Session
from rospkg_cli.example import manifest
from rospkg_cli.ros.distros import Targets
from rospkg_cli.tree import MemoryTree

CLONE = "`git clone https://example.org/topic_monitor.git`\n"
APT = "RUN apt-get install -y ros-${ROS_DISTRO}-topic-monitor\n"


def told(node: str, missing: str = "", **others: str) -> list[str]:
    """Return the levels and messages on a node of another package."""
    files = {"a/package.xml": manifest(), "a/launch/a.launch.xml": f"<launch><node {node}/></launch>\n"}
    files |= {path.replace("_", "."): text for path, text in others.items()}
    scope = Scope(
        ("a",), frozenset({"a"}), "my_ws", missing, missing_repositories=frozenset({"time"} if missing else ())
    )
    found = Session(MemoryTree.of(files), scope, frozenset({"LCH002"}), Targets()).run().findings
    return [f"{each.severity.value}: {each.message}" for each in found]


MONITOR = 'pkg="topic_monitor" exec="topic_monitor_node"'
LISTED = "`underlay` lists repositories that are not here (time)"


@pytest.mark.parametrize(
    "node, missing, others, level",
    [
        (MONITOR, "", {}, "error"),
        (MONITOR, LISTED, {}, "info"),
        (MONITOR, LISTED, {"Dockerfile": APT}, "error"),
        (MONITOR, "", {"README_md": CLONE}, "info"),
        (MONITOR, "", {"README_md": CLONE.replace("topic_monitor", "my_ws")}, "error"),
        (MONITOR, "", {"README_md": "vcs import src < https://example.org/all\n"}, "info"),
        ('pkg="tf2_ros" exec="static_transform_publishe"', LISTED, {}, "error"),
    ],
)
def test_another_package_of_a_known_name_may_be_meant(node: str, missing: str, others: dict, level: str) -> None:
    (message,) = told(node, missing, **others)
    assert message.startswith(f"{level}: ")


def test_the_message_says_what_may_have_it() -> None:
    (message,) = told(MONITOR, LISTED)
    assert "unless a listed repository that is not here has another package of this name" in message
