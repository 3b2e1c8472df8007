"""Small packages of five kinds that lint clean, as many as wanted: a synthetic workspace."""

from __future__ import annotations

from pathlib import Path

Files = dict[str, str]

MANIFEST = """\
<?xml version="1.0"?>
<package format="3">
  <name>{name}</name>
  <version>0.1.0</version>
  <description>Part {number} of a synthetic workspace</description>
  <maintainer email="someone@example.com">Someone</maintainer>
  <license>Apache-2.0</license>
{depends}
  <export>
    <build_type>{build_type}</build_type>
  </export>
</package>
"""
CPP = """\
cmake_minimum_required(VERSION 3.10)
project({name})

find_package(ament_cmake REQUIRED)
find_package(rclcpp REQUIRED)

add_executable(node_{number} src/node.cpp)
target_link_libraries(node_{number} PUBLIC rclcpp::rclcpp)
install(TARGETS node_{number} DESTINATION lib/${{PROJECT_NAME}})

ament_package()
"""
NODE = """\
#include <rclcpp/rclcpp.hpp>

int main(int argc, char ** argv)
{{
  rclcpp::init(argc, argv);
  auto node = std::make_shared<rclcpp::Node>("node_{number}");
  node->declare_parameter("rate", 10.0);
  rclcpp::spin(node);
  rclcpp::shutdown();
  return 0;
}}
"""
SETUP = """\
from setuptools import find_packages, setup

package_name = "{name}"

setup(
    name=package_name,
    version="0.1.0",
    packages=find_packages(exclude=["test"]),
    data_files=[
        ("share/ament_index/resource_index/packages", ["resource/" + package_name]),
        ("share/" + package_name, ["package.xml"]),
    ],
    install_requires=["setuptools"],
    zip_safe=True,
    maintainer="Someone",
    maintainer_email="someone@example.com",
    description="Part {number} of a synthetic workspace",
    license="Apache-2.0",
    entry_points={{"console_scripts": ["talk = {name}.talk:main"]}},
)
"""
TALK = """\
import rclpy
from rclpy.node import Node


def main() -> None:
    rclpy.init()
    rclpy.spin(Node("talk_{number}"))
"""
INTERFACES = """\
cmake_minimum_required(VERSION 3.10)
project({name})

find_package(ament_cmake REQUIRED)
find_package(rosidl_default_generators REQUIRED)

rosidl_generate_interfaces(${{PROJECT_NAME}} msg/State.msg srv/Ask.srv)

ament_package()
"""
BRINGUP = """\
cmake_minimum_required(VERSION 3.10)
project({name})

find_package(ament_cmake REQUIRED)

install(DIRECTORY config launch DESTINATION share/${{PROJECT_NAME}})

ament_package()
"""
PARAMETERS = "one:\n  ros__parameters:\n    rate: 20.0\n"
LAUNCH = """\
from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([Node(package="{started}", executable="{executable}", name="one")])
"""
PLAIN = """\
cmake_minimum_required(VERSION 3.10)
project({name})

find_package(ament_cmake REQUIRED)

add_library(${{PROJECT_NAME}} INTERFACE)
install(DIRECTORY include/ DESTINATION include/${{PROJECT_NAME}})

ament_package()
"""


def depends(**tags: tuple[str, ...]) -> str:
    """Return dependency elements, one line each, in the order of the keywords."""
    return "\n".join(f"  <{tag}>{name}</{tag}>" for tag, names in tags.items() for name in names)


def name_of(number: int) -> str:
    return f"part_{number:05d}"


def beside(number: int, offset: int) -> tuple[str, ...]:
    """Return the package some places before this one, if there is one."""
    return (name_of(number - offset),) if number >= offset else ()


def package(number: int) -> Files:
    """Return the files of one package, by path; the kind follows from the number."""
    name, start = name_of(number), number - number % 5
    before = beside(start, 1)
    kind = number % 5
    if kind == 0:
        texts = {"CMakeLists.txt": CPP, "src/node.cpp": NODE}
        needs = depends(buildtool_depend=("ament_cmake",), depend=("rclcpp",), exec_depend=before)
    elif kind == 1:
        texts = {"setup.py": SETUP, f"{name}/__init__.py": "", f"{name}/talk.py": TALK, f"resource/{name}": ""}
        texts["setup.cfg"] = f"[develop]\nscript_dir=$base/lib/{name}\n[install]\ninstall_scripts=$base/lib/{name}\n"
        needs = depends(exec_depend=("rclpy", *beside(number, 7)))
    elif kind == 2:
        texts = {"CMakeLists.txt": INTERFACES, "msg/State.msg": "float64 x\n", "srv/Ask.srv": "---\nbool fine\n"}
        needs = depends(
            buildtool_depend=("ament_cmake", "rosidl_default_generators"),
            exec_depend=("rosidl_default_runtime",),
            member_of_group=("rosidl_interface_packages",),
        )
    elif kind == 3:
        texts = {"CMakeLists.txt": BRINGUP, "launch/all.launch.py": LAUNCH, "config/all.yaml": PARAMETERS}
        started = (name_of(start), name_of(start + 1))
        needs = depends(buildtool_depend=("ament_cmake",), exec_depend=("launch", "launch_ros", *started, *before))
    else:
        texts = {"CMakeLists.txt": PLAIN, f"include/{name}/{name}.hpp": "#pragma once\n"}
        needs = depends(buildtool_depend=("ament_cmake",), exec_depend=before)
    build_type = "ament_python" if kind == 1 else "ament_cmake"
    filled = {"name": name, "number": number, "started": name_of(start), "executable": f"node_{start}"}
    files = {path: text.format(**filled) for path, text in texts.items()}
    files["package.xml"] = MANIFEST.format(depends=needs, build_type=build_type, **filled)
    return files


def write_packages(folder: Path, count: int) -> None:
    """Write packages below a folder, a hundred to a sub-folder."""
    for number in range(count):
        here = folder / f"group_{number // 100:03d}" / name_of(number)
        for path, text in package(number).items():
            (here / path).parent.mkdir(parents=True, exist_ok=True)
            (here / path).write_text(text)
