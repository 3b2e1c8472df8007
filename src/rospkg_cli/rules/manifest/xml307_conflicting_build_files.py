"""XML307 conflicting-build-files."""

from __future__ import annotations

import re
from collections.abc import Iterator

from ...checks.manifest.manifest_inputs import ManifestAndCMake
from ...example import CMAKE, CONFIG_INSTALL, SETUP_PY, Example, manifest
from ...finding import Hit, Severity
from ...lazy_regex import regex
from ...ros.manifest import BUILD_FILES
from ...rule import rule

INSTALL = regex(r"install\w*\s*\(", re.I)
"""A call of `install()` or of a command that is named after it: of an ignored file only the text is looked at."""

INSTALLED = regex(r"\b(?:packages|package_dir|py_modules|scripts|data_files|entry_points|ext_modules)\b")
"""What setup.py or setup.cfg says of files to install."""

INSTALLING = CMAKE.replace("ament_package()", CONFIG_INSTALL + "ament_package()")
PYTHON = manifest().replace("<build_type>ament_python", "<build_type>«ament_python»")
MIXED = manifest(build_type="ament_cmake").replace("<build_type>ament_cmake", "<build_type>«ament_cmake»")
OF_CATKIN = regex(r"^\s*catkin_(?:package|python_setup)\s*\(", re.MULTILINE)


@rule(
    "XML307",
    "conflicting-build-files",
    over=ManifestAndCMake,
    severity=Severity.WARNING,
    levels={Severity.INFO: "where the file that is ignored installs nothing, or is for ROS 1"},
    examples=(
        Example(bad={"package.xml": PYTHON, "CMakeLists.txt": INSTALLING}, good={"CMakeLists.txt": None}),
        Example(on="ament_cmake", bad={"package.xml": MIXED, "setup.py": SETUP_PY}, good={"setup.py": None}),
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
    A CMakeLists.txt without an install rule, or for catkin, is an info, and so is a setup.py without packages, modules
    and scripts, whose data files CMake installs: left from ROS 1 often, nothing of them is missed. Packages for ROS 1
    and ROS 2 (catkin, conditions) are left alone, those without the file of their own build type to XML304, and a
    setup.py that CMake installs by `ament_python_install_package()`, or that a CMakeLists.txt of unknown parts may use.

    ## References
    - [ament_cmake_python](https://docs.ros.org/en/rolling/How-To-Guides/Ament-CMake-Python-Documentation.html)
    """
    manifest, files = package.manifest, package.files
    types = list(manifest.build_types(package.targets))
    if len(types) != 1 or manifest.depends_on("catkin") or any("condition" in each.attributes for each in types):
        return
    used, other, level = types[0].text, "", None
    harmless = "which installs nothing"
    if not files.exists(BUILD_FILES.get(used, "package.xml")):
        return
    if used == "ament_python" and files.exists("CMakeLists.txt"):
        other, advice = "CMakeLists.txt", "remove it, or make this an ament_cmake package"
        text = files.source("CMakeLists.txt").text
        is_for_ros1 = OF_CATKIN.search(text) is not None
        harmless = "which catkin read in ROS 1" if is_for_ros1 else harmless
        level = None if INSTALL.search(text) and not is_for_ros1 else Severity.INFO
    elif used == "ament_cmake" and files.exists("setup.py") and package.cmake and not package.installs_python:
        other, advice = "setup.py", "remove it, or call `ament_python_install_package` in CMakeLists.txt"
        texts = (files.source(path).text for path in ("setup.py", "setup.cfg") if files.exists(path))
        words = {word for text in texts for word in INSTALLED.findall(text)}
        same = package.cmake.installs and words <= {"data_files"}
        level = Severity.INFO if same or not words else None
        harmless = "whose files CMake installs" if words else harmless
    if other:
        ends = f", {harmless}" if level else ": what it installs is missing"
        message = f"the build type is `{used}`, so colcon ignores `{other}`{ends}; {advice}"
        yield Hit(manifest.path, manifest.span(types[0]), message, level)
