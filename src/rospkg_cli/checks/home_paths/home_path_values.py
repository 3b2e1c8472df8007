"""Rule input: whether a home path in YAML or a launch file is a value that a node gets and reads."""

from __future__ import annotations

from functools import cached_property
from typing import Annotated

from ...files import PackageFiles
from ...light_dataclasses import dataclass
from ...package.file_role import role_of
from ...package.install_table import InstallTable
from ...package.launch.launch_file import LaunchFile
from ...package.package_facts import PackageFacts
from ...package.params.parameter_file import ParameterFile
from ...package.workspace import Workspace
from ...source import Span
from ...unreadable import READABLE
from ..launch.launch_context import LaunchContext
from ..launch.undeclared_files import is_written_in_vain
from ..launch.unread_values import UnreadValues
from ..launch.who_meets import level_met
from ..params.block_readers import BlockReaders
from ..params.launch_overrides import is_given, is_overridden
from ..params.path_readers import PathReaders
from ..params.replaced_defaults import is_replaced
from ..paths.home_path_texts import CPP, YAML
from ..repository.replaced_launch_files import has_named_twin, is_always_given
from .home_mention import HomeMention


@dataclass(frozen=True)
class HomePathValues:
    files: PackageFiles
    facts: PackageFacts
    workspace: Workspace
    table: InstallTable | None = None
    blocks: BlockReaders | None = None
    launches: Annotated[tuple[LaunchFile, ...], READABLE] = ()
    parameters: Annotated[tuple[ParameterFile, ...], READABLE] = ()

    @cached_property
    def readers(self) -> PathReaders:
        return PathReaders(self.files, self.workspace, self.parameters)

    @cached_property
    def contexts(self) -> tuple[LaunchContext, ...]:
        rest = self.files, self.facts, self.workspace, self.table, None
        return tuple(LaunchContext(each, *rest) for each in self.launches)

    @cached_property
    def unread_values(self) -> tuple[UnreadValues, ...]:
        """What each launch file sets and nothing reads."""
        return tuple(map(UnreadValues, self.contexts))

    def is_value(self, mention: HomeMention) -> bool:
        """Return whether a path is a value of a YAML file, but not the image of a map."""
        path = mention.path
        return path.endswith((".yaml", ".yml")) and role_of(path) != "launch" and not mention.is_image

    def is_unread(self, path: str, place: Span) -> bool:
        """Return whether a place is that of a value of a launch file which nothing reads."""
        return any(each.holds(place) for each in self.unread_values if each.scope.file.path == path)

    def is_unclaimed(self, mention: HomeMention) -> bool:
        """Return whether a path is the value of a parameter that no code and no well-known node is known to read."""
        path, place = mention.path, mention.place
        if self.is_value(mention) and not self.readers.has(path, place, mention.bare):
            return True
        own = (each for each in self.contexts if each.file.path == path)
        return any(is_written_in_vain(each, place) for each in own)

    def is_replaced(self, mention: HomeMention) -> bool:
        """Return whether YAML or launch files give nodes another value in place of a default, or of that of a file."""
        path, place, before = mention.path, mention.place, mention.before
        if path.endswith(YAML) and role_of(path) != "launch":
            return is_overridden(path, place, self.parameters, self.launches)
        if role_of(path) == "launch":
            return is_always_given(path, before, self.files) or has_named_twin(path, self.files)
        is_given_by_launch = is_given(before, mention.named, self.facts.name, self.launches)
        return is_replaced(before, mention.named, self.parameters) or is_given_by_launch

    def is_given_otherwise(self, mention: HomeMention) -> bool:
        """Return whether the build leaves a place out, or what is run gives another value than the one there."""
        from ..cpp.undefined_macros import is_left_out  # few files have such a path
        from ..repository.overridden_defaults import is_given_otherwise

        path, place, text = mention.path, mention.place.start, mention.bare
        is_out = path.endswith(CPP) and is_left_out(text, place, self.files)
        return is_out or is_given_otherwise(path, text, place, self.files)

    def is_in_unread_block(self, path: str, place: Span) -> bool:
        """Return whether a place is in a block for a node that launch files never give the file to."""
        own = ((file, block) for file in self.parameters if file.path == path for block in file.blocks)
        held = ((file, block) for file, block in own if block.value.span.holds(place))
        return self.blocks is not None and any(self.blocks.is_unread(*each) for each in held)

    def is_of_written(self, path: str, place: Span) -> bool:
        """Return whether a place is that of a parameter whose file code only writes."""
        from ..paths.written_parameters import is_of_written  # few files have such a path

        return is_of_written(path, place, self.parameters, self.files)

    def is_unused(self, path: str, place: Span) -> bool:
        """Return whether a launch never runs a place of a launch file: nothing adds it, or the launch ends before."""
        own = (each for each in self.launches if each.path == path)
        return any(level_met(each, place, self.workspace)[0] == "info" for each in own)
