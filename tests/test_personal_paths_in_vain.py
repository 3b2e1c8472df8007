"""DEP118: paths that no plain run comes to, that nothing reads, or that people are told to replace, are infos."""

from __future__ import annotations

import pytest

from rospkg_cli.example import CMAKE, SETUP_CFG, SETUP_PY_FOR_ALL, manifest
from rospkg_cli.testing import lint_files

PATH = "/home/ada/ws/src/my_pkg/config/robot.yaml"
SETUP = SETUP_PY_FOR_ALL.replace(
    "    license=", "    entry_points={'console_scripts': ['talker = my_pkg.talker:main']},\n    license="
)
PYTHON = {
    "package.xml": manifest("  <exec_depend>rclpy</exec_depend>\n"),
    "setup.py": SETUP,
    "setup.cfg": SETUP_CFG,
    "resource/my_pkg": "",
    "my_pkg/__init__.py": "",
    "config/robot.yaml": "/**:\n  ros__parameters:\n    rate: 2.0\n",
}
NODE = """\
import os

import rclpy
from rclpy.node import Node

DEBUG = {state}


class Talker(Node):
    def __init__(self):
        super().__init__('talker')
{body}

    def load(self):
        return open(self.path)


def main():
    rclpy.init()
    rclpy.spin(Talker())
"""
OPENS = f"        self.f = open('{PATH}')\n"


def levels(files: dict[str, str], page: str = "") -> list[str]:
    tree = {f"src/my_pkg/{path}": text for path, text in files.items()} | {"README.md": page}
    return [each.severity.value for each in lint_files(tree, ["DEP118"]).findings]


def in_node(body: str, state: str = "False") -> dict[str, str]:
    return {**PYTHON, "my_pkg/talker.py": NODE.format(body=body, state=state)}


def in_file(text: str, **others: str) -> dict[str, str]:
    return {**PYTHON, "my_pkg/talker.py": text, **others}


SWITCHED = f"        if DEBUG:\n    {OPENS}"
ASKED = "        self.declare_parameter('debug', {})\n        if self.get_parameter('debug').value:\n    " + OPENS
CHOSEN = f"        self.f = open('{PATH}' if DEBUG else 'robot.yaml')\n"


@pytest.mark.parametrize(
    ("quiet", "loud"),
    [
        (in_node(SWITCHED), in_node(SWITCHED, "True")),
        (in_node(CHOSEN), in_node(CHOSEN, "True")),
        (in_node(ASKED.format("False")), in_node(ASKED.format("True"))),
    ],
)
def test_a_path_behind_a_switch(quiet: dict[str, str], loud: dict[str, str]) -> None:
    assert levels(quiet) == ["info"]
    assert levels(loud) == ["warning"]
    assert levels(in_node(ASKED.format("False")), "Start it with `-p debug:=true`.\n") == ["warning"]


CONSTANT = f"FILE = '{PATH}'\n\n\ndef main():\n    print({{}})\n"
METHOD = "    def go(self):\n        print({})\n\n\ndef main():\n    Talker().go()\n"
OF_CLASS = f"class Talker:\n    FILE = '{PATH}'\n\n{METHOD}"
MEMBER = f"        self.path = '{PATH}'\n{{}}        self.path = 'robot.yaml'\n        self.load()\n"
LOCAL = f"        path = '{PATH}'\n{{}}        path = 'robot.yaml'\n        open(path)\n"


@pytest.mark.parametrize(
    ("quiet", "loud"),
    [
        (in_file(CONSTANT.format("")), in_file(CONSTANT.format("open(FILE)"))),
        (in_file(OF_CLASS.format("")), in_file(OF_CLASS.format("open(self.FILE)"))),
        (in_node(MEMBER.format("")), in_node(MEMBER.format("        self.load()\n"))),
        (in_node(LOCAL.format("")), in_node(LOCAL.format("        open(path)\n"))),
    ],
)
def test_a_path_that_nothing_reads(quiet: dict[str, str], loud: dict[str, str]) -> None:
    assert levels(quiet) == ["info"]
    assert levels(loud) == ["warning"]


def test_a_constant_that_another_file_or_package_takes() -> None:
    tree = in_file("def main():\n    pass\n", **{"my_pkg/places.py": f"FILE = '{PATH}'\n"})
    taking = {**tree, "my_pkg/talker.py": "from my_pkg.places import FILE\n\n\ndef main():\n    open(FILE)\n"}
    assert levels(taking) == ["warning"]
    taking = {**tree, "my_pkg/talker.py": "from my_pkg import places\n\n\ndef main():\n    open(places.FILE)\n"}
    assert levels(taking) == ["warning"]


@pytest.mark.parametrize(
    "page",
    [
        "Paths are hard-coded. Please change them to yours before you start.\n",
        "You have to adapt the absolute paths in the code.\n",
        "Replace `/home/ada/ws` by your workspace.\n",
        '    sed -i "s#/home/ada#$HOME#" src/my_pkg/my_pkg/*.py\n',
        "    docker run -it -v $PWD:/home/ada/ws ros:jazzy\n",
        "    docker run --mount type=bind,source=.,target=/home/ada/ws ros:jazzy\n",
    ],
)
def test_a_page_that_has_people_replace_the_home(page: str) -> None:
    assert levels(in_node(OPENS), page) == ["info"]


