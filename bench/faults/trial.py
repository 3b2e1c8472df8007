"""One fault put into a copy, linted before and after: what is told of it, and what beside."""

from __future__ import annotations

import io
import json
import os
import re
from collections import Counter
from collections.abc import Sequence
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from bench.faults.fault import PutFault
from bench.faults.kinds import FaultKind
from bench.faults.source_package import SourcePackage
from bench.faults.working_copy import WorkingCopy
from rospkg_cli.cli.lint.lint_options import LintOptions, ReportOptions, RuleOptions
from rospkg_cli.cli.lint.run import lint_to

UNREADABLE = "RPK001"
WAS_UNREADABLE = "the file could not be read before the fault, and lint says so"
SILENT = {"RPK004", "RPK005", "RPK008"}
"""They say what was not checked: a fault that only they name is not seen."""


@dataclass(frozen=True)
class Trial:
    kind: FaultKind
    package: SourcePackage
    fault: PutFault
    told: tuple[str, ...]
    """New findings that name the thing: code and message."""
    beside: tuple[str, ...]
    """New findings that do not."""
    reworded: int = 0
    """Of the new findings beside the first that names the thing: those in whose place one is gone, of the same code and
    in the same file, or of the same words (its file was renamed). Nobody has more to read for them."""
    was_unreadable: bool = False
    """Whether the file was no XML, YAML or Python before the fault."""

    @property
    def excluded(self) -> str:
        unread = WAS_UNREADABLE if self.was_unreadable and not self.told else ""
        return self.kind.excluded or self.fault.excluded or unread

    @property
    def beside_count(self) -> int:
        return len(self.told) + len(self.beside) - bool(self.told)

    @property
    def added_count(self) -> int:
        return self.beside_count - self.reworded


@dataclass
class Linter:
    """`rospkg lint` with the default rules, in this process, and with the cache that the environment names."""

    preview: bool = False
    known: dict[tuple[Path, str], Counter[tuple[str, str, str]]] = field(default_factory=dict)

    def findings(self, repository: Path, folder: str) -> list[dict[str, Any]]:
        stream = io.StringIO()
        options = LintOptions(
            paths=(repository / folder,),
            workspace=repository,
            jobs="1",
            isolated=True,
            rules=RuleOptions(preview=self.preview),
            report=ReportOptions(format="json", quiet=True),
        )
        lint_to(options, stream)
        found: list[dict[str, Any]] = json.loads(stream.getvalue())["findings"]
        return [{**each, "path": os.path.relpath(each["path"], repository)} for each in found]

    def before(self, copy: WorkingCopy, folder: str) -> Counter[tuple[str, str, str]]:
        key = copy.folder, folder
        if key not in self.known:
            self.known[key] = Counter(identity(each) for each in self.findings(copy.folder, folder))
        return self.known[key]


def identity(finding: dict[str, Any]) -> tuple[str, str, str]:
    """Return what stays of a finding when lines above it come and go."""
    return finding["code"], finding["path"], re.sub(r"\bline \d+", "line", finding["message"])


def attempt(linter: Linter, copy: WorkingCopy, kind: FaultKind, package: SourcePackage, fault: PutFault) -> Trial:
    folder = "" if kind.is_seen_outside else package.folder
    before = Counter(linter.before(copy, folder))
    was_unreadable = any(code == UNREADABLE and path == fault.path for code, path, _ in before)
    told: list[str] = []
    beside: list[str] = []
    new: list[tuple[str, str, str]] = []
    with copy.with_fault(fault):
        for finding in linter.findings(copy.folder, folder):
            each = identity(finding)
            if before[each] > 0:
                before[each] -= 1
                continue
            is_told = each[0] not in SILENT and is_named(fault, finding)
            new += [each] if told or not is_told else []
            if is_told:
                told.append(f"{each[0]} {finding['severity']} {each[2]}")
            else:
                beside.append(f"{each[0]} {finding['severity']} {finding['path']}: {each[2]}")
    return Trial(kind, package, fault, tuple(told), tuple(beside), replaced(new, before), was_unreadable)


def replaced(new: Sequence[tuple[str, str, str]], before: Counter[tuple[str, str, str]]) -> int:
    """Return how many of some new findings stand in the place of one that is gone."""
    gone, count = list(before.elements()), 0
    for code, path, message in new:
        alike = (each for each in gone if each[0] == code and (each[1] == path or each[2] == message))
        if (old := next(alike, None)) is not None:
            gone.remove(old)
            count += 1
    return count


def is_named(fault: PutFault, finding: dict[str, Any]) -> bool:
    """Return whether a finding names the thing, stands at the very line, or in the file that is at fault as a whole."""
    message, path = finding["message"].lower(), finding["path"]
    for name in fault.names:
        if re.search(rf"(?<![\w-]){re.escape(name.lower().strip())}(?![\w-])", message):
            return True
        if "." in name and (path == name or path.endswith(f"/{name}")):
            return True
    return bool(fault.line) and path in fault.files and finding["line"] == fault.line
