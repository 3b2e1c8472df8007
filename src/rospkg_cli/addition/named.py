"""Whether anything but its declaration needs a dependency of a package."""

from __future__ import annotations

import re

from ..lazy_regex import regex
from ..package.package import Package
from ..scaffold.answers_record import RECORD

TALK = (".md", ".rst", ".txt", ".html", ".svg")
"""Suffixes of files that only speak of packages; CMakeLists.txt is none of them."""

COMMENT = regex(r"#[^\n]*")
XML_COMMENT = re.compile(r"<!--.*?-->", re.DOTALL)

STANDS_FOR = {
    "ament_cmake_gtest": r"ament_add_gtest\b|ament_add_gtest_executable\b",
    "ament_cmake_gmock": r"ament_add_gmock\b",
    "ament_cmake_pytest": r"ament_add_pytest_test\b",
    "ament_cmake_python": r"ament_python_install_\w+",
    "ament_cmake_auto": r"ament_auto_\w+",
    "generate_parameter_library": r"generate_parameter_module\b",
    "generate_parameter_library_py": r"generate_parameter_module\b",
    "launch_ros": r"<(?:composable_)?node\b|(?m:^\s*-\s*(?:composable_)?node:)",
    "launch_testing_ament_cmake": r"add_launch_test\b",
    "rclcpp_components": r"rclcpp_components_register_\w+",
    "rosidl_default_generators": r"rosidl_generate_interfaces\b",
    "rosidl_default_runtime": r"rosidl_generate_interfaces\b",
    "tf2_ros_py": r"\b(?:from|import)\s+tf2_ros\b",
    "python3-pytest": r"\bpytest\b",
    "python3-yaml": r"\byaml\b",
}
"""What needs a package without its name."""

BY_FILES = {
    "action_msgs": (".action",),
    "launch": (".launch.py", "_launch.py", "/test_launch.py"),
    "launch_xml": (".launch.xml", "_launch.xml", ".launch"),
    "launch_yaml": (".launch.yaml", "_launch.yaml", ".launch.yml", "_launch.yml"),
}
"""What files with certain ends need."""


def is_needed(package: Package, name: str, besides: str = "") -> bool:
    """Return whether a file of a package, other than package.xml, names another package, or does what needs it.

    Files that end in `besides` don't count, such as those of Python for who compiles.
    """
    if name in BY_FILES:
        return any(path.endswith(BY_FILES[name]) for path in package.files.paths)
    word = re.compile(rf"(?<![\w-]){re.escape(name)}(?![\w-])|" + STANDS_FOR.get(name, r"(?!)"))
    paths = [path for path in package.files.paths if is_code(path) and not (besides and path.endswith(besides))]
    return any(word.search(code_of(package, path, name)) for path in paths)


def is_code(path: str) -> bool:
    name = path.rpartition("/")[2]
    if name == "CMakeLists.txt":
        return True
    return name not in ("package.xml", "LICENSE", RECORD) and not name.endswith(TALK)


def code_of(package: Package, path: str, name: str) -> str:
    """Return what a file says besides comments, and besides looking for a package."""
    text = package.files.readable_text(path)
    if path.endswith((".cmake", "CMakeLists.txt")):
        text = COMMENT.sub("", text)
        return re.sub(rf"(?i)\bfind_package\s*\(\s*{re.escape(name)}\b[^)]*\)", "", text)
    if path.endswith((".py", ".yaml", ".yml", ".cfg", ".toml")):
        return COMMENT.sub("", text)
    return XML_COMMENT.sub("", text) if path.endswith((".xml", ".launch", ".urdf", ".xacro")) else text
