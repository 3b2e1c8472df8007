"""Nobody comes to a fault of a package that can't be built as long as its manifest or build file can't be read."""

from __future__ import annotations

import pytest

from rospkg_cli.example import BACKDROPS, existing_files
from rospkg_cli.testing import lint_files

PATH = "NAMES = open('/home/ada/ws/src/my_pkg/my_pkg/names.txt').read()\n"
BESIDE = {"my_pkg/names.py": PATH, "my_pkg/names.txt": "a\n"}
PYTHON = existing_files(BACKDROPS["ament_python"])
NATIVE = existing_files(BACKDROPS["ament_cmake"])


@pytest.mark.parametrize("path", ["package.xml", "setup.py"])
def test_what_stands_behind_an_unreadable_build_file_is_an_info(path: str) -> None:
    broken = PYTHON[path].replace("</package>", "<depend></package>").replace("setup(", "setup((")
    files = {**PYTHON, **BESIDE, path: broken}
    found = {each.code: each for each in lint_files(files, ["RPK001", "DEP118"]).findings}
    assert found["RPK001"].severity.value == "error"
    assert found["DEP118"].severity.value == "info"
    assert found["DEP118"].message.endswith(f"; this matters only once `{path}` can be read")


@pytest.mark.parametrize("more", [{}, {"scripts/setup.py": "def (:\n"}, {"config/a.yaml": "a: [\n"}])
def test_other_files_that_cannot_be_read_hide_nothing(more: dict[str, str]) -> None:
    used = {"my_pkg/talker.py": "import my_pkg.names\n"}
    files = {**PYTHON, **BESIDE, **used, **more}
    files["setup.py"] = files["setup.py"].replace(
        "    license=", "    entry_points={'console_scripts': ['talker = my_pkg.talker:main']},\n    license="
    )
    assert [each.severity.value for each in lint_files(files, ["DEP118"]).findings] == ["warning"]


def test_the_fault_that_stops_the_build_stays_an_error() -> None:
    files = {**NATIVE, "package.xml": "<package>", "CMakeLists.txt": "project("}
    assert {each.severity.value for each in lint_files(files, ["RPK001"]).findings} == {"error"}
