"""Rule input: what gives the parameter files of a package to nodes, as far as the files of the workspace show."""

from __future__ import annotations

import posixpath
from functools import cached_property

from ...files import PackageFiles
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.install_table import InstallTable
from ...package.launch.live_text import live_text
from ...package.package_facts import PackageFacts
from ...package.params.named_yaml import ANY
from ...package.params.parameter_file import ParameterFile
from ...package.workspace import Workspace
from ...ros.python_nodes import PYTHON_PACKAGES, is_python_package
from ...ros.share_layout import LAUNCH
from ...source import Span
from ..fault import Level
from ..yaml_elsewhere import is_named_elsewhere, is_of_another
from .parameter_file_names import STARTING, may_name, named_in, names_file
from .rewritten_yaml import is_replaced, is_written_out

PARSES = regex(r"\bYAML\s*\(|\byaml\.load|\b(?:safe|full|unsafe)_load\s*\(")
SHOWN = regex(r"(?:^|[_.-])(?:examples?|samples?|templates?)[_.-]")
"""How a file is called that is there to be copied."""
CONTROLLERS, MOVEIT = "ros2_controllers.yaml", "moveit_configs_utils"
"""What generate_demo_launch gives to ros2_control, and the module that has it. (moveit_configs_utils/launches.py)"""


@dataclass(frozen=True)
class ParameterFileUse:
    """A parameter file, among the packages whose launch files may use it."""

    file: ParameterFile
    workspace: Workspace
    package: PackageFacts
    files: PackageFiles
    table: InstallTable | None

    @property
    def level(self) -> Level | None:
        """The level of what rcl refuses: an error where a launch file hands the file to a node.

        It is a warning where a launch file, code or a command of a page names it, and an info where nothing does: even
        a package without launch files may have it to be copied.
        """
        return None if self.is_handed else "warning" if self.is_named and not self.is_unnamed else "info"

    @cached_property
    def is_named(self) -> bool:
        """Whether something here names the file that may give it to a node, or MoveIt does."""
        name = self.file.path.rpartition("/")[2]
        if self.is_for_moveit(name) or any(map(self.naming, self.files.paths)):
            return True
        return is_named_elsewhere(name.rpartition(".")[0], self.package, self.workspace)

    @cached_property
    def is_handed(self) -> bool:
        """Whether a launch file of the workspace gives a node the file by its path."""
        return any(self.workspace.having("handed_yaml", self.package.name, path) for path in self.share_paths)

    @property
    def share_paths(self) -> list[str]:
        """Where the file is installed in the share directory."""
        rows = self.table.below(f"share/{self.package.name}") if self.table is not None else ()
        return [path for path, row in rows if row.source == self.file.path] or [self.file.path]

    @cached_property
    def is_for_python(self) -> bool:
        """Whether every node that a launch file gives the file is Python, as far as package or name show.

        Of a file that none gives by its path, every block is for a node that is called like such a package.
        """
        files = {(self.package.name, path) for path in self.share_paths}
        givers = [facts for file in files for facts in self.workspace.having("handed_yaml", *file)]
        readers = {each[2:] for facts in givers for each in facts.yaml_readers if each[:2] in files}
        if not readers:
            blocks = self.file.blocks
            return bool(blocks) and all(each.name.rpartition("/")[2] in PYTHON_PACKAGES for each in blocks)
        return all(is_in_python(*each, self.workspace) for each in readers)

    @property
    def is_parsed_by_launch(self) -> bool:
        """Whether a launch file, or else code, parses it: then what is there for others needs no block."""
        name = self.file.path.rpartition("/")[2]
        return bool(self.workspace.having("parsed_yaml", name)) or self.is_parsed_by_code(name)

    def is_parsed_by_code(self, name: str) -> bool:
        """Return whether Python parses YAML and names the file, and no launch file does."""
        texts = {path: self.read(path) for path in self.files.paths if STARTING.search(path)}
        naming = {path: text for path, text in texts.items() if name in text}
        if any(LAUNCH.fullmatch(path.rpartition("/")[2]) for path in naming):
            return False
        return any(PARSES.search(text) for path, text in naming.items() if path.endswith(".py"))

    @cached_property
    def is_unnamed(self) -> bool:
        """Whether nothing names it: not the package, and no other that may give it to a node.

        That counts where nodes are launched, or the file is not installed, or called an example. A README names it
        where it shows a command that starts a node with it.
        """
        launches = any(LAUNCH.fullmatch(path.rpartition("/")[2]) for path in self.files.paths)
        launches = launches or any(facts.launch_files for facts in self.workspace.packages)
        if self.is_handed or is_of_another(self.share_paths, self.package, self.workspace):
            return not self.is_handed
        folder, _, name = self.file.path.rpartition("/")
        if not (launches or self.is_left_out or SHOWN.search(name)) or self.is_for_moveit(name):
            return False
        paths = [path for path in self.files.paths if path.endswith(f"/{name}") and path != self.file.path]
        others = [posixpath.dirname(path) for path in paths]
        for text in filter(None, map(self.naming, self.files.paths)):
            if named_in(folder, name, text) or not any(
                named_in(posixpath.dirname(each), name, text) for each in others
            ):
                return False
        return not is_named_elsewhere(name.rpartition(".")[0], self.package, self.workspace)

    def naming(self, path: str) -> str:
        """Return the text of a file that names this one, "" of any other; a node may be called like its file."""
        text = self.read(path) if may_name(path) else ""
        name, in_parts = self.file.path.rpartition("/")[2], ANY in self.package.named_yaml
        return text if text and names_file(name, path, text, in_parts=in_parts) else ""

    def is_for_moveit(self, name: str) -> bool:
        """Return whether the launch files that MoveIt makes give the file to ros2_control, by its usual name."""
        return name == CONTROLLERS and any(MOVEIT in text for text in self.launch_texts)

    @cached_property
    def is_resolved(self) -> bool:
        """Whether a launch file has aliases of this file written out: RewrittenYaml, which nav2_bringup uses, does."""
        return is_written_out(self.file.path.rpartition("/")[2], self.launch_texts)

    def is_rewritten(self, span: Span) -> bool:
        """Return whether a launch file may give the parameter at a place another value (RewrittenYaml)."""
        return is_replaced(self.file.source.slice(span), self.launch_texts)

    @cached_property
    def launch_texts(self) -> tuple[str, ...]:
        """What the launch files of the package do, without comments and unused actions."""
        paths = (path for path in self.files.paths if LAUNCH.fullmatch(path.rpartition("/")[2]))
        return tuple(map(self.read, paths))

    @property
    def is_left_out(self) -> bool:
        """Whether the package is known not to install the file."""
        return self.package.knows("share_files") and self.file.path not in self.package.share_files

    def read(self, path: str) -> str:
        is_launch = LAUNCH.fullmatch(path.rpartition("/")[2]) is not None
        return live_text(self.files, path) if is_launch else self.files.readable_text(path)


@dataclass(frozen=True)
class ParameterFileUses:
    """The same for any file of a package."""

    workspace: Workspace
    package: PackageFacts
    files: PackageFiles
    table: InstallTable | None

    def of(self, file: ParameterFile) -> ParameterFileUse:
        return ParameterFileUse(file, self.workspace, self.package, self.files, self.table)


def is_in_python(package: str, executable: str, workspace: Workspace) -> bool:
    """Return whether a node is in Python, by the name of its program or by its package."""
    facts = workspace.named(package)
    if executable.endswith(".py") or (facts is not None and facts.build_type == "ament_python"):
        return True
    return facts is None and is_python_package(package)
