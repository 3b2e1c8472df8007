"""Paths that Python joins to one that begins at the root (LCH021)."""

from __future__ import annotations

import pytest

from rospkg_cli.example import manifest
from rospkg_cli.testing import lint_files

HEAD = """\
import os
from glob import glob
from pathlib import Path

from ament_index_python.packages import get_package_share_directory
from launch.substitutions import PathJoinSubstitution, TextSubstitution

share = get_package_share_directory('my_pkg')
"""


def said(line: str, path: str = "launch/a.launch.py") -> list[str]:
    files = {"src/my_pkg/package.xml": manifest(""), f"src/my_pkg/{path}": f"{HEAD}\n\nfound = {line}\n"}
    return [f"{each.severity.value}: {each.message}" for each in lint_files(files, ["LCH021"]).findings]


@pytest.mark.parametrize(
    "line",
    [
        "os.path.join(share, '/config/a.yaml')",
        "os.path.join(share, 'config', '/config/a.yaml')",
        "os.path.join(share, '/config/a.yaml' + name)",
        "os.path.join(share, f'/config/a.yaml{name}')",
        "Path(share, '/config/a.yaml')",
        "Path(share) / 'config' / '/config/a.yaml'",
        "Path(share).joinpath('/config/a.yaml')",
        "PathJoinSubstitution([share, '/config/a.yaml'])",
        "PathJoinSubstitution([share, ['/config/a.yaml', name]])",
        "PathJoinSubstitution([share, TextSubstitution(text='/config/a.yaml')])",
    ],
)
def test_a_path_that_begins_with_a_slash(line: str) -> None:
    (text,) = said(line)
    assert text.startswith("warning: `/config/a.yaml` begins with a slash")
    assert text.endswith("; write `config/a.yaml`")


@pytest.mark.parametrize(
    "line",
    [
        "os.path.join(share, 'config/a.yaml')",
        "os.path.join('/config', 'a.yaml')",
        "os.path.join('/', '/config/a.yaml')",
        "os.path.join('/config', '/config/a.yaml')",
        "os.path.join(*parts, '/config/a.yaml')",
        "share + '/config/a.yaml'",
        "', '.join(['a', '/config'])",
        "Path('/config/a.yaml')",
        "4 / 2",
    ],
)
def test_nothing_is_dropped(line: str) -> None:
    assert said(line) == []


def test_a_path_of_the_system_is_an_info() -> None:
    (text,) = said("os.path.join(share, '/tmp/a.yaml')")
    assert text.startswith("info: ")


@pytest.mark.parametrize("line, count", [("glob(os.path.join('a', '/*.yaml'))", 1), ("os.path.join('a', '/b')", 0)])
def test_setup_py(line: str, count: int) -> None:
    assert len(said(line, "setup.py")) == count
