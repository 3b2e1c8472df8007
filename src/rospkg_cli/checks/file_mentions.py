"""Rule input: which files of a package have the name of another one, outside of comments."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterator

from ..files import PackageFiles
from ..light_dataclasses import dataclass
from ..package.launch.live_text import live_text
from .how_installed import HowInstalled
from .module_mentions import NAMING, PAGES
from .paths.home_path_texts import CPP, without_comments

BUILDS = ("CMakeLists.txt", ".cmake", "Makefile")


@dataclass(frozen=True)
class FileMentions:
    files: PackageFiles
    how: HowInstalled

    def having(self, word: re.Pattern[str], path: str) -> Iterator[str]:
        """Yield the other files that a pattern for a file matches in; not setup.py where that installs the file."""
        ends, without = (*PAGES, *NAMING, *BUILDS, *CPP), {path, "setup.py"} if path in self.how.installed else {path}
        others = (each for each in self.files.paths if each not in without and each.endswith(ends))
        named = (each for each in others if word.search(self.files.readable_text(each)))
        return (each for each in named if word.search(self.live(each)))

    def live(self, path: str) -> str:
        """Return the text of a file: of a page all of it, of any other file what is left without comments."""
        if path.endswith(CPP):
            return without_comments(path, self.files.readable_text(path))
        return self.files.readable_text(path) if path.endswith(PAGES) else live_text(self.files, path)


def naming(path: str) -> re.Pattern[str]:
    """Return the pattern by which other files name a file: by its name, or where they import it as a module."""
    name = posixpath.basename(path)
    stem = re.escape(name.removesuffix(".py"))
    return re.compile(rf"(?<![\w-]){re.escape(name)}(?!\w)|(?<![\w-])(?:import|from)(?![\w-])[^\n]*(?<!\w){stem}(?!\w)")
