"""Build a finding from a rule's hit: code, severity, paths from the root of the run, lines and columns."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import PurePosixPath
from typing import Any

from ...files import PackageFiles
from ...finding import AGAIN, Edit, Finding, Fix, Hit, Location, Move, Operation, Related, Severity
from ...light_dataclasses import dataclass, replace
from ...package.workspace import Workspace
from ...rule import Rule
from ...source import Source, Span
from ...unreadable import UnreadableError
from .laid_aside import OF_RUNS, level_aside

IN_USE = (*OF_RUNS, "PLG", "IDL012", "CMK201")
"""Families and rules about code, launch files and what these open: their faults do no harm in unused files."""
AT_RUN = frozenset({"DEP117", "DEP120", "IDL010"})
"""Rules about lines of Python that raise when they run."""
OF_STARTS = AT_RUN | {"DEP109", "DEP110", "DEP112", "IDL011", "PRM007"}
"""Those, and the rules about imports, look-ups and parameters: their errors end the programs that run them."""
UNLED = "; nothing here leads to this file"


def nothing_is_left(_: str) -> bool:
    return False


def nothing_is_seldom(_: Hit) -> str:
    return ""


@dataclass
class FindingBuilder:
    """For the hits of one package. `whole` holds the files of the whole run, for paths that begin with `/`."""

    files: PackageFiles
    whole: PackageFiles
    package: str
    is_left: Callable[[str], bool]
    """Whether nothing of the package uses a file, by its path in the package."""
    why_warning: Callable[[Hit], str]
    """Why a fault of Python code that ends a run does so only at times: its program is not started; "" for others."""
    why_unmet: Callable[[str, Severity, Hit], str]
    """Why a launch with its defaults reaches no place of a hit, by the rule's code and level; "" where it may."""

    @property
    def crash_path(self) -> str:
        return self.resolve("package.xml")

    def resolve(self, path: str) -> str:
        """Return a path relative to the root of the run."""
        if path.startswith("/"):
            return path[1:]
        return str(PurePosixPath(self.files.folder, path))

    def source(self, path: str) -> Source:
        try:
            if path.startswith("/"):
                return self.whole.source(path[1:])
            return self.files.source(path)
        except UnreadableError:
            return Source(path, "")

    def place(self, path: str, span: Span) -> Location:
        source = self.source(path)
        end = max(span.start, min(span.end, len(source.text)))
        start = min(span.start, len(source.text))
        return Location(self.resolve(path), Span(start, end), *source.position(start), *source.position(end))

    def package_of(self, path: str) -> str:
        """Return the name of the package that a hit's path belongs to."""
        return self.package

    def build(self, rule: Rule[Any], hit: Hit) -> Finding:
        hit = self.at_met_place(rule, hit)
        place, source = self.place(hit.path, hit.span), self.source(hit.path)
        level = self.level(rule.code, hit.level or rule.severity, hit.path)
        level, why = self.met(rule.code, level, hit)
        return Finding(
            code=rule.code,
            name=rule.name,
            severity=level,
            message=f"{hit.message}{why}",
            location=place,
            package=self.package_of(hit.path),
            excerpt=source.slice(source.line_span(place.line)),
            related=tuple((self.place(each.path, each.span), each.message) for each in hit.related),
            fix=self.fix(hit.fix),
            edit_locations=tuple(
                self.place(o.path, o.span) for o in (hit.fix.operations if hit.fix else ()) if isinstance(o, Edit)
            ),
        )

    def met(self, code: str, level: Severity, hit: Hit) -> tuple[Severity, str]:
        """Return the level of a hit by whether its file or place is used, and the reason, which ends the message."""
        if level is Severity.INFO:
            return level, ""
        if code.startswith(IN_USE) and self.is_left(hit.path):
            return Severity.INFO, UNLED
        if unmet := self.why_unmet(code, level, hit):
            return Severity.INFO, f"; {unmet.removeprefix('but ')}"
        if level is Severity.ERROR and code in OF_STARTS and (why := self.why_warning(hit)):
            return Severity.WARNING, why
        return level, ""

    def at_met_place(self, rule: Rule[Any], hit: Hit) -> Hit:
        """Return a hit of several launch files at the first of its places that is not left or laid aside."""
        level = hit.level or rule.severity
        if not rule.code.startswith("LCH") or all(each.path == hit.path for each in hit.related):
            return hit
        own = Related(hit.path, hit.span, AGAIN)
        for each in (own, *(each for each in hit.related if each.message == AGAIN)):
            if self.level(rule.code, level, each.path) is level and not self.is_left(each.path):
                others = tuple(own if other is each else other for other in hit.related)
                return hit if each is own else replace(hit, path=each.path, span=each.span, related=others)
        return hit

    def level(self, code: str, level: Severity, path: str) -> Severity:
        """Return the level of a hit by where its file is: milder in folders for what is no longer used."""
        return level_aside(code, level, self.resolve(path), self.folder_of(path), lambda: self.is_left(path))

    def folder_of(self, path: str) -> str:
        """Return the folder of the package that a hit's path belongs to, from the root of the run."""
        return self.files.folder

    def fix(self, fix: Fix | None) -> Fix | None:
        if fix is None:
            return None
        return replace(fix, operations=tuple(self.relative_to_root(each) for each in fix.operations))

    def relative_to_root(self, operation: Operation) -> Operation:
        moved = replace(operation, path=self.resolve(operation.path))
        return replace(moved, to=self.resolve(moved.to)) if isinstance(moved, Move) else moved


@dataclass
class RootFindingBuilder(FindingBuilder):
    """For hits whose paths are relative to the root of the run: each belongs to the package that its path is in."""

    workspace: Workspace

    def package_of(self, path: str) -> str:
        """Return the name of the package whose folder holds a path."""
        return self.workspace.package_at(path.lstrip("/"))

    def folder_of(self, path: str) -> str:
        return str(PurePosixPath(path.lstrip("/")).parent)
