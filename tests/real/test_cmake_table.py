"""The install table of packages that CMake builds against what Debian's colcon and ament really install."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from cmake_packages import MANIFEST, PACKAGES
from shell import Shell
from test_install_table import COLCONS_OWN, inspected

pytestmark = [pytest.mark.debian, pytest.mark.network]

PYTHON = re.compile(r"(?:local/)?lib/python3(?:\.\d+)?/(?:site|dist)-packages/")
AMENTS_OWN = re.compile(
    r"share/ament_index/.*|share/[^/]+/(?:local_setup\..*|environment/.*)|share/[^/]+/cmake/"
    r"(?:[^/]+Config(?:-version)?|ament_cmake_export_\w+-extras|[^/]+Export(?:-\w+)?)\.cmake"
)
"""Files that ament adds to whatever a package installs."""


def installed(prefix: Path) -> set[str]:
    """Return what stands below a prefix, in the terms of `rospkg inspect`."""
    files = {path.relative_to(prefix).as_posix() for path in prefix.rglob("*") if not path.is_dir()}
    own = {path for path in files if COLCONS_OWN.fullmatch(path) or AMENTS_OWN.fullmatch(path)}
    return {PYTHON.sub("lib/python3.*/site-packages/", path) for path in files - own}


def test_the_table_is_what_ament_installs(debian_colcon: Shell, tmp_path: Path) -> None:
    for name, files in PACKAGES.items():
        for path, text in {"package.xml": MANIFEST.format(name=name), **files}.items():
            file = tmp_path / "src" / name / path
            file.parent.mkdir(parents=True, exist_ok=True)
            file.write_text(text)
            file.chmod(0o755 if text.startswith("#!") else 0o644)
    expected = inspected(debian_colcon, tmp_path)
    built = debian_colcon.run("colcon", "build", "--executor", "sequential", cwd=tmp_path)
    assert built.returncode == 0, built.stderr
    assert set(expected) == set(PACKAGES)
    assert {name: installed(tmp_path / "install" / name) for name in expected} == expected
