"""Faults that people repaired in Python packages, told again in small."""

from __future__ import annotations

from rospkg_cli.example import SETUP_PY, Example
from rospkg_cli.rules.setup import set302_package_not_installed as set302

from .setups import MAIN, python
from .shown_imports import MIXED, MIXED_CMAKE

BOTH = """\
import os
import xml.etree.ElementTree as ET
from setuptools import setup

version = ET.parse('package.xml').getroot().find('version').text
if {}:
    from catkin_pkg.python_setup import generate_distutils_setup

    setup(**generate_distutils_setup(packages=['my_pkg', 'my_pkg.speech']))
    exit(0)
else:
{}"""
ASKING = (
    "'ROS_VERSION' in os.environ and os.environ['ROS_VERSION'] == '1'",
    "os.environ.get('ROS_VERSION') == '1'",
    "'ROS_VERSION' not in os.environ or os.getenv('ROS_VERSION') != '2'",
    "'ROS_VERSION' in os.environ",
    "'ROS_VERSION' in names",
    "'ROS_DISTRO' in os.environ",
)


def for_both(condition: str) -> Example:
    """A setup.py for ROS 1 and 2, of which the latter leaves a package out."""
    listed = SETUP_PY.replace(set302.FOUND, "['my_pkg']").replace("from setuptools import find_packages, setup\n", "")
    lines = "".join(f"    {line}\n" if line else "\n" for line in listed.splitlines())
    speech = {"my_pkg/talker.py": f"from my_pkg.speech.words import A\n\n\n{MAIN}", "my_pkg/speech/__init__.py": ""}
    return python({"setup.py": BOTH.format(condition, lines), **speech, "my_pkg/speech/words.py": "A = 1\n"})


def of_cmake(line: str) -> Example:
    """A package of CMake that imports two modules of its own, of which it has no file."""
    files = {**MIXED, "CMakeLists.txt": MIXED_CMAKE.replace("ament_package", f"{line}\nament_package")}
    text = "from .config.loaders import A\nimport my_pkg.nothing_alike\n"
    return Example(on="", bad={**files, "my_pkg/talker.py": text, "src/core.cpp": "int i;\n"}, good={})


def moved(*packages: str) -> Example:
    """A package that imports a module which other packages of the workspace have."""
    files = {f"a/{path}": each for path, each in MIXED.items()}
    for name in packages:
        files |= {
            f"{name}/{path.replace('my_pkg', name)}": each.replace("my_pkg", name) for path, each in MIXED.items()
        }
        files |= {f"{name}/{name}/config/__init__.py": "", f"{name}/{name}/config/loader.py": "A = 1\n"}
    return Example(on="", bad={**files, "a/my_pkg/talker.py": "from .config.loader import A\n"}, good={})


MAKING = (
    "",
    "add_library(core SHARED src/core.cpp)",
    "pybind11_add_module(core src/core.cpp)",
    "configure_file(a.in a.py)",
    "add_custom_target(core ALL COMMAND a)",
    "include(${MODULES}/a.cmake)",
)

CASES = {
    "DEP109": (*map(of_cmake, MAKING), moved("other"), moved("other", "third")),
    "SET302": tuple(map(for_both, ASKING)),
}