@pytest.mark.parametrize(
    "page",
    [
        "    cd /home/ada/ws && colcon build\n",
        "    docker run -it -v /home/ada/ws:/ws ros:jazzy\n",
        "Replace `/home/adam/ws` by your workspace.\n",
        "Parameters may be changed. There are no hard-coded limits.\n",
    ],
)
def test_a_page_that_says_something_else(page: str) -> None:
    assert levels(in_node(OPENS), page) == ["warning"]


@pytest.mark.parametrize(("account", "level"), [("ada", "info"), ("root", "warning")])
def test_the_account_of_a_unit(account: str, level: str) -> None:
    unit = f"[Service]\nUser={account}\nExecStart=/opt/ros/start\n"
    assert levels({**in_node(OPENS), "systemd/robot.service": unit}) == [level]


@pytest.mark.parametrize(
    ("comment", "level"),
    [
        ("update the path to match your machine", "info"),
        ("set to your own", "info"),
        ("update the path of the file", "warning"),
        ("set up the path", "warning"),
    ],
)
def test_a_comment_at_a_path(comment: str, level: str) -> None:
    assert levels(in_node(f"        # {comment}\n{OPENS}")) == [level]


DECLARED = f"        self.declare_parameter('file', '{PATH}')\n        open(self.get_parameter('file').value)\n"


@pytest.mark.parametrize(
    ("page", "level"),
    [
        ("    ros2 run my_pkg talker --ros-args -p file:=a.yaml\n", "info"),
        ("    ros2 run my_pkg talker --ros-args -p profile:=a.yaml\n", "warning"),
        ("    ros2 run my_pkg talker\n", "warning"),
    ],
)
def test_the_default_of_a_parameter_that_pages_give(page: str, level: str) -> None:
    assert levels(in_node(DECLARED), page) == [level]


SOURCE = "#include <fstream>\n#include <string>\n{top}\nint main()\n{{\n{body}\n}}\n"
LINES = """\
option(WITH_ARM "" OFF)
add_executable(talker src/talker.cpp)
add_executable(other src/other.cpp)
install(TARGETS talker other DESTINATION lib/${PROJECT_NAME})
install(DIRECTORY launch DESTINATION share/${PROJECT_NAME})
"""
LAUNCH = '<launch><node pkg="my_pkg" exec="talker"/></launch>\n'


def in_cpp(body: str, top: str = "", lines: str = "", file: str = "talker") -> dict[str, str]:
    sources = {f"src/{each}.cpp": SOURCE.format(top="", body="") for each in ("talker", "other")}
    return {
        "package.xml": manifest("", "ament_cmake"),
        "CMakeLists.txt": CMAKE.replace("ament_package", f"{LINES}{lines}ament_package"),
        "config/robot.yaml": "",
        "launch/talker.launch.xml": LAUNCH,
        **sources,
        f"src/{file}.cpp": SOURCE.format(top=top, body=body),
    }


READS = f'std::ifstream file("{PATH}");'
KEPT = f'std::string path = "{PATH}";'


@pytest.mark.parametrize(
    ("quiet", "loud"),
    [
        (in_cpp(KEPT), in_cpp(KEPT + "\nstd::ifstream file(path);")),
        (in_cpp(f'{KEPT}\npath = get("path");\nopen(path);'), in_cpp(f'{KEPT}\npath = path + "/a";\nopen(path);')),
        (in_cpp("", f'const char * FILE = "{PATH}";'), in_cpp("open(FILE);", f'const char * FILE = "{PATH}";')),
        (in_cpp(f"if (false) {{\n{READS}\n}}"), in_cpp(f"if (true) {{\n{READS}\n}}")),
        (in_cpp(f"if (on) {{\n{READS}\n}}", "constexpr bool on = false;"), in_cpp(READS)),
        (in_cpp(READS, file="other"), in_cpp(READS)),
    ],
)
def test_what_no_run_of_cpp_comes_to(quiet: dict[str, str], loud: dict[str, str]) -> None:
    assert levels(quiet) == ["info"]
    assert levels(loud) == ["warning"]


COPIES = f"configure_file({PATH} robot.yaml)\n"


@pytest.mark.parametrize(
    ("lines", "level"),
    [
        (f"if(WITH_ARM)\n{COPIES}endif()\n", "info"),
        (f"if(EXISTS {PATH})\n{COPIES}endif()\n", "info"),
        (f"if(UNIX)\n{COPIES}endif()\n", "warning"),
        (COPIES, "warning"),
    ],
)
def test_what_no_build_comes_to(lines: str, level: str) -> None:
    assert levels(in_cpp("", lines=lines)) == [level]


@pytest.mark.parametrize(("block", "level"), [("other", "info"), ("talker", "warning")])
def test_a_block_that_no_node_reads(block: str, level: str) -> None:
    text = f"{block}:\n  ros__parameters:\n    path: {PATH.replace('config', 'maps')}\n"
    launch = LAUNCH.replace("/>", '><param from="$(find-pkg-share my_pkg)/config/robot.yaml"/></node>')
    code = NODE.format(body="        open(self.declare_parameter('path', '').value)", state="False")
    files = {"config/robot.yaml": text, "launch/a.launch.xml": launch, "maps/robot.yaml": ""}
    assert levels(in_file(code, **files)) == [level]
