"""Parameter files and values that launch files give to nodes."""

from __future__ import annotations

import re
from collections.abc import Iterator
from functools import cached_property
from typing import Annotated

from ...light_dataclasses import dataclass
from ...package.file_role import role_of
from ...package.install_table import InstallTable
from ...package.launch.launch_file import LaunchedNode, LaunchFile
from ...package.launch.text import LaunchText, Literal, Substitution
from ...package.package_facts import PackageFacts
from ...package.params.declared_parameter import DeclaredParameter
from ...package.params.parameter_file import NodeBlock, ParameterFile
from ...package.workspace import Workspace
from ...ros.known_nodes import known_nodes
from ...suggest import near_names
from ...unreadable import READABLE, Unreadable
from ..launch.ros1_syntax import is_refused
from ..yaml_elsewhere import is_named_elsewhere
from .declaring_packages import is_its_own
from .given_otherwise import may_be_set
from .handed_on import may_hand_on
from .inner_nodes import may_make
from .mistyped_blocks import WILD, MistypedBlock, differing, last, mistyped_blocks

MAX_DEPTH = 5
ENDINGS = (".yaml", ".yml")
SHARE = "\0share"
ENOUGH_NAMES = 2
"""What a block has to set to be known by it."""


@dataclass(frozen=True)
class NodeArguments:
    """A node that a launch file starts, and the parameter files of this package that may be passed to it."""

    launch: LaunchFile
    node: LaunchedNode
    files: tuple[ParameterFile, ...]
    is_complete: bool
    """Whether these are certainly all, and the node is certainly started."""
    has_all: bool = False
    """Whether these are certainly all, if the node is started."""
    in_code: str | None = None
    """The name that its code gives it, where the launch file gives none."""
    by_default: str | None = None
    """The name that the defaults of arguments give it."""

    @property
    def name(self) -> str | None:
        return self.node.name.literal if self.node.name else None

    @property
    def known_name(self) -> str | None:
        return self.name or self.in_code or self.by_default

    @property
    def usual_name(self) -> str | None:
        """The same; that of a well-known node is mostly that of its program."""
        program = self.node.executable.literal if self.node.executable and self.node.name is None else None
        package = self.node.package.literal if self.node.package else None
        return self.known_name or (program if package in known_nodes().get(program or "", ()) else None)

    @property
    def likely_name(self) -> str | None:
        """The same; where nothing tells it, that of the program, which is often the node's."""
        return self.known_name or (self.node.executable.literal if self.node.executable else None)

    def starts(self, executable: str) -> bool:
        """Return whether the node has an executable of this name, which is often that of a node without `name=`."""
        return self.node.executable is not None and self.node.executable.literal == executable

    @property
    def full_name(self) -> str | None:
        """The name with its namespace, where both are literal; others may be put before it, but for an absolute one."""
        space = self.node.namespace.literal if self.node.namespace else None
        return f"/{space.strip('/')}/{self.known_name}" if space and space.strip("/") and self.known_name else None

    def blocks(self) -> Iterator[NodeBlock]:
        """Yield the blocks that the node reads."""
        for file in self.files:
            for block in file.blocks:
                if self.name is None or last(block) in (*WILD, self.name):
                    yield block

    def names(self) -> set[str]:
        """Return the names of the parameters that are set for the node."""
        values = [name.literal for entry in self.node.parameters for name, _ in entry.values]
        return {each.name for block in self.blocks() for each in block.parameters} | {name for name in values if name}


