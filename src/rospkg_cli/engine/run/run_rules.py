"""Run rules over the inputs of one package, and build a finding from each hit."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Iterator
from typing import Any

from ...finding import Finding, Hit
from ...light_dataclasses import replace
from ...package.run_events import RuleCrash
from ...rule import Rule
from ...suggest import refill
from .finding_builder import FindingBuilder

InputsOf = Callable[[type], list[Any]]
"""Returns the inputs of a type, as `InputBuilder.of` does."""

MAX_HITS = 2_000
"""Findings of one rule in one package; one more says that there are others."""


def run_rule(rule: Rule[Any], inputs: Iterable[Any], package: str) -> Iterator[Hit]:
    """Yield the hits of a rule, at most MAX_HITS and one that says that others are not shown; raises what it raises."""
    refill()
    hits = (hit for each in inputs for hit in rule.check(each))
    for count, hit in enumerate(hits, 1):
        if count > MAX_HITS:
            where = f"`{package}`" if package else "the workspace"
            more = f"more than {MAX_HITS:,} findings of {rule.code} in {where}: from here on they are not shown"
            yield replace(hit, message=more, related=(), fix=None)
            return
        yield hit


def run_rules(inputs: InputsOf, rules: Iterable[Rule[Any]], builder: FindingBuilder) -> Iterator[Finding | RuleCrash]:
    """Run the rules over one package; a rule that raises is reported and the others go on."""
    for rule in rules:
        try:
            for hit in run_rule(rule, inputs(rule.over), builder.package):
                yield builder.build(rule, hit)
        except Exception:  # a bug of one rule must not hide what other rules found
            import traceback

            yield RuleCrash(rule.code, builder.package, builder.crash_path, traceback.format_exc())
