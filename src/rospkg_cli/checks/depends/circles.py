"""Packages of the workspace that need this one already, declared or not: to declare them here would make a circle.

colcon orders packages by all that they declare, and stops where they wait for each other (`dependency_cycles`).
"""

from __future__ import annotations

from collections import deque
from collections.abc import Mapping

from ...light_dataclasses import dataclass
from ...package.package_facts import PackageFacts
from ...package.workspace import Workspace
from ...ros.manifest import NOT_ORDERED
from ..launch.example_files import is_example
from .declared_dependencies import DeclaredDependencies

MOVE = "move what needs it to a package above both"
MOVE_FILE = "move one of the two files to a package above both"


@dataclass(frozen=True, slots=True)
class Circle:
    """A package that needs this one, and the launch file, robot or look-up that does; "" for code and package.xml."""

    by: str
    path: str

    def why(self, name: str) -> str:
        """Return why a package is not to be declared here, as a clause that says what to do."""
        way = "" if name == self.by else f" by way of `{self.by}`"
        where, todo = (f" in `{self.path}`", MOVE_FILE) if self.path else ("", MOVE)
        return f"to declare it would make a circle, for `{name}` needs this package{way}{where}: {todo}"


def circle_with(declared: DeclaredDependencies, name: str) -> Circle | None:
    """Return what would close a circle if a package of the workspace were declared here, by the shortest way.

    What code here is built with or imports comes first: others are to move the launch files that use this package.
    """
    workspace, own = declared.workspace, declared.facts
    if workspace.named(name) is None:
        return None
    is_for_code = name in code_needs(own)
    known, seen, waiting = workspace.index_of(Needs), {name}, deque([name])
    while waiting:
        facts = workspace.named(waiting.popleft())
        needs = known.of(facts, workspace) if facts is not None else {}
        needs = {each: path for each, path in needs.items() if not (path and is_for_code)}
        if facts is not None and own.name in needs:
            return Circle(facts.name, needs[own.name])
        waiting += (each for each in needs if each not in seen)
        seen.update(needs)
    return None


class Needs(dict[str, Mapping[str, str]]):
    """The packages of the workspace that each package needs, by its name, with the file that `Circle` names."""

    def of(self, facts: PackageFacts, workspace: Workspace) -> Mapping[str, str]:
        if facts.name not in self:
            self[facts.name] = needs_of(facts, workspace)
        return self[facts.name]


def needs_of(facts: PackageFacts, workspace: Workspace) -> dict[str, str]:
    """Return what a package declares, and what it uses and may declare: nothing that waits for it already."""
    aside = facts.uninstalled if facts.used_packages and facts.knows("share_files") else frozenset[str]()
    places = (each for each in sorted(facts.used_packages, reverse=True) if each[1] not in aside)
    used = {name: path for name, path in places if name in workspace.names and not is_example(path)}
    used = {name: path for name, path in used.items() if not waits_for(name, facts.name, workspace)}
    every = used | dict.fromkeys(code_needs(facts) | declared_by(facts), "")
    return {name: path for name, path in every.items() if name in workspace.names and name != facts.name}


def declared_by(facts: PackageFacts) -> set[str]:
    return {need.name for need in facts.dependencies if need.tag not in NOT_ORDERED}


def waits_for(name: str, other: str, workspace: Workspace) -> bool:
    """Return whether colcon builds a package after another one, by what is declared."""
    seen, waiting = {name}, [name]
    while waiting:
        facts = workspace.named(waiting.pop())
        needs = declared_by(facts) - seen if facts is not None else set[str]()
        if other in needs:
            return True
        seen |= needs
        waiting += needs
    return False


def code_needs(facts: PackageFacts) -> frozenset[str]:
    """Return what a package imports, includes, generates interfaces with and looks for by CMake, as far as it says."""
    modules = {module.partition(".")[0] for module, _ in facts.taken_names}
    headers = {header.partition("/")[0] for header in facts.included_headers}
    return facts.typed_with | facts.sought_packages | modules | headers
