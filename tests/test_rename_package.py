"""`rospkg rename` in memory: what moves, what is edited in each kind of file, and what keeps the old name."""

from __future__ import annotations

import pytest
from renaming import CMAKE, after, below, depends, named, python_package, renamed, texts

from rospkg_cli.change import ChangeError
from rospkg_cli.renaming.plan import Left

OLD = "old_name"


def test_a_python_package_moves_with_all_that_carries_its_name() -> None:
    plan = renamed(below("src/old_name", python_package(OLD)), "src/old_name", OLD, "new_name")
    assert texts(plan.draft.tree) == below("src/new_name", python_package("new_name"))
    assert plan.left == ()


def test_a_folder_of_another_name_stays() -> None:
    plan = renamed(below("drive", python_package(OLD)), "drive", OLD, "new_name")
    assert texts(plan.draft.tree) == below("drive", python_package("new_name"))


LAUNCH = """\
from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch_ros.actions import Node

import old_name.gears
from old_name.drive import main  # old_name has it


def generate_launch_description():
    share = get_package_share_directory('old_name')
    old_name.gears.shift()
    return LaunchDescription([
        Node(package='old_name', executable='drive', name='old_name', namespace='old_name'),
        Node(package='other', executable='old_name'),
    ])
"""


def test_python_is_read_by_its_meaning() -> None:
    done = after(LAUNCH, "launch/up.launch.py")
    for line in (
        "import new_name.gears",
        "from new_name.drive import main  # old_name has it",
        "get_package_share_directory('new_name')",
        "    new_name.gears.shift()",
        "Node(package='new_name', executable='drive', name='old_name', namespace='old_name')",
        "Node(package='other', executable='old_name')",
    ):
        assert line in done


@pytest.mark.parametrize(
    ("path", "line"),
    [
        ('launch/a.launch.xml', '<node pkg="«»" exec="drive" name="old_name"/>'),
        ('launch/a.launch.xml', '<include file="$(find-pkg-share «»)/a.xml"/>'),
        ('launch/a.launch.xml', '<arg name="robot_package" default="«»"/>'),
        ('launch/a.launch.xml', '<arg name="robot" default="old_name"/>'),
        ('launch/a.launch.yaml', '- node: {pkg: other}\n  pkg: «»'),
        ('urdf/a.urdf', '<mesh filename="package://«»/meshes/a.stl"/>'),
        ('urdf/a.urdf', '<mesh filename="package://old_name_too/a.stl"/>'),
        ('urdf/a.xacro', '<xacro:include filename="$(find «»)/a"/>'),
        ('config/a.yaml', '/**:\n  ros__parameters:\n    mesh: package://«»/a'),
        ('config/a.yaml', 'old_name:\n  ros__parameters: {}'),
        ('config/a.yaml', 'packages:\n  - rclpy\n  - «»\nrest: [old_name]'),
        ('run.sh', 'ros2 run «» drive  # see https://a.b/share/old_name'),
        ('run.sh', 'colcon build --packages-select other \\\n  «»'),
        ('a.cpp', 'auto a = get_package_share_directory("«»");'),
        ('a.cpp', 'Loader a("«»", "old_name::Base"), b("old_name");'),
        ('a.cpp', 'old_name::Gear gear;  // of old_name'),
        ('CMakeLists.txt', 'find_package(«» REQUIRED)  # old_name'),
        ('CMakeLists.txt', 'ament_target_dependencies(old_name «»)'),
        ('CMakeLists.txt', 'if(«»_FOUND)\nmessage(${old_name_DIRS})'),
        ('CMakeLists.txt', 'set(DEPS rclcpp «»)\nament_target_dependencies(a ${DEPS})'),
        ('CMakeLists.txt', 'set(NODES a old_name)'),
        ("CMakeLists.txt", "ament_export_dependencies(«» rclcpp)\nament_export_dependencies(rclcpp «»)"),
        ("launch/a.launch", '<node args="--config_pkg=«» robot_package:=«» a_pkgs:=old_name"/>'),
        ('CMakeLists.txt', 'target_link_libraries(a PUBLIC «»::gears)'),
        ('CMakeLists.txt', 'rclcpp_components_register_node(a PLUGIN "old_name::A")'),
        ('README.md', 'ros2 run old_name drive'),
        ('a.repos', 'old_name: {}'),
        ('test/test_a.py', "from unittest.mock import patch\npatch('«».gears.shift')\npatch('old_name.yaml')"),
        ('a.py', "import os\na = os.path.join('install', 'share', '«»', 'old_name')"),
        ('a.py', "print 'python 2'\nfrom «» import gears"),
        ('a.py', "def start(package_name='«»', node='old_name'): ..."),
        ('a.py', "cmd = ['ros2', 'run', '«»', 'drive', 'old_name']"),
        ('a.py', "name = '«»'\nshare = get_package_share_path(name)"),
        ('rospkg.toml', '[per-package.«».ignore]\nXML1 = "old_name is new"'),
        ('colcon.meta', '{"names": {"«»": {}}}'),
    ],
)  # fmt: skip
def test_what_other_packages_say(path: str, line: str) -> None:
    """`«»` stands for the name where it means the package."""
    assert after(line.replace("«»", "old_name") + "\n", path) == line.replace("«»", "new_name") + "\n"


