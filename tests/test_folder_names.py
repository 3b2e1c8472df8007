"""A setup.py that takes the package's name from its folder: the name is not known, and nothing is told of it."""

from __future__ import annotations

import pytest

from rospkg_cli.testing import lint_files

HERE = (
    "os.path.basename(os.path.abspath(os.path.dirname(__file__)))",
    "os.path.basename(os.path.dirname(os.path.realpath(__file__)))",
    "Path(__file__).resolve().parent.name",
    "Path.cwd().name",
    "os.path.basename(os.getcwd())",
    "os.path.split(os.getcwd())[-1]",
    "os.path.abspath(os.path.dirname(__file__)).split('/')[-1]",
    "os.path.relpath('.', '..')",
)


def named(clean: dict[str, str], here: str) -> dict[str, str]:
    text = clean["setup.py"].replace("'my_pkg'", "NAME").replace("\nsetup(", f"\nNAME = {here}\n\nsetup(")
    entry = "    entry_points={'console_scripts': [f'talker = {NAME}.talker:main']},\n    license="
    text = f"import os\nfrom pathlib import Path\n\n{text}".replace("    license=", entry)
    return {**clean, "setup.py": text, "my_pkg/talker.py": "def main():\n    pass\n"}


@pytest.mark.parametrize("here", HERE)
def test_the_name_of_the_folder(clean, here: str) -> None:
    files = named(clean, here)
    assert "NAME" in files["setup.py"]
    found = lint_files(files).findings
    assert [each.message for each in found if each.severity.value != "info"] == []
    assert [each.message for each in found if "<package>" in each.message] == []


def test_a_path_below_the_folder_is_known(clean) -> None:
    text = clean["setup.py"].replace("find_packages(exclude=['test'])", "[os.path.basename('a/other')]")
    found = lint_files({**clean, "setup.py": f"import os\n\n{text}"}, ["SET302"]).findings
    assert [each.severity.value for each in found] == ["error"]
