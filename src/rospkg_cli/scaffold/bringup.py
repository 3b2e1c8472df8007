"""What a package that starts a robot starts: launch files and nodes of other packages."""

from __future__ import annotations

import re
from dataclasses import dataclass, replace

from ..ros.manifest import PACKAGE_NAME
from ..suggest import did_you_mean
from . import ScaffoldError
from .workspace import Around, Neighbour

PROGRAM = re.compile(r"[A-Za-z0-9_][A-Za-z0-9_.+-]*")
NODE_NAME = re.compile(r"[A-Za-z_][A-Za-z0-9_]*")

PASSED_ON = {
    "namespace": ("", "Namespace of every node"),
    "log_level": ("info", "debug, info, warn, error or fatal"),
    "use_sim_time": ("false", "Whether time comes from the topic /clock, as in a simulation"),
}
"""The arguments that launch files written here have, with default and meaning; they are handed on to those that have
them too."""

PARAMS_FILE = ("config/params.yaml", "YAML file with parameters")


@dataclass(frozen=True)
class Start:
    """A node of another package."""

    package: str
    executable: str
    name: str


@dataclass(frozen=True)
class Include:
    """A launch file of another package."""

    package: str
    file: str
    """Below `launch/`."""
    arguments: tuple[str, ...] = ()
    """Those of PASSED_ON that it has."""
    params: str = ""
    """The parameters that it would start with: the text of a YAML file."""


@dataclass(frozen=True)
class Started:
    starts: tuple[Start, ...] = ()
    includes: tuple[Include, ...] = ()
    unknown: tuple[str, ...] = ()
    """Packages of which nothing could be started, each with the reason."""
    params: bool = True
    """Whether what it starts has parameters of its own choice."""

    @property
    def arguments(self) -> dict[str, tuple[str, str]]:
        """The arguments that the launch file has, with default and meaning."""
        used = {name for include in self.includes for name in include.arguments}
        shown = {name: about for name, about in PASSED_ON.items() if self.starts or name in used}
        return {**shown, **({"params_file": PARAMS_FILE} if self.starts and self.params else {})}

    @property
    def packages(self) -> tuple[str, ...]:
        found = [*(include.package for include in self.includes), *(start.package for start in self.starts)]
        return tuple(dict.fromkeys(found))


def started_by(
    name: str, asked: tuple[str, ...], depends: tuple[str, ...], there: Around, params: bool = True
) -> Started:
    """Return what a package starts: the nodes that are asked for as PACKAGE/EXECUTABLE, and what dependencies offer.

    Where nothing is asked for, the packages around that are named after the same robot are its dependencies.
    """
    robot = name.removesuffix("_bringup")
    if not asked and not depends:
        depends = tuple(each for each in (robot, f"{robot}_description") if each != name and there.named(each))
    named = [start_of(text, there) for text in asked]
    if any(start.package == name for start in named):
        raise ScaffoldError(f"`{name}` has no executables: it starts those of others; give --node PACKAGE/EXECUTABLE")
    offered = [offer(package, there) for package in depends if package not in {start.package for start in named}]
    starts = [*named, *(start for each in offered for start in each.starts)]
    names = [start.name for start in starts]
    for twice in names:
        if names.count(twice) > 1:
            raise ScaffoldError(f"two nodes would be called `{twice}`; name one: --node PACKAGE/EXECUTABLE:NAME")
    return Started(
        tuple(starts),
        tuple(include if params else replace(include, params="") for each in offered for include in each.includes),
        tuple(reason for each in offered for reason in each.unknown),
        params,
    )


def start_of(text: str, there: Around) -> Start:
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
    return Start(package, executable, name)


def offer(package: str, there: Around) -> Started:
    """Return what a package offers to be started: its launch file, else all its nodes."""
    neighbour = there.named(package)
    if neighbour is None:
        return Started(
            unknown=(f"`{package}` is not in this workspace: --node {package}/EXECUTABLE starts a node of it",)
        )
    files = neighbour.launch_files
    own = [name for name in files if name.partition(".")[0] == package] or (list(files) if len(files) == 1 else [])
    if own:
        return Started(includes=(include_of(package, own[0], files[own[0]], neighbour),))
    if files:
        reason = f"`{package}` has several launch files ({', '.join(files)}): include the one that you mean"
        return Started(unknown=(reason,))
    found = sorted(neighbour.facts.executables)
    if "interfaces" not in neighbour.facts.unknown and neighbour.facts.interfaces and not found:
        return Started()
    if not found:
        return Started(unknown=(f"`{package}` has neither launch files nor executables",))
    return Started(tuple(start_of(f"{package}/{name}", there) for name in found))


def include_of(package: str, file: str, arguments: frozenset[str], neighbour: Neighbour) -> Include:
    passed = tuple(name for name in PASSED_ON if name in arguments)
    params = neighbour.text("config/params.yaml").rstrip() if "params_file" in arguments else ""
    return Include(package, file, passed, params + "\n" if params else "")
