"""Sentences about package.xml that no example shows."""

from __future__ import annotations

from rospkg_cli.example import CMAKE, Example, manifest
from rospkg_cli.rules.manifest import xml305_missing_interface_group as xml305

PLAIN = manifest()


def with_line(line: str, below: str = "<license>Apache-2.0</license>") -> Example:
    """A manifest with one more line."""
    return Example(bad={"package.xml": PLAIN.replace(f"  {below}\n", f"  {below}\n  {line}\n")}, good={})


def instead(old: str, new: str) -> Example:
    """A manifest where something says something else."""
    assert old in PLAIN
    return Example(bad={"package.xml": PLAIN.replace(old, new)}, good={})


def depend(attributes: str) -> Example:
    return with_line(f"<depend {attributes}>rclcpp</depend>")


VERSION = "  <version>1.0.0</version>\n"
BELOW = """\
  <description>Drives my robot</description>
  <maintainer email="ada@example.org">Ada</maintainer>
  <license>Apache-2.0</license>
"""
PROSE = "You may use, change and pass on this software for whatever you like, as long as you share"

AUTHOR, URL = "  <author>Bob</author>\n", "  <url>https://example.org</url>\n"
LICENSE, DEPEND = "  <license>Apache-2.0</license>\n", "  <depend>rclpy</depend>\n"
OWN_VARIABLE = '  <depend condition="$ACME_ROBOT == one">rclpy</depend>\n'


def with_text(text: str) -> Example:
    """A manifest with other lines in the place of its license."""
    return Example(bad={"package.xml": PLAIN.replace(LICENSE, text)}, good={})


def without_schema(example: Example) -> Example:
    text = example.bad["package.xml"] or ""
    lines = [line for line in text.splitlines(keepends=True) if "xml-model" not in line]
    return Example(bad={"package.xml": "".join(lines)}, good={})


def gathering(name: str) -> Example:
    """A metapackage of a name."""
    text = manifest("  <exec_depend>rclpy</exec_depend>\n", "ament_cmake", name)
    files = {"package.xml": text, "CMakeLists.txt": CMAKE.replace("my_pkg", name)}
    return Example(bad=files, good={}, on="ament_cmake")


def generating(*dependencies: str) -> Example:
    """A package that generates interfaces."""
    body = "".join(f"  {each}\n" for each in dependencies)
    group = "  <member_of_group>rosidl_interface_packages</member_of_group>\n"
    files = {"CMakeLists.txt": xml305.CMAKE, "msg/Battery.msg": "float32 level\n"}
    return Example(bad={"package.xml": manifest(body + group, "ament_cmake"), **files}, good={}, on="ament_cmake")


SETUP_OF_FILES = "from setuptools import setup\n\nsetup(data_files=[('share/my_pkg', ['a.launch.py'])])\n"
NATIVE = CMAKE
INSTALLS = NATIVE.replace("ament_package", "install(DIRECTORY launch DESTINATION share/my_pkg)\nament_package")

