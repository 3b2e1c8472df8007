"""A folder in which a dialog for files begins may be missing: it begins elsewhere then (DEP118)."""

from __future__ import annotations

import pytest

from rospkg_cli.example import BACKDROPS, CMAKE, existing_files, scripts, setup_py
from rospkg_cli.testing import lint_files

PATH = "/home/ada/ws/src/my_pkg/maps"
PYTHON = {**existing_files(BACKDROPS["ament_python"]), "setup.py": setup_py(scripts("talker = my_pkg.talker:main"))}
NATIVE = existing_files(BACKDROPS["ament_cmake"])


def level(files: dict[str, str]) -> str:
    (found,) = lint_files({**files, "maps/a.txt": "a\n"}, ["DEP118"]).findings
    return found.severity.value


@pytest.mark.parametrize(
    ("call", "expected"),
    [
        ("QFileDialog.getOpenFileName(self, self.tr('Open'), '{}', 'Maps (*.yaml)')", "info"),
        ("QtWidgets.QFileDialog.getExistingDirectory(self, 'Open', '{}')", "info"),
        ("filedialog.askopenfilename(title='Open', initialdir='{}')", "info"),
        ("askdirectory(mustexist=True, initialdir=r'{}')", "info"),
        ("dialog.setDirectory('{}')", "info"),
        ("options = {{'initialdir': '{}'}}", "info"),
        ("QFileDialog.getOpenFileName(self); open('{}')", "warning"),
        ("open(QFileDialog.getOpenFileName(self), '{}')", "warning"),
        ("load(initial='{}')", "warning"),
    ],
)
def test_where_a_dialog_of_python_begins(call: str, expected: str) -> None:
    assert level({**PYTHON, "my_pkg/talker.py": f"def main():\n    {call.format(PATH)}\n"}) == expected


@pytest.mark.parametrize(
    ("call", "expected"),
    [
        ('QFileDialog::getOpenFileName(this, tr("Open"),\n      "{}", tr("Maps (*.yaml)"))', "info"),
        ('QFileDialog dialog(this, "Open", "{}")', "info"),
        ('QFileDialog::getOpenFileName(this); load("{}")', "warning"),
    ],
)
def test_where_a_dialog_of_cpp_begins(call: str, expected: str) -> None:
    cmake = CMAKE.replace("ament_package", "add_executable(a src/a.cpp)\nament_package")
    assert level({**NATIVE, "CMakeLists.txt": cmake, "src/a.cpp": f"void a() {{ {call.format(PATH)}; }}\n"}) == expected
