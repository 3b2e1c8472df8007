"""Whether anything leads to a file by its name: another file, a page or a script, or a package that needs this one."""

from __future__ import annotations

import re
from collections.abc import Iterator
from functools import cached_property

from ..files import PackageFiles
from ..light_dataclasses import dataclass
from ..package.file_role import role_of
from ..package.launch.live_text import live_text
from ..package.package_facts import PackageFacts
from ..package.params.named_yaml import ANY
from ..package.workspace import Workspace
from .opened_elsewhere import CODE
from .pages_and_scripts import pages_and_scripts

YAML = (".yaml", ".yml")
LAUNCHED = (".py", ".xml", ".launch", *YAML)


@dataclass(frozen=True)
class LedTo:
    files: PackageFiles
    package: PackageFacts
    workspace: Workspace

    def has(self, path: str) -> bool:
        """Return whether something leads to a launch file or a YAML file; what installs it does not.

        A package has one launch file to start it, so its only one is led to; a name of YAML may be put together.
        """
        if role_of(path) == "launch" and not path.endswith(YAML) and self.is_only_launch_file(path):
            return True
        name = path.rpartition("/")[2]
        word = re.compile(rf"(?<![\w-]){re.escape(name)}(?!\w)")
        if any(word.search(text) for text in self.texts_but(path)):
            return True
        wanted = {ANY, name.rpartition(".")[0]} if path.endswith(YAML) else set[str]()
        others = (self.package, *self.workspace.needing(self.package.name))
        return any(not wanted.isdisjoint(each.named_yaml) for each in others)

    def is_only_launch_file(self, path: str) -> bool:
        others = (each for each in self.files.paths if each != path and role_of(each) == "launch")
        return not any(each.endswith(LAUNCHED) and not each.rpartition("/")[2].startswith(".") for each in others)

    def texts_but(self, path: str) -> Iterator[str]:
        """Yield all that may name a file: pages, scripts, the code of the package and of those that need it."""
        yield from self.pages
        code = (each for each in self.files.paths if each.endswith(CODE) and each not in (path, "setup.py"))
        yield from (live_text(self.files, each) for each in code)
        whole = self.files.whole
        for other in self.workspace.needing(self.package.name):
            if whole is None:
                return
            theirs = PackageFiles(whole.sub(other.folder), other.folder, whole)
            yield from (live_text(theirs, each) for each in theirs.paths if each.endswith(CODE))

    @cached_property
    def pages(self) -> tuple[str, ...]:
        return pages_and_scripts(self.files)
