"""Launch files that nothing installs and nothing starts by their path, so that their faults never show."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterator

from ...files import PackageFiles
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.file_role import role_of
from ...package.launch.live_text import live_text
from ...package.package_facts import PackageFacts
from ..left_files import LeftFiles
from ..repository.container_files import OF_CONTAINER, OF_SCRIPT, OF_WORKFLOW, files_called

UNSTARTED = "nothing installs this file, or starts it by its path"
PROSE = (".md", ".rst")
CMAKE = (".cmake", "CMakeLists.txt")
OF_CODE = regex(r"\.(?:py|xml|launch|service|desktop|cpp)$|(?:^|/)CMakeLists\.txt$|\.cmake$")
STARTS = r"(?:\bros2[\s\"',]+launch|\broslaunch|\blaunch_test|\bpython3?)[\s\"',]+(?:-\S+\s+)*"
"""What starts a launch file, up to its path or its package."""
OWN_FOLDER = regex(r"\b__file__\b|\bThisLaunchFileDir\b|\$\(dirname\)")
"""How code names files in its own folder."""


@dataclass(frozen=True)
class UnstartedLaunchFiles:
    files: PackageFiles
    package: PackageFacts
    left: LeftFiles

    def has(self, path: str) -> bool:
        """Return whether nothing installs a launch file, and nothing in the run starts or includes it by its path."""
        found, waiting = {path}, [path]
        while waiting:
            one = waiting.pop()
            if role_of(one) != "launch" or not self.left.is_uninstalled(one):
                return False
            naming = set(self.naming(one)) - found
            found |= naming
            waiting += naming
        return True

    def naming(self, path: str) -> Iterator[str]:
        """Yield the files that start or include one by its path, of the package, and "" for each of others."""
        name, folder = posixpath.basename(path), "" if self.files.whole is None else self.files.folder
        for whole, each in files_called(self.files, OF_CONTAINER, OF_WORKFLOW, OF_SCRIPT, OF_CODE):
            own = posixpath.relpath(each, folder) if is_below(each, folder) else ""
            if own in (path, "setup.py") or not whole.holds(each, name.encode()):
                continue
            text = whole.readable_text(each) if each.endswith(PROSE) else live_text(whole, each)
            if self.starts(each, text, name, is_own=bool(own)):
                yield own

    def starts(self, path: str, text: str, name: str, *, is_own: bool) -> bool:
        """Return whether a text, of the package or of others, starts or includes a file of a name by its path.

        A command that names the package looks in its share directory, where the file is not.
        """
        text, word = text.replace("\\\n", " "), rf"(?<![\w-]){re.escape(name)}(?!\.?\w)"
        if re.search(rf"{STARTS}[^\s\"',`]*{word}", text):
            return True
        if path.endswith(PROSE):
            return False
        if re.search(rf"(?<![\w.-]){re.escape(self.package.name)}/[^\s\"',]*{word}", text):
            return True
        if OF_CODE.search(path) and not path.endswith(CMAKE) and not OWN_FOLDER.search(text):
            return False
        by_package = rf"{STARTS}[^\s\"',/]+[\s\"',]+{word}"
        return is_own and re.search(word, re.sub(by_package, "", text)) is not None


def is_below(path: str, folder: str) -> bool:
    return not folder or path.startswith(f"{folder}/")
