"""Baselines: the findings of a workspace at one time are set aside, new ones are reported.

A baseline counts findings by code, path and message, so that it holds when lines move.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Callable, Iterable
from pathlib import Path

from ..disk_trace import read
from ..finding import Finding
from ..light_dataclasses import replace
from ..user_error import UserError
from .run.results import Results

SCHEMA = 1
REASON = "in the baseline"
Key = tuple[str, str, str]


class BaselineError(UserError):
    """A baseline that can't be read; the message says what to do."""


def keys(findings: Iterable[Finding], shown: Callable[[str], str]) -> Counter[Key]:
    return Counter((f.code, shown(f.location.path), f.message) for f in findings)


def write_baseline(findings: Iterable[Finding], shown: Callable[[str], str]) -> str:
    """Return the text of a baseline; `shown` makes a path relative to the baseline's folder."""
    entries = [
        {"code": code, "path": path, "message": message, "count": count}
        for (code, path, message), count in sorted(keys(findings, shown).items())
    ]
    import json

    return json.dumps({"schema": SCHEMA, "findings": entries}, indent=2, ensure_ascii=False) + "\n"


def read_baseline(path: Path) -> Counter[Key]:
    """Read a baseline; raises BaselineError."""
    import json

    try:
        data = json.loads(read(path).decode("utf-8"))
        return Counter({(e["code"], e["path"], e["message"]): int(e["count"]) for e in data["findings"]})
    except OSError as error:
        hint = f"create it with --write-baseline {path}"
        raise BaselineError(f"the baseline `{path}` can't be read: {error.strerror}; {hint}") from None
    except (ArithmeticError, AttributeError, LookupError, RecursionError, TypeError, ValueError):
        raise BaselineError(f"`{path}` is not a baseline of rospkg; create one with --write-baseline {path}") from None


def apply_baseline(results: Results, known: Counter[Key], shown: Callable[[str], str]) -> Results:
    """Set the known findings aside, each as often as the baseline counts it."""
    left = known.copy()
    new: list[Finding] = []
    old: list[Finding] = []
    for finding in results.findings:
        key = (finding.code, shown(finding.location.path), finding.message)
        if left[key] > 0:
            left[key] -= 1
            old.append(replace(finding, suppressed=REASON, external=True))
        else:
            new.append(finding)
    return replace(results, findings=tuple(new), suppressed=(*results.suppressed, *old))
