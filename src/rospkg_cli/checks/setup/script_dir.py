"""Rule input: where the executables of a package go."""

from __future__ import annotations

import ast
from functools import cached_property

from ...languages.python.evaluate.values import Mapping
from ...languages.python.nodes import nodes_of_kind
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.setup.entry_point import EntryPoint
from ...package.setup.setup_cfg import SetupCfg
from ...package.setup.setup_py import SetupPy
from ...package.setup.setup_text import SetupText
from ...package.workspace import Workspace
from ..repository.linked_build import linking_file
from .python_package import PythonPackage

SCRIPT_OPTIONS = (("develop", "script_dir"), ("install", "install_scripts"))
BELOW_BASE = regex(r"\$(?:base|\{base\})/(?P<folder>[^/$%]+|lib/[^/$%]+|share/[^$%]+?)/*")
TOOLS = "bin"
LINKS = frozenset({"symlink", "symlink_to", "link", "hardlink_to"})
"""Functions of `os` and methods of `pathlib.Path` that make links."""
COMMANDS = frozenset({"develop", "editable_wheel", "install", "install_scripts", "easy_install"})
"""The commands of setuptools that decide where scripts go."""


@dataclass(frozen=True)
class ScriptDir:
    """Where the executables of a package go."""

    package: PythonPackage
    cfg: SetupCfg | None
    workspace: Workspace

    @property
    def is_configured(self) -> bool:
        """Whether something else than setuptools may choose the folder: setup.cfg, or `options` of setup()."""
        has_file = self.cfg is not None or self.package.files.exists("setup.cfg")
        return has_file or self.package.setup.argument("options") is not None

    @cached_property
    def executables(self) -> tuple[EntryPoint, ...]:
        """Those that are found only where setuptools puts them: `data_files` has no script of their name in lib/."""
        return tuple(each for each in self.package.executables if each.name not in self.scripts_in_lib)

    @cached_property
    def scripts_in_lib(self) -> frozenset[str]:
        """What `data_files` puts into lib/<package>, and who runs the package may execute."""
        files, prefix = self.package.files, f"lib/{self.package.name}/"
        there = (each for each in self.package.setup.data_files if each.destination.startswith(prefix))
        run = (each for each in there if each.source is not None and files.is_executable(each.source))
        return frozenset(each.destination.removeprefix(prefix) for each in run)

    @cached_property
    def nodes(self) -> tuple[EntryPoint, ...]:
        """The executables that run a node, and those that a launch file of the workspace starts."""
        named = (each for each in self.executables if self.is_started(each))
        nodes = (each for each in self.package.nodes if each in self.executables)
        return tuple(dict.fromkeys((*nodes, *named)))

    @cached_property
    def wrong(self) -> tuple[tuple[str, str, SetupText | None], ...]:
        """The options that install nodes outside of lib/<package>: section, key, value; None where it is missing.

        A value outside of `$base`, or deeper in it, is taken to be intended, but for `share/…`, where no program is
        looked for; so is the package name of setup.py, and `bin` for tools that are no nodes.
        """
        found: list[tuple[str, str, SetupText | None]] = []
        name = self.package.setup.setup_text("name")
        right = {f"lib/{self.package.name}", f"lib/{name.text}" if name else ""}
        values = {key: self.folder(section, key) for section, key in SCRIPT_OPTIONS}
        is_moved = moves_scripts(self.package.setup)
        is_for_tools = not (self.has_nodes_in_lib or right & set(values.values()))
        is_for_lib = bool(self.nodes) or bool(right & set(values.values()))
        right |= {TOOLS} if is_for_tools or is_moved else set()
        for section, key in SCRIPT_OPTIONS if self.cfg is not None and self.executables else ():
            option = self.cfg.get(section, key) if self.cfg else None
            folder = values[key]
            if option is None and is_for_lib and not is_moved and self.package.setup.argument("options") is None:
                found.append((section, key, None))
            elif option is not None and folder is not None and folder not in right:
                found.append((section, key, option.value))
        return tuple(found)

    @cached_property
    def when(self) -> str:
        """With which builds executables go elsewhere, as words; "" for all, as far as is known."""
        sections = {section for section, _, _ in self.wrong}
        if sections == {"develop"}:
            return " with `--symlink-install`"
        links = sections == {"install"} and linking_file(self.package.files)
        return f" except with `--symlink-install` (`{links}`)" if links else ""

    def folder(self, section: str, key: str) -> str | None:
        """Return the folder below the prefix that an option names; None where it is none, or is unknown."""
        option = self.cfg.get(section, key) if self.cfg else None
        match = BELOW_BASE.fullmatch(option.value.text) if option else None
        return match["folder"] if match else None

    @cached_property
    def has_nodes_in_lib(self) -> bool:
        """Whether a launch file of the workspace looks in lib/<package> for one of the executables."""
        return any(map(self.is_started, self.executables))

    def is_started(self, entry: EntryPoint) -> bool:
        return bool(self.workspace.having("started_nodes", self.package.name, entry.name))


def moves_scripts(setup: SetupPy) -> bool:
    """Return whether setup.py puts scripts in their place itself: with links, or a command of its own to install."""
    if any(
        isinstance(node.func, ast.Attribute) and node.func.attr in LINKS
        for node in nodes_of_kind(setup.file.tree, ast.Call)
    ):
        return True
    commands = setup.value("cmdclass")
    if not isinstance(commands, Mapping):
        return commands is not None
    return any(str(key) in COMMANDS for key in commands.items)
