"""One cause, one finding: what follows from it in another file keeps quiet."""

from __future__ import annotations

import pytest

from rospkg_cli.example import CMAKE, INTERFACES_CMAKE, manifest, setup_py
from rospkg_cli.rules.launch import lch011_unknown_component as lch011
from rospkg_cli.testing import lint_files

INCLUDE = '<launch>\n  <include file="$(find-pkg-share my_pkg)/launch/b.launch.xml"/>\n</launch>\n'
LAUNCH = {"launch/a.launch.xml": INCLUDE, "launch/b.launch.xml": "<launch/>\n"}
CONFIG = "$(find-pkg-share my_pkg)/config/a.yaml"
NAMES_CONFIG = f'<launch>\n  <arg name="a" default="{CONFIG}"/>\n  <log message="$(var a)"/>\n</launch>\n'
MANIFEST = "        ('share/' + package_name, ['package.xml']),\n"


def said(files: dict[str, str], *codes: str) -> list[str]:
    """Return codes and levels."""
    return [f"{each.code} {each.severity.value}" for each in lint_files(files, codes).findings]


def data(destination: str) -> str:
    return setup_py().replace(MANIFEST, f"{MANIFEST}        ('{destination}', glob('launch/*')),\n")


@pytest.mark.parametrize("place", ["share/launch", "shre/my_pkg/launch"])
def test_a_wrong_destination_in_setup_py(clean, place: str) -> None:
    files = {**clean, **LAUNCH, "setup.py": "from glob import glob\n" + data(place)}
    assert said(files, "SET208", "LCH004") == ["SET208 error"]
    (found,) = lint_files(files, ["SET208"]).findings
    assert "so that `launch/a.launch.xml` stops at `launch/b.launch.xml`; write" in found.message
    for text, level in (
        (INCLUDE.replace("$(find-pkg-share my_pkg)/launch", "$(dirname)"), "warning"),
        (INCLUDE.replace("my_pkg", "other"), "warning"),
        (INCLUDE.replace("<include", '<arg name="a" default="false"/><include if="$(var a)"'), "warning"),
    ):
        assert said({**files, "launch/a.launch.xml": text}, "SET208") == [f"SET208 {level}"]
    assert said({**files, "launch/c.launch.xml": "<launch>\n"}, "SET208", "LCH004") == ["SET208 error"]


@pytest.mark.parametrize("rule", ["DIRECTORY launch config", "DIRECTORY config launch"])
def test_folders_of_one_rule_that_go_to_share_alone(rule: str) -> None:
    text = CMAKE.replace("ament_package", f"install({rule} DESTINATION share)\nament_package")
    robot = f'  <node pkg="a" exec="b"><param from="{CONFIG}"/></node>\n'
    files = {
        **LAUNCH,
        "package.xml": manifest("  <exec_depend>ros2launch</exec_depend>\n", "ament_cmake"),
        "CMakeLists.txt": text,
        "config/a.yaml": "a: 1\n",
        "launch/a.launch.xml": INCLUDE.replace("<launch>\n", f'<launch>\n{robot}  <log message="$(var a)"/>\n'),
    }
    (found,) = lint_files(files, ["CMK101", "LCH004"]).findings
    assert (found.code, found.severity.value) == ("LCH004", "error")
    assert found.message.startswith("`launch/b.launch.xml` and 1 more go to `share/launch/b.launch.xml`")
    assert said({**files, "launch/a.launch.xml": "<launch/>\n"}, "CMK101", "LCH004") == ["CMK101 warning"]


@pytest.mark.parametrize("folder, expected", [("launch", []), ("launhc", ["SET204 error"])])
def test_a_misspelt_folder_of_a_glob(clean, folder: str, expected: list[str]) -> None:
    text = "from glob import glob\n" + data("share/my_pkg/launch").replace("launch/*", f"{folder}/*")
    assert said({**clean, **LAUNCH, "setup.py": text}, "SET204", "SET206", "LCH003", "LCH004") == expected


@pytest.mark.parametrize(
    "folders, launch, expected",
    [
        ("config", "<launch/>\n", ["CMK104 info"]),
        ("config", "<launch><!-- a.yaml --></launch>\n", []),
        ("config launch", "<launch/>\n", ["CMK101 warning"]),
        ("config launch", NAMES_CONFIG, ["LCH004 warning"]),
    ],
)
def test_folders_that_go_to_share_alone_are_told_once(folders: str, launch: str, expected: list[str]) -> None:
    others = "" if "launch" in folders else "install(DIRECTORY launch DESTINATION share/${PROJECT_NAME})\n"
    rules = f"{others}install(DIRECTORY {folders} DESTINATION share)\n"
    files = {
        "package.xml": manifest("  <exec_depend>ros2launch</exec_depend>\n", "ament_cmake"),
        "CMakeLists.txt": CMAKE.replace("ament_package", f"{rules}ament_package"),
        "config/a.yaml": "a: 1\n",
        "launch/a.launch.xml": launch,
    }
    assert said(files, "CMK101", "CMK104", "LCH004") == expected


def test_a_project_of_another_name() -> None:
    rules = "add_executable(${PROJECT_NAME} a.cpp)\ninstall(TARGETS ${PROJECT_NAME} DESTINATION lib/${PROJECT_NAME})\n"
    rules += "install(DIRECTORY launch DESTINATION share/${PROJECT_NAME})\n"
    text = CMAKE.replace("ament_package", f"{rules}ament_package")
    launch = '<launch>\n  <node pkg="my_pkg" exec="{}"/>\n</launch>\n'
    files = {
        "package.xml": manifest("", "ament_cmake"),
        "a.cpp": "int main() {}\n",
        "CMakeLists.txt": text,
        "launch/a.launch.xml": launch.format("my_pkg"),
    }
    assert said(files, "CMK001", "LCH002") == []
    assert said({**files, "launch/a.launch.xml": launch.format("other")}, "CMK001", "LCH002") == ["LCH002 error"]
    renamed = text.replace("project(my_pkg)", "project(my_package)")
    assert said({**files, "CMakeLists.txt": renamed}, "CMK001", "LCH002") == ["CMK001 error"]


