"""The one-line test of a package under the real colcon, counted by the real `colcon test-result`."""

from __future__ import annotations

import sys
from pathlib import Path

import pytest
from absent import absent
from checkout import ROOT
from shell import Shell
from venvs import COLCON, SETUPTOOLS, NoIndexError, venv

from rospkg_cli.example import Example

ONE_LINE = "from rospkg_cli.testing import test_package  # noqa: F401\n"
LIBRARIES = ("typer<0.29", "rich", "jinja2", "lxml", "xmlschema", "pyyaml", "tomli")


@pytest.fixture
def colcon_with_rospkg(shell: Shell) -> Shell:
    """colcon in an environment that has rospkg's libraries, and this checkout on its path."""
    try:
        folder = venv(sys.executable, (f"setuptools=={SETUPTOOLS[-1]}", *COLCON, *LIBRARIES), str(ROOT / "src"))
    except NoIndexError as error:
        absent(str(error))
    return shell.before(folder / "bin")


@pytest.mark.parametrize("license, failures", [("Apache-2.0", "0 failures"), ("TODO", "1 failure")])
def test_it_is_counted(colcon_with_rospkg: Shell, tmp_path: Path, license: str, failures: str) -> None:
    files = Example(bad={}, good={}).bad_files()
    files["package.xml"] = files["package.xml"].replace("Apache-2.0", license)
    for path, text in {**files, "test/test_rospkg.py": ONE_LINE}.items():
        (tmp_path / "src/my_pkg" / path).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / "src/my_pkg" / path).write_text(text)
    shell = colcon_with_rospkg
    assert shell.run("colcon", "build", cwd=tmp_path).returncode == 0
    tested = shell.run("colcon", "test", "--event-handlers", "console_direct+", cwd=tmp_path)
    counted = shell.run("colcon", "test-result", "--all", "--verbose", cwd=tmp_path)
    assert f"Summary: 1 test, 0 errors, {failures}, 0 skipped" in counted.stdout, tested.stdout
    assert counted.returncode == (1 if license == "TODO" else 0)
    if counted.returncode:
        assert "XML104 placeholder-metadata" in tested.stdout


def test_our_own_junit_is_counted_too(colcon_with_rospkg: Shell, tmp_path: Path) -> None:
    files = Example(bad={}, good={}).bad_files()
    files["package.xml"] = files["package.xml"].replace("Apache-2.0", "TODO")
    for path, text in files.items():
        (tmp_path / "my_pkg" / path).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / "my_pkg" / path).write_text(text)
    report = tmp_path / "build" / "my_pkg" / "rospkg.xml"
    shell = colcon_with_rospkg
    shell.run("python", "-m", "rospkg_cli", "lint", "my_pkg", "--output", f"junit:{report}", cwd=tmp_path)
    counted = shell.run("colcon", "test-result", "--all", cwd=tmp_path)
    assert "Summary: 1 test, 0 errors, 1 failure, 0 skipped" in counted.stdout
