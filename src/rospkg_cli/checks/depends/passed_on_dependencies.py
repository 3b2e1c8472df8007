"""What is installed with one package: its own dependencies to run and to build against, by manifest or table."""

from __future__ import annotations

from functools import cache

from ...light_dataclasses import dataclass
from ...package.workspace import Workspace
from ...ros.manifest import EXPORTED, RUNS
from ...ros.read_table import rows

PASSED_ON = RUNS | EXPORTED
"""Tags whose packages are installed with the one that declares them: bloom writes them to Depends of Debian."""

RUNTIME, EXPORTS, DEBIAN = "runtime_dependencies.txt", "exported_dependencies.txt", "debian_dependencies.txt"

PERHAPS = "?"
"""Begins a name in the table that comes with a package on some distributions only."""


@dataclass(frozen=True, slots=True)
class PassedOn:
    """What is installed with one package, for certain and perhaps, and whether that is known."""

    certain: tuple[str, ...]
    perhaps: tuple[str, ...]
    is_known: bool


class PassedOnIndex(dict[str, PassedOn]):
    """What is installed with each package, by its name; kept because most packages of a workspace ask for the same."""

    def of(self, name: str, workspace: Workspace) -> PassedOn:
        if name not in self:
            self[name] = found_passed_on(name, workspace)
        return self[name]


def found_passed_on(name: str, workspace: Workspace) -> PassedOn:
    facts = workspace.named(name)
    if facts is not None:
        needs = [need for need in facts.dependencies if need.tag in PASSED_ON]
        certain = (*(need.name for need in needs if need.certain), *sorted(facts.typed_with))
        return PassedOn(certain, tuple(need.name for need in needs if not need.certain), facts.knows("dependencies"))
    row = table_needs(name)
    perhaps = tuple(need[1:] for need in row if need[0] == PERHAPS)
    return PassedOn(tuple(need for need in row if need[0] != PERHAPS), perhaps, is_in_table(name))


@cache
def table_needs(name: str) -> tuple[str, ...]:
    """Return the row of the first table that knows a name."""
    return next((rows(table)[name] for table in (RUNTIME, EXPORTS, DEBIAN) if name in rows(table)), ())


def is_in_table(name: str) -> bool:
    return any(name in rows(table) for table in (RUNTIME, EXPORTS, DEBIAN))
