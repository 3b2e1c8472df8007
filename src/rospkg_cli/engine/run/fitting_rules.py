"""Which rules can find anything in a package, so that the others need not be imported."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from ...package.package import Package
from ...package.package_facts import PackageFacts
from ...package.run_events import RUN_EVENTS
from ...package.workspace import Workspace
from ...rule_table import rule_entries

OF_ROS_2 = ("CMK", "DEP", "IDL", "LCH", "PLG", "PRM", "SET", "URD")
"""Families of rules about builds, launches and runs of ROS 2, which say nothing of a package for ROS 1."""
OVER_RUNS = {kind.__name__ for kind in RUN_EVENTS | {Workspace}}


def fitting_rules(codes: Iterable[str], package: Package, facts: PackageFacts) -> Iterator[str]:
    """Yield those of some rules that may find anything in a package."""
    for code in codes:
        if not (facts.is_for_ros1 and code.startswith(OF_ROS_2)) and has_inputs(code, package):
            yield code


def is_over_packages(code: str) -> bool:
    """Return whether a rule is about one package; a rule of a plugin, which is in no table, is."""
    entry = rule_entries().get(code)
    return entry is None or entry.over not in OVER_RUNS


def has_inputs(code: str, package: Package) -> bool:
    """Return whether a package may have what a rule is about, so that the rule is worth its import."""
    entry = rule_entries().get(code)
    return entry is None or all(package.has(model) for model in entry.needs)
