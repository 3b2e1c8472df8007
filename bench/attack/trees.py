"""Odd things in the working tree of a package: what no repository shows, and every disk has."""

from __future__ import annotations

import os
import random
import shutil
import socket
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path

SECRET = "CANARY-bMq7x-do-not-show"
"""Stands in the files outside of the package; no output may hold it."""

OUTSIDE = {
    "secret.xml": f"{SECRET}\n<package><name>{SECRET}</name></package>\n",
    "package.xml": f'<?xml version="1.0"?>\n<package format="3">\n  <name>{SECRET}</name>\n</package>\n',
    "secret.py": f"def main(: # {SECRET}\n",
    "secret.yaml": f"{SECRET}: [\n",
    "folder/secret.msg": f"{SECRET} x y z\n",
    "folder/CMakeLists.txt": f"{SECRET}(\n",
}
NAMES = (
    "include",
    "src",
    "a.b",
    "launch",
    "msg",
    "resource",
    "no_dot",
    "x.py",
    "x.launch.py",
    "a.msg",
    "b.yaml",
    "c.urdf",
)
ODD_NAMES = (
    b"\xff.py",
    b"a\nb.py",
    b"a\n::error::owned.py",
    b"\x1b[31m.launch.py",
    b"a b.yaml",
    b"`a`|<b>.xml",
    "\u202egnp.py".encode(),
    b"-rf",
    b"*.py",
    b"%0A.msg",
    b"a\\b.py",
    b"\xe9\x80.msg",
    b"a" * 250 + b".py",
    b"Setup.py",
    b"PACKAGE.XML",
    b".package.xml.swp",
)


def folder_in(package: Path, chance: random.Random) -> Path:
    """Return one of the folders of a package, itself among them."""
    folders = sorted(each for each in package.rglob("*") if each.is_dir() and not each.is_symlink())
    return chance.choice([package, *folders])


def free(package: Path, chance: random.Random) -> Path:
    """Return a path in a package where nothing is."""
    folder = folder_in(package, chance)
    left = [folder / name for name in NAMES if not os.path.lexists(folder / name)]
    return chance.choice(left) if left else folder / f"more_{chance.randrange(10**6)}"


def file_in(package: Path, chance: random.Random) -> Path | None:
    files = sorted(each for each in package.rglob("*") if each.is_file() and not each.is_symlink())
    return chance.choice(files) if files else None


def add_empty_folder(package: Path, chance: random.Random) -> None:
    (free(package, chance) / chance.choice((".", "a/b"))).mkdir(parents=True)


def add_dead_link(package: Path, chance: random.Random) -> None:
    free(package, chance).symlink_to("nowhere")


def add_link_to_folder(package: Path, chance: random.Random) -> None:
    at = free(package, chance)
    at.symlink_to(os.path.relpath(folder_in(package, chance), at.parent))


def add_link_out(package: Path, chance: random.Random) -> None:
    at = free(package, chance)
    at.symlink_to(
        os.path.relpath(package.parent.parent / "outside" / chance.choice((".", *OUTSIDE, "folder")), at.parent)
    )


def link_file_out(package: Path, chance: random.Random) -> None:
    """Put a link to a file outside where a file of the package was."""
    at = file_in(package, chance)
    if at is not None:
        at.unlink()
        at.symlink_to(os.path.relpath(package.parent.parent / "outside" / chance.choice(tuple(OUTSIDE)), at.parent))


def add_link_circle(package: Path, chance: random.Random) -> None:
    at = free(package, chance)
    at.symlink_to(chance.choice((at.name, ".", "..")))


def add_fifo(package: Path, chance: random.Random) -> None:
    os.mkfifo(free(package, chance))


def add_socket(package: Path, chance: random.Random) -> None:
    at = free(package, chance)
    with socket.socket(socket.AF_UNIX) as made:
        here = os.open(at.parent, os.O_RDONLY)
        try:
            made.bind(f"/proc/self/fd/{here}/{at.name}")  # the path of a socket may have 107 bytes only
        finally:
            os.close(here)


def make_folder_of_file(package: Path, chance: random.Random) -> None:
    at = file_in(package, chance)
    if at is not None:
        at.unlink()
        at.mkdir()


def make_fifo_of_file(package: Path, chance: random.Random) -> None:
    at = file_in(package, chance)
    if at is not None:
        at.unlink()
        os.mkfifo(at)


def add_odd_name(package: Path, chance: random.Random) -> None:
    """Copy a file of the package to a name that is hard to show, or to read."""
    source, name = file_in(package, chance), chance.choice(ODD_NAMES)
    target = folder_in(package, chance) / os.fsdecode(name)
    if source is not None and not os.path.lexists(target):
        shutil.copyfile(source, target)


def add_deep_folder(package: Path, chance: random.Random) -> None:
    at = free(package, chance)
    deep = at.joinpath(*"a" * chance.choice((40, 150, 400)))
    deep.mkdir(parents=True)
    (deep / "x.py").write_text("import nothing\n")


def add_built(package: Path, chance: random.Random) -> None:
    """Add what builds, editors and virtual environments leave."""
    for name in ("build", "install", "log", ".venv/lib", "node_modules/a", "__pycache__", ".pytest_cache"):
        folder = package / name
        if chance.randrange(2) and not os.path.lexists(package / name.partition("/")[0]):
            folder.mkdir(parents=True)
            with suppress(shutil.Error, OSError):  # of what is no file there, no copy
                shutil.copytree(package / "launch", folder / "launch")
            (folder / "setup.py").write_text("def broken(:\n")


def drop_file(package: Path, chance: random.Random) -> None:
    at = file_in(package, chance)
    if at is not None:
        at.unlink()


ODDITIES: tuple[Callable[[Path, random.Random], None], ...] = (
    add_empty_folder,
    add_dead_link,
    add_link_to_folder,
    add_link_out,
    link_file_out,
    add_link_circle,
    add_fifo,
    add_socket,
    make_folder_of_file,
    make_fifo_of_file,
    add_odd_name,
    add_odd_name,
    add_deep_folder,
    add_built,
    drop_file,
)
