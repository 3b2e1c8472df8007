"""What repairs of launch files, parameter files and robots mended: names in code, slashes for dots, lost signs."""

from __future__ import annotations

import pytest

from rospkg_cli.example import manifest
from rospkg_cli.testing import lint_files

CPP = """\
#include "rclcpp/rclcpp.hpp"
// : Node("other")
class Talker : public rclcpp::Node {
public:
  Talker() : Node("talker_node") {
    declare_parameter("rate", 1.0);
    declare_parameter("arm.frame", "map");
  }
};
int main() { rclcpp::spin(std::make_shared<Talker>()); }
"""
CMAKE = """\
cmake_minimum_required(VERSION 3.20)
project(my_pkg)
find_package(ament_cmake REQUIRED)
find_package(rclcpp REQUIRED)
add_executable(talk src/talk.cpp)
target_link_libraries(talk rclcpp::rclcpp)
install(TARGETS talk DESTINATION lib/${PROJECT_NAME})
install(DIRECTORY config launch DESTINATION share/${PROJECT_NAME})
ament_package()
"""
PYTHON = """\
import rclpy
from rclpy.node import Node


class Talker(Node):
    def __init__(self):
        super().__init__('talker_node')
        self.declare_parameter('rate', 1.0)


def main():
    rclpy.init()
    rclpy.spin(Talker())
"""
SETUP = """\
from setuptools import setup

setup(
    name='my_pkg',
    version='0.0.0',
    packages=['my_pkg'],
    data_files=[
        ('share/ament_index/resource_index/packages', ['resource/my_pkg']),
        ('share/my_pkg', ['package.xml']),
        ('share/my_pkg/config', ['config/a.yaml']),
        ('share/my_pkg/launch', ['launch/a.launch.xml']),
    ],
    entry_points={'console_scripts': ['talk = my_pkg.talk:main']},
)
"""
NODE = """\
<launch>
  <arg name="name" default="speaker"/>
  <node pkg="my_pkg" exec="talk"{}>
    <param from="$(find-pkg-share my_pkg)/config/a.yaml"/>
  </node>
</launch>
"""


def said(code: str, files: dict[str, str], build: str = "ament_cmake", needs: str = "") -> list[str]:
    texts = {"package.xml": manifest(needs, build), **files}
    found = lint_files({f"src/my_pkg/{path}": text for path, text in texts.items()}, [code]).findings
    return [f"{each.severity.value}: {each.message}" for each in found]


def blocks(key: str, more: str = "", cpp: str = CPP, setting: str = "rate: 2.0") -> list[str]:
    text = f"{key}:\n  ros__parameters:\n    {setting}\n    arm:\n      frame: odom\n"
    files = {"CMakeLists.txt": CMAKE, "src/talk.cpp": cpp, "launch/a.launch.xml": NODE.format(more)}
    return said("PRM003", {**files, "config/a.yaml": text})


@pytest.mark.parametrize(
    "key, more, found",
    [
        (
            "speaker",
            "",
            "info: nothing here starts a node `speaker`: the one that `launch/a.launch.xml` gives this file",
        ),
        ("teller", "", "warning: no node is called `teller`: the one that `launch/a.launch.xml` gives this file to"),
        ("talker_node", "", ""),
        ("/**", "", ""),
        ("talker_node", ' name="other"', "warning: no node is called `talker_node`"),
        ("talker_node", ' namespace="one"', "warning: `talker_node` is no node: the one that"),
        ("/one/talker_node", ' namespace="one"', ""),
        ("speaker", ' args="--ros-args -r __node:=speaker"', ""),
        ("speaker", ' name="$(var name)"', ""),
        ("talker_node", ' name="$(var name)"', "info: no node is called `talker_node`"),
    ],
)
def test_a_block_for_another_name_than_the_code_gives(key: str, more: str, found: str) -> None:
    texts = blocks(key, more)
    assert len(texts) == bool(found)
    assert all(text.startswith(found) for text in texts)


@pytest.mark.parametrize(
    "cpp",
    [
        CPP.replace('Node("talker_node")', "Node(name())"),
        CPP.replace("};\n", '};\nauto helper = rclcpp::Node::make_shared("helper");\n', 1),
        'int main() { auto a = rclcpp::Node::make_shared("a"); std::make_shared<other::Talker>(); }\n',
    ],
)
def test_a_name_that_code_computes_or_gives_several_of(cpp: str) -> None:
    assert not blocks("speaker", cpp=cpp)


@pytest.mark.parametrize("key, count", [("speaker", 1), ("talker_node", 0)])
def test_the_name_that_python_gives_its_node(key: str, count: int) -> None:
    files = {
        "setup.py": SETUP,
        "resource/my_pkg": "",
        "my_pkg/__init__.py": "",
        "my_pkg/talk.py": PYTHON,
        "launch/a.launch.xml": NODE.format(""),
        "config/a.yaml": f"{key}:\n  ros__parameters:\n    rate: 2.0\n",
    }
    assert len(said("PRM003", files, "ament_python")) == count


