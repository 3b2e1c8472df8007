"""Files that maps and parameter files name (PRM010)."""

from __future__ import annotations

import pytest

from rospkg_cli.example import manifest
from rospkg_cli.testing import lint_files

MAP = "image: {}\nresolution: 0.05\norigin: [0.0, 0.0, 0.0]\nnegate: 0\noccupied_thresh: 0.65\nfree_thresh: 0.25\n"
OPENS = "<launch><log message='$(find-pkg-share my_pkg)/{}'/></launch>\n"
TREE = "bt_navigator:\n  ros__parameters:\n    default_nav_to_pose_bt_xml: {}\n"
FILES: dict[str, str | None] = {
    "package.xml": manifest("", "ament_cmake"),
    "CMakeLists.txt": "project(my_pkg)\nfind_package(ament_cmake REQUIRED)\n"
    "install(DIRECTORY config launch maps DESTINATION share/${PROJECT_NAME})\nament_package()\n",
    "maps/hall.pgm": "",
    "maps/old/hall.pgm": "",
    "config/a.xml": "",
}


def told(**files: str) -> list[tuple[str, str]]:
    found = lint_files({**FILES, **files}, ["PRM010"]).findings
    return [(each.severity.value, each.message) for each in found]


def test_the_image_of_a_map_has_another_name() -> None:
    named = {"launch/a.launch.xml": OPENS.format("maps/office.yaml")}
    ((level, message),) = told(**{"maps/office.yaml": MAP.format("hal.pgm"), **named})
    assert level == "warning"
    assert message.endswith("did you mean `hall.pgm`?")
    assert told(**{"maps/office.yaml": MAP.format("nothing_alike.png")})[0][0] == "info"


NAV2 = "<launch><include file='$(find-pkg-share nav2_bringup)/launch/bringup_launch.py'/><log message='{}'/></launch>\n"


@pytest.mark.parametrize(
    ("launch", "level"),
    [
        (NAV2.format("$(find-pkg-share my_pkg)/maps/hall.yaml"), "warning"),
        (NAV2.format("maps_of_others/hall.yaml"), "info"),
        (OPENS.format("maps/office.png"), "info"),
        (OPENS.format("config/office.yaml"), "warning"),
        ("<launch><arg name='map' default='$(find-pkg-share my_pkg)/maps/office.yaml'/></launch>\n", "info"),
    ],
)
def test_a_map_is_met_where_it_is_named_or_as_one_of_those_that_nav2_is_given(launch: str, level: str) -> None:
    files = {"maps/office.yaml": MAP.format("gone.png"), "src/a.py": "NAME = f'{1}.yaml'\n"}
    assert told(**files, **{"launch/a.launch.xml": launch})[0][0] == level


def test_a_name_of_several_maps_needs_its_folder() -> None:
    files = {"maps/big/office.yaml": MAP.format("gone.png"), "maps/office.yaml": MAP.format("hall.pgm")}
    assert told(**files, **{"launch/a.launch.xml": OPENS.format("maps/office.yaml")})[0][0] == "info"
    assert told(**files, **{"launch/a.launch.xml": OPENS.format("maps/big/office.yaml")})[0][0] == "warning"


PARSED = """\
#!/usr/bin/env python3
import os
import yaml
from ament_index_python.packages import get_package_share_directory

SHARE = get_package_share_directory('my_pkg')
with open(os.path.join(SHARE, 'maps', 'office.yaml')) as file:
    DATA = yaml.safe_load(file)
print(DATA['resolution'])
"""
HANDED = PARSED.partition("with open")[0] + "PLACE = os.path.join(SHARE, 'maps', 'office.yaml')\nshow(PLACE)\n"


@pytest.mark.parametrize(
    ("code", "level"),
    [
        (PARSED, "info"),
        (PARSED.replace("resolution", "image"), "warning"),
        (HANDED, "warning"),
        (f"{HANDED}PICTURE = os.path.join(SHARE, 'worlds', 'hall.pgm')\n", "info"),
        (f"{PARSED}from nav2_msgs.srv import LoadMap\n", "warning"),
        (f"{PARSED}COMMAND = 'ros2 run nav2_map_server map_server'\n", "warning"),
    ],
)
def test_a_map_of_which_programs_read_other_keys(code: str, level: str) -> None:
    build = f"{FILES['CMakeLists.txt']}install(PROGRAMS scripts/a.py DESTINATION lib/${{PROJECT_NAME}})\n"
    files = {"maps/office.yaml": MAP.format("gone.png"), "CMakeLists.txt": build, "scripts/a.py": code}
    assert told(**files)[0][0] == level
    assert told(**files, **{"launch/a.launch.xml": OPENS.format("maps/office.yaml")})[0][0] == "warning"


