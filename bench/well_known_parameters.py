"""Write the table of the parameters of well-known packages (well_known_parameters.txt in ros/tables).

    python -m bench.well_known_parameters FOLDER

FOLDER holds bare mirrors, `owner+name/repo` each.  Of every repository the branches of the supported distributions and
the newest one are read as `rospkg lint` reads a workspace.  A type is written where all branches agree on it.  What
older releases on a branch declare otherwise, or a branch in a loop, which is not seen, is in changed_parameters.txt.
"""

from __future__ import annotations

import sys
from collections.abc import Iterator
from pathlib import Path

from bench.tables import Origin, write
from bench.well_known import branches, facts_in, mirrored
from bench.well_known_renames import REPOSITORIES
from rospkg_cli.package.package_facts import PackageFacts
from rospkg_cli.package.params.declared_parameter import DeclaredParameter, type_named

TABLE = "well_known_parameters.txt"
ABOUT = {
    TABLE: "Parameters that well-known packages declare in the supported distributions: package, then each name, with "
    "its type behind `:` where all declarations of it agree (b bool, d double, i int, s string, `[]` a list). Behind "
    "`*` stands what follows a part that is known at run time only. [removed]: names that only older distributions "
    "have, from Dashing on."
}
ORIGIN = Origin(
    "calls that declare parameters and definitions for generate_parameter_library in the repositories that "
    "bench/well_known_renames.py lists, their branches from Dashing on",
    "Apache-2.0, BSD-2-Clause, BSD-3-Clause, EPL-2.0, LGPL-2.1, LGPL-3.0, MIT",
    "bench/well_known_parameters.py",
)
LONGEST = 60
ASIDE = ("demo", "example", "tutorial", "test", "composition", "lifecycle", "quality_of_service")
"""Words in the names of packages whose nodes nobody gives parameters to."""
Names = dict[tuple[str, bool], set[str]]
"""The types of a parameter, by its name and whether only the end of it is known; "" for one that is unknown."""


def main(folder: Path) -> None:
    found: dict[str, Names] = {}
    before: dict[str, Names] = {}
    mirrors, revision = mirrored(folder, REPOSITORIES)
    for mirror in mirrors:
        for branch, is_current in branches(mirror):
            for facts in facts_in(mirror, branch):
                if not any(word in facts.name for word in ASIDE):
                    add((found if is_current else before).setdefault(facts.name, {}), facts)
    removed = {name: gone(names, found[name]) for name, names in before.items() if name in found}
    write(TABLE, ABOUT[TABLE], [*rows(found), "[removed]", *rows(removed)], ORIGIN, revision)


def gone(before: Names, now: Names) -> Names:
    """Return the names that only older distributions have, without types."""
    return {name: set() for name in before if not any(name[0].strip(".") == other[0].strip(".") for other in now)}


def add(names: Names, facts: PackageFacts) -> None:
    """Add what a package declares on one branch."""
    for each in facts.parameters:
        if is_plain(each):
            same = [one for one in facts.parameters if (one.name, one.tail) == (each.name, each.tail)]
            names.setdefault((each.name, each.tail), set()).add(type_named(same, each.name))


def is_plain(each: DeclaredParameter) -> bool:
    return len(each.name) <= LONGEST and not any(sign in each.name for sign in " :*")


def rows(found: dict[str, Names]) -> Iterator[str]:
    for package, names in sorted(found.items()):
        if names:
            yield " ".join([package, *sorted(word(name, tail, types) for (name, tail), types in names.items())])


def word(name: str, tail: bool, types: set[str]) -> str:
    known = types - {""}
    only = known.pop() if len(known) == 1 else ""
    kind = f":{only[0]}{'[]' if only.endswith('[]') else ''}" if only else ""
    return f"{'*' if tail else ''}{name}{kind}"


if __name__ == "__main__":
    main(Path(sys.argv[1]))
