"""SET104 duplicate-entry-point."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.setup.started_entry_points import StartedEntryPoints
from ...example import Example, scripts, setup_py
from ...finding import Hit, Related, Severity
from ...package.setup.entry_point import EntryPoint
from ...rule import rule

MODULE = "def main():\n    print('hello')\n"
MODULES = {"my_pkg/talker.py": MODULE, "my_pkg/listener.py": MODULE}


@rule(
    "SET104",
    "duplicate-entry-point",
    over=StartedEntryPoints,
    severity=Severity.ERROR,
    levels={
        Severity.WARNING: "the pages name no distribution after Humble, and one of two programs is lost",
        Severity.INFO: "the pages name none after Humble, and both are the same",
    },
    examples=(
        Example(
            bad={
                **MODULES,
                "setup.py": setup_py(scripts("talker = my_pkg.talker:main", "«talker» = my_pkg.listener:main")),
            },
            good={"setup.py": setup_py(scripts("talker = my_pkg.talker:main", "listener = my_pkg.listener:main"))},
        ),
    ),
)
def duplicate_entry_point(started: StartedEntryPoints) -> Iterator[Hit]:
    """
    ## What it does
    Finds two entry points of one group with the same name.

    ## Why is this bad?
    setuptools from 60 on stops with "'distutils.core.setup()' was never called". The older one of Humble makes one
    executable of the two, and does not say which.

    ## When it is quiet
    Where an entry is made by code that can't be evaluated. One name in two groups is no duplicate. Where
    the pages, scripts and workflows of the repository name Humble or older ones alone, and install no newer setuptools
    by pip, nothing stops: two entries that are the same are an info, and others a warning.
    """
    seen: dict[tuple[str, str], EntryPoint] = {}
    for entry in started.package.setup.entry_points:
        if not entry.name or entry.fault:
            continue
        first = seen.setdefault((entry.group, entry.name), entry)
        if first is not entry:
            related = (Related(first.path, first.name_span, "the other one"),)
            is_same = (entry.module, entry.attribute) == (first.module, first.attribute)
            start, advice = f"`{entry.name}` is twice in `{entry.group}`", "remove" if is_same else "rename"
            message, level = f"{start}: setuptools stops, Humble's keeps one; {advice} one", None
            if started.has_old_setuptools:
                message = f"{start}: the setuptools of Humble keeps one, later ones stop; {advice} one"
                level = Severity.INFO if is_same else Severity.WARNING
            yield Hit(entry.path, entry.name_span, message, level, related)
