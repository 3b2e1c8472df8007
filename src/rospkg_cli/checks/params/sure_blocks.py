"""Whether a block that no node reads is certainly for the node that lacks one, or may be read some other way."""

from __future__ import annotations

import re
from collections.abc import Iterable
from functools import cached_property

from ...files import PackageFiles
from ...light_dataclasses import dataclass
from ...package.file_role import role_of
from ...package.params.node_texts import of_cpp, of_python
from ...package.params.parameter_file import NodeBlock, ParameterFile
from ...ros.known_nodes import known_nodes
from ..repository.pages_and_scripts import pages_and_scripts
from .inner_nodes import SINGLE
from .launch_parameters import LaunchParameters
from .misnamed_blocks import is_near
from .mistyped_blocks import WILD, last
from .node_parameters import NodeArguments

CODE = (".cpp", ".hpp", ".cc", ".h", ".hh", ".cxx")
OTHER_NAMES = r"(?:package|executable|pkg|exec|plugin|[dD]irectory|Share|[pP]refix)\s*[=(:]\s*"
"""What a name in quotes is of that is not a node's."""


@dataclass(frozen=True)
class SureBlocks:
    launched: LaunchParameters
    files: PackageFiles

    def why_not(self, file: ParameterFile, block: NodeBlock, nodes: list[NodeArguments]) -> str:
        """Return how another node may read a block than those that lack one; "" where none can."""
        key = last(block)
        if self.is_coded(key, nodes) or self.is_in_launch(key) or self.is_on_page(key):
            return ", unless the node of that name is started, which is here"
        given = [each for each in self.launched.node_arguments if file in each.files]
        if any(each.known_name is None for each in given):
            return ", unless another one that gets the file is called so"
        if any(is_near(key, each.known_name or "") or each.starts(key) for each in nodes):
            return ""
        if any(self.may_hold(each, key) for each in given):
            return ", unless its program makes one of that name as well"
        return "" if self.is_alone(file, given) else ", unless a node of that name is started elsewhere"

    def is_coded(self, key: str, nodes: Iterable[NodeArguments]) -> bool:
        """Return whether code gives the name to another node than those, which may be started."""
        names = [each for facts in self.launched.workspace.packages for each in facts.node_names if each.name == key]
        if names:
            return any(not any(node.starts(each.starts) for node in nodes) for each in names)
        return key in self.coded

    @cached_property
    def coded(self) -> frozenset[str]:
        """The names that code of the package gives its nodes."""
        paths = [path for path in self.files.paths if role_of(path) == "run"]
        native = (of_cpp(self.files.readable_text(path)) for path in paths if path.endswith(CODE))
        python = (of_python(self.files.readable_text(path)) for path in paths if path.endswith(".py"))
        return frozenset().union(*(each.names for each in (*native, *python)))

    def is_on_page(self, key: str) -> bool:
        """Return whether a page or a script starts a node under a name: `-r __node:=key`."""
        named = re.compile(rf"\b__(?:node|name):=['\"]?/?{re.escape(key)}(?![\w-])")
        return any(map(named.search, pages_and_scripts(self.files)))

    def is_in_launch(self, key: str) -> bool:
        """Return whether a launch file holds a name, also in a comment, which may be turned on."""
        named = re.compile(rf"({OTHER_NAMES})?(?:['\"]{re.escape(key)}['\"]|__node:=/?{re.escape(key)}\b)")
        return any(not found[1] for each in self.launched.launches for found in named.finditer(each.source.text))

    def may_hold(self, given: NodeArguments, key: str) -> bool:
        """Return whether the process of a node may hold others, which read the same file: that of a program which is
        not here, unless its package is known to have single ones, or the node of this name.
        """
        package = given.node.package.literal if given.node.package else None
        is_known = package in SINGLE or package in known_nodes().get(key, ())
        return not package or (self.launched.workspace.named(package) is None and not is_known)

    def is_alone(self, file: ParameterFile, given: list[NodeArguments]) -> bool:
        """Return whether one block of a file is lost and one node lacks a block: others are lists, to take parts of."""
        started = {each.known_name for each in self.launched.node_arguments}
        named = {last(block) for block in file.blocks}
        lost = [block for block in file.blocks if last(block) not in (*started, *WILD)]
        return len(lost) == 1 and len({each.known_name for each in given} - named) == 1
