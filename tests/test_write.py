"""Writing: whole files or none, in their mode, never over somebody else's edit."""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from rospkg_cli.disk import DiskTree
from rospkg_cli.engine.fixing.write import WriteError, write_changes
from rospkg_cli.tree import TreeEntry


def test_content_changes_and_the_mode_stays(tmp_path: Path) -> None:
    script = tmp_path / "run.py"
    script.write_text("old")
    script.chmod(0o750)
    tree = DiskTree(tmp_path)
    old = tree.entry("run.py")
    changes = {"run.py": TreeEntry("file", b"new", old.mode), "resource/x": TreeEntry("file", b"")}
    assert write_changes(tmp_path, tree, changes) == ["resource/x", "run.py"]
    assert script.read_text() == "new"
    assert script.stat().st_mode & 0o777 == 0o750
    assert (tmp_path / "resource/x").read_bytes() == b""
    assert sorted(p.name for p in tmp_path.iterdir()) == ["resource", "run.py"]


def test_a_file_changed_meanwhile_is_left_alone(tmp_path: Path) -> None:
    (tmp_path / "a").write_text("read")
    tree = DiskTree(tmp_path)
    tree.entry("a")
    (tmp_path / "a").write_text("somebody's")
    with pytest.raises(WriteError, match="changed by someone else"):
        write_changes(tmp_path, tree, {"a": TreeEntry("file", b"ours")})
    assert (tmp_path / "a").read_text() == "somebody's"


def test_a_read_only_file_is_said(tmp_path: Path) -> None:
    (tmp_path / "a").write_text("x")
    (tmp_path / "a").chmod(0o444)
    with pytest.raises(WriteError, match="`a` can't be written: the file is read-only; nothing was written"):
        write_changes(tmp_path, DiskTree(tmp_path), {"a": TreeEntry("file", b"y")})
    assert (tmp_path / "a").read_text() == "x"


def test_a_link_stays_a_link(tmp_path: Path) -> None:
    (tmp_path / "real").write_text("x")
    (tmp_path / "link").symlink_to("real")
    write_changes(tmp_path, DiskTree(tmp_path), {"link": TreeEntry("link", b"y")})
    assert (tmp_path / "link").is_symlink()
    assert (tmp_path / "real").read_text() == "y"


def test_deleting(tmp_path: Path) -> None:
    (tmp_path / "a").write_text("x")
    write_changes(tmp_path, DiskTree(tmp_path), {"a": None})
    assert list(tmp_path.iterdir()) == []


@pytest.mark.parametrize("kind", ["fifo", "folder", "dead link"])
def test_what_is_no_file_is_not_replaced_by_one(tmp_path: Path, kind: str) -> None:
    target = tmp_path / "__init__.py"
    {"fifo": os.mkfifo, "folder": Path.mkdir, "dead link": lambda path: path.symlink_to("nowhere")}[kind](target)
    before = target.lstat()
    with pytest.raises(WriteError, match="exists and is not a file; it was not changed"):
        write_changes(tmp_path, DiskTree(tmp_path), {"__init__.py": TreeEntry("file", b"")})
    assert target.lstat().st_mode == before.st_mode
