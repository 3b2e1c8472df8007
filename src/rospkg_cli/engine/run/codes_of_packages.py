"""Which rules run on which package where configs differ: all run, and what was not asked for there is dropped."""

from __future__ import annotations

from collections.abc import Collection, Mapping


def enclosing_folder(path: str, folders: Collection[str]) -> str | None:
    """Return the innermost of some packages' folders that is a path of the run or holds it; None for none."""
    while path not in folders:
        if not path:
            return None
        path = path.rpartition("/")[0]
    return path


class CodesOfPackages:
    """Answers which rules run on the package around a path. Paths and folders are relative to the root of the run."""

    def __init__(self, codes: frozenset[str], special: Mapping[str, frozenset[str]]) -> None:
        self.codes = codes
        """Of what is in no package, and of every package that is not special."""
        self.special = special
        """By folder."""
        self.folders = frozenset(special)

    def at(self, path: str) -> frozenset[str]:
        """Return the codes of the rules that run on the package around a path."""
        folder = enclosing_folder(path, self.folders) if self.special else None
        return self.codes if folder is None else self.special[folder]
