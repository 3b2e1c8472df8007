"""A second `DIRECTORY` in install(): ament, which makes links, reads it as a keyword, and CMake as a path (CMK123)."""

from __future__ import annotations

import pytest

from rospkg_cli.example import BACKDROPS, CMAKE, existing_files
from rospkg_cli.testing import lint_files

FILES = {
    **existing_files(BACKDROPS["ament_cmake"]),
    "launch/a.launch.xml": "<launch/>\n",
    "urdf/a.urdf": "<robot name='a'/>\n",
    "rviz/a.rviz": "Panels: []\n",
}
LINKED = "    colcon build --symlink-install\n"
TO = "DESTINATION share/my_pkg"
REPEATED = f"install(DIRECTORY launch DIRECTORY urdf DIRECTORY rviz {TO})\n"


def told(lines: str, **pages: str) -> list[tuple[str, int, bool]]:
    """Return the level, the number of further places, and whether a kind of build is said to go on."""
    cmake = CMAKE.replace("ament_package", f"{lines}ament_package")
    found = lint_files({**FILES, "CMakeLists.txt": cmake, **pages}, ["CMK123"]).findings
    return [(each.severity.value, len(each.related), "without `--symlink-install`" in each.message) for each in found]


@pytest.mark.parametrize(
    ("pages", "level"),
    [
        ({"README.md": LINKED}, "warning"),
        ({"build.sh": "colcon build --symlink-install;\n"}, "warning"),
        ({"README.md": LINKED, "Dockerfile": "RUN colcon build\n"}, "error"),
        ({"README.md": "    colcon build\n"}, "error"),
        ({}, "error"),
    ],
)
def test_one_finding_of_a_call_by_who_builds_it(pages: dict[str, str], level: str) -> None:
    assert told(REPEATED, **pages) == [(level, 1, True)]


@pytest.mark.parametrize(
    "line",
    [
        f"install(DIRECTORY launch RUNTIME {TO})\n",
        f"install(DIRECTORY launch FILES urdf/a.urdf {TO})\n",
        f"install(FILES urdf/a.urdf PROGRAMS rviz/a.rviz {TO})\n",
        f"install(DIRECTORY launch DIRECTORY urdf {TO} USE_SOURCE_PERMISSIONS)\n",
        f'install(DIRECTORY launch DIRECTORY urdf {TO} FILES_MATCHING PATTERN "a.*")\n',
    ],
)
def test_what_stops_with_links_too(line: str) -> None:
    assert told(line, **{"README.md": LINKED}) == [("error", 0, False)]


def test_without_ament_nothing_is_linked() -> None:
    plain = CMAKE.replace("find_package(ament_cmake REQUIRED)\n", "").replace("ament_package()", REPEATED)
    pages = {"CMakeLists.txt": plain, "README.md": LINKED}
    (found,) = lint_files({**FILES, **pages}, ["CMK123"]).findings
    assert found.severity.value == "error"
    assert "symlink" not in found.message
