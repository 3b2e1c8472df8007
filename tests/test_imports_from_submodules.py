"""What a package imports and another one brings: a submodule that is not checked out, a finder of modules."""

from __future__ import annotations

import pytest

from rospkg_cli.example import BACKDROPS, existing_files, scripts, setup_py
from rospkg_cli.testing import lint_files


@pytest.mark.parametrize(
    ("place", "expected"), [("my_pkg/third_party/arm", []), ("my_pkg/third", ["error"]), ("other", ["error"])]
)
def test_the_folder_around_a_submodule(place: str, expected: list[str]) -> None:
    files = {
        **existing_files(BACKDROPS["ament_python"]),
        "setup.py": setup_py(scripts("talker = my_pkg.talker:main")),
        "my_pkg/talker.py": "from my_pkg.third_party.arm import Arm\n\n\ndef main():\n    print(Arm)\n",
        ".gitmodules": f'[submodule "arm"]\n\tpath = {place}\n\turl = https://example.org/arm.git\n',
    }
    assert [each.severity.value for each in lint_files(files, ["DEP109"]).findings] == expected


@pytest.mark.parametrize(("line", "expected"), [("sys.meta_path.append(Finder())", []), ("print(Finder)", ["error"])])
def test_a_finder_of_the_package_may_make_modules(line: str, expected: list[str]) -> None:
    files = {
        **existing_files(BACKDROPS["ament_python"]),
        "setup.py": setup_py(scripts("talker = my_pkg.talker:main")),
        "my_pkg/talker.py": "from my_pkg.made.arm import Arm\n\n\ndef main():\n    print(Arm)\n",
        "my_pkg/made/__init__.py": f"import sys\n\n\nclass Finder: ...\n\n\n{line}\n",
    }
    assert [each.severity.value for each in lint_files(files, ["DEP109"]).findings] == expected
