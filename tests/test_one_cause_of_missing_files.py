"""What is installed to a wrong place is told there, and not by everyone who looks for it."""

from __future__ import annotations

import pytest

from rospkg_cli.example import CMAKE, manifest, setup_py
from rospkg_cli.testing import lint_files

ROBOT = """\
<robot name="r"><link name="a"><visual><geometry>
<mesh filename="package://my_pkg/meshes/a.stl"/></geometry></visual></link></robot>
"""
MODULE = """\
import os

from ament_index_python.packages import get_package_share_directory


def main():
    with open(os.path.join(get_package_share_directory('my_pkg'), 'config', 'a.csv')) as file:
        print(file.read())
"""


def codes(files: dict[str, str]) -> list[str]:
    return [each.code for each in lint_files(files, ["CMK111", "DEP113", "SET208", "URD002"]).findings]


@pytest.mark.parametrize("slash, told", [("", []), ("/", ["CMK111"])])
def test_an_absolute_destination(slash: str, told: list[str]) -> None:
    install = f"install(DIRECTORY meshes urdf DESTINATION {slash}share/${{PROJECT_NAME}})\n"
    files = {
        "package.xml": manifest("", "ament_cmake"),
        "CMakeLists.txt": CMAKE.replace("ament_package", install + "ament_package"),
        "meshes/a.stl": "solid\n",
        "urdf/r.urdf": ROBOT,
    }
    assert codes(files) == told


@pytest.mark.parametrize("folder, told", [("share/my_pkg/config", []), ("share/config", ["SET208"])])
def test_a_wrong_destination_of_setup_py(folder: str, told: list[str]) -> None:
    setup = setup_py().replace("data_files=[", f"data_files=[('{folder}', ['config/a.csv']),")
    files = {
        "package.xml": manifest("", "ament_python"),
        "setup.py": setup.replace("'console_scripts': [", "'console_scripts': ['talk = my_pkg.talk:main',"),
        "my_pkg/__init__.py": "",
        "my_pkg/talk.py": MODULE,
        "config/a.csv": "1\n",
    }
    assert codes(files) == told
