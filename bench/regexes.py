"""How the time of every regular expression of rospkg grows with hostile text.

Imports all modules of the package, takes each pattern that a module holds, and drives it with texts of 2,000, 8,000 and
32,000 characters: what the pattern mentions (each literal, one character of each class, pairs of these, and the
shortest text that it fits), again and again, with and without an end that makes a match fail. Prints the patterns
whose time grows faster than 1.5 times linearly, the worst text of each, and the seconds. A pattern that only sees
short texts may stand in the table: whether the code bounds what it gets, this does not know.

    python bench/regexes.py [NAME ...]      only modules whose name holds one of these
"""

from __future__ import annotations

import importlib
import pkgutil
import re
import sys
import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from itertools import islice, permutations
from typing import Any

import rospkg_cli

SIZES = (2_000, 8_000, 32_000)
TAILS = ("", "\n!\x7f", '"')
MAX_ATOMS = 7
STEEP = 1.5
NOTICEABLE = 0.002
"""Seconds: what takes less at 8,000 characters is noise."""
ENOUGH = 0.2
"""Seconds at 8,000 characters from which the largest text is not tried."""
CLASSES = {"DIGIT": "1", "SPACE": " ", "WORD": "a", "NOT_DIGIT": "a", "NOT_SPACE": "a", "NOT_WORD": "-"}

parser: Any = importlib.import_module("re._parser" if sys.version_info >= (3, 11) else "sre_parse")


@dataclass(frozen=True)
class Growth:
    """The worst that a pattern does."""

    name: str
    method: str
    unit: str
    seconds: tuple[float, ...]
    """For each of the sizes that was tried."""

    @property
    def steepness(self) -> float:
        """How often more than linear the last step is."""
        return self.seconds[-1] / max(self.seconds[-2], 1e-7) / 4


def patterns(wanted: list[str]) -> Iterator[tuple[str, re.Pattern[str]]]:
    """Yield each pattern once, with the module and the name that hold it."""
    seen: set[int] = set()
    for info in pkgutil.walk_packages(rospkg_cli.__path__, "rospkg_cli."):
        if info.name.endswith("__main__"):
            continue
        for name, value in vars(importlib.import_module(info.name)).items():
            if isinstance(value, re.Pattern) and isinstance(value.pattern, str) and id(value) not in seen:
                seen.add(id(value))
                if not wanted or any(each in info.name for each in wanted):
                    yield f"{info.name.removeprefix('rospkg_cli.')}.{name}", value


def atoms(tree: Any) -> Iterator[str]:
    """Yield one text for each thing that a parsed pattern mentions, literals in a row as one."""
    row = ""
    for operator, value in tree:
        if str(operator) == "LITERAL":
            row += chr(value)
            continue
        if row:
            yield row
        row = ""
        yield from mentioned(str(operator), value)
    if row:
        yield row


def mentioned(operator: str, value: Any) -> Iterator[str]:
    match operator:
        case "IN":
            yield from islice((char for item in value if (char := of_class(*item))), 3)
        case "ANY" | "NOT_LITERAL":
            yield "x"
        case "MAX_REPEAT" | "MIN_REPEAT" | "POSSESSIVE_REPEAT":
            yield from atoms(value[2])
        case "SUBPATTERN":
            yield from atoms(value[-1])
        case "BRANCH":
            for branch in value[1]:
                yield from atoms(branch)
        case "ASSERT" | "ASSERT_NOT":
            yield from atoms(value[1])
        case "ATOMIC_GROUP":
            yield from atoms(value)


def of_class(operator: Any, value: Any) -> str:
    """Return one character of a part of a class."""
    match str(operator):
        case "LITERAL":
            return chr(value)
        case "RANGE":
            return chr(value[0])
        case "CATEGORY":
            return CLASSES.get(str(value).removeprefix("CATEGORY_"), "")
        case _:
            return "x" if str(operator) == "NEGATE" else ""


def shortest(tree: Any) -> str:
    """Return a short text that a parsed pattern may fit."""
    found = ""
    for operator, value in tree:
        match str(operator):
            case "LITERAL":
                found += chr(value)
            case "IN":
                found += next((char for item in value if (char := of_class(*item))), "")
            case "ANY" | "NOT_LITERAL":
                found += "x"
            case "MAX_REPEAT" | "MIN_REPEAT" | "POSSESSIVE_REPEAT":
                found += shortest(value[2]) * max(1, min(value[0], 3))
            case "SUBPATTERN":
                found += shortest(value[-1])
            case "BRANCH":
                found += shortest(value[1][0])
    return found


def units(pattern: re.Pattern[str]) -> list[str]:
    """Return the texts to repeat."""
    tree = parser.parse(pattern.pattern, pattern.flags & ~re.DEBUG)
    single = list(dict.fromkeys(each for each in atoms(tree) if each))
    single = sorted(single, key=len)[:MAX_ATOMS] + single[-2:]
    pairs = ["".join(pair) for pair in permutations(dict.fromkeys(single), 2)]
    whole = shortest(tree)
    return list(dict.fromkeys([*single, *pairs, *filter(None, (whole, whole[:-1], f"{whole}\n"))]))


def seconds(run: Callable[[str], object], text: str) -> float:
    """Return the CPU time of a run, the best of up to three."""
    best = float("inf")
    for _ in range(3):
        start = time.process_time()
        run(text)
        best = min(best, time.process_time() - start)
        if best > ENOUGH or best < NOTICEABLE:
            break
    return best


def methods(pattern: re.Pattern[str]) -> dict[str, Callable[[str], object]]:
    return {
        "search": pattern.search,
        "match": pattern.match,
        "fullmatch": pattern.fullmatch,
        "finditer": lambda text: sum(1 for _ in pattern.finditer(text)),
    }


def worst(name: str, pattern: re.Pattern[str]) -> Growth | None:
    """Return the text on which a pattern's time grows most, None where it is linear on all."""
    found: list[Growth] = []
    for unit in units(pattern):
        for tail in TAILS:
            texts = [(unit * (size // len(unit) + 1))[:size] + tail for size in SIZES]
            for method, run in methods(pattern).items():
                second = seconds(run, texts[1])
                first = seconds(run, texts[0]) if second >= NOTICEABLE else second
                if second < first * 4 * STEEP:
                    continue
                times = (first, second) if second > ENOUGH else (first, second, seconds(run, texts[2]))
                growth = Growth(name, method, f"{unit}…{tail}", times)
                if growth.steepness > STEEP:
                    found.append(growth)
        if found:
            break
    return max(found, key=lambda growth: growth.seconds[1], default=None)


def main() -> None:
    steep, number = 0, 0
    for number, (name, pattern) in enumerate(patterns(sys.argv[1:]), 1):  # noqa: B007
        if (each := worst(name, pattern)) is not None:
            steep += 1
            times = "  ".join(f"{second:8.3f}" for second in each.seconds)
            print(f"{each.name:50} {each.method:9} {times:30} {each.unit[:50]!r}", flush=True)
    print(f"{number} patterns, {steep} not linear")


if __name__ == "__main__":
    main()
