"""XML307 conflicting-build-files."""

from __future__ import annotations

import re
from collections.abc import Iterator

from ...checks.enumeration import in_ticks
from ...checks.manifest.ignored_build_file import is_told_elsewhere, lost_of_cmake, lost_of_setup
from ...checks.manifest.manifest_and_cmake import ManifestAndCMake
from ...example import CMAKE, SETUP_PY, Example, manifest
from ...finding import Hit, Severity
from ...lazy_regex import regex
from ...ros.manifest import BUILD_FILES
from ...rule import rule

MODULES = {"my_pkg/__init__.py": "", "my_pkg/talker.py": "RATE = 10\n"}
INSTALLING = CMAKE.replace(
    "ament_package()", "install(DIRECTORY docs DESTINATION share/${PROJECT_NAME})\nament_package()"
)
PYTHON = manifest().replace("<build_type>ament_python", "<build_type>«ament_python»")
MIXED = manifest(build_type="ament_cmake").replace("<build_type>ament_cmake", "<build_type>«ament_cmake»")
OF_CATKIN = regex(r"^\s*catkin_(?:package|python_setup)\s*\(", re.MULTILINE)


@rule(
    "XML307",
    "conflicting-build-files",
    over=ManifestAndCMake,
    severity=Severity.WARNING,
    levels={
        Severity.INFO: "where the file that is ignored installs nothing that is there and else missing, or is for ROS 1"
    },
    examples=(
        Example(
            bad={"package.xml": PYTHON, "CMakeLists.txt": INSTALLING, "docs/a.md": ""}, good={"CMakeLists.txt": None}
        ),
        Example(
            on="ament_cmake",
            bad={
                "package.xml": MIXED,
                "setup.py": SETUP_PY,
                "my_pkg/__init__.py": "",
                "my_pkg/talker.py": "RATE = 10\n",
            },
            good={"setup.py": None},
        ),
    ),
)
def conflicting_build_files(package: ManifestAndCMake) -> Iterator[Hit]:
    """
    ## What it does
    Finds a CMakeLists.txt in an ament_python package, and an unused setup.py in an ament_cmake one.
    A setup.py is used by ament_cmake_python. Packages for ROS 1 and 2 (catkin, conditions) are left alone.

    ## Why is this bad?
    colcon reads one of the two and ignores the other. What the ignored one would install is missing, although the
    package seems to install it.

    ## When it is quiet
    It is an info where the ignored file installs nothing that is there and is missing without it: a CMakeLists.txt for
    catkin, or one whose files setup.py names too, or has to name (folders of launch files, parameters …); a setup.py
    whose modules are not there, or whose files CMake installs. Packages for ROS 1 and ROS 2 (catkin, conditions) are
    left alone, those without the file of their own build type to XML304, and a setup.py that CMake installs by
    `ament_python_install_package()`, or that a CMakeLists.txt of unknown parts may use.

    ## References
    - [ament_cmake_python](https://docs.ros.org/en/rolling/How-To-Guides/Ament-CMake-Python-Documentation.html)
    """
    manifest, files = package.manifest, package.files
    types = list(manifest.build_types(package.targets))
    if len(types) != 1 or manifest.depends_on("catkin") or any("condition" in each.attributes for each in types):
        return
    used, other, is_lost = types[0].text, "", True
    harmless = "which installs nothing more"
    if not files.exists(BUILD_FILES.get(used, "package.xml")):
        return
    if used == "ament_python" and files.exists("CMakeLists.txt"):
        other, advice = "CMakeLists.txt", "remove it, or make this an ament_cmake package"
        is_for_ros1 = OF_CATKIN.search(files.source("CMakeLists.txt").text) is not None
        harmless = "which catkin read in ROS 1" if is_for_ros1 else harmless
        lost = [] if is_for_ros1 else lost_of_cmake(files)
        harmless = f"which would install {in_ticks(lost)}" if lost else harmless
        is_lost = not all(map(is_told_elsewhere, lost))
    elif used == "ament_cmake" and files.exists("setup.py") and package.cmake and not package.installs_python:
        other, advice = "setup.py", "remove it, or call `ament_python_install_package` in CMakeLists.txt"
        is_lost = lost_of_setup(files)
    if other:
        ends = ": what it installs is missing" if is_lost else f", {harmless}"
        message = f"the build type is `{used}`, so colcon ignores `{other}`{ends}; {advice}"
        yield Hit(manifest.path, manifest.span(types[0]), message, None if is_lost else Severity.INFO)
