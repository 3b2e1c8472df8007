"""Phase three: run rules over the slices of one package, and stamp what they say."""

from __future__ import annotations

import traceback
from collections.abc import Iterable, Iterator
from typing import Any

from ..finding import Finding, Hit
from ..model.happenings import RuleCrash
from ..rule import Rule
from .slices import Slices
from .stamp import Stamper

MAX_HITS = 2_000
"""More than these from one rule over one package is a rule gone wild, not a package gone bad."""


class TooManyHitsError(RuntimeError):
    """A rule found more than it may."""


def run_rule(rule: Rule[Any], slices: Iterable[Any]) -> Iterator[Hit]:
    """Yield the hits of a rule; raises what the rule raises, and TooManyHitsError."""
    count = 0
    for each in slices:
        for hit in rule.check(each):
            count += 1
            if count > MAX_HITS:
                raise TooManyHitsError(f"more than {MAX_HITS} findings")
            yield hit


def check(slices: Slices, rules: Iterable[Rule[Any]], stamper: Stamper) -> Iterator[Finding | RuleCrash]:
    """Run the rules over one package; a rule that raises is reported and the others go on."""
    for rule in rules:
        try:
            for hit in run_rule(rule, slices.of(rule.over)):
                yield stamper.stamp(rule, hit)
        except Exception:  # a fault of ours must not hide what other rules found
            yield RuleCrash(rule.code, stamper.package, stamper.crash_path, traceback.format_exc())
