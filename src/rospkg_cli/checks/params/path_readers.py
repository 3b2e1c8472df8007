"""Whether anything is shown to read a value of YAML by its name: code of the package, or a well-known node."""

from __future__ import annotations

from functools import cached_property

from ...files import PackageFiles
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.file_role import role_of
from ...package.launch.text import uncommented
from ...package.params.parameter_file import NodeBlock, ParameterFile
from ...package.workspace import Workspace
from ...ros.known_nodes import known_nodes, known_parameters, removed_parameters
from ...source import Span
from ..repository.distribution_names import OLDER
from ..repository.older_distribution import OlderDistribution
from .idle_declarations import is_idle
from .mistyped_blocks import last

CODE = (".py", ".cpp", ".cc", ".cxx", ".hpp", ".h")
BEFORE_GALACTIC = frozenset({"bt_xml_filename", "default_bt_xml_filename"})
"""What Galactic's bt_navigator has another name for already: `default_nav_to_pose_bt_xml`."""
KEY = regex(r"([\w./-]+)[\"']?[ \t]*:[ \t]*[\"']?(?:file://)?\Z")
ABOVE = regex(r"(?m)^[ \t-]*[\"']?([\w./-]+)[\"']?[ \t]*:[ \t]*(?:[#&][^\n]*)?$")


@dataclass(frozen=True)
class PathReaders:
    files: PackageFiles
    workspace: Workspace
    parameters: tuple[ParameterFile, ...]

    def has(self, path: str, place: Span, text: str) -> bool:
        """Return whether code, or a well-known node, reads the value at a place in YAML by its key."""
        blocks = [block for file in self.parameters if file.path == path for block in file.blocks]
        found = [(block, each.name) for block in blocks for each in block.parameters if each.value.span.holds(place)]
        if found:
            return any(self.is_declared(name) or self.is_well_known(block, name) for block, name in found)
        key = key_at(text[: place.start])
        return bool(key) and is_written(key, "\n".join(self.code.values()))

    def is_declared(self, name: str) -> bool:
        """Return whether code of the workspace declares a parameter, or that of the package has its name.

        A launch file that gives a parameter to a node is no reader of it, nor is code that never asks for its value.
        """
        if self.is_idle(name):
            return False
        declared = (each for facts in self.workspace.packages for each in facts.parameters)
        own = "\n".join(text for path, text in self.code.items() if role_of(path) != "launch")
        return any(each.fits(name) for each in declared) or is_written(name.rpartition(".")[2], own)

    def is_idle(self, name: str) -> bool:
        """Return whether Python code of the package alone declares a parameter, and nothing asks for its value."""
        own = {path: text for path, text in self.code.items() if role_of(path) != "launch"}
        naming = [path for path, text in own.items() if name in text]
        if not naming or not all(path.endswith(".py") for path in naming):
            return False
        declaring = [facts for facts in self.workspace.packages if any(each.fits(name) for each in facts.parameters)]
        if len(declaring) > 1:
            return False
        return is_idle(name, (uncommented(path, text) for path, text in own.items()))

    @cached_property
    def code(self) -> dict[str, str]:
        return {path: self.files.readable_text(path) for path in self.files.paths if path.endswith(CODE)}

    def is_well_known(self, block: NodeBlock, name: str) -> bool:
        """Return whether a well-known node of a block's name declares a parameter, today or in the old distribution."""
        every = {package for packages in known_nodes().values() for package in packages}
        owners = every if "." in name else known_nodes().get(last(block), every)  # a plugin is of any package
        if any(each.fits(name) for package in owners for each in known_parameters(package)):
            return True
        removed = (each for package in owners for each in removed_parameters(package))
        return any(each.fits(name) for each in removed) and self.is_for_older_distributions(name)

    def is_for_older_distributions(self, name: str) -> bool:
        """Return whether the repository is for old distributions alone, which may still have a removed parameter."""
        older = OlderDistribution(self.files)
        is_gone_before = name in BEFORE_GALACTIC
        return older.is_only_unsupported and (not is_gone_before or older.intended.issubset(OLDER))


def is_written(key: str, code: str) -> bool:
    """Return whether code has a key as a text, or as an attribute."""
    return any(f"{before}{key}{after}" in code for before, after in (("'", "'"), ('"', '"'), (".", "")))


def key_at(before: str) -> str:
    """Return the key of a value that follows a text; of an element of a list that of the list, "" for none."""
    here = KEY.search(before.rpartition("\n")[2])
    if here is not None:
        return here[1]
    above = ABOVE.findall(before)
    return above[-1] if above else ""
