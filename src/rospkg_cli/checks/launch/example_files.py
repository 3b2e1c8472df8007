"""Launch files for examples, tests or debugging, which few people start."""

from __future__ import annotations

from ...lazy_regex import regex

EXAMPLE = regex(r"(?:^|[_.-])(?:example|demo|test|debug(?:ging)?|gdb|valgrind|profiling|benchmark)s?(?:[_.-]|$)")
ENDING = regex(r"[._]launch\.\w+$|\.launch$")


def is_example(path: str) -> bool:
    """Return whether a launch file, or its folder, is called after examples, tests or debugging, which few start.

    MoveIt's `demo.launch.py` is none: it is the one that all users start.
    """
    folder, _, file = path.rpartition("/")
    name = ENDING.sub("", file)
    parts = (*folder.split("/"), *(() if name == "demo" else (name,)))
    return any(EXAMPLE.search(part) for part in parts)
