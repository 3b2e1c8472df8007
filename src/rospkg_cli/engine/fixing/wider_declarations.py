"""Fixes that declare for one use what another declares for all: made together, the one would be taken out again."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from ...edits.dependency_lines import elements_of
from ...finding import Edit, Finding, Fix

Declared = tuple[str, str, str]
"""A package.xml, a tag and a name."""


def needless(findings: Sequence[Finding]) -> Iterator[Finding]:
    """Yield the findings whose fix only declares what others declare with `<depend>` in the same package.xml."""
    declared = [(each, [*declarations(each.fix)]) for each in findings]
    everywhere = {(path, name) for _, found in declared for path, tag, name in found if tag == "depend"}
    for each, found in declared:
        is_covered = all(tag == "exec_depend" and (path, name) in everywhere for path, tag, name in found)
        if found and is_covered and each.fix is not None and all(isinstance(o, Edit) for o in each.fix.operations):
            yield each


def declarations(fix: Fix | None) -> Iterator[Declared]:
    for operation in fix.operations if fix else ():
        if isinstance(operation, Edit) and operation.path.rpartition("/")[2] == "package.xml":
            yield from ((operation.path, each.tag, each.name) for each in elements_of(operation.text) if each.name)
