"""What lies in working trees and in no export of git: to be put into each folder of a package."""

from __future__ import annotations

import os
import socket
import tempfile
from collections.abc import Callable
from contextlib import closing
from pathlib import Path


def put_empty_folder(folder: Path) -> None:
    (folder / "empty_folder").mkdir()


def put_dead_link(folder: Path) -> None:
    (folder / "dead_link").symlink_to("nothing/there")


def put_folder_link(folder: Path) -> None:
    (folder / "folder_link").symlink_to(tempfile.gettempdir())


def put_circle(folder: Path) -> None:
    (folder / "circle").symlink_to("circle")
    (folder / "up_link").symlink_to("..")


def put_fifo(folder: Path) -> None:
    os.mkfifo(folder / "fifo")


def put_socket(folder: Path) -> None:
    before = Path.cwd()
    os.chdir(folder)  # its address is at most 108 bytes long
    try:
        with closing(socket.socket(socket.AF_UNIX)) as made:
            made.bind("socket")
    finally:
        os.chdir(before)


def put_editor_files(folder: Path) -> None:
    (folder / ".setup.py.swp").write_bytes(b"b0VIM 9.0\0\xff\xfe")
    (folder / ".#setup.py").symlink_to("ada@laptop.4711:1763800000")
    (folder / "setup.py~").write_text("def half(:")
    (folder / "#setup.py#").write_text("def half(:")
    (folder / "._setup.py").write_bytes(b"\0\5\x16\7\0\2\0\0Mac OS X\xff")
    (folder / ".DS_Store").write_bytes(b"\0\0\0\1Bud1\xff")


def put_tool_leavings(folder: Path) -> None:
    for name in (".pytest_cache/v/cache", "__pycache__", "node_modules/flatted/python", ".venv/lib", "env/lib"):
        (folder / name).mkdir(parents=True)
    (folder / "env/pyvenv.cfg").write_text("home = /usr/bin\n")
    (folder / "env/lib/broken.py").write_text("def half(:")
    (folder / "node_modules/flatted/python/flatted.py").write_text("import numpy, def")
    (folder / "__pycache__/x.cpython-311.pyc").write_bytes(b"\xa7\r\r\n\xff")


def put_odd_names(folder: Path) -> None:
    for name in (b"caf\xe9", b"new\nline", b"esc\x1b[31m", b"quote'\"", b" blank ", b"-dash", b"\xff\xfe.dat"):
        (folder / os.fsdecode(name)).write_text("text\n")


PUT: dict[str, Callable[[Path], None]] = {
    name.removeprefix("put_"): value for name, value in vars().copy().items() if name.startswith("put_")
}


def folders_of(package: Path) -> list[Path]:
    """Return the package's folder and every folder in it, as they are now."""
    return [package, *sorted(path for path in package.rglob("*") if path.is_dir() and not path.is_symlink())]
