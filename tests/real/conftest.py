"""The real tools, in an environment of the tests' own making.

What pip must fetch is fetched once into a cache (see `venvs`). Where that or a Debian package is missing, the tests
that need it skip and say why; under CI=true or ROSPKG_REAL=1 such a skip is a failure.
"""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from collections.abc import Callable
from functools import cache
from pathlib import Path

import pytest
from absent import absent
from shell import Shell
from venvs import COLCON, SETUPTOOLS, NoIndexError, setuptools_for_this_python, venv

DEBIAN_PYTHON = "/usr/bin/python3"
DEBIAN_MODULES = "/usr/lib/python3/dist-packages"
DEBIAN_PACKAGES = Path(__file__).parents[2] / ".ci" / "debian-packages.txt"

PASSED_ON = ("LANG", "LC_ALL", "TMPDIR", "TZ", "TERM", "SSL_CERT_FILE", "REQUESTS_CA_BUNDLE")
PASSED_ON_PREFIXES = ("PIP_", "HTTP_PROXY", "HTTPS_PROXY", "NO_PROXY", "http_proxy", "https_proxy", "no_proxy")


def pytest_runtest_setup(item: pytest.Item) -> None:
    if item.get_closest_marker("debian") and (missing := missing_debian_packages()):
        absent(missing)


@cache
def missing_debian_packages() -> str:
    """Return a sentence that names the packages of the list that aren't installed; "" where all are."""
    wanted = DEBIAN_PACKAGES.read_text().split()
    if not shutil.which("dpkg-query"):
        return "needs Debian's ament packages, and this is no Debian"
    query = ["dpkg-query", "-W", "-f", "${db:Status-Status} ${Package}\n", *wanted]
    found = subprocess.run(query, capture_output=True, text=True, check=False).stdout.splitlines()
    missing = sorted(set(wanted) - {line.partition(" ")[2] for line in found if line.startswith("installed ")})
    return f"needs the Debian packages {', '.join(missing)} (see .ci/debian-packages.txt)" if missing else ""


@pytest.fixture(scope="session")
def mypy_cache(tmp_path_factory: pytest.TempPathFactory) -> Path:
    return tmp_path_factory.mktemp("mypy-cache")


@pytest.fixture(scope="session")
def compiler_cache(tmp_path_factory: pytest.TempPathFactory) -> dict[str, str]:
    """What lets CMake compile the same text once in a session, if ccache is there: gtest is in every package."""
    if not shutil.which("ccache"):
        return {}
    base = tmp_path_factory.getbasetemp()
    folder = (base.parent if os.environ.get("PYTEST_XDIST_WORKER") else base) / "ccache"
    launcher = {f"CMAKE_{language}_COMPILER_LAUNCHER": "ccache" for language in ("C", "CXX")}
    return {**launcher, "CCACHE_DIR": str(folder)}


@pytest.fixture
def shell(tmp_path: Path, mypy_cache: Path, compiler_cache: dict[str, str]) -> Shell:
    """A shell with a home and a git identity of its own; without PYTHON*, ROS_*, AMENT_*, COLCON_* and GIT_*."""
    home = tmp_path / "home"
    home.mkdir()
    (home / ".gitconfig").write_text("[user]\n\tname = Ada Lovelace\n\temail = ada@example.org\n")
    kept = {n: v for n, v in os.environ.items() if n in PASSED_ON or n.startswith(PASSED_ON_PREFIXES)}
    git = str(Path(shutil.which("git") or "/usr/bin/git").parent)
    folders = dict.fromkeys(("/usr/local/bin", "/usr/bin", "/bin", git))
    own = {"HOME": str(home), "GIT_CONFIG_NOSYSTEM": "1", "MYPY_CACHE_DIR": str(mypy_cache), **compiler_cache}
    return Shell({**kept, **own, "PATH": os.pathsep.join(folders)})


def tools(make: Callable[[], Path]) -> Path:
    """Return the folder of programs of an environment, or skip."""
    try:
        return make() / "bin"
    except NoIndexError as error:
        absent(str(error))


@pytest.fixture(scope="session", params=setuptools_for_this_python(), ids=lambda version: f"setuptools-{version}")
def each_colcon(request: pytest.FixtureRequest) -> Path:
    """The programs of colcon with each setuptools of the list in turn."""
    return tools(lambda: venv(sys.executable, (f"setuptools=={request.param}", *COLCON)))


@pytest.fixture(scope="session")
def newest_colcon() -> Path:
    """The programs of colcon with the last setuptools that it allows."""
    return tools(lambda: venv(sys.executable, (f"setuptools=={SETUPTOOLS[-1]}", *COLCON)))


@pytest.fixture
def colcon(shell: Shell, each_colcon: Path) -> Shell:
    """A shell in which `colcon` runs with each setuptools of the list in turn; `python` holds catkin_pkg and pytest."""
    return shell.before(each_colcon)


@pytest.fixture
def one_colcon(shell: Shell, newest_colcon: Path) -> Shell:
    """As `colcon`, once."""
    return shell.before(newest_colcon)


@pytest.fixture(scope="session")
def debian_colcon_programs() -> Path:
    return tools(lambda: venv(DEBIAN_PYTHON, ("setuptools==65.5.1", *COLCON), DEBIAN_MODULES))


@pytest.fixture
def debian_colcon(shell: Shell, debian_colcon_programs: Path) -> Shell:
    """A shell in which colcon finds Debian's ament linters and ament_cmake; for tests marked `debian`.

    Its Python is Debian's own, with the modules of Debian behind those that are installed beside colcon.
    """
    return shell.before(debian_colcon_programs)
