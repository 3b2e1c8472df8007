"""Modules that are not installed, in a package that another one needs: does anything import them (SET301, SET302)?"""

from __future__ import annotations

import pytest

from rospkg_cli.example import BACKDROPS, existing_files, manifest, scripts, setup_py
from rospkg_cli.testing import lint_files

OWN = {
    **existing_files(BACKDROPS["ament_python"]),
    "setup.py": setup_py(scripts("talker = my_pkg.talker:main")).replace(
        "find_packages(exclude=['test'])", "['my_pkg']"
    ),
    "my_pkg/talker.py": "def main():\n    pass\n",
    "my_pkg/models/imu.py": "G = 9.81\n",
}
NEEDS = "  <exec_depend>my_pkg</exec_depend>\n"
USER = manifest("", "ament_python", "user").replace("  <export>", f"{NEEDS}  <export>")


def level(path: str, text: str, **more: str) -> str:
    files = {f"my_pkg/{each}": content for each, content in {**OWN, **more}.items()}
    found = lint_files({**files, "user/package.xml": USER, path: text}, ["SET301", "SET302"]).findings
    return next(each.severity.value for each in found)


@pytest.mark.parametrize("more", [{}, {"my_pkg/models/__init__.py": ""}])
@pytest.mark.parametrize(
    ("path", "text", "expected"),
    [
        ("README.md", "The model is `my_pkg/models/imu.py`, or my_pkg.models.\n", "info"),
        ("user/user/a.py", "from my_pkg import talker\nmodels = 1\n", "info"),
        ("user/user/a.py", "from user.models import imu\n", "info"),
        ("user/user/a.py", "# from my_pkg.models import imu\n", "info"),
        ("user/test/test_a.py", "from my_pkg.models import imu\n", "info"),
        ("user/user/a.py", "from my_pkg.models import imu\n", "warning"),
        ("user/user/a.py", "import my_pkg.models.imu as imu\n", "warning"),
        ("user/user/a.py", "from my_pkg import (\n    talker,\n    models,\n)\n", "warning"),
        ("user/config/a.yaml", "model: my_pkg.models.imu:G\n", "warning"),
        ("user/launch/a.launch.py", "from my_pkg.models.imu import G\n", "warning"),
        ("my_pkg/scripts/a.py", "from my_pkg.models.imu import G\n", "warning"),
    ],
)
def test_who_imports_modules_that_are_not_installed(more: dict[str, str], path: str, text: str, expected: str) -> None:
    assert level(path, text, **more) == expected
