"""Which process reads which packages: the largest first, each to the process that has the least."""

from __future__ import annotations

from collections.abc import Iterable, Mapping, Sequence

READ = (
    ".py .c .cpp .cc .cxx .h .hh .hpp .hxx .ipp .tpp .xml .launch .urdf .xacro .yaml .yml .cmake .txt .msg .srv .action"
).split()
"""Endings of files that are read; how many a package has of them says well enough how long it takes."""


def parts_of(folders: Sequence[str], files: Iterable[str], jobs: int) -> list[tuple[str, ...]]:
    """Return the packages of each process, in their order; at most as many processes as packages."""
    sizes = sizes_of(folders, files)
    parts: list[list[str]] = [[] for _ in range(min(jobs, len(folders)))]
    loads = [0] * len(parts)
    for folder in sorted(folders, key=lambda each: -sizes[each]):
        least = loads.index(min(loads))
        parts[least].append(folder)
        loads[least] += sizes[folder] + 1
    order = {folder: number for number, folder in enumerate(folders)}
    return [tuple(sorted(part, key=order.__getitem__)) for part in parts]


def sizes_of(folders: Sequence[str], files: Iterable[str]) -> Mapping[str, int]:
    """Return how many files that are read lie in each package, and not in one below it."""
    sizes = dict.fromkeys(folders, 0)
    for path in files:
        if path.endswith(tuple(READ)):
            folder = path.rpartition("/")[0]
            while folder and folder not in sizes:
                folder = folder.rpartition("/")[0]
            if folder in sizes:
                sizes[folder] += 1
    return sizes
