"""Folders with a package before and after an exercise: of the task and its solution one is built at a time."""

from __future__ import annotations

import posixpath

from ...lazy_regex import regex

TASKS = frozenset(
    "exercise exercises start starter begin initial skeleton student students before task tasks assignment assignments "
    "handout todo template templates ejercicio ejercicios aufgabe aufgaben exercice exercices esercizi".split()
)
SOLUTIONS = frozenset(
    "solution solutions final finish finished end complete completed solved after answer answers teacher instructor "
    "reference solucion soluciones loesung loesungen soluzioni corrige".split()
)
WORDS = regex(r"[a-z]+|[0-9]+")


def are_states(one: str, other: str) -> bool:
    """Return whether two folders differ first in a word for a task or its solution: `exercises/a` and `solutions/a`,
    `lab1` and `lab1_solution`."""
    here, there = one.lower().split("/"), other.lower().split("/")
    shared = len(posixpath.commonprefix([here, there]))
    if len(here) <= shared or len(there) <= shared:
        return False
    first, second = (frozenset(WORDS.findall(parts[shared])) for parts in (here, there))
    return is_solution_of(first, second) or is_solution_of(second, first)


def is_solution_of(first: frozenset[str], second: frozenset[str]) -> bool:
    """Return whether the second of two names, by their words, is that of a solution of the first."""
    return not first & SOLUTIONS and bool(second & SOLUTIONS) and (bool(first & TASKS) or second - SOLUTIONS == first)
