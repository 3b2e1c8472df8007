"""What a package uses against what it declares: where to speak, and the many places where to keep quiet."""

from __future__ import annotations

import pytest

from rospkg_cli.example import BACKDROPS, CMAKE, manifest, present
from rospkg_cli.testing import lint_files

PYTHON = present(BACKDROPS["ament_python"])
ROS1 = '<build_type condition="$ROS_VERSION == 1">catkin</build_type>\n    <build_type'


def said(code: str, files: dict[str, str | None]) -> list[str]:
    """Return the names in backticks that a rule's findings begin with: the dependency each is about."""
    found = lint_files(present({**PYTHON, **files}), [code]).findings
    return [finding.message.split("`")[1] for finding in found]


def imports(text: str, body: str = "", path: str = "my_pkg/node.py") -> list[str]:
    return said("DEP101", {path: text, "package.xml": manifest(body)})


@pytest.mark.parametrize(
    "text",
    [
        "import os, json\nfrom pathlib import Path\n",
        "try:\n    import cv2\nexcept ImportError:\n    cv2 = None\n",
        "try:\n    import cv2\nexcept (ModuleNotFoundError, OSError):\n    import numpy\n",
        "try:\n    import cv2\nexcept:\n    pass\n",
        "import contextlib\nwith contextlib.suppress(ImportError):\n    import cv2\n",
        "from typing import TYPE_CHECKING\nif TYPE_CHECKING:\n    import cv2\n",
        "import sys\nif sys.platform == 'win32':\n    import serial\nelse:\n    import numpy\n",
        "from . import cv2\nfrom .numpy import x\n",
        "import my_pkg.cv2\n",
        "import beside\n",
        "import no_such_library\n",
    ],
)
def test_imports_that_need_no_declaration(text: str) -> None:
    assert (
        said("DEP101", {"my_pkg/node.py": text, "my_pkg/beside.py": "", "my_pkg/vendored/yaml/__init__.py": ""}) == []
    )


def test_a_lazy_import_is_needed_as_any_other() -> None:
    assert imports("def run():\n    import cv2\n    return cv2\n") == ["python3-opencv"]


def test_a_vendored_copy_is_the_packages_own() -> None:
    assert said("DEP101", {"my_pkg/node.py": "import yaml\n", "my_pkg/vendor/yaml/__init__.py": ""}) == []


def test_one_finding_for_each_dependency() -> None:
    text = "import cv2\nfrom geometry_msgs.msg import Twist\n"
    assert said("DEP101", {"my_pkg/a.py": text, "my_pkg/b.py": text}) == ["python3-opencv", "geometry_msgs"]


@pytest.mark.parametrize("tag", ["depend", "exec_depend", "build_depend", "test_depend"])
def test_a_dependency_under_any_tag_is_declared(tag: str) -> None:
    assert imports("import rclpy\n", f"  <{tag}>rclpy</{tag}>\n") == []


def test_a_dependency_under_a_condition_is_declared() -> None:
    assert imports("import rclpy\n", '  <depend condition="$ROS_DISTRO == humble">rclpy</depend>\n') == []


@pytest.mark.parametrize("key", ["python3-opencv", "libopencv-dev", "python-opencv-contrib-pip"])
def test_any_key_that_brings_the_module_will_do(key: str) -> None:
    assert imports("import cv2\n", f"  <exec_depend>{key}</exec_depend>\n") == []


def test_a_key_that_is_called_like_the_module_will_do() -> None:
    assert imports("import simple_pid\n", "  <exec_depend>python3-simple-pid</exec_depend>\n") == []


def test_interfaces_are_a_ros_package_even_if_nobody_knows_it() -> None:
    assert imports("from acme_msgs.msg import Gripper\n") == ["acme_msgs"]
    assert imports("from acme.msg import helper\n") == []


@pytest.mark.parametrize(
    "path", ["test/test_a.py", "my_pkg/test/helper.py", "docs/conf.py", "setup.py", "scripts/once.py"]
)
def test_what_is_not_installed_does_not_count(path: str) -> None:
    files = {**PYTHON, path: PYTHON.get(path, "") + "import cv2\n"}
    assert said("DEP101", files) == []


def test_a_package_may_be_called_like_a_test() -> None:
    assert said("DEP101", {"my_test_utils/__init__.py": "import cv2\n"}) == ["python3-opencv"]


def test_ros_1_packages_are_left_alone() -> None:
    only = manifest(build_type="catkin")
    both = manifest().replace("<build_type", ROS1)
    assert said("DEP101", {"package.xml": only, "my_pkg/a.py": "import rclpy\n"}) == []
    assert said("DEP101", {"package.xml": both, "my_pkg/a.py": "import rclpy\n"}) == ["rclpy"]


def test_scripts_of_cmake_packages_count_where_they_are_installed() -> None:
    install = CMAKE.replace(
        "ament_package()", "install(PROGRAMS scripts/run.py DESTINATION lib/my_pkg)\nament_package()"
    )
    files: dict[str, str | None] = dict.fromkeys(PYTHON)
    files |= {"package.xml": manifest(build_type="ament_cmake"), "CMakeLists.txt": install}
    files |= {"scripts/run.py": "#!/usr/bin/env python3\nimport rclpy\n", "scripts/tool.py": "import cv2\n"}
    assert said("DEP101", files) == ["rclpy"]


def test_a_script_without_a_suffix_is_python_by_its_first_line() -> None:
    install = CMAKE.replace("ament_package()", "install(PROGRAMS run DESTINATION lib/my_pkg)\nament_package()")
    files: dict[str, str | None] = dict.fromkeys(PYTHON)
    files |= {"package.xml": manifest(build_type="ament_cmake"), "CMakeLists.txt": install}
    assert said("DEP101", {**files, "run": "#!/usr/bin/env python3\nimport rclpy\n"}) == ["rclpy"]
    assert said("DEP101", {**files, "run": "#!/bin/sh\nimport rclpy\n"}) == []


def test_packages_around_are_known() -> None:
    around = {f"b/{path}": text for path, text in PYTHON.items()}
    around["b/package.xml"] = manifest(name="acme_driver")
    files = {f"a/{path}": text for path, text in PYTHON.items()} | around | {"a/my_pkg/n.py": "import acme_driver.x\n"}
    assert [f.message.split("`")[1] for f in lint_files(files, ["DEP101"]).findings] == ["acme_driver"]


def test_a_metapackage_stands_for_what_it_names() -> None:
    files = {f"a/{path}": text for path, text in PYTHON.items()}
    files["a/package.xml"] = manifest("  <exec_depend>acme_all</exec_depend>\n")
    files["a/my_pkg/n.py"] = "import rclpy, cv2\n"
    files["b/package.xml"] = manifest("  <exec_depend>rclpy</exec_depend>\n", "ament_cmake", "acme_all")
    files["b/CMakeLists.txt"] = CMAKE
    assert [f.message.split("`")[1] for f in lint_files(files, ["DEP101"]).findings] == ["python3-opencv"]
    files["b/src/node.cpp"] = "int main() {}\n"
    assert {f.message.split("`")[1] for f in lint_files(files, ["DEP101"]).findings} == {"python3-opencv", "rclpy"}