def test_dependencies_of_others() -> None:
    files = below(OLD, python_package(OLD)) | {"other/package.xml": named("other", depends("old_name", "rclpy"))}
    done = texts(renamed(files, OLD, OLD, "new_name").draft.tree)
    assert done["other/package.xml"] == named("other", depends("new_name", "rclpy"))


INTERFACES = {
    "old_name/package.xml": named(OLD, CMAKE, "ament_cmake"),
    "old_name/CMakeLists.txt": 'project(old_name)\nrosidl_generate_interfaces(${PROJECT_NAME} "msg/Gear.msg")\n',
    "old_name/msg/Gear.msg": "int32 ratio\n",
    "other/package.xml": named("other", CMAKE + depends(OLD), "ament_cmake"),
}


@pytest.mark.parametrize(
    ("path", "line"),
    [
        ('a.cpp', '#include <«»/msg/gear.hpp>\n«»::msg::Gear a;'),
        ('a.c', '«»__msg__Gear a;'),
        ('a.cpp', 'REGISTER_GEAR(1, «», Gear);\nf("old_name", old_name);'),
        ('a.py', 'from «».msg import Gear\nimport «».srv as b'),
        ('msg/Box.msg', '«»/Gear[] gears\nstring old_name'),
        ('a.yaml', 'type: "«»/msg/Gear"'),
        ('CMakeLists.txt', 'target_link_libraries(a «»::«»)'),
        ('CMakeLists.txt', 'target_link_libraries(a ${«»_TARGETS} «»::«»__rosidl_typesupport_cpp)'),
        ('CMakeLists.txt', 'rosidl_generate_interfaces(${PROJECT_NAME} "msg/Box.msg" DEPENDENCIES «»)'),
    ],
)  # fmt: skip
def test_interfaces(path: str, line: str) -> None:
    files = INTERFACES | {f"other/{path}": line.replace("«»", "old_name") + "\n"}
    assert texts(renamed(files, OLD, OLD, "new_name").draft.tree)[f"other/{path}"] == (
        line.replace("«»", "new_name") + "\n"
    )


