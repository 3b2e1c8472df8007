"""What a run itself can report: the inputs of the RPK rules."""

from __future__ import annotations

from ..light_dataclasses import dataclass
from ..source import Span


@dataclass(frozen=True, slots=True)
class UnusedSuppression:
    """An ignore, or one code of an ignore comment, that matched no finding."""

    path: str
    span: Span
    code: str
    delete: Span | None
    """What to delete so that the ignore is gone; None where that is not known."""
    is_pattern: bool = False
    """Whether it is a pattern of the config's `exclude`, which fits nothing."""


@dataclass(frozen=True, slots=True)
class UnknownRuleName:
    """A suppression that names no rule; its name is "" where it names nothing at all."""

    path: str
    span: Span
    name: str
    nearest: str | None


@dataclass(frozen=True, slots=True)
class ReasonlessIgnore:
    """An ignore comment that suppresses something and gives no reason."""

    path: str
    span: Span
    codes: str
    """As they are written, joined by commas."""


@dataclass(frozen=True, slots=True)
class CheckSwitchedOff:
    """Dependencies whose names are not judged; at the first of them."""

    path: str
    span: Span
    names: tuple[str, ...]
    why: str
    """A clause that names what switches the check off."""


@dataclass(frozen=True, slots=True)
class RuleCrash:
    """A rule raised, or a reader, or a fix."""

    code: str
    package: str
    path: str
    error: str
    what: str = "rule"
    """What `code` names: "rule", "reader of" a model, or "fix of" a rule."""


@dataclass(frozen=True, slots=True)
class NoPackagesFound:
    """No package under the given paths."""

    paths: tuple[str, ...]
    hidden: str = ""
    """Why packages that are there were left out, where that is known."""
    place: str = "."
    """The first path, relative to the root of the run."""


RUN_EVENTS: frozenset[type] = frozenset(
    {UnusedSuppression, UnknownRuleName, ReasonlessIgnore, CheckSwitchedOff, RuleCrash, NoPackagesFound}
)
"""Rule inputs that the run makes, after the packages have been checked."""
