"""Whether anything starts or imports a Python file of a package, by a search in texts: it can't be read itself."""

from __future__ import annotations

import re
from collections.abc import Iterator
from functools import cached_property

from ...files import PackageFiles
from ...light_dataclasses import dataclass
from ...package.file_role import role_of
from ...package.launch.live_text import live_text
from ..paths.home_path_texts import without_comments

NAMING = (".py", ".cfg", ".toml", ".txt", ".cmake", ".xml", ".launch", ".yaml", ".yml", ".json", ".sh")
"""Files that may start or import a module; pages only describe it."""
BINDING = (".py", ".cfg", ".toml")


@dataclass(frozen=True)
class StartedTexts:
    files: PackageFiles

    def named(self, path: str, others: Iterator[str]) -> Iterator[str]:
        """Yield those of some files that name a Python file or its module."""
        stem = re.escape(path.rpartition("/")[2].partition(".")[0])
        word = re.compile(rf"(?<![\w.-]){stem}(?!\w)|\.{stem}\b")
        # where names are bound, those of variables and of entry points may be the same word
        is_entry = re.search(rf"\b{stem}\s*=", self.files.readable_text("setup.py")) is not None
        quoted = "" if is_entry else rf"|[\"']{stem}[\"']"
        module = re.compile(rf"\.{stem}\b|\b{stem}\.py\b{quoted}|\b(?:import|from)\b[^\n]*\b{stem}\b")
        for each in others:
            named = module if each.endswith(BINDING) else word
            if each != path and named.search(self.code(each)) and not self.is_of_another_folder(path, each):
                yield each

    def is_of_another_folder(self, path: str, setup: str) -> bool:
        """Return whether setup.py or setup.cfg has the name of a module as that of another package: `my_pkg.talker` is
        no `tools/talker.py`."""
        folder, _, name = path.rpartition("/")
        text = self.code(setup) if setup in ("setup.py", "setup.cfg") else ""
        if not folder or not text or "package_dir" in text:
            return False
        word = rf"(?<![\w-]){re.escape(name.partition('.')[0])}(?![\w-]|\s*=)"
        before = [text[: found.start()] for found in re.finditer(word, text)]
        dotted = [re.search(r"(\w+)\.\Z", each) for each in before]
        return bool(dotted) and all(each is not None and each[1] != folder.rpartition("/")[2] for each in dotted)

    def code(self, path: str) -> str:
        """Return a text without what is said in it: comments, and strings of Python that stand alone."""
        is_plain = path.endswith(".py") and role_of(path) != "launch"
        text = self.files.readable_text(path) if is_plain else ""
        return without_comments(path, text) if is_plain else live_text(self.files, path)

    def is_named(self, path: str) -> bool:
        """Return whether another file names a Python file."""
        return any(self.named(path, iter(self.texts)))

    def is_reached(self, path: str) -> bool:
        """Return whether a file that is no module names one, or a module does that one of these names, and so on.

        What a rule of CMake installs with its folder may be started by its name.
        """
        found, waiting = {path}, [path]
        while waiting:
            one = waiting.pop()
            if self.is_installed_with_its_folder(one):
                return True
            for other in self.named(one, iter(self.texts)):
                if not is_module(other):
                    return True
                waiting += [other] if other not in found else []
                found.add(other)
        return False

    def is_installed_with_its_folder(self, path: str) -> bool:
        """Return whether a rule of CMake installs all that is in a file's folder, or all that a glob finds there."""
        place = rf"(?:(?<![\w./-])|\}}/){re.escape(path.rpartition('/')[0])}(?:/(?:\*[\w.*]*)?)?(?![\w./-])"
        rule = rf"\b(?:DIRECTORY|GLOB|GLOB_RECURSE)\b[^()]*{place}"
        return "/" in path and re.search(rule, self.files.readable_text("CMakeLists.txt")) is not None

    @cached_property
    def texts(self) -> tuple[str, ...]:
        paths = (path for path in self.files.paths if path.endswith(NAMING))
        return tuple(path for path in paths if role_of(path) != "test")


def is_module(path: str) -> bool:
    """Return whether a file is Python that something else starts or imports, and no setup.py or launch file."""
    return path.endswith(".py") and path != "setup.py" and role_of(path) != "launch"
