"""Rule input: the Python code of a package that imports its own interfaces, and when these imports run (IDL008)."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator

from ...languages.python.file import PythonFile
from ...languages.python.imports import Import
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.file_role import is_set_aside, role_of
from ...ros.interfaces import KINDS
from ..fault import WORST_FIRST, Level
from ..reached_places import ReachedPlaces
from ..repository.pages_and_scripts import pages_and_scripts
from ..unstarted_programs import UnstartedPrograms
from .facts_and_files import FactsAndFiles

GENERATES = regex(r"\brosidl[ \t\"',]+generate\b|\brosidl_generator_py\b|\brosidl_generate_interfaces[ \t]*\(")


@dataclass(frozen=True)
class InterfaceImporters:
    package: FactsAndFiles
    places: ReachedPlaces | None = None
    programs: UnstartedPrograms | None = None

    def level(self) -> Level:
        """Return the highest level of an import: an error where a start runs it, an info where no run is known to."""
        files, name = self.package.files, self.package.facts.name
        own = [f"{name}/{kind}{end}" for kind in KINDS for end in (".py", "/__init__.py")]
        if any(map(files.exists, own)) or self.is_generated():
            return "info"
        return worst(self.level_in(path) for path in self.paths())

    def is_generated(self) -> bool:
        """Return whether a script, a page or setup.py generates code of interfaces by a command of its own."""
        texts = (self.package.files.readable_text("setup.py"), *pages_and_scripts(self.package.files))
        return any(map(GENERATES.search, texts))

    def paths(self, kind: str = "(?:msg|srv|action)", what: str = "") -> Iterator[str]:
        """Yield the Python files of the package that import interfaces of it."""
        name = re.escape(self.package.facts.name)
        wanted = re.compile(
            rf"^[ \t]*(?:from|import)[ \t]+{name}(?:\.|[ \t]+import[ \t(]+){kind}\b{what}", re.MULTILINE
        )
        paths = (path for path in self.package.files.paths if path.endswith(".py"))
        yield from (path for path in paths if wanted.search(self.package.files.readable_text(path)))

    def level_in(self, path: str) -> Level:
        if role_of(path) != "run" or is_set_aside(path) or self.package.is_left(path):
            return "info"
        file = self.places.run.modules.at(path) if self.places is not None else None
        if file is None:
            return "error"
        imports = [each for each in file.imports if self.is_own(each)]
        level = worst(self.level_of(file, each) for each in imports)
        is_aside = level == "error" and self.programs is not None and self.programs.has(path)
        return "warning" if is_aside else level

    def level_of(self, file: PythonFile, each: Import) -> Level:
        if each.is_optional or each.is_for_typing:
            return "info"
        places = self.places
        if places is None or places.why_seldom(file.path, each.span):
            return "error" if places is None else "info"
        return "warning" if each.is_local or places.is_conditional(file.path, each.span) else "error"

    def is_own(self, each: Import) -> bool:
        name, kinds = self.package.facts.name, "|".join(KINDS)
        is_whole = each.module == name and any(one in each.names for one in KINDS)
        return is_whole or re.match(rf"{re.escape(name)}\.(?:{kinds})(?!\w)", each.module) is not None


def worst(levels: Iterable[Level]) -> Level:
    found: list[Level] = [*levels, "info"]
    return min(found, key=WORST_FIRST.index)
