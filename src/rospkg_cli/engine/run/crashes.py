"""Crashes of rules and readers, each cause once: rules that fail at one place in the code have one cause."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from ...light_dataclasses import replace
from ...package.package import Package
from ...package.run_events import RuleCrash


def reader_crashes(package: Package, name: str, path: str) -> Iterator[RuleCrash]:
    """Yield the crashes of a package's readers."""
    for model, error in sorted(package.crashes.items()):
        yield RuleCrash(model, name, path, error, "reader of")


def one_each(crashes: Iterable[RuleCrash]) -> list[RuleCrash]:
    """Join the crashes of one package that have the same last place and error."""
    found: dict[tuple[str, str, str], RuleCrash] = {}
    for crash in crashes:
        key = (crash.package, crash.what, place_of(crash.error))
        known = found.get(key)
        found[key] = replace(known, code=f"{known.code}, {crash.code}") if known else crash
    return list(found.values())


def place_of(error: str) -> str:
    """Return the last place that a traceback names, with the error itself."""
    lines = error.strip().splitlines()
    places = [line.strip() for line in lines if line.lstrip().startswith('File "')]
    return f"{places[-1] if places else ''} {lines[-1] if lines else ''}"
