"""A setup() without `packages`, in a repository for distributions with an old setuptools or a newer one (SET302)."""

from __future__ import annotations

import pytest

from rospkg_cli.example import BACKDROPS, existing_files
from rospkg_cli.rules.setup import set302_package_not_installed as set302
from rospkg_cli.testing import lint_files

HUMBLE = "FROM ros:humble\n"
PIP = f"{HUMBLE}RUN pip install "
FILES = {
    **{f"src/my_pkg/{path}": text for path, text in existing_files(BACKDROPS["ament_python"]).items()},
    "src/my_pkg/setup.py": set302.NONE,
    "src/my_pkg/my_pkg/rates.py": "RATE = 10.0\n",
}
IMPORT = "from my_pkg.rates import RATE\n"


@pytest.mark.parametrize(
    ("files", "level"),
    [
        ({}, "error"),
        ({"Dockerfile": HUMBLE}, "warning"),
        ({"Dockerfile": "FROM ros:foxy\n"}, "warning"),
        ({"Dockerfile": "FROM ros:jazzy\n"}, "error"),
        ({"Dockerfile": HUMBLE, "README.md": "For Humble and Jazzy.\n"}, "error"),
        ({"Dockerfile": f"{PIP}setuptools==58.2.0\n"}, "warning"),
        ({"Dockerfile": f"{PIP}setuptools\n"}, "warning"),
        ({"Dockerfile": f"{PIP}-U pip setuptools\n"}, "error"),
        ({"Dockerfile": f"{PIP}'setuptools>=64'\n"}, "error"),
        ({"Dockerfile": f"{PIP}-U 'setuptools<60'\n"}, "warning"),
        ({"Dockerfile": HUMBLE, "src/tools/run.py": IMPORT}, "error"),
        ({"Dockerfile": HUMBLE, "src/my_pkg/scripts/run.py": "import my_pkg.rates\n"}, "error"),
        ({"Dockerfile": HUMBLE, "src/my_pkg/my_pkg/clock.py": IMPORT}, "warning"),
        ({"Dockerfile": HUMBLE, "src/my_pkg/test/test_rates.py": IMPORT}, "warning"),
        ({"Dockerfile": HUMBLE, "tools/run.py": "from my_pkg import RATE\n", "tools/my_pkg.py": "RATE = 1.0\n"},
         "warning"),
    ],
)  # fmt: skip
def test_what_a_setup_without_packages_stops(files: dict[str, str], level: str) -> None:
    (found,) = lint_files({**FILES, **files}, ["SET302"]).findings
    assert found.severity.value == level
