"""Installed from a wheel, editable, and from an sdist: schemas and templates are found, from any folder."""

from __future__ import annotations

import sys
import sysconfig
from pathlib import Path

import pytest
from checkout import copy_checkout
from shell import Shell

WAYS = ("wheel", "editable", "sdist")
ASK = """\
from rospkg_cli.resources import resources
for kind, wanted in (("schemas", "package_format3.xsd"), ("templates", "ament_python/template.toml")):
    assert (resources(kind) / wanted).is_file(), resources(kind)
print(resources("schemas"))
"""


@pytest.fixture
def python(tmp_path: Path, shell: Shell) -> Path:
    """An interpreter of its own that borrows the libraries of this one, and not rospkg."""
    made = shell.run(sys.executable, "-m", "venv", "--without-pip", tmp_path / "venv", cwd=tmp_path)
    assert made.returncode == 0, made.stderr
    site = next((tmp_path / "venv" / "lib").glob("python3*")) / "site-packages"
    (site / "libraries.pth").write_text(f"import sys; sys.path.append({sysconfig.get_path('purelib')!r})\n")
    return tmp_path / "venv" / "bin" / "python"


def install(way: str, checkout: Path, python: Path, shell: Shell) -> None:
    """Install without an index: build backend and libraries are those of this interpreter."""
    source = [str(checkout)]
    if way == "editable":
        source = ["--editable", *source]
    if way == "sdist":
        built = shell.run(sys.executable, "-m", "build", "--sdist", "--no-isolation", checkout, cwd=checkout)
        assert built.returncode == 0, built.stdout + built.stderr
        source = [str(next((checkout / "dist").glob("*.tar.gz")))]
    pip = [
        sys.executable,
        "-m",
        "pip",
        "--python",
        python,
        "install",
        "--no-deps",
        "--no-build-isolation",
        "--no-index",
    ]
    done = shell.run(*pip, *source, cwd=checkout.parent)
    assert done.returncode == 0, done.stdout + done.stderr


@pytest.mark.parametrize("way", WAYS)
def test_it_works_from_another_folder(way: str, tmp_path: Path, python: Path, shell: Shell) -> None:
    checkout = copy_checkout(tmp_path / "checkout")
    install(way, checkout, python, shell)
    elsewhere = tmp_path / "elsewhere"
    elsewhere.mkdir()
    asked = shell.run(python, "-c", ASK, cwd=elsewhere)
    assert asked.returncode == 0, asked.stderr
    assert ("checkout" in asked.stdout) == (way == "editable")
    rospkg = python.with_name("rospkg")
    made = shell.run(rospkg, "new", "my_robot_nav", cwd=elsewhere)
    assert made.returncode == 0, made.stdout + made.stderr
    assert (elsewhere / "my_robot_nav" / "setup.py").is_file()
    linted = shell.run(rospkg, "lint", "--pedantic", "--release", "my_robot_nav", cwd=elsewhere)
    assert linted.returncode == 0, linted.stdout + linted.stderr
    assert shell.run(rospkg, "--version", cwd=elsewhere).stdout.startswith("rospkg ")
