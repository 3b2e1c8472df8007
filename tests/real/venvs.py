"""Virtual environments with real tools, made once through pip and kept in a cache folder.

The folder is `$ROSPKG_TEST_CACHE`, else `rospkg-tests` in the user's cache.  Several processes may ask for the same
environment at once: the first makes it under a file lock, the others wait.
"""

from __future__ import annotations

import fcntl
import hashlib
import os
import shutil
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

SETUPTOOLS = ("59.6.0", "65.5.1", "68.1.2", "78.1.1", "79.0.1")
"""What colcon is tried with: Ubuntu 22.04's, the first with pyproject's editable installs, 24.04's, 26.04's, and the
last that colcon-core allows."""

COLCON = (
    "colcon-core==0.21.3",
    "colcon-cmake",
    "colcon-library-path",
    "colcon-output",
    "colcon-package-selection",
    "colcon-pkg-config",
    "colcon-python-setup-py",
    "colcon-recursive-crawl",
    "colcon-ros",
    "colcon-test-result",
    "catkin_pkg",
    "empy<4",
    "mypy",
    "pytest<9",
    "pyyaml",
)
"""colcon with the extensions that find, build and test ROS packages, and what their tests run on."""


class NoIndexError(Exception):
    """Nothing could be installed: no package index answers, or it lacks what was asked for."""


def setuptools_for_this_python() -> tuple[str, ...]:
    """Return the setuptools that run on this interpreter; 59.6 needs `distutils`, which Python 3.12 took away."""
    return SETUPTOOLS[1:] if sys.version_info >= (3, 12) else SETUPTOOLS


USERS_CACHE = os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache"
"""Read before a test takes the user's cache away."""


def cache_folder() -> Path:
    return Path(os.environ.get("ROSPKG_TEST_CACHE") or Path(USERS_CACHE, "rospkg-tests"))


def venv(python: str, requirements: tuple[str, ...], folder_on_path: str = "") -> Path:
    """Return an environment that holds the requirements; raises NoIndexError.

    `folder_on_path` is appended to its `sys.path`, behind everything that is installed in it.
    """
    version = subprocess.check_output([python, "-c", "import sys; print(sys.version)"], text=True)
    recipe = "\n".join((version, *requirements, folder_on_path))
    folder = cache_folder() / f"venv-{hashlib.sha256(recipe.encode()).hexdigest()[:16]}"
    with locked(folder.with_suffix(".lock")):
        finished = folder / "recipe.txt"
        if not finished.exists():
            shutil.rmtree(folder, ignore_errors=True)
            make(python, folder, requirements, folder_on_path)
            finished.write_text(recipe)
    return folder


def make(python: str, folder: Path, requirements: tuple[str, ...], folder_on_path: str) -> None:
    outer = {name: value for name, value in os.environ.items() if not name.startswith("PYTHON")}
    pip = [str(folder / "bin" / "python"), "-m", "pip", "install", "--quiet", "--disable-pip-version-check"]
    try:
        subprocess.run([python, "-m", "venv", str(folder)], env=outer, check=True, capture_output=True, text=True)
        subprocess.run([*pip, *requirements], env=outer, check=True, capture_output=True, text=True)
    except subprocess.CalledProcessError as error:
        said = (error.stderr or error.stdout).strip().splitlines() or [str(error)]
        raise NoIndexError(f"pip could not install {', '.join(requirements[:2])} …: {said[-1]}") from None
    if folder_on_path:
        site = next((folder / "lib").glob("python3*")) / "site-packages"
        (site / "also_on_path.pth").write_text(folder_on_path + "\n")


@contextmanager
def locked(path: Path) -> Iterator[None]:
    path.parent.mkdir(parents=True, exist_ok=True)
    with path.open("w") as file:
        fcntl.flock(file, fcntl.LOCK_EX)
        yield