@pytest.mark.parametrize("folder, expected", [("src/my_pkg", []), ("my_pkg", ["CMK102 error"])])
def test_a_python_package_in_another_folder(folder: str, expected: list[str]) -> None:
    lines = f"find_package(ament_cmake_python REQUIRED)\nament_python_install_package(my_pkg PACKAGE_DIR {folder})\n"
    programs = "install(PROGRAMS a.py DESTINATION lib/${PROJECT_NAME})\n"
    files = {
        "package.xml": manifest("  <depend>ament_cmake_python</depend>\n", "ament_cmake"),
        "CMakeLists.txt": CMAKE.replace("ament_package", f"{lines}{programs}ament_package"),
        "src/my_pkg/__init__.py": "",
        "src/my_pkg/action.py": "A = 1\n",
        "a.py": "#!/usr/bin/env python3\nfrom my_pkg.action import A\n",
    }
    assert said(files, "CMK102", "IDL011") == expected
    other = {**files, "a.py": "#!/usr/bin/env python3\nfrom my_pkg.msg import A\n"}
    assert said(other, "IDL011") == ([] if expected else ["IDL011 error"])


def test_a_component_that_cmake_misspells() -> None:
    text = lch011.BAD.replace("«", "").replace("»", "").replace("Taker", "Talker")
    files = {**lch011.FILES, "package.xml": manifest("", "ament_cmake"), "launch/a.launch.xml": text}
    assert said(files, "CMK108", "LCH011") == []
    wrong = files["CMakeLists.txt"].replace("my_pkg::Talker", "my_pkg::Tallker")
    assert said({**files, "CMakeLists.txt": wrong}, "CMK108", "LCH011") == ["CMK108 error"]


def test_an_attribute_that_no_node_has(clean) -> None:
    text = '<launch>\n  <node {}="joy" exec="joy_node"/>\n</launch>\n'
    for name, expected in (("pkg", []), ("pakg", ["LCH007 error"])):
        assert said({**clean, "launch/a.launch.xml": text.format(name)}, "LCH002", "LCH007") == expected
    bare = '<launch>\n  <executable cmd="ls"/>\n  <node exec="joy_node"/>\n</launch>\n'
    assert "LCH002 error" in said({**clean, "launch/a.launch.xml": bare}, "LCH002", "LCH007")


def test_a_link_that_a_joint_and_gazebo_name() -> None:
    joint = '  <joint name="j" type="fixed"><parent link="{}"/><child link="b"/></joint>\n'
    gazebo = '  <gazebo reference="{}"/>\n'

    def found(parent: str, reference: str) -> list[str]:
        robot = f'<robot name="r">\n  <link name="a"/>\n  <link name="b"/>\n{joint}{gazebo}</robot>\n'
        files = {"package.xml": manifest("", "ament_cmake"), "CMakeLists.txt": CMAKE}
        text = robot.replace("{}", parent, 1).replace("{}", reference)
        install = CMAKE.replace("ament_package", "install(DIRECTORY urdf DESTINATION share/my_pkg)\nament_package")
        opens = '<launch>\n  <arg name="a" default="$(find-pkg-share my_pkg)/urdf/r.urdf"/>\n</launch>\n'
        more = {"urdf/r.urdf": text, "CMakeLists.txt": install, "launch/a.launch.xml": opens}
        return said({**files, **more}, "URD001")

    assert found("a", "b") == []
    assert found("wheel", "wheel") == ["URD001 error"]
    assert found("wheel", "caster") == ["URD001 error", "URD001 info"]
    assert found("a", "wheel") == ["URD001 info"]


def test_an_argument_that_launch_refuses(clean) -> None:
    texts = {"launch/b.launch.xml": '<launch>\n  <arg name="a" {}="1"/>\n</launch>\n', "launch/a.launch.xml": INCLUDE}
    files = {**clean, **texts}
    for word, expected in (("default", []), ("defualt", ["LCH007 error"]), ("description", ["LCH015 warning"])):
        changed = {"launch/b.launch.xml": texts["launch/b.launch.xml"].format(word)}
        found = said({**files, **changed}, "LCH007", "LCH015")
        assert [each.split()[0] for each in found] == [each.split()[0] for each in expected]


def test_a_broken_launch_file_beside_others(clean) -> None:
    unset = (
        '<launch>\n  <log message="$(var rate)"/>\n  <arg name="speed"/>\n  <log message="$(var speed)"/>\n</launch>\n'
    )
    undeclared = '<launch>\n  <node pkg="joy" exec="joy_node"/>\n</launch>\n'
    files = {**clean, "launch/a.launch.xml": unset, "launch/b.launch.xml": undeclared}
    expected = ["LCH008 warning", "DEP103 warning"]
    assert said(files, "LCH008", "DEP103") == expected
    assert said({**files, "launch/c.launch.xml": "<launch>\n"}, "LCH008", "DEP103") == expected


def test_an_interface_file_in_other_case() -> None:
    files = {
        "package.xml": manifest("", "ament_cmake"),
        "CMakeLists.txt": INTERFACES_CMAKE.replace('  "srv/SetMode.srv"\n', ""),
        "msg/status.msg": "bool a\n",
    }
    assert said(files, "IDL005", "IDL006") == ["IDL006 error"]
    assert said({**files, "msg/Status.msg": "bool a\n"}, "IDL005", "IDL006") == ["IDL005 info"]
