"""Which programs of a package a source is of, as far as CMake or the names of files show."""

from __future__ import annotations

import posixpath
from collections.abc import Iterator

from ...package.package_facts import PackageFacts


def is_of_another(name: str, program: str | None, facts: PackageFacts) -> bool:
    """Return whether only code of other programs of a package declares a parameter, as far as that is known."""
    declaring = [set(programs_of(path, facts)) for path in {one.path for one in facts.parameters if one.name == name}]
    return bool(program) and bool(declaring) and all(each and program not in each for each in declaring)


def programs_of(path: str, facts: PackageFacts) -> Iterator[str]:
    """Yield the programs and components that a source is of: CMake makes them of it, or they are called like it."""
    yield from (code.starts for code in facts.node_code if path in code.paths)
    yield from (each for each in (*facts.executables, *facts.components) if is_of(path, each))


def is_of(path: str, program: str | None) -> bool:
    """Return whether a source is called like the program, whose sources are not known."""
    if not program or (program.endswith(".py") and not path.endswith(".py")):
        return False
    stem, name = posixpath.splitext(posixpath.basename(path))[0], program.rpartition("::")[2].removesuffix(".py")
    plain, own = (each.replace("_", "").lower().removesuffix("node") for each in (stem, name))
    return plain == own
