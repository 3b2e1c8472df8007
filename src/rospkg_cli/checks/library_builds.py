"""Rule input: whether pages and scripts of a repository build or import a package that no package here uses."""

from __future__ import annotations

import posixpath
from collections.abc import Iterator

from ..files import PackageFiles
from ..light_dataclasses import dataclass
from ..tree import READABLE
from .workspace.wanted_packages import BUILDS, WantedPackages

IMPORTS = r"(?m)\bfrom[ \t]+{0}[\w.]*[ \t]+import\b|^[ \t>]*import[ \t]+{0}\b"
SCRIPTS = "scripts"
"""The folder of programs next to packages."""


@dataclass(frozen=True)
class LibraryBuilds:
    wanted: WantedPackages

    def has(self, name: str) -> bool:
        """Return whether a page builds a package by its name, or a page or a script next to packages imports it."""
        in_pages, scripts = self.wanted.is_commanded, tuple(scripts_above(self.wanted.files))
        return in_pages(BUILDS, name) or in_pages(IMPORTS, name) or self.wanted.is_in(IMPORTS, name, scripts)


def scripts_above(files: PackageFiles) -> Iterator[str]:
    """Yield the text of each Python file in a folder `scripts` next to a package or above it."""
    if files.whole is None:
        return
    whole, above = PackageFiles(files.whole), files.folder
    while above:
        above = posixpath.dirname(above)
        place = posixpath.join(above, SCRIPTS)
        for path, kind in files.whole.sub(place).files().items():
            if kind in READABLE and path.endswith(".py"):
                yield whole.readable_text(f"{place}/{path}")
