"""Rule input: what nodes need, what launch files and parameter files give them, and who reads these (PRM008)."""

from __future__ import annotations

import posixpath
from collections.abc import Iterator

from ...light_dataclasses import dataclass
from ...package.file_role import role_of
from ...package.params.declared_parameter import DeclaredParameter
from ...source import Span
from ..fault import Level
from ..repository.distribution_names import UNSUPPORTED, names_in
from ..repository.older_distribution import OlderDistribution
from ..repository.pages_and_scripts import own_pages
from .block_readers import BlockReaders
from .declaring_packages import ParameterContext
from .given_otherwise import may_be_set
from .launch_parameters import LaunchParameters
from .node_parameters import NodeArguments


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
        """Return whether the pages that name a parameter file name only distributions before Humble.

        False where a launch file of the package names it: it is read wherever that is started.
        """
        name, files = posixpath.basename(path), self.distribution.files
        launches = (each for each in files.paths if role_of(each) == "launch")
        if any(name in files.readable_text(each) for each in launches):
            return False
        pages = (text.lower() for text in own_pages(files) if name in text)
        named = frozenset(each for text in pages for each in names_in(text))
        return bool(named) and named.issubset(UNSUPPORTED)


def missing_parameters(launched: LaunchParameters) -> Iterator[tuple[NodeArguments, list[DeclaredParameter]]]:
    """Yield each node with the parameters that its code declares without a default and that are not set."""
    for each in launched.started:
        package = each.node.package.literal if each.node.package else None
        facts = launched.workspace.named(package) if package else None
        started = each.node.executable or each.node.plugin
        if facts is None or not each.is_complete or started is None or started.literal is None:
            continue
        code = next((code for code in facts.node_code if code.starts == started.literal), None)
        if code is not None:
            needed = [one for one in facts.parameters if one.required and not one.tail and one.path in code.paths]
            names = each.names()
            missing = [one for one in needed if one.name not in names]
            if missing and not may_be_set(each.node, {one.name for one in missing}, launched.launches):
                yield each, missing
