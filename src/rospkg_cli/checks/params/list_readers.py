"""Whether a node in C++ is shown to read a block of a parameter file: at an empty list such a node alone stops."""

from __future__ import annotations

from ...light_dataclasses import dataclass
from ...package.package_facts import PackageFacts
from ...package.params.parameter_file import NodeBlock
from ...ros.known_nodes import known_nodes
from ...ros.names import NameKind
from ...source import Span
from .block_readers import BlockReaders, may_read
from .mistyped_blocks import WILD, last
from .node_parameters import NodeArguments
from .parameter_file_use import ParameterFileUse, is_in_python

UNSHOWN = "where a C++ node reads the block, as nothing here shows"


@dataclass(frozen=True)
class ListReaders:
    use: ParameterFileUse
    readers: BlockReaders

    def has(self, place: Span) -> bool:
        """Return whether a node in C++ that is started is given the file, and may read the block at a place."""
        blocks = self.use.file.blocks
        block = next((each for each in blocks if each.value.span.holds(place)), None)
        if block is None:
            return True
        given = [each for each in self.native if self.use.file in each.files]
        is_given = any(may_read(each, block) for each in given) or self.is_given_elsewhere()
        return is_given or (self.use.is_named and self.is_started(block))

    @property
    def native(self) -> list[NodeArguments]:
        """The nodes of the package's launch files that are started, but for those that may be in Python."""
        met = (each for each in self.readers.launched.node_arguments if self.readers.is_met(each))
        return [each for each in met if self.is_native(*names_of(each))]

    def is_native(self, package: str, executable: str) -> bool:
        """Return whether a node is taken to be in C++: a component is, no program of a strange package may be."""
        is_known = package == "" or self.use.workspace.kind_of(package) is NameKind.PACKAGE
        return (is_known or "::" in executable) and not is_in_python(package, executable, self.use.workspace)

    def is_given_elsewhere(self) -> bool:
        """Return whether a launch file of another package gives the file to a node in C++, whatever that is called."""
        files = {(self.use.package.name, path) for path in self.use.share_paths}
        rows = (row for facts in self.others for row in facts.yaml_readers if row[:2] in files)
        return any(self.is_native(*row[2:]) for row in rows)

    @property
    def others(self) -> list[PackageFacts]:
        return [facts for facts in self.use.workspace.packages if facts.name != self.use.package.name]

    def is_started(self, block: NodeBlock) -> bool:
        """Return whether a node of the block's name is started, be it by a launch file of a package that is not here.

        How it comes to its file, which something names, may be more than is read of a launch file.
        """
        name = last(block)
        if name in WILD:
            return bool(self.native) or any(facts.started_nodes for facts in self.others)
        if any(name in (each.known_name, names_of(each)[1]) for each in self.native):
            return True
        owners = known_nodes().get(name, ())
        started = (each for facts in self.others for each in facts.started_nodes)
        if any(program == name or package in owners for package, program in started):
            return True
        return bool(owners) and self.is_handed_out()

    def is_handed_out(self) -> bool:
        """Return whether a launch file that names the file includes one of a package that is not here."""
        name, workspace = self.use.file.path.rpartition("/")[2], self.use.workspace
        for launch in self.readers.launched.launches:
            for each in launch.includes if name in launch.source.text else ():
                found = each.file.substitutions("find-pkg-share")
                packages = [one.arguments[0].literal for one in found if one.arguments]
                if any(package and workspace.named(package) is None for package in packages):
                    return True
        return False


def names_of(each: NodeArguments) -> tuple[str, str]:
    """Return package and program of a node, "" for what is not literal."""
    started = each.node.executable or each.node.plugin
    package = each.node.package
    return (package.literal or "") if package else "", (started.literal or "") if started else ""
