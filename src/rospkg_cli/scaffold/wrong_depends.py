"""Names of `--depends` that are certainly wrong: they are refused, with the option as it should be."""

from __future__ import annotations

from collections.abc import Iterable, Mapping

from ..finding import Edit, Finding, Severity
from . import ScaffoldError

UNKNOWN_NAME = "DEP001"
NEEDS_NONE = "remove the line"
"""How a finding ends on a name that needs no dependency at all."""


def refuse_wrong_depends(asked: tuple[str, ...], findings: Iterable[Finding]) -> None:
    """Raise ScaffoldError for names that our linter reports for everyone, and for which it knows what is right.

    A name that is merely unknown, or that a repository which is not here may have, is written as it was typed.
    """
    unknown = [each for each in findings if each.code == UNKNOWN_NAME and each.severity is Severity.WARNING]
    wrong = {
        key: each for key in asked for each in unknown if each.message.startswith(f"`{key}` ") and is_certain(each)
    }
    if wrong:
        reason = next(iter(wrong.values())).message.rpartition("; ")[0]
        raise ScaffoldError(f"{reason}; {corrected(asked, wrong)}")


def is_certain(finding: Finding) -> bool:
    return finding.fix is not None or finding.message.endswith(NEEDS_NONE)


def corrected(asked: tuple[str, ...], wrong: Mapping[str, Finding]) -> str:
    """Return what to type instead of all wrong names."""
    right = [name for key in asked for name in ([key] if key not in wrong else names_of(wrong[key]))]
    return f"write `--depends {','.join(dict.fromkeys(right))}`" if right else "leave --depends out"


def names_of(finding: Finding) -> list[str]:
    """Return the name that a finding would write, none where nothing is needed."""
    operations = finding.fix.operations if finding.fix else ()
    return [each.text for each in operations[:1] if isinstance(each, Edit) and each.text]