HEADER = (
    "#ifndef OLD_NAME__GEAR_HPP_\n#define OLD_NAME__GEAR_HPP_\nnamespace old_name {}\n#endif  // OLD_NAME__GEAR_HPP_\n"
)
LIBRARY = """\
project(old_name)
add_library(${PROJECT_NAME} src/gear.cpp src/old_name/more.cpp)
add_executable(old_name_node src/${PROJECT_NAME}_node.cpp)
target_link_libraries(old_name_node old_name)
install(DIRECTORY include/old_name DESTINATION include)
install(DIRECTORY config DESTINATION share/old_name)
ament_export_targets(old_name HAS_LIBRARY_TARGET)
"""
CPP = {
    "old_name/package.xml": named(OLD, CMAKE, "ament_cmake"),
    "old_name/CMakeLists.txt": LIBRARY,
    "old_name/include/old_name/gear.hpp": HEADER,
    "old_name/src/gear.cpp": '#include "old_name/gear.hpp"\n#include "old_name/more.hpp"\n',
    "old_name/src/old_name/more.cpp": "",
    "old_name/src/old_name/more.hpp": "",
    "old_name/src/old_name_node.cpp": "int main() { return 0; }\n",
    "old_name/run.sh": "cat src/old_name_node.cpp old_name_node.cpp.orig my_old_name_node.cpp\n",
    "old_name/plugins.xml": '<library path="old_name"><class type="old_name::Gear" name="old_name/Gear"/></library>\n',
    ".gitignore": "old_name/config/*\n/old_name/include/old_name/a.hpp\nother/old_name\n",
}


def test_headers_library_and_files_called_after_the_project() -> None:
    plan = renamed(CPP, OLD, OLD, "new_name")
    done = texts(plan.draft.tree)
    assert sorted(done) == sorted(
        path.replace("include/old_name", "include/new_name")
        .replace("old_name/", "new_name/", 1)
        .replace("old_name_node", "new_name_node")
        for path in CPP
    )
    assert done["new_name/include/new_name/gear.hpp"] == HEADER.replace("OLD_NAME", "NEW_NAME")
    assert done["new_name/src/gear.cpp"] == '#include "new_name/gear.hpp"\n#include "old_name/more.hpp"\n'
    cmake = LIBRARY.replace("old_name", "new_name").replace("src/new", "src/old").replace("(new_name_", "(old_name_")
    assert done["new_name/CMakeLists.txt"] == cmake
    assert done["new_name/run.sh"] == "cat src/new_name_node.cpp old_name_node.cpp.orig my_old_name_node.cpp\n"
    assert done["new_name/plugins.xml"] == CPP["old_name/plugins.xml"].replace('path="old_name"', 'path="new_name"')
    assert done[".gitignore"] == "new_name/config/*\n/new_name/include/new_name/a.hpp\nother/old_name\n"
    assert Left(".gitignore", 3, "other/old_name") in plan.left


def test_paths_from_outside_of_the_package() -> None:
    files = CPP | {
        "other/package.xml": named("other"),
        "other/CMakeLists.txt": "include_directories(${CMAKE_CURRENT_SOURCE_DIR}/../old_name/include/old_name)\n",
        "tools/a.sh": "cat old_name/package.xml ../old_name/src/gear.cpp old_name/none.txt /old_name\n",
        "README.md": "old_name/package.xml\n",
    }
    done = texts(renamed(files, OLD, OLD, "new_name").draft.tree)
    assert done["other/CMakeLists.txt"] == files["other/CMakeLists.txt"].replace("old_name", "new_name")
    assert done["tools/a.sh"] == "cat new_name/package.xml ../new_name/src/gear.cpp old_name/none.txt /old_name\n"
    assert done["README.md"] == files["README.md"]


def test_headers_of_a_name_that_another_package_has() -> None:
    files = CPP | {
        "other/package.xml": named("other"),
        "other/include/old_name/wheel.hpp": "",
        "other/a.cpp": '#include "old_name/wheel.hpp"\n',
    }
    assert texts(renamed(files, OLD, OLD, "new_name").draft.tree)["other/a.cpp"] == files["other/a.cpp"]


def test_a_class_keeps_the_namespace_that_the_project_gave_it() -> None:
    from renaming import MemoryTree, plan_rename

    line = 'rclcpp_components_register_node(a PLUGIN "${PROJECT_NAME}::Gear" EXECUTABLE a)\n'
    files = MemoryTree.of(CPP | {"old_name/CMakeLists.txt": "project(old_name)\n" + line})
    done = texts(plan_rename(files, OLD, OLD, "new_name").draft.tree)
    assert done["new_name/CMakeLists.txt"] == "project(new_name)\n" + line.replace("${PROJECT_NAME}", "old_name")


