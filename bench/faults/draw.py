"""Which faults are tried: of every kind so many, each in another package, of as many repositories as there are."""

from __future__ import annotations

import random
from collections.abc import Iterator, Sequence
from itertools import islice

from bench.faults.fault import PutFault
from bench.faults.kinds import FaultKind
from bench.faults.source_package import SourcePackage

MOST = 200
"""So many places are looked at in one package."""
NOT_BUILT = "colcon builds the package by its setup.py, and nobody runs its CMakeLists.txt"


def draw(
    kind: FaultKind, packages: Sequence[SourcePackage], count: int, seed: int
) -> Iterator[tuple[SourcePackage, PutFault]]:
    """Yield packages, each with a fault of a kind; the same for the same seed and packages."""
    chance, drawn = random.Random(f"{seed} {kind.name}"), 0
    ordered = in_rounds(packages, random.Random(seed))
    start = chance.randrange(len({each.repository for each in packages}))
    for package in ordered[start:] + ordered[:start]:
        if drawn == count:
            return
        places = [each for each in islice(kind.places(package), MOST) if changes(package, each)]
        places = [each.known(is_built(package, each), NOT_BUILT) for each in places]
        if places:
            drawn += 1
            yield package, chance.choice(places)


def in_rounds(packages: Sequence[SourcePackage], chance: random.Random) -> list[SourcePackage]:
    """Return the packages shuffled: one of each repository, then a second one of each, and so on.

    All kinds share the order and begin at different places in it, so that packages come again, whose lint is known.
    """
    shuffled = list(packages)
    chance.shuffle(shuffled)
    seen: dict[object, int] = {}
    rounds = []
    for package in shuffled:
        seen[package.repository] = seen.get(package.repository, 0) + 1
        rounds.append((seen[package.repository], package))
    return [package for _, package in sorted(rounds, key=lambda each: each[0])]


def is_built(package: SourcePackage, fault: PutFault) -> bool:
    """Return whether anything runs the file at fault, if it is one of CMake."""
    return not (package.is_python and fault.path.endswith("CMakeLists.txt"))


def changes(package: SourcePackage, fault: PutFault) -> bool:
    """Return whether a fault is another state of the files than there is."""
    for path, data in fault.files.items():
        there = package.repository / path
        if path in fault.not_executable:
            if there.stat().st_mode & 0o111:
                return True
        elif data != (there.read_bytes() if there.is_file() else None):
            return True
    return False