def test_one_of_several_blocks_that_the_node_declares() -> None:
    text = "speaker:\n  ros__parameters:\n    rate: 2.0\n    arm.frame: odom\nelse:\n  ros__parameters:\n    x: 1\n"
    files = {"CMakeLists.txt": CMAKE, "src/talk.cpp": CPP, "launch/a.launch.xml": NODE.format("")}
    assert len(said("PRM003", {**files, "config/a.yaml": text})) == 1


@pytest.mark.parametrize(
    "name, found",
    [
        ("arm/frame", "`my_pkg` declares no parameter `arm/frame`: the value is dropped; did you mean `arm.frame`?"),
        ("rate:=", "no node has a parameter `rate:=`: the value is dropped, and `:=` is for the command line alone"),
        ("rate", ""),
        ("arm.frame", ""),
    ],
)
def test_a_name_with_slashes_or_a_sign(name: str, found: str) -> None:
    launch = (
        f'<launch>\n  <node pkg="my_pkg" exec="talk">\n    <param name="{name}" value="5"/>\n  </node>\n</launch>\n'
    )
    texts = said("PRM007", {"CMakeLists.txt": CMAKE, "src/talk.cpp": CPP, "launch/a.launch.xml": launch})
    assert len(texts) == bool(found)
    assert all(f"warning: {found}" in text for text in texts)


@pytest.mark.parametrize("name, count", [("arm/frame", 1), ("arm.frame", 0), ("arm/other", 0)])
def test_slashes_in_a_parameter_file(name: str, count: int) -> None:
    text = f"talker_node:\n  ros__parameters:\n    rate: 1.0\n    {name}: odom\n"
    files = {"CMakeLists.txt": CMAKE, "src/talk.cpp": CPP, "launch/a.launch.xml": NODE.format("")}
    texts = said("PRM007", {**files, "config/a.yaml": text})
    assert len(texts) == count
    assert all(
        "`arm/frame`: the value is dropped, and slashes are of ROS 1; write `arm.frame`" in text for text in texts
    )


@pytest.mark.parametrize(
    "name, count", [("costmap/rate", 0), ("FollowPath/max_vel_x", 0), ("general_goal_checker.xy_goal_tolerance", 0)]
)
def test_slashes_of_what_nobody_declares(name: str, count: int) -> None:
    text = f"controller_server:\n  ros__parameters:\n    {name}: 1.0\n"
    assert len(said("PRM007", {"CMakeLists.txt": CMAKE, "src/talk.cpp": CPP, "config/a.yaml": text})) == count


@pytest.mark.parametrize(
    "name, found",
    [
        ("arm_{prefix}_joint", "warning: `arm_{prefix}` is read as it stands, for no `$` is right before the brace"),
        ("arm_{$prefix}_joint", "warning: `arm_{$prefix}` is read as it stands"),
        ("arm_${prefix}_joint", ""),
        ("${dict(prefix=1)['prefix']}", ""),
        ("{other}", ""),
    ],
)
def test_a_parameter_of_a_macro_without_its_sign(name: str, found: str) -> None:
    robot = (
        '<robot xmlns:xacro="http://www.ros.org/wiki/xacro" name="robot">\n  <xacro:macro name="arm" params="prefix">\n'
        f'    <link name="{name}"/>\n  </xacro:macro>\n  <xacro:arm prefix="a"/>\n</robot>\n'
    )
    texts = [text for text in said("URD001", {"CMakeLists.txt": CMAKE, "urdf/a.urdf.xacro": robot}) if "stands" in text]
    assert len(texts) == bool(found)
    assert all(found.partition(": ")[2] in text for text in texts)


@pytest.mark.parametrize("name", ["friction", "spring_stiffness"])
def test_a_value_without_its_sign_is_an_info(name: str) -> None:
    robot = (
        '<robot xmlns:xacro="http://www.ros.org/wiki/xacro" name="robot">\n  <xacro:property name="stiff" value="5"/>\n'
        '  <link name="a"/>\n  <link name="b"/>\n  <joint name="c" type="fixed">\n    <parent link="a"/>\n'
        f'    <child link="b"/>\n    <dynamics {name}="{{stiff}}"/>\n  </joint>\n</robot>\n'
    )
    files = {"CMakeLists.txt": CMAKE, "urdf/a.urdf.xacro": robot, "launch/a.launch.py": "A = 'a.urdf.xacro'\n"}
    texts = [text for text in said("URD001", files) if "stands" in text]
    assert [text.partition(":")[0] for text in texts] == ["info"]


