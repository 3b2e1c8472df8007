"""DEP202: what keeps it quiet."""

from __future__ import annotations

import pytest

from rospkg_cli.example import manifest
from rospkg_cli.testing import lint_files

NODE = "import rclpy\n"


def names(clean: dict[str, str], depends: str, **files: str) -> list[str]:
    tree = {**clean, "package.xml": manifest(f"  {depends}\n"), "my_pkg/node.py": NODE}
    tree |= {path.replace("__", "/", 1): text for path, text in files.items()}
    return [f.message.split("`")[1] for f in lint_files(tree, ["DEP202"]).findings]


def test_an_unused_one_is_named(clean) -> None:
    assert names(clean, "<depend>message_filters</depend>") == ["message_filters"]
    assert names(clean, "<depend>python3-numpy</depend>") == ["python3-numpy"]


@pytest.mark.parametrize(
    "depends",
    [
        "<exec_depend>robot_state_publisher</exec_depend>",
        "<test_depend>python3-pytest</test_depend>",
        "<depend>rclpy</depend>",
    ],
)
def test_what_may_be_started_by_name_or_is_used_is_not(clean, depends: str) -> None:
    assert names(clean, depends) == []


def test_launch_files_and_parameters_use_things(clean) -> None:
    launch = "<launch>\n  <node pkg='nav_msgs' exec='x'/>\n</launch>\n"
    assert names(clean, "<depend>nav_msgs</depend>", **{"launch__a.launch.xml": launch}) == []
    assert names(clean, "<depend>nav_msgs</depend>", **{"config__a.yaml": "plugin: nav_msgs/X\n"}) == []


def test_imports_of_another_name_and_in_tests_count(clean) -> None:
    assert names(clean, "<depend>python3-opencv</depend>", **{"my_pkg__see.py": "import cv2\n"}) == []
    assert names(clean, "<depend>tf2_ros_py</depend>", **{"my_pkg__tf.py": "import tf2_ros\n"}) == []
    assert names(clean, "<depend>nav_msgs</depend>", **{"test__test_a.py": "import nav_msgs.msg\n"}) == []


def test_a_package_without_code_gathers_on_purpose(clean) -> None:
    files = {**clean, "package.xml": manifest("  <depend>nav_msgs</depend>\n")}
    assert lint_files(files, ["DEP202"]).findings == ()
