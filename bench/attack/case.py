"""One hostile input: what it is made of follows from the seed and its number alone."""

from __future__ import annotations

import random
import shutil
from dataclasses import dataclass
from pathlib import Path

from .corpus import Corpus, Files, reduced
from .kinds import KINDS, NEW_PATH, SPARE
from .texts import LIMIT, MUTATIONS, retype
from .trees import ODDITIES, OUTSIDE


@dataclass(frozen=True)
class Case:
    number: int
    kind: str
    package: str
    path: str
    """The damaged file."""
    mutations: tuple[str, ...]
    files: Files
    oddities: tuple[int, ...]
    """Places in ODDITIES of what is put into the tree."""
    seed: str
    unsafe: bool
    """Whether unsafe fixes are asked for, too."""

    @property
    def how(self) -> str:
        """Return what was done to the package, in one line."""
        done = [*self.mutations, *(ODDITIES[each].__name__ for each in self.oddities)]
        return f"{self.package}/{self.path}: {', '.join(done)}"


def make_case(corpus: Corpus, seed: int, number: int) -> Case:
    """Return the input of a number."""
    chance = random.Random(f"{seed}:{number}")
    kind = KINDS[number % len(KINDS)]
    if kind not in corpus.places and kind not in SPARE:
        kind = "tree"
    places = corpus.places.get(kind, [])
    if kind == "tree":
        package = chance.choice(sorted(corpus.packages))
        return Case(
            number, kind, package, "", (), *around(corpus, package, "", chance, 1.0), f"{seed}:{number}:tree", True
        )
    if places and (kind not in SPARE or chance.random() < 0.8):
        package, path = chance.choice(places)
        data = corpus.packages[package][path]
    else:
        package, path = chance.choice(sorted(corpus.packages)), NEW_PATH[kind]
        data = SPARE[kind]
    files, oddities = around(corpus, package, path, chance, 0.1)
    others, names = corpus.texts(kind), []
    for _ in range(chance.choice((1, 1, 1, 2, 3))):
        mutation = retype if kind == "config" and chance.random() < 0.7 else chance.choice(MUTATIONS)
        data = mutation(data, kind, others, chance)[:LIMIT]
        names.append(mutation.__name__)
    files[path] = data
    return Case(
        number, kind, package, path, tuple(names), files, oddities, f"{seed}:{number}:tree", chance.random() < 0.5
    )


def around(corpus: Corpus, package: str, path: str, chance: random.Random, odd: float) -> tuple[Files, tuple[int, ...]]:
    """Return the package around the damage, and which oddities its tree gets (with a probability of `odd`)."""
    files = reduced(corpus.packages[package], path, chance)
    count = chance.choice((1, 1, 2, 3)) if chance.random() < odd else 0
    return files, tuple(chance.randrange(len(ODDITIES)) for _ in range(count))


def write_case(case: Case, folder: Path) -> Path:
    """Write the input below a new folder, beside files that nobody may show or change; return the package."""
    for name, text in OUTSIDE.items():
        (folder / "outside" / name).parent.mkdir(parents=True, exist_ok=True)
        (folder / "outside" / name).write_text(text)
    package = folder / "ws" / "pkg"
    for path, data in case.files.items():
        at = package / path
        if not at.parent.is_dir():
            at.parent.mkdir(parents=True)
        at.write_bytes(data)
    chance = random.Random(case.seed)
    for each in case.oddities:
        ODDITIES[each](package, chance)
    return package


def remove(folder: Path) -> None:
    """Remove a folder of an input."""
    shutil.rmtree(folder, ignore_errors=True)
