"""Rule input: the entry points of setup.py, and what starts their programs."""

from __future__ import annotations

from collections.abc import Sequence

from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.setup.entry_point import EntryPoint
from ..repository.linked_build import build_texts
from ..repository.older_distribution import OlderDistribution
from ..unstarted_programs import UnstartedPrograms
from .module_tree import ModuleTree
from .python_package import PythonPackage

LEFT = "; nothing here starts it, as others of the package are"

SETUPTOOLS = regex(r"(?m)^.*\bpip3?\b.*\binstall\b.*\bsetuptools\b.*$")
PINNED = regex(r"\bsetuptools[\"']?\s*(?P<sign>[=<>~]=|<)\s*(?P<major>\d+)")
UPGRADED = regex(r"\s(?:-U|--upgrade)\b")
NEWER = 60
"""The first version of setuptools that refuses what the one of Humble (59) accepts."""


@dataclass(frozen=True)
class StartedEntryPoints:
    package: PythonPackage
    programs: UnstartedPrograms | None = None
    distribution: OlderDistribution | None = None

    @property
    def has_old_setuptools(self) -> bool:
        """Whether the repository is for distributions before Jazzy alone, and installs no newer setuptools by pip.

        That of Humble is 59: it keeps one of two equal names, and stops at no second folder.
        """
        known = self.distribution
        if known is None or not known.is_before_jazzy or known.reaches_jazzy:
            return False
        return not any(installs_newer(line) for text in build_texts(known.files) for line in SETUPTOOLS.findall(text))

    def left_all(self, entries: Sequence[EntryPoint]) -> str:
        """Return that nothing starts the programs of some entries, where others are started; "" where one may be."""
        return LEFT if all(map(self.left, entries)) else ""

    def left(self, entry: EntryPoint) -> str:
        """Return that nothing starts the program of an entry, where another one is started; "" of all others."""
        is_left = entry.is_script and self.programs is not None and self.programs.is_beside_started(entry.name)
        return LEFT if is_left else ""


@dataclass(frozen=True)
class EntryPointTree:
    """Rule input: the folders of modules of a package, and what starts its entry points."""

    tree: ModuleTree
    started: StartedEntryPoints


def installs_newer(line: str) -> bool:
    """Return whether a line installs a setuptools by pip that is newer than the one of Humble."""
    pinned = PINNED.search(line)
    if pinned is None or pinned["sign"] == ">=":
        return bool(UPGRADED.search(line)) or (pinned is not None and int(pinned["major"]) >= NEWER)
    return not pinned["sign"].startswith("<") and int(pinned["major"]) >= NEWER