def test_an_executable_of_the_same_name_follows() -> None:
    launch = "from launch_ros.actions import Node\nNode(package='old_name', executable='old_name', name='old_name')\n"
    files = below(OLD, python_package(OLD)) | {"other/package.xml": named("other"), "other/launch/a.launch.py": launch}
    files |= {
        "other/a.launch.xml": '<node pkg="old_name" exec="old_name"/>\n',
        "other/a.yaml": "- pkg: old_name\n  exec: old_name\n",
    }
    files["old_name/setup.py"] = files["old_name/setup.py"].replace("drive = ", "old_name = ")
    done = texts(renamed(files, OLD, OLD, "new_name").draft.tree)
    assert "'new_name = new_name.drive:main'" in done["new_name/setup.py"]
    assert "package='new_name', executable='new_name', name='old_name'" in done["other/launch/a.launch.py"]
    assert done["other/a.launch.xml"] == '<node pkg="new_name" exec="new_name"/>\n'
    assert done["other/a.yaml"] == "- pkg: new_name\n  exec: new_name\n"


PROJECT = """\
project(old_name)
add_executable(${PROJECT_NAME}_node src/node.cpp)
add_library(${PROJECT_NAME}_core src/core.cpp)
add_executable(old_name_tool src/tool.cpp)
install(TARGETS old_name_node ${PROJECT_NAME}_core old_name_tool DESTINATION lib/${PROJECT_NAME})
"""
STARTS = """\
owner = 'old_name'
Node(package='old_name', executable='old_name_node', name='old_name_node')
Node(package=owner, executable='old_name_node')
Node(package=owner, executable='old_name_tool')
Node(package=other, executable='old_name_node')
"""
NODES = '<node pkg="old_name" exec="old_name_node"/><node pkg="old_name" exec="old_name_tool"/>\n'


def test_targets_that_are_called_after_the_project_follow() -> None:
    files = {
        "old_name/package.xml": named(OLD, CMAKE, "ament_cmake"),
        "old_name/CMakeLists.txt": PROJECT,
        **{f"old_name/src/{name}.cpp": "int main() {}\n" for name in ("node", "core", "tool")},
        "old_name/plugins.xml": '<library path="old_name_core"/>\n',
        "other/package.xml": named("other"),
        "other/CMakeLists.txt": "target_link_libraries(a old_name::old_name_core)\n",
        "other/a.launch.xml": NODES,
        "other/a.urdf": '<plugin filename="libold_name_core.so"/>\n',
        "other/launch/a.launch.py": STARTS,
    }
    done = texts(renamed(files, OLD, OLD, "new_name").draft.tree)
    cmake = PROJECT.replace("(old_name)", "(new_name)").replace(" old_name_n", " new_name_n")
    assert done["new_name/CMakeLists.txt"] == cmake
    assert done["new_name/plugins.xml"] == '<library path="new_name_core"/>\n'
    assert done["other/CMakeLists.txt"] == "target_link_libraries(a new_name::new_name_core)\n"
    assert done["other/a.launch.xml"] == NODES.replace('"old_name"', '"new_name"').replace("old_name_n", "new_name_n")
    assert done["other/a.urdf"] == '<plugin filename="libnew_name_core.so"/>\n'
    python = STARTS.replace("owner = 'old", "owner = 'new").replace("package='old", "package='new")
    assert done["other/launch/a.launch.py"] == python.replace("executable='old_name_n", "executable='new_name_n", 2)


def test_what_is_in_the_way_is_named() -> None:
    files = below(OLD, python_package(OLD)) | {"new_name/notes.txt": ""}
    with pytest.raises(ChangeError, match="`new_name` is there already, so `old_name` can't get that name"):
        renamed(files, OLD, OLD, "new_name")


def test_line_ends_stay() -> None:
    files = below(OLD, python_package(OLD)) | {
        "other/package.xml": named("other"),
        "other/a.sh": "ros2 run old_name drive\r\n",
    }
    assert texts(renamed(files, OLD, OLD, "new_name").draft.tree)["other/a.sh"] == "ros2 run new_name drive\r\n"
