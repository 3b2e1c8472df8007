"""Folders of which a robot names several files, and none is there: they moved, or the package name is wrong."""

from __future__ import annotations

import posixpath
from collections.abc import Iterable

SEVERAL = 3
"""The number of missing files in one folder that shows a single cause."""

File = tuple[str, str]
"""A package, and a path in its share directory."""


def emptied_folders(named: Iterable[File], missing: Iterable[File]) -> frozenset[File]:
    """Return the folders of the missing files, each with its package, where several are named and all are missing."""
    lost = frozenset(missing)
    there = {folder_of(each) for each in named if each not in lost}
    folders = [folder_of(each) for each in lost]
    return frozenset(folder for folder in folders if folders.count(folder) >= SEVERAL and folder not in there)


def folder_of(file: File) -> File:
    return file[0], posixpath.dirname(file[1])
