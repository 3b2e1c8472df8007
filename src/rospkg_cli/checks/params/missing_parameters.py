"""Rule input: what nodes need, what launch files and parameter files give them, and who reads these (PRM008)."""

from __future__ import annotations

import posixpath

from ...light_dataclasses import dataclass
from ...package.file_role import role_of
from ...source import Span
from ..fault import Level
from ..repository.distribution_names import UNSUPPORTED, names_in
from ..repository.older_distribution import OlderDistribution
from ..repository.pages_and_scripts import own_pages
from .block_readers import BlockReaders
from .declaring_packages import ParameterContext
from .launch_parameters import LaunchParameters


@dataclass(frozen=True)
class MissingParameters:
    readers: BlockReaders
    code: ParameterContext
    distribution: OlderDistribution

    @property
    def launched(self) -> LaunchParameters:
        return self.readers.launched

    def level_at(self, path: str, place: Span) -> Level | None:
        """Return the level of what a parameter file lacks: an info where no node reads the block at a place."""
        return "info" if self.readers.is_idle(path, place) else None

    def level_of_plugin(self, path: str, place: Span) -> Level | None:
        """Return the level of what a list of plugins lacks: before Humble nav2 read other lists."""
        is_older = self.distribution.is_only_unsupported or self.is_named_for_older(path)
        return "info" if is_older else self.level_at(path, place)

    def is_named_for_older(self, path: str) -> bool:
        """Return whether pages of the package name a parameter file, and only distributions before Humble beside.

        One that a launch file of the package names is read wherever that is started.
        """
        name, files = posixpath.basename(path), self.distribution.files
        launches = (each for each in files.paths if role_of(each) == "launch")
        if any(name in files.readable_text(each) for each in launches):
            return False
        pages = (text.lower() for text in own_pages(files) if name in text)
        named = frozenset(each for text in pages for each in names_in(text))
        return bool(named) and named.issubset(UNSUPPORTED)