@dataclass(frozen=True)
class LaunchParameters:
    files: Annotated[tuple[ParameterFile, ...], READABLE]
    launches: Annotated[tuple[LaunchFile, ...], READABLE]
    table: InstallTable | None
    package: PackageFacts
    workspace: Workspace
    unreadable: tuple[Unreadable, ...] = ()

    @property
    def is_whole(self) -> bool:
        """Whether all launch files and parameter files can be read: else another may start a node, or be for it."""
        return not any(role_of(each.path) == "launch" or each.path.endswith(ENDINGS) for each in self.unreadable)

    @cached_property
    def node_arguments(self) -> tuple[NodeArguments, ...]:
        return tuple(
            self.arguments_of(launch, node) for launch in self.launches if not launch.is_ros1 for node in launch.nodes
        )

    @cached_property
    def started(self) -> tuple[NodeArguments, ...]:
        """Those of launch files that ROS 2 reads; what is said of another file comes first (LCH006)."""
        return tuple(each for each in self.node_arguments if not is_refused(each.launch))

    def is_left_out(self, launch: LaunchFile) -> bool:
        """Return whether a launch file is known not to be installed: only who knows its path in the source starts it.

        Tests are run from there.
        """
        if self.table is None or not self.table.knows("share") or role_of(launch.path) == "test":
            return False
        return all(row.source != launch.path for _, row in self.table.below(f"share/{self.package.name}"))

    def arguments_of(self, launch: LaunchFile, node: LaunchedNode) -> NodeArguments:
        found: list[ParameterFile] = []
        has_all = node.is_complete
        for entry in node.parameters:
            has_names = all(name.literal is not None for name, _ in entry.values)
            has_all = has_all and entry.is_complete and has_names
            if entry.file is not None:
                files = list(self.files_at(entry.file, launch))
                has_all = has_all and len(files) == 1
                found += files
        in_code = self.name_in_code(node) if self.files else None
        is_complete, default = has_all and node.is_certain, default_name(launch, node)
        return NodeArguments(launch, node, tuple(found), is_complete, has_all, in_code, default)

    def name_in_code(self, node: LaunchedNode) -> str | None:
        """Return the name that the code of a node gives it, where nothing else does."""
        started = node.executable or node.plugin
        package = node.package.literal if node.package is not None else None
        facts = self.workspace.named(package) if package and node.name is None and node.is_complete else None
        if facts is None or started is None or any("__n" in (each.literal or "__n") for each in node.arguments):
            return None
        return next((each.name for each in facts.node_names if each.starts == started.literal), None)

    def files_at(self, text: LaunchText, launch: LaunchFile) -> Iterator[ParameterFile]:
        """Yield the files of this package that a path may mean; what is unknown in it may be any name."""
        pattern = "".join(self.pattern(text, launch, 0))
        if text.literal and text.literal.startswith("/"):
            yield from (file for file in self.files if text.literal.endswith(f"/{self.package.name}/{file.path}"))
        if pattern.startswith(SHARE):
            path = re.compile(re.sub("/+", "/", pattern[len(SHARE) :]).lstrip("/"))
            for file in self.files:
                if any(path.fullmatch(each) for each in self.share_paths(file)):
                    yield file

    def pattern(self, text: LaunchText, launch: LaunchFile, depth: int) -> Iterator[str]:
        for part in text.parts:
            match part:
                case Literal(text=literal):
                    yield re.escape(literal)
                case Substitution(name="find-pkg-share", arguments=(package, *_)):
                    yield SHARE if package.literal == self.package.name else "\0elsewhere"
                case Substitution(name="var", arguments=(name, *_)) if depth < MAX_DEPTH:
                    defaults = [each.default for each in launch.arguments if each.name.literal == name.literal]
                    if len(defaults) == 1 and defaults[0] is not None:
                        yield from self.pattern(defaults[0], launch, depth + 1)
                    else:
                        yield "[^/]*"
                case _:
                    yield "[^/]*"

    def share_paths(self, file: ParameterFile) -> list[str]:
        """Return where a file is installed in the share directory."""
        rows = self.table.below(f"share/{self.package.name}") if self.table else ()
        return [path for path, row in rows if row.source == file.path] or [file.path]

    def misnamed(self) -> Iterator[tuple[ParameterFile, NodeBlock, list[NodeArguments]]]:
        """Yield the blocks that no node reads, where a node that gets the file and has none has a near name.

        Where the file goes to no other node, the names need not be alike: it has one block, be it for several nodes, or
        the code of the node declares what the block sets.
        """
        started = {each.likely_name for each in self.node_arguments}
        for file in self.files:
            readers = [each for each in self.node_arguments if file in each.files and each.known_name]
            named = {last(block) for block in file.blocks}
            without_block = [each for each in readers if each.known_name not in named]
            for block in file.blocks if without_block else ():
                key = last(block)
                if key not in started and key not in WILD and "$" not in key:
                    found = [each for each in without_block if is_near(key, each.known_name or "") or each.starts(key)]
                    if (
                        not found
                        and self.is_only_for_named(file)
                        and not any(may_make(each.node, key) for each in readers)
                    ):
                        is_only = len(file.blocks) == 1
                        found = [each for each in without_block if is_only or self.declares(each, block)]
                    is_alone = len(file.blocks) == 1 and found == readers and key not in known_nodes()
                    if found and (is_alone or len({each.known_name for each in found}) == 1):
                        yield file, block, found

    def declares(self, each: NodeArguments, block: NodeBlock) -> bool:
        """Return whether the package of a node declares all that a block sets."""
        package = each.node.package.literal if each.node.package else None
        facts = self.workspace.named(package) if package else None
        names = [parameter.name for parameter in block.parameters if is_its_own(parameter.name)]
        if facts is None or not names:
            return False
        declared = [one for one in facts.parameters if not one.tail]
        return all(any(one.fits(name) for one in declared) for name in names) and len(names) >= ENOUGH_NAMES

    def mistyped(self) -> Iterator[tuple[ParameterFile, MistypedBlock]]:
        """Yield the blocks of nodes that are not here, with nearly the name of a controller or a well-known node."""
        started = {each.name for each in self.node_arguments}
        texts = [launch.source.text for launch in self.launches]
        told = {id(block) for _, block, _ in self.misnamed()}
        for file in self.files:
            yield from ((file, each) for each in mistyped_blocks(file, started, texts) if id(each.block) not in told)

    def is_only_for_named(self, file: ParameterFile) -> bool:
        """Return whether all nodes that may get a file have a literal name, and nothing else opens or passes it on."""
        given = [each for each in self.node_arguments if file in each.files]
        texts = [launch.source.text for launch in self.launches if not any(each.launch is launch for each in given)]
        name = file.path.rpartition("/")[2]
        alone = all(each.known_name and each.node.is_certain for each in given) and not any(
            name in text for text in texts
        )
        alone = alone and not is_named_elsewhere(name.rpartition(".")[0], self.package, self.workspace)
        return alone and not any(may_hand_on(each.launch, name, self.workspace) for each in given)

    def missing(self) -> Iterator[tuple[NodeArguments, list[DeclaredParameter]]]:
        """Yield each node with the parameters that its code declares without a default and that are not set."""
        for each in self.started:
            package = each.node.package.literal if each.node.package else None
            facts = self.workspace.named(package) if package else None
            started = each.node.executable or each.node.plugin
            if facts is None or not each.is_complete or started is None or started.literal is None:
                continue
            code = next((code for code in facts.node_code if code.starts == started.literal), None)
            if code is not None:
                needed = [one for one in facts.parameters if one.required and not one.tail and one.path in code.paths]
                names = each.names()
                missing = [one for one in needed if one.name not in names]
                if missing and not may_be_set(each.node, {one.name for one in missing}, self.launches):
                    yield each, missing


def default_name(launch: LaunchFile, node: LaunchedNode) -> str | None:
    """Return the name of a node that is one launch argument, as its only default has it."""
    parts = node.name.parts if node.name is not None else ()
    if len(parts) != 1 or not isinstance(parts[0], Substitution) or parts[0].name != "var":
        return None
    wanted = parts[0].arguments[0].literal if parts[0].arguments else None
    defaults = [each.default for each in launch.arguments if each.name.literal == wanted and wanted]
    return defaults[0].literal if len(defaults) == 1 and defaults[0] is not None else None


def is_near(key: str, name: str) -> bool:
    short, long = sorted((key, name), key=len)
    return long in (f"{short}_node", f"{short}node") or bool(differing(key, near_names(key, [name], 1)))
