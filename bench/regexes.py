"""How the time of every regular expression of rospkg grows with hostile text.

Imports all modules of the package, takes each pattern that a module holds, and drives it by the methods that the code
calls on it, with texts of 1,000, 4,000 and 16,000 characters: what the pattern mentions (each literal, one character of
each class, pairs of these, and the shortest text that it fits), again and again, with and without an end that makes a
match fail. Prints the patterns whose time grows faster than 1.5 times linearly, the worst text of each, and the
seconds. A pattern is given up after 2 s of CPU, with the worst that was found by then. One that only sees short texts
may stand in the table: whether the code bounds what it gets, this does not know.

    python bench/regexes.py [NAME ...]      only modules whose name holds one of these
"""

from __future__ import annotations

import ast
import importlib
import pkgutil
import re
import signal
import sys
import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass
from itertools import islice, permutations
from pathlib import Path
from typing import Any

import rospkg_cli

SIZES = (1_000, 4_000, 16_000)
TAILS = ("", "\n!\x7f", '"')
MAX_ATOMS = 7
STEEP = 1.5
NOTICEABLE = 0.002
"""Seconds: what takes less at 4,000 characters is noise."""
ENOUGH = 0.2
"""Seconds at 4,000 characters from which the largest text is not tried."""
MAX_SECONDS = 2.0
"""Of CPU for one pattern."""
METHODS = ("search", "match", "fullmatch", "finditer", "findall", "sub", "subn", "split")
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
            if hasattr(value, "groupindex") and isinstance(value.pattern, str) and id(value) not in seen:
                seen.add(id(value))
                if not wanted or any(each in info.name for each in wanted):
                    yield f"{info.name.removeprefix('rospkg_cli.')}.{name}", re.compile(value.pattern, value.flags)


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


def methods_used() -> dict[str, set[str]]:
    """Return the methods that the code calls on each name: NAME.match(…), module.NAME.match(…), map(NAME.match, …)."""
    used: dict[str, set[str]] = {}
    for path in Path(rospkg_cli.__path__[0]).rglob("*.py"):
        for node in ast.walk(ast.parse(path.read_text(encoding="utf-8"))):
            if isinstance(node, ast.Attribute) and node.attr in METHODS:
                owner = node.value
                name = (
                    owner.id if isinstance(owner, ast.Name) else owner.attr if isinstance(owner, ast.Attribute) else ""
                )
                used.setdefault(name, set()).add(node.attr)
    return used


def methods(pattern: re.Pattern[str], wanted: set[str]) -> dict[str, Callable[[str], object]]:
    """Return the wanted methods, all that find every match as one; match and finditer where none is known."""
    runs: dict[str, Callable[[str], object]] = {
        "search": pattern.search,
        "match": pattern.match,
        "fullmatch": pattern.fullmatch,
        "finditer": lambda text: sum(1 for _ in pattern.finditer(text)),
    }
    names = {each if each in runs else "finditer" for each in wanted} or {"match", "finditer"}
    return {name: run for name, run in runs.items() if name in names}


class TooLongError(Exception):
    """A pattern has had its time."""


def stop_after(end: float) -> Callable[..., None]:
    """Return a handler that raises TooLongError once the CPU time of the process has reached an end."""

    def stop(*_: object) -> None:
        if time.process_time() > end:
            raise TooLongError

    return stop


def worst(name: str, pattern: re.Pattern[str], wanted: set[str]) -> Growth | None:
    """Return the text on which a pattern's time grows most, None where it is linear on all that was tried."""
    found: list[Growth] = []
    signal.signal(signal.SIGALRM, stop_after(time.process_time() + MAX_SECONDS))
    signal.setitimer(signal.ITIMER_REAL, 0.25, 0.25)
    try:
        drive(name, pattern, wanted, found)
    except TooLongError:
        pass
    finally:
        signal.setitimer(signal.ITIMER_REAL, 0)
    return max(found, key=lambda growth: growth.seconds[1], default=None)


def drive(name: str, pattern: re.Pattern[str], wanted: set[str], found: list[Growth]) -> None:
    """Put what grows faster than linearly into a list, unit by unit, until one unit does."""
    for unit in units(pattern):
        for tail in TAILS:
            texts = [(unit * (size // len(unit) + 1))[:size] + tail for size in SIZES]
            for method, run in methods(pattern, wanted).items():
                second = seconds(run, texts[1])
                if second < NOTICEABLE or second < (first := seconds(run, texts[0])) * 4 * STEEP:
                    continue
                times = (first, second) if second > ENOUGH else (first, second, seconds(run, texts[2]))
                growth = Growth(name, method, f"{unit}…{tail}", times)
                if growth.steepness > STEEP:
                    found.append(growth)
        if found:
            break


def main() -> None:
    steep, number, used = 0, 0, methods_used()
    for number, (name, pattern) in enumerate(patterns(sys.argv[1:]), 1):  # noqa: B007
        if (each := worst(name, pattern, used.get(name.rpartition(".")[2], set()))) is not None:
            steep += 1
            times = "  ".join(f"{second:8.3f}" for second in each.seconds)
            print(f"{each.name:50} {each.method:9} {times:30} {each.unit[:50]!r}", flush=True)
    print(f"{number} patterns, {steep} not linear")


if __name__ == "__main__":
    main()
