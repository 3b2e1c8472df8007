"""Folders of a course with a few files of a package, which people copy into the one that `ros2 pkg create` makes."""

from __future__ import annotations

import pytest

from rospkg_cli.example import CMAKE, manifest, scripts, setup_py
from rospkg_cli.testing import lint_files

STEP, WHY = "02-talker", "; a page has people copy these files into a package that `ros2 pkg create` makes"
PYTHON = {
    f"{STEP}/package.xml": manifest(),
    f"{STEP}/setup.py": setup_py(scripts("talker = my_pkg.talker:main")),
    f"{STEP}/talker.py": "def main():\n    print('hello')\n",
}
NATIVE = {
    f"{STEP}/package.xml": manifest(build_type="ament_cmake"),
    f"{STEP}/CMakeLists.txt": CMAKE.replace("ament_package", "add_executable(talker src/talker.cpp)\nament_package"),
    f"{STEP}/talker.cpp": "int main() {return 0;}\n",
}
CODES = ["CMK102", "SET101", "SET202", "SET302", "XML304"]
PAGES = [
    {f"{STEP}/README.md": "```\nros2 pkg create --build-type ament_python my_pkg\n```\n"},
    {"README.md": "ros2 pkg create --license Apache-2.0 \\\n  --build-type ament_cmake my_pkg\n"},
    {"01-start/README.md": "Run `ros2 pkg create my_pkg`, then go to the next step.\n"},
    {f"{STEP}/README.md": "Copy `02-talker/talker.py` into `~/ros2_ws/src/my_pkg/my_pkg`.\n"},
    {f"{STEP}/README.md": "3. Replace the `CMakeLists.txt` of `~/ros2_ws/src/my_pkg` with the one in this folder.\n"},
]


def told(files: dict[str, str]) -> set[tuple[str, bool]]:
    found = lint_files(files, CODES).findings
    assert found
    return {(each.severity.value, each.message.endswith(WHY)) for each in found}


@pytest.mark.parametrize("page", PAGES)
@pytest.mark.parametrize("files", [PYTHON, NATIVE])
def test_what_people_copy_from_is_not_built(files: dict[str, str], page: dict[str, str]) -> None:
    assert told({**files, **page}) == {("info", True)}


@pytest.mark.parametrize(
    "more",
    [
        {},
        {"README.md": "Run `ros2 pkg create other_pkg`.\n"},
        {"README.md": "The package my_pkg holds a talker. Copy the maps.\n"},
        {**PAGES[0], f"{STEP}/src/listener.cpp": "int main() {return 0;}\n"},
        {**PAGES[0], f"{STEP}/resource/other": ""},
    ],
)
@pytest.mark.parametrize("files", [PYTHON, NATIVE])
def test_without_a_page_or_with_the_folders_of_a_package_it_is(files: dict[str, str], more: dict[str, str]) -> None:
    assert all(level != "info" for level, _ in told({**files, **more}))


def test_a_package_without_code_beside_its_build_file() -> None:
    files = {path: text for path, text in NATIVE.items() if not path.endswith(".cpp")}
    assert told({**files, **PAGES[0]}) == {("error", False)}