@pytest.mark.parametrize(
    "value, found",
    [
        ("{pi}", "write `${pi}`"),
        ("-{pi}", "write `${pi}`"),
        ("{wide}", "write `${wide}`"),
        ("$(find my_pkg)/{model}.stl", "write `$(arg model)`"),
        ("${pi}", ""),
        ("${ {pi}}", ""),
        ("{other}", ""),
        ("{wide: {pi}}", ""),
    ],
)
@pytest.mark.parametrize("place", ["<a b='{}'/>", "<gazebo><max>{}</max></gazebo>"])
def test_a_name_of_xacro_without_its_sign(value: str, found: str, place: str) -> None:
    robot = (
        '<robot xmlns:xacro="http://www.ros.org/wiki/xacro" name="robot">\n  <xacro:arg name="model" default="a"/>\n'
        f'  <xacro:property name="wide" value="5"/>\n  {place.format(value)}\n</robot>\n'
    )
    texts = [text for text in said("URD001", {"CMakeLists.txt": CMAKE, "urdf/a.urdf.xacro": robot}) if "stands" in text]
    assert len(texts) == bool(found)
    assert all(found in text for text in texts)


@pytest.mark.parametrize("end, count", [("", 1), ("</Sequence>", 0)])
def test_a_behavior_tree_with_a_tag_that_is_not_closed(end: str, count: int) -> None:
    tree = f'<root BTCPP_format="4">\n  <BehaviorTree ID="A">\n    <Sequence>{end}\n  </BehaviorTree>\n</root>\n'
    texts = said("RPK001", {"CMakeLists.txt": CMAKE, "behavior_trees/a.xml": tree, "src/talk.cpp": CPP})
    assert len(texts) == count
    assert all("`<Sequence>` is closed by `</BehaviorTree>`" in text for text in texts)


@pytest.mark.parametrize(
    "project, count",
    [('dynamic = ["scripts"]', 1), ('dynamic = ["readme"]', 0), ('dynamic = ["scripts"]\n[tool.setuptools]', 0)],
)
def test_scripts_that_pyproject_leaves_to_setup(project: str, count: int) -> None:
    files = {
        "setup.py": SETUP.replace("my_pkg.talk:main", "my_pkg.talks:main"),
        "pyproject.toml": f'[project]\nname = "my_pkg"\n{project}\n',
        "resource/my_pkg": "",
        "my_pkg/__init__.py": "",
        "my_pkg/talk.py": PYTHON,
    }
    assert len(said("SET101", files, "ament_python")) == count


@pytest.mark.parametrize("argument, count", [("R", 1), ("other", 0)])
def test_an_argument_that_only_including_files_set(argument: str, count: int) -> None:
    inner = f'<launch>\n  <arg name="{argument}" default="0"/>\n  <log message="$(var roll)"/>\n</launch>\n'
    outer = (
        '<launch>\n  <include file="$(find-pkg-share my_pkg)/launch/inner.launch.xml">\n'
        '    <arg name="roll" value="5"/>\n  </include>\n</launch>\n'
    )
    files = {"CMakeLists.txt": CMAKE, "launch/inner.launch.xml": inner, "launch/outer.launch.xml": outer}
    texts = [text for text in said("LCH008", files) if "`roll`" in text]
    assert len(texts) == count
    assert all(text.startswith("info: this file declares no launch argument") for text in texts)


def test_what_an_entry_point_imports_in_a_folder_without_init() -> None:
    files = {
        "setup.py": SETUP.replace("my_pkg.talk:main", "my_pkg.nodes.talk:main"),
        "resource/my_pkg": "",
        "my_pkg/__init__.py": "",
        "my_pkg/nodes/talk.py": "import imageio\n\n\ndef main():\n    pass\n",
    }
    assert any("`python3-imageio`" in text for text in said("DEP101", files, "ament_python"))


@pytest.mark.parametrize("launch, count", [("", 1), (NODE.format(' name="other"').replace("/a.yaml", "/b.yaml"), 0)])
def test_a_block_of_a_file_that_nothing_names(launch: str, count: int) -> None:
    files = {"CMakeLists.txt": CMAKE, "src/talk.cpp": CPP, "launch/a.launch.xml": launch or "<launch>\n</launch>\n"}
    texts = said("PRM003", {**files, "config/a.yaml": "speaker:\n  ros__parameters:\n    rate: 2.0\n"})
    assert len(texts) == count
    assert all(text.startswith("info: no node is called `speaker`: this package's is") for text in texts)


@pytest.mark.parametrize(
    "key, one, other, count",
    [
        ("solver", "10", "10.0", 1),
        ("solver", "10.0", "12.5", 0),
        ("solver", "10", "12", 0),
        ("/**", "10", "10.0", 0),
        ("talker_node", "10", "10.0", 0),
    ],
)
def test_an_int_that_another_file_has_as_a_double(key: str, one: str, other: str, count: int) -> None:
    name = "damping" if key == "solver" else "rate"
    texts = [f"{key}:\n  ros__parameters:\n    {name}: {value}\n    arm.frame: a\n" for value in (one, other)]
    files = {"CMakeLists.txt": CMAKE, "src/talk.cpp": CPP, "config/a.yaml": texts[0], "config/b.yaml": texts[1]}
    found = [text for text in said("PRM006", files) if "an int here" in text]
    assert len(found) == count
    assert all(text.startswith(f"info: `{name}` is an int here and a double in `config/b.yaml`") for text in found)
