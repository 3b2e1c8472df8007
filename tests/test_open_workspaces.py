"""Which workspace of an editor a file belongs to, and which changes on disk concern it."""

from __future__ import annotations

from pathlib import Path

import pytest

from rospkg_cli.cli.server.open_text import OpenText
from rospkg_cli.cli.server.open_workspaces import OpenWorkspaces

TEXT = OpenText("file:///x", 1, b"<package/>")


def opened(*folders: Path) -> OpenWorkspaces:
    found = OpenWorkspaces()
    for folder in folders:
        found.open(folder)
    return found


@pytest.mark.parametrize(
    "path, counts",
    [
        ("src/my_pkg/package.xml", True),
        ("src/my_pkg/log/talker.py", True),
        ("src/my_pkg/build/x", True),
        ("build/my_pkg/Makefile", False),
        ("install/my_pkg/share/my_pkg/package.xml", False),
        ("src/.git/index", False),
        ("src/.git", True),
        ("src/.gitignore", True),
    ],
)
def test_what_git_and_colcon_write_changes_nothing(tmp_path: Path, path: str, counts: bool) -> None:
    for tree in ("build", "install"):
        (tmp_path / tree).mkdir()
        (tmp_path / tree / "COLCON_IGNORE").touch()
    workspaces = opened(tmp_path)
    workspaces.touch(tmp_path / path)
    [live] = workspaces
    assert live.changed == ({tmp_path / path} if counts else set())
    assert live.world.written.empty() is not counts


def test_the_innermost_shows_and_all_around_see(tmp_path: Path) -> None:
    path = tmp_path / "src/my_pkg/package.xml"
    workspaces = opened(tmp_path, tmp_path / "src")
    outer, inner = workspaces
    workspaces.put(path, TEXT)
    assert workspaces.at(path) is inner
    assert (outer.texts, inner.texts) == ({path: TEXT}, {path: TEXT})
    assert (workspaces.shows(outer, path), workspaces.shows(inner, path)) == (False, True)


def test_what_lies_in_no_folder_is_shown_and_opens_none(tmp_path: Path) -> None:
    (tmp_path / "other").mkdir()
    (tmp_path / "other/package.xml").touch()
    workspaces = opened(tmp_path / "my_pkg")
    [live] = workspaces
    assert workspaces.shows(live, tmp_path / "other/package.xml")
    assert list(workspaces) == [live]


def test_open_files_move_with_the_folders(tmp_path: Path) -> None:
    path = tmp_path / "src/my_pkg/package.xml"
    workspaces = opened(tmp_path)
    workspaces.put(path, TEXT)
    workspaces.open(tmp_path / "src")
    outer, inner = workspaces
    assert inner.texts == {path: TEXT}
    outer.changed.clear()
    workspaces.close(tmp_path / "src")
    assert list(workspaces) == [outer]
    assert outer.changed == {path}
