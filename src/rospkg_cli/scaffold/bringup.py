"""What a package that starts a robot starts: launch files and nodes of other packages."""

from __future__ import annotations

import re

from ..light_dataclasses import dataclass, replace
from ..ros.manifest import PACKAGE_NAME
from ..suggest import did_you_mean
from . import ScaffoldError
from .workspace import Neighbour, WorkspacePackages

PROGRAM = re.compile(r"[A-Za-z0-9_][A-Za-z0-9_.+-]*")
NODE_NAME = re.compile(r"[A-Za-z_][A-Za-z0-9_]*")

FORWARDED_ARGUMENTS = {
    "namespace": ("", "Namespace of every node"),
    "log_level": ("info", "debug, info, warn, error or fatal"),
    "use_sim_time": ("false", "Whether time comes from the topic /clock, as in a simulation"),
}
"""The arguments that launch files written here have, with default and meaning; they are handed on to those that have
them too."""

PARAMS_FILE = ("config/params.yaml", "YAML file with parameters")


@dataclass(frozen=True)
class StartedNode:
    """A node of another package."""

    package: str
    executable: str
    name: str


@dataclass(frozen=True)
class IncludedLaunchFile:
    """A launch file of another package."""

    package: str
    file: str
    """Below `launch/`."""
    arguments: tuple[str, ...] = ()
    """Those of PASSED_ON that it has."""
    params: str = ""
    """The parameters that it would start with: the text of a YAML file."""


@dataclass(frozen=True)
class Bringup:
    starts: tuple[StartedNode, ...] = ()
    includes: tuple[IncludedLaunchFile, ...] = ()
    unknown: tuple[str, ...] = ()
    """Packages of which nothing could be started, each with the reason."""
    params: bool = True
    """Whether what it starts has parameters of its own choice."""

    @property
    def arguments(self) -> dict[str, tuple[str, str]]:
        """The arguments that the launch file has, with default and meaning."""
        used = {name for include in self.includes for name in include.arguments}
        shown = {name: about for name, about in FORWARDED_ARGUMENTS.items() if self.starts or name in used}
        return {**shown, **({"params_file": PARAMS_FILE} if self.starts and self.params else {})}

    @property
    def packages(self) -> tuple[str, ...]:
        found = [*(include.package for include in self.includes), *(start.package for start in self.starts)]
        return tuple(dict.fromkeys(found))


def bringup_of(
    name: str, asked: tuple[str, ...], depends: tuple[str, ...], there: WorkspacePackages, params: bool = True
) -> Bringup:
    """Return what a package starts: the nodes that are asked for as PACKAGE/EXECUTABLE, and what dependencies offer.

    Where nothing is asked for, the packages around that are named after the same robot are its dependencies.
    """
    robot = name.removesuffix("_bringup")
    if not asked and not depends:
        depends = tuple(each for each in (robot, f"{robot}_description") if each != name and there.named(each))
    named = [started_node(text, there) for text in asked]
    if any(start.package == name for start in named):
        raise ScaffoldError(f"`{name}` has no executables: it starts those of others; give --node PACKAGE/EXECUTABLE")
    offered = [offered_by(package, there) for package in depends if package not in {start.package for start in named}]
    starts = [*named, *(start for each in offered for start in each.starts)]
    names = [start.name for start in starts]
    for twice in names:
        if names.count(twice) > 1:
            raise ScaffoldError(f"two nodes would be called `{twice}`; name one: --node PACKAGE/EXECUTABLE:NAME")
    return Bringup(
        tuple(starts),
        tuple(include if params else replace(include, params="") for each in offered for include in each.includes),
        tuple(reason for each in offered for reason in each.unknown),
        params,
    )


def started_node(text: str, there: WorkspacePackages) -> StartedNode:
    """Return a node from `PACKAGE/EXECUTABLE` or `PACKAGE/EXECUTABLE:NAME`."""
    program, colon, name = text.partition(":")
    package, slash, executable = program.partition("/")
    if not slash or not PACKAGE_NAME.fullmatch(package) or not PROGRAM.fullmatch(executable):
        raise ScaffoldError(
            f"`{text}`: a package of this type starts nodes of others, so a node is PACKAGE/EXECUTABLE, "
            "as demo_nodes_cpp/talker; one of its own belongs into a package of its own"
        )
    name = name if colon else re.sub(r"\W", "_", executable.partition(".")[0])
    if not NODE_NAME.fullmatch(name):
        raise ScaffoldError(f"`{name}` can't be the name of a node: letters, digits and underscores, no digit first")
    neighbour = there.named(package)
    if neighbour and neighbour.facts.knows("executables") and executable not in neighbour.facts.executables:
        known = sorted(neighbour.facts.executables)
        hint = did_you_mean(executable, known)
        raise ScaffoldError(f"`{package}` has no executable `{executable}`{hint}; it has {', '.join(known) or 'none'}")
    return StartedNode(package, executable, name)


def offered_by(package: str, there: WorkspacePackages) -> Bringup:
    """Return what a package offers to be started: its launch file, else all its nodes."""
    neighbour = there.named(package)
    if neighbour is None:
        return Bringup(
            unknown=(f"`{package}` is not in this workspace: --node {package}/EXECUTABLE starts a node of it",)
        )
    files = neighbour.launch_files
    own = [name for name in files if name.partition(".")[0] == package] or (list(files) if len(files) == 1 else [])
    if own:
        return Bringup(includes=(included_launch_file(package, own[0], files[own[0]], neighbour),))
    if files:
        reason = f"`{package}` has several launch files ({', '.join(files)}): include the one that you mean"
        return Bringup(unknown=(reason,))
    found = sorted(neighbour.facts.executables)
    if "interfaces" not in neighbour.facts.unknown and neighbour.facts.interfaces and not found:
        return Bringup()
    if not found:
        return Bringup(unknown=(f"`{package}` has neither launch files nor executables",))
    return Bringup(tuple(started_node(f"{package}/{name}", there) for name in found))


def included_launch_file(
    package: str, file: str, arguments: frozenset[str], neighbour: Neighbour
) -> IncludedLaunchFile:
    passed = tuple(name for name in FORWARDED_ARGUMENTS if name in arguments)
    params = neighbour.text("config/params.yaml").rstrip() if "params_file" in arguments else ""
    return IncludedLaunchFile(package, file, passed, params + "\n" if params else "")
