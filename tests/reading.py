"""Read one package of plain texts."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TypeVar

from rospkg_cli.files import PackageFiles
from rospkg_cli.package.package import Package
from rospkg_cli.tree import MemoryTree, TreeEntry

T = TypeVar("T")


def package(files: Mapping[str, str | bytes | TreeEntry]) -> Package:
    return Package(PackageFiles(MemoryTree.of(files)))


def one(files: Mapping[str, str | bytes | TreeEntry], kind: type[T]) -> T:
    """Return the one model of a kind; fails where it is absent or can't be read."""
    parts = package(files).parts(kind)
    assert not parts.broken, parts.broken
    (found,) = parts.good
    return found
