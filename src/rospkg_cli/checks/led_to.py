"""Whether anything names a file: another file, a page or a script, or a package that depends on this one."""

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
from .opening_places import OpeningPlaces
from .repository.pages_and_scripts import pages_and_scripts
from .share.opened_elsewhere import CODE
from .urdf.robot_texts import COMMAND

YAML = (".yaml", ".yml")
LAUNCHED = (".py", ".xml", ".launch", *YAML)


@dataclass(frozen=True)
class LedTo:
    opening: OpeningPlaces

    def has(self, path: str) -> bool:
        """Return whether something names a launch file or a YAML file; the rule that installs it does not count.

        The only launch file of a package always counts as started. YAML counts as opened where a command of a page
        names it, but not by its description; where code puts a name together, its part before the suffix is in quotes.
        """
        is_launch = role_of(path) == "launch"
        if is_launch and not path.endswith(YAML) and self.is_only_launch_file(path):
            return True
        name = path.rpartition("/")[2]
        word = re.compile(rf"(?<![\w-]){re.escape(name)}(?!\w)")
        if any(word.search(each) for each in (self.pages if is_launch else self.commands)):
            return True
        stem = re.compile(rf"[\"'/]{re.escape(name.rpartition('.')[0])}[\"']")
        others = (self.package, *self.opening.workspace.needing(self.package.name))
        is_made = path.endswith(YAML) and any(ANY in each.named_yaml for each in others)
        texts = tuple(self.texts_but(path))
        return any(word.search(each) or (is_made and stem.search(each)) for each in texts)

    @property
    def package(self) -> PackageFacts:
        return self.opening.package

    @property
    def files(self) -> PackageFiles:
        return self.opening.files

    def is_only_launch_file(self, path: str) -> bool:
        others = (each for each in self.files.paths if each != path and role_of(each) == "launch")
        return not any(each.endswith(LAUNCHED) and not each.rpartition("/")[2].startswith(".") for each in others)

    def texts_but(self, path: str) -> Iterator[str]:
        """Yield the code that may name a file, of the package and of those that need it, without what nothing reads."""
        yield from (text for own, text in self.opening.texts if own != path)
        whole = self.files.whole
        for other in self.opening.workspace.needing(self.package.name):
            if whole is None:
                return
            theirs = PackageFiles(whole.sub(other.folder), other.folder, whole)
            yield from (live_text(theirs, each) for each in theirs.paths if each.endswith(CODE))

    @property
    def commands(self) -> Iterator[str]:
        """The lines of pages and scripts with a command."""
        typed = re.compile(COMMAND)
        return (line for text in self.pages for line in text.splitlines() if typed.search(line))

    @cached_property
    def pages(self) -> tuple[str, ...]:
        return pages_and_scripts(self.files)