CASES = {
    "XML001": (
        with_line("<version>1.0.1</version>"),
        instead("<license>Apache-2.0</license>", "<license> </license>"),
        with_line("<member_of_group>My Group</member_of_group>"),
        with_line("<maintainr>Ada</maintainr>"),
        with_line("<build_type>ament_python</build_type>"),
        with_line("stray words"),
        with_line("<depend>rclpy<b/></depend>"),
        Example(bad={"package.xml": manifest("  <depend>rclpy</depend>\n").replace('"3"', '"1"')}, good={}),
        Example(
            bad={
                "package.xml": manifest(
                    "  <depend>rclpy</depend>\n  <exec_depend>a</exec_depend>\n  <depend>b</depend>\n"
                    "  <depend>c</depend>\n  <doc_depend>d</doc_depend>\n  <maintainr>Ada</maintainr>\n"
                ).replace('"3"', '"1"')
            },
            good={},
        ),
        instead("<license>", '<license file="LICENSE" colour="red">'),
    ),
    "XML002": (
        instead(VERSION + BELOW, BELOW + VERSION),
        without_schema(with_text(2 * AUTHOR + "  <license>Apache-2.0</license>\n")),
        with_text("  <buildtool_depend>cmake</buildtool_depend>\n" + LICENSE + DEPEND + URL + AUTHOR + DEPEND),
    ),
    "XML003": (instead('format="3"', 'format=" 3 "'), instead('format="3"', 'format="4"')),
    "XML101": (
        *(instead("<name>my_pkg<", f"<name>{name}<") for name in ("", "m", "9", "My__Pkg", "9a", "_a")),
        gathering("my-pkgs"),
        gathering("My_pkgs"),
        *(
            Example(bad={"package.xml": manifest("", "ament_cmake").replace("my_pkg", "my_pkg-400"), **more}, good={})
            for more in ({}, {"my_pkg/__init__.py": ""}, {"my_pkg-400/__init__.py": ""})
        ),
    ),
    "XML103": (
        instead("1.0.0", "1.02.0"),
        instead("<version>", '<version compatibility="one">'),
        instead("<version>", '<version compatibility="1.0.1">'),
        instead("<version>", '<version compatibility="1.0.0">'),
    ),
    "XML104": (
        instead("Drives my robot", " "),
        instead("Drives my robot", "The my_pkg package."),
        instead(">Ada<", ">TODO<"),
        instead("Apache-2.0", "TODO"),
        instead("<license>Apache-2.0</license>", "<license>MIT</license>\n  <license>TODO</license>"),
        Example(bad={"package.xml": PLAIN.replace("Apache-2.0", "TODO"), "LICENSE": None}, good={}),
        *(
            Example(bad={"src/my_pkg/package.xml": PLAIN.replace("Apache-2.0", "TODO"), name: "MIT\n"}, good={}, on="")
            for name in ("LICENSE", "src/COPYING.md", "other/LICENSE")
        ),
    ),
    "XML106": tuple(instead("Apache-2.0", PROSE[-length:]) for length in (59, 60, 90)),
    "XML306": (
        instead("<build_type>", '<rqt_gui plugin="${prefix}/gone.xml"/>\n    <build_type>'),
    ),
    "XML108": (with_line('<url type="development">https://example.org</url>'),),
    "XML107": (instead("<license>", '<license file="">'), instead("<license>", '<license file="../LICENSE">'),
               instead("<license>", '<license file="LICENCE">')),
    "XML204": (
        depend('condition="$ROS_VERSION &lt; 10"'),
        depend('condition="$ROS_VERSION &lt; 2"'),
        depend('condition="$ROS_VERSION == 10"'),
        depend('condition="ROS_DISTRO == humble"'),
        depend('condition="$ROS_DISTR == humble"'),
        depend('condition="$ROS_DITSRO == humble"'),
        depend('condition="$GZ_VERSION == jetty"'),
        Example(bad={"package.xml": manifest(2 * OWN_VARIABLE)}, good={}),
        depend('condition=""'),
        depend('condition="$ROS_DISTRO &amp;&amp; humble"'),
    ),
    "XML301": tuple(
        Example(
            on="ament_cmake",
            bad={
                "package.xml": manifest().replace("<build_type>ament_python</build_type>", "<x/>"),
                "CMakeLists.txt": text,
                "a.cpp": "int main() {}\n",
            },
            good={},
        )
        for text in (
            "cmake_minimum_required(VERSION 3.20)\nproject(my_pkg)\n",
            CMAKE.replace("ament_package", "add_executable(a a.cpp)\nament_package"),
            CMAKE.replace("ament_package", "add_library(a a.cpp)\nament_package"),
        )
    ),
    "XML305": (
        generating("<exec_depend>rosidl_default_generators</exec_depend>"),
        generating("<depend>rosidl_default_generators</depend>"),
        generating("<buildtool_depend>rosidl_default_generators</buildtool_depend>",
                   "<exec_depend>rosidl_default_generators</exec_depend>"),
    ),
    "XML205": (
        depend('version_gte="1.0" version_gt="1.0" version_lt="2.0"'),
        depend('version_eq="1.0" version_lt="2.0"'),
        depend('version_gte="two"'),
    ),
    "XML208": (
        Example(bad={"package.xml": manifest("  <depend>rclcpp</depend>\n", "ament_cmake").replace(
            "  <buildtool_depend>ament_cmake</buildtool_depend>\n", "")}, good={}, on="ament_cmake"),
    ),
    "XML307": (
        Example(bad={"package.xml": PLAIN, "CMakeLists.txt": CMAKE}, good={}),
        *(
            Example(bad={"setup.py": SETUP_OF_FILES + more, "CMakeLists.txt": cmake}, good={}, on="ament_cmake")
            for more, cmake in (("", INSTALLS), ("", NATIVE), ("SCRIPTS = dict(scripts=[])\n", INSTALLS))
        ),
    ),
}  # fmt: skip
