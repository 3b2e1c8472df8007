"""DEP118: a path in YAML is a warning where code here or a well-known node is shown to read it by its key."""

from __future__ import annotations

import pytest

from rospkg_cli.example import BACKDROPS, CMAKE, existing_files, manifest, scripts, setup_py
from rospkg_cli.testing import lint_files

PLACE = "/home/ada/ws/src/my_pkg/data/a.xml"
LAUNCH = """\
<launch>
  <node pkg="my_pkg" exec="talker"><param from="$(find-pkg-share my_pkg)/config/a.yaml"/></node>
</launch>
"""
INSTALLS = "install(DIRECTORY config data launch DESTINATION share/${PROJECT_NAME})\nament_package"
BASE = {
    "package.xml": manifest("", "ament_cmake"),
    "CMakeLists.txt": CMAKE.replace("ament_package", INSTALLS),
    "data/a.xml": "<a/>\n",
    "launch/a.launch.xml": LAUNCH,
}
OWN = "people:\n  - name: ada\n    place: {}\n"


def level(files: dict[str, str]) -> str:
    (only,) = lint_files({**BASE, **files}, ["DEP118"]).findings
    assert only.message.endswith("read it by this key") is (only.severity.value == "info")
    return only.severity.value


def parameter(node: str, name: str) -> dict[str, str]:
    return {"config/a.yaml": f"{node}:\n  ros__parameters:\n    {name}: {PLACE}\n"}


@pytest.mark.parametrize(
    ("node", "name", "expected"),
    [
        ("bt_navigator", "default_nav_to_pose_bt_xml", "warning"),
        ("bt_navigator", "default_bt_xml_filename", "info"),
        ("bt_navigator", "navigate_to_pose_bt_xml_filename", "info"),
        ("/robot1/map_server", "yaml_filename", "warning"),
        ("/**", "yaml_filename", "warning"),
        ("map_of_hall", "yaml_filename", "warning"),
        ("bt_navigator", "yaml_filename", "info"),
        ("talker", "place", "info"),
    ],
)
def test_parameters_of_well_known_nodes(node: str, name: str, expected: str) -> None:
    assert level(parameter(node, name)) == expected


@pytest.mark.parametrize("name", ["default_bt_xml_filename", "bt_xml_filename"])
def test_what_only_older_distributions_have(name: str) -> None:
    files = parameter("bt_navigator", name)
    assert level({**files, "README.md": "For ROS 2 Foxy.\n"}) == "warning"
    assert level({**files, "README.md": "For ROS 2 Foxy and Humble.\n"}) == "info"
    assert level({**files, "README.md": "ROS 2 Galactic on Ubuntu 20.04\n"}) == "info"
    assert level({**files, "README.md": "Runs on Foxy and Galactic.\n"}) == "info"


@pytest.mark.parametrize(
    ("path", "text", "expected"),
    [
        ("src/a.cpp", 'void a() {declare_parameter("place", "");}\n', "warning"),
        ("my_pkg/a.py", "PLACE = 'place'\n", "warning"),
        ("my_pkg/a.py", "PLACE = 'places'\n", "info"),
        ("launch/b.launch.py", "GIVEN = {'place': 'a'}\n", "info"),
    ],
)
def test_code_that_has_the_name_of_a_parameter(path: str, text: str, expected: str) -> None:
    assert level({**parameter("talker", "place"), path: text}) == expected


@pytest.mark.parametrize(
    ("text", "expected"), [("print(each['place'])\n", "warning"), ("print(each.place)\n", "warning"), ("\n", "info")]
)
def test_values_of_a_format_of_ones_own(text: str, expected: str) -> None:
    opens = f"PEOPLE = open('config/a.yaml')\n{text}"
    assert level({"config/a.yaml": OWN.format(PLACE), "launch/b.launch.py": opens}) == expected
    listed = f"place:\n  - {PLACE}\n"
    assert level({"config/a.yaml": listed, "launch/b.launch.py": opens}) == expected


def test_code_with_a_path_is_told_as_before() -> None:
    files = {**existing_files(BACKDROPS["ament_python"]), "setup.py": setup_py(scripts("talker = my_pkg.talker:main"))}
    files["my_pkg/talker.py"] = f"def main():\n    return open('{PLACE}')\n"
    (only,) = lint_files({**files, "data/a.xml": ""}, ["DEP118"]).findings
    assert only.severity.value == "warning"


NODE = """\
#!/usr/bin/env python3
from rclpy.node import Node


class Talker(Node):
    def __init__(self):
        super().__init__('talker')
        self.declare_parameter('rate', 1.0)
        {}
        # self.get_parameter('place')
        rate = self.get_parameter('rate').value
"""


@pytest.mark.parametrize(
    ("line", "expected"),
    [
        ("self.declare_parameter('place', '')", "info"),
        ("self.declare_parameters('', [('place', ''), ('other', (1, 2))])", "info"),
        ("self.declare_parameter('place', '').value", "warning"),
        ("place = self.declare_parameter('place', '')", "warning"),
        ("self.declare_parameter('place', '')\n        self.get_parameter('place')", "warning"),
        ("self.declare_parameter('place', '')\n        self.get_parameter(name)", "warning"),
        ("self.declare_parameter('place', '')\n        self.get_parameters_by_prefix('')", "warning"),
        ("[self.declare_parameter(name, '') for name in ('place',)]", "warning"),
    ],
)
def test_a_parameter_that_python_declares_and_never_reads(line: str, expected: str) -> None:
    build = (
        f"{INSTALLS[: -len('ament_package')]}install(PROGRAMS scripts/talker.py DESTINATION lib/${{PROJECT_NAME}})\n"
    )
    files = {
        "scripts/talker.py": NODE.format(line),
        "CMakeLists.txt": CMAKE.replace("ament_package", f"{build}ament_package"),
    }
    assert level({**parameter("talker", "place"), **files}) == expected
