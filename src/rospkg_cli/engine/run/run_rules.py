"""Phase three: run rules over the slices of one package, and stamp what they say."""

from __future__ import annotations

import traceback
from collections.abc import Iterable, Iterator
from dataclasses import replace
from typing import Any

from ...finding import Finding, Hit
from ...package.run_events import RuleCrash
from ...rule import Rule
from .finding_builder import FindingBuilder
from .rule_inputs import InputBuilder

MAX_HITS = 2_000
"""Nobody reads more findings of one rule in one package; what comes after them is said in one."""


def run_rule(rule: Rule[Any], slices: Iterable[Any], package: str) -> Iterator[Hit]:
    """Yield the hits of a rule, the last of very many with the word that more were cut off; raises what it raises."""
    hits = (hit for each in slices for hit in rule.check(each))
    for count, hit in enumerate(hits, 1):
        if count > MAX_HITS:
            more = f"more than {MAX_HITS:,} findings of {rule.code} in `{package}`: from here on they are not shown"
            yield replace(hit, message=more, related=(), fix=None)
            return
        yield hit


def run_rules(
    slices: InputBuilder, rules: Iterable[Rule[Any]], stamper: FindingBuilder
) -> Iterator[Finding | RuleCrash]:
    """Run the rules over one package; a rule that raises is reported and the others go on."""
    for rule in rules:
        try:
            for hit in run_rule(rule, slices.of(rule.over), stamper.package):
                yield stamper.stamp(rule, hit)
        except Exception:  # a fault of ours must not hide what other rules found
            yield RuleCrash(rule.code, stamper.package, stamper.crash_path, traceback.format_exc())