def test_a_parameter_that_nobody_is_shown_to_read() -> None:
    value = "$(find-pkg-share my_pkg)/config/b.xml"
    files = {"config/nav.yaml": TREE.format(value), "launch/a.launch.xml": OPENS.format("config/nav.yaml")}
    own = {**files, "config/nav.yaml": files["config/nav.yaml"].replace("default_nav_to_pose_bt_xml", "my_tree")}
    ((level, message),) = told(**own)
    assert (level, "read it by this key; add it" in message) == ("info", True)
    assert told(**own, **{"src/a.py": "print(node.declare_parameter('my_tree', '').value)\n"})[0][0] == "warning"


@pytest.mark.parametrize(
    "image",
    [
        "hall.pgm",
        "'hall.pgm'",
        "old/hall.pgm  # the older one",
        "/home/ada/hall.pgm",
        "../../elsewhere/hall.pgm",
        "$(x).pgm",
        "",
    ],
)
def test_an_image_that_is_there_or_elsewhere(image: str) -> None:
    assert told(**{"maps/office.yaml": MAP.format(image)}) == []


def test_an_image_that_git_ignores_or_a_test_needs() -> None:
    assert told(**{"maps/office.yaml": MAP.format("made.pgm"), ".gitignore": "*.pgm\n"}) == []
    assert told(**{"test/maps/office.yaml": MAP.format("made.pgm")}) == []
    assert told(**{"config/camera.yaml": "image: made.pgm\nresolution: 5\n"}) == []


@pytest.mark.parametrize("value", ['"$(find-pkg-share my_pkg)/config/b.xml"', "package://my_pkg/config/b.xml # why"])
def test_a_parameter_names_a_file_that_is_missing(value: str) -> None:
    files = {"config/nav.yaml": TREE.format(value), "launch/a.launch.xml": OPENS.format("config/nav.yaml")}
    ((level, message),) = told(**files)
    assert level == "warning"
    assert message.startswith("`my_pkg` has no file `config/b.xml`")
    given = "<launch><let name='default_nav_to_pose_bt_xml' value='a'/><log message='nav.yaml'/></launch>\n"
    assert told(**{**files, "launch/a.launch.xml": given})[0][0] == "info"


@pytest.mark.parametrize(
    "value",
    [
        "$(find-pkg-share my_pkg)/config/a.xml",
        "$(find-pkg-share other)/config/b.xml",
        "$(find-pkg-share my_pkg)/config/$(var b).xml",
        "$(find-pkg-share my_pkg)/config",
    ],
)
def test_a_parameter_names_a_file_that_may_be_there(value: str) -> None:
    files = {"config/nav.yaml": TREE.format(f'"{value}"'), "launch/a.launch.xml": OPENS.format("config/nav.yaml")}
    assert told(**files) == []


def test_what_a_macro_may_install_is_not_told() -> None:
    files = {"config/nav.yaml": TREE.format("package://my_pkg/config/b.xml")}
    unknown = f"{FILES['CMakeLists.txt']}".replace("config launch maps", "${SOME_FOLDERS}")
    assert told(**files, **{"CMakeLists.txt": unknown}) == []


@pytest.mark.parametrize(
    ("key", "named", "more", "level"),
    [
        ("tree_file", "trees/a.xml", "", "warning"),
        ("output_file", "out/a.xml", "", "info"),
        ("log_path", "out/a.xml", "", "info"),
        ("logic_path", "out/a.xml", "", "warning"),
        ("model_path", "networks/a.onnx", "", "info"),
        ("model_path", "networks/a.onnx", "config/other.onnx", "warning"),
        ("tree_file", "config/trees.xml", "config/trees.zip", "info"),
        ("tree_file", "config/trees.xml", "config/forest.zip", "warning"),
    ],
)
def test_what_a_node_writes_or_people_bring(key: str, named: str, more: str, level: str) -> None:
    values = f"talker:\n  ros__parameters:\n    {key}: $(find-pkg-share my_pkg)/{named}\n"
    files = {"config/talker.yaml": values, "launch/a.launch.xml": OPENS.format("config/talker.yaml")}
    code = f"from rclpy.node import Node\n\n\nnode = Node('talker')\nprint(node.declare_parameter('{key}', '').value)\n"
    ((found, _),) = told(**files, **{"src/a.py": code}, **({more: ""} if more else {}))
    assert found == level


def test_a_map_whose_image_is_packed() -> None:
    named = {"launch/a.launch.xml": OPENS.format("maps/office.yaml"), "maps/office.tar.gz": ""}
    ((level, message),) = told(**{"maps/office.yaml": MAP.format("office.pgm"), **named})
    assert level == "info"
    assert "until `maps/office.tar.gz` is unpacked" in message
