"""Folders that are installed and not there, and that pages tell people to make (CMK102)."""

from __future__ import annotations

import pytest

from rospkg_cli.example import CMAKE, manifest
from rospkg_cli.testing import lint_files

INSTALL = "install(DIRECTORY {} DESTINATION share/${{PROJECT_NAME}})\nament_package"


def told(page: str, folders: str = "maps", path: str = "my_pkg/README.md") -> tuple[str, str]:
    files = {
        "my_pkg/CMakeLists.txt": CMAKE.replace("ament_package", INSTALL.format(folders)),
        "my_pkg/package.xml": manifest("", "ament_cmake"),
    }
    (found,) = lint_files({**files, path: page}, ["CMK102"]).findings
    return found.severity.value, found.message


@pytest.mark.parametrize(
    "page, path",
    [
        ("    mkdir -p maps && colcon build\n", "my_pkg/README.md"),
        ("    mkdir -p ~/ws/src/my_pkg/maps\n", "my_pkg/README.md"),
        ("mkdir my_pkg/maps\n", "setup.sh"),
        ("    wget https://a.b/c.yaml -P src/my_pkg/maps\n", "README.md"),
        ("    cp ~/hall.yaml src/my_pkg/maps/hall.yaml\n", "README.md"),
    ],
)
def test_who_does_as_a_page_says_has_the_folder(page: str, path: str) -> None:
    level, message = told(page, path=path)
    assert level == "info"
    assert ", until it is fetched or made, as a page or a script here says; add it" in message


@pytest.mark.parametrize(
    "page, folders, path",
    [
        ("The maps are in `maps`.\n", "maps", "my_pkg/README.md"),
        ("    mkdir -p ~/maps\n", "maps", "my_pkg/README.md"),
        ("    mkdir -p maps\n", "maps", "README.md"),
        ("    mkdir -p my_pkg/maps_of_old\n", "maps", "README.md"),
        ("    cp my_pkg/maps/a.yaml ~/\n", "maps", "README.md"),
        ("    ros2 pkg create my_pkg\n    cd my_pkg\n    mkdir maps\n", "maps", "my_pkg/README.md"),
        ("    mkdir launch\n", "launch", "my_pkg/README.md"),
        ("    mkdir maps\n", "maps bags", "my_pkg/README.md"),
    ],
)
def test_others_meet_the_stop_of_the_build(page: str, folders: str, path: str) -> None:
    assert told(page, folders, path)[0] == "error"
