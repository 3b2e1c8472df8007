"""Rule input: the entry points of setup.py, with who starts the programs that are made of them."""

from __future__ import annotations

from collections.abc import Sequence

from ...light_dataclasses import dataclass
from ...package.setup.entry_points import EntryPoint
from ..older_distribution import OlderDistribution
from ..unstarted_programs import UnstartedPrograms
from .module_tree import ModuleTree
from .python_package import PythonPackage

LEFT = "; nothing here starts it, as others of the package are"


@dataclass(frozen=True)
class StartedEntryPoints:
    package: PythonPackage
    programs: UnstartedPrograms | None = None
    distribution: OlderDistribution | None = None

    @property
    def takes_duplicates(self) -> bool:
        """Whether the repository is for distributions alone whose setuptools keeps one of two equal names."""
        known = self.distribution
        return known is not None and known.is_before_jazzy and not known.reaches_jazzy

    def left_all(self, entries: Sequence[EntryPoint]) -> str:
        """Return that nothing starts the programs of some entries, where others are started; "" where one may be."""
        return LEFT if all(map(self.left, entries)) else ""

    def left(self, entry: EntryPoint) -> str:
        """Return that nothing starts the program of an entry, where another one is started; "" of all others."""
        is_left = entry.is_script and self.programs is not None and self.programs.is_beside_started(entry.name)
        return LEFT if is_left else ""


@dataclass(frozen=True)
class EntryPointTree:
    """Rule input: the folders of modules of a package, and who starts its entry points."""

    tree: ModuleTree
    started: StartedEntryPoints
