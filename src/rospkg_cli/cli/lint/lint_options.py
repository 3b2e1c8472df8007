"""The options of `rospkg lint` as they were typed, in the parts that serve one purpose each."""

from __future__ import annotations

from collections.abc import Mapping
from pathlib import Path
from typing import Any

from ...light_dataclasses import dataclass, field, field_names


@dataclass(frozen=True)
class RuleOptions:
    """Which rules run, and for which distributions."""

    select: tuple[str, ...] = ()
    ignore: tuple[str, ...] = ()
    extend_select: tuple[str, ...] = ()
    pedantic: bool = False
    release: bool = False
    preview: bool = False
    target: tuple[str, ...] = ()


@dataclass(frozen=True)
class FixOptions:
    fix: bool = False
    fix_level: str | None = None
    """The least severity that is fixed; None for warnings, and for infos where they are shown."""
    unsafe_fixes: bool = False
    diff: bool = False
    fix_only: bool = False
    show_fixes: bool = False
    exit_non_zero_on_fix: bool = False


@dataclass(frozen=True)
class SuppressionOptions:
    """What sets findings aside, or writes down that they are; None where nothing was typed."""

    add_ignores: str | None = None
    """The reason to write."""
    baseline: Path | None = None
    write_baseline: Path | None = None


@dataclass(frozen=True)
class ReportOptions:
    format: str = "text"
    output: tuple[str, ...] = ()
    """Further reports, as FORMAT:FILE."""
    statistics: bool = False
    color: str = "auto"
    quiet: bool = False
    show: tuple[str, ...] = ()
    """What the text shows beyond errors and warnings: info, all."""
    traceback: bool = False


@dataclass(frozen=True)
class LintOptions:
    paths: tuple[Path, ...] = ()
    workspace: Path | None = None
    changed: bool = False
    since: str | None = None
    """A commit, tag or branch: packages that have not changed after it are left out."""
    stdin_filename: Path | None = None
    """The file that standard input stands for."""
    jobs: str = "auto"
    allow_empty: bool = False
    no_cache: bool = False
    watch: bool = False
    fail_on: str | None = None
    """The least severity that fails; None where the config decides."""
    exit_zero: bool = False
    config: Path | None = None
    """The only config that counts."""
    isolated: bool = False
    show_settings: bool = False
    rules: RuleOptions = field(default_factory=RuleOptions)
    fixing: FixOptions = field(default_factory=FixOptions)
    suppression: SuppressionOptions = field(default_factory=SuppressionOptions)
    report: ReportOptions = field(default_factory=ReportOptions)

    @classmethod
    def of(cls, typed: Mapping[str, Any]) -> LintOptions:
        """Return the options from their values by the names of the fields; raises KeyError where one is missing."""
        parts = {name: kind(**{each: typed[each] for each in field_names(kind)}) for name, kind in PARTS.items()}
        return cls(**{each: typed[each] for each in field_names(cls) if each not in PARTS}, **parts)


PARTS: dict[str, type[Any]] = {
    "rules": RuleOptions,
    "fixing": FixOptions,
    "suppression": SuppressionOptions,
    "report": ReportOptions,
}
"""The fields of LintOptions that are options themselves."""
