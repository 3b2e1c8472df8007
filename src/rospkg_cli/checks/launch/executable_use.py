"""What a launch file starts under a name: an executable of the workspace, or one of a well-known package."""

from __future__ import annotations

import posixpath

from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.launch.text import LaunchText
from ...package.package_facts import PackageFacts
from ...ros.well_known import WrongName
from ...source import Span
from ...suggest import nearest
from ..fault import Level
from ..paths.closest_path import is_like

PROGRAM = regex(r"[^.]+(\.(py|sh|bash|pl|rb|js))?")


@dataclass(frozen=True, slots=True)
class ExecutableUse:
    """A node whose package is one of the workspace and whose executable is literal."""

    path: str
    span: Span
    """Of the executable."""
    executable: str
    plain: bool
    """Whether the span holds the name and nothing else."""
    facts: PackageFacts
    level: Level | None = None
    """None for the rule's own."""
    why: str = ""
    """Of another level: part of a sentence."""
    sister: str = ""
    """Another package that installs one of this name."""
    entry: str = ""
    """The executable whose entry point is a function of the module of this name."""
    is_command: bool = False
    """Whether `ros2 run` starts it, which looks into folders of lib/<package> as well."""

    @property
    def ends(self) -> str:
        """What happens: part of a sentence."""
        if self.is_command:
            return 'the process ends with "No executable found"'
        return f"the launch stops with \"executable '{self.executable}' not found on the libexec directory\""

    @property
    def suggestion(self) -> str | None:
        """The executable of its module, else the only similar one, or the only one with more or fewer words."""
        if self.entry:
            return self.entry
        names = self.startable
        if near := nearest(self.executable, {name for name in names if is_like(self.executable, name)}):
            return near
        words = set(self.executable.split("_"))
        renamed = [name for name in names if words <= (other := set(name.split("_"))) or other <= words]
        return renamed[0] if len(renamed) == 1 else None

    @property
    def startable(self) -> frozenset[str]:
        """The executables of the package, but for those in folders of lib/<package>, where launch doesn't look."""
        return frozenset(name for name in self.facts.executables if "/" not in name)

    @property
    def programs(self) -> list[str]:
        """Those to offer: no libraries, and no data that was installed next to the programs."""
        return sorted(filter(PROGRAM.fullmatch, self.startable))

    @property
    def in_folder(self) -> str:
        """The executable of this name in a folder of lib/<package>; "" for none."""
        name = posixpath.basename(self.executable)
        paths = sorted(each for each in self.facts.executables - self.startable if posixpath.basename(each) == name)
        return paths[0] if paths else ""


@dataclass(frozen=True, slots=True)
class WellKnownUse:
    """A node of a well-known package that has no executable of this name."""

    package: str
    executable: LaunchText
    name: str
    wrong: WrongName
    level: Level | None
    why: str
    plain: bool
    """Whether the text is the name and nothing else."""
