"""Rule input: where the executables of a package go."""

from __future__ import annotations

from functools import cached_property

from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.setup.entry_points import EntryPoint
from ...package.setup.setup_cfg import SetupCfg
from ...package.setup.setup_text import SetupText
from ...package.workspace import Workspace
from .python_package import PythonPackage

SCRIPT_OPTIONS = (("develop", "script_dir"), ("install", "install_scripts"))
ELSEWHERE = regex(r"\$(?:base|\{base\})/lib/(?P<name>[^/$]+)/*")


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
    def nodes(self) -> tuple[EntryPoint, ...]:
        """The executables that run a node, and those that a launch file of the workspace starts."""
        started = {pair for facts in self.workspace.packages for pair in facts.started_nodes}
        named = (e for e in self.package.executables if (self.package.name, e.name) in started)
        return tuple(dict.fromkeys((*self.package.nodes, *named)))

    @cached_property
    def wrong(self) -> tuple[tuple[str, str, SetupText | None], ...]:
        """The options that install nodes outside of lib/<package>: section, key, value; None where it is missing.

        A value that is no folder below lib/ is taken to be intended; so is the package name of setup.py.
        """
        found: list[tuple[str, str, SetupText | None]] = []
        own = {self.package.name, name.text if (name := self.package.setup.setup_text("name")) else ""}
        for section, key in SCRIPT_OPTIONS if self.cfg is not None and self.package.executables else ():
            option = self.cfg.get(section, key) if self.cfg else None
            match = ELSEWHERE.fullmatch(option.value.text) if option else None
            if option is None and self.nodes and self.package.setup.argument("options") is None:
                found.append((section, key, None))
            elif option is not None and match is not None and match["name"] not in own:
                found.append((section, key, option.value))
        return tuple(found)
