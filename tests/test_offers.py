"""The commands of `rospkg add` that messages offer."""

from __future__ import annotations

import pytest

from rospkg_cli.edits.offers import file_command, how_to_have, node_command
from rospkg_cli.package.package_facts import PackageFacts

OWN = PackageFacts("my_pkg", "my_pkg", "ament_python")
OTHER = PackageFacts("other_pkg", "other_pkg", "ament_cmake")
PLAIN = PackageFacts("plain", "plain", "cmake")


@pytest.mark.parametrize(
    ("facts", "path", "command"),
    [
        (OWN, "launch/up.launch.py", "rospkg add launch up.launch.py"),
        (OWN, "launch/up_launch.xml", "rospkg add launch up_launch.xml"),
        (OTHER, "launch/up.launch.yaml", "rospkg add launch up.launch.yaml --package other_pkg"),
        (OWN, "config/robot.yaml", "rospkg add params config/robot"),
        (OWN, "params/robot.yaml", "rospkg add params params/robot"),
        (OWN, "launch/deep/up.launch.py", ""),
        (OWN, "launch/up.py", ""),
        (OWN, "rviz/a.rviz", ""),
        (PLAIN, "config/robot.yaml", ""),
    ],
)
def test_what_makes_a_file(facts: PackageFacts, path: str, command: str) -> None:
    assert file_command(facts, path, OWN) == command


def test_what_makes_an_executable() -> None:
    assert node_command(OWN, "talker", OWN) == "rospkg add node talker"
    assert node_command(OTHER, "talker", OWN) == "rospkg add node talker --package other_pkg"
    assert node_command(OWN, "talker.py", OWN) == ""
    assert node_command(OWN, "my_pkg", OWN) == ""
    assert node_command(PLAIN, "talker", OWN) == ""
    written = PackageFacts("my_pkg", "my_pkg", "ament_python", modules=frozenset({"my_pkg", "my_pkg.talker"}))
    assert node_command(written, "talker", OWN) == ""
    assert node_command(written, "hearer", OWN) == "rospkg add node hearer"


def test_files_of_the_same_name_are_named_before_a_command() -> None:
    share = PackageFacts("my_pkg", "my_pkg", "ament_python", share_files=frozenset({"a/b.yaml", "config/c/robot.yaml"}))
    assert how_to_have(share, "config/robot.yaml", OWN) == "correct the path: there is `config/c/robot.yaml`"
    assert how_to_have(share, "config/b.txt", OWN) == "add it, or correct the path"
    assert how_to_have(share, "config/x.yaml", OWN) == "`rospkg add params config/x` adds it, or correct the path"
