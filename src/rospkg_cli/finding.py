"""The result of a rule (Hit) and what users get (Finding): plain values that pickle, never a syntax node."""

from __future__ import annotations

from collections import defaultdict
from enum import Enum
from itertools import pairwise

from .light_dataclasses import dataclass
from .source import Span


class Severity(Enum):
    INFO = "info"
    WARNING = "warning"
    ERROR = "error"

    @property
    def rank(self) -> int:
        """0 for info, 1 for warning, 2 for error."""
        return list(Severity).index(self)


class Safety(Enum):
    SAFE = "safe"
    UNSAFE = "unsafe"


@dataclass(frozen=True, slots=True)
class Edit:
    """Replace a span of a file; an empty span inserts."""

    path: str
    span: Span
    text: str


@dataclass(frozen=True, slots=True)
class Create:
    """Write a file that is not there."""

    path: str
    text: str
    executable: bool = False


@dataclass(frozen=True, slots=True)
class Delete:
    path: str


@dataclass(frozen=True, slots=True)
class Move:
    path: str
    to: str


@dataclass(frozen=True, slots=True)
class Chmod:
    path: str
    executable: bool


Operation = Edit | Create | Delete | Move | Chmod


@dataclass(frozen=True, slots=True)
class Fix:
    """A repair in one line, and its operations on files; raises ValueError when its own edits overlap."""

    title: str
    operations: tuple[Operation, ...]
    safety: Safety = Safety.SAFE

    def __post_init__(self) -> None:
        spans: dict[str, list[Span]] = defaultdict(list)
        for operation in self.operations:
            if isinstance(operation, Edit):
                spans[operation.path].append(operation.span)
        for path, found in spans.items():
            found.sort()
            if any(a.end > b.start for a, b in pairwise(found)):
                raise ValueError(f"the edits of one fix overlap in {path}: {self.title}")


AGAIN = "and here"
"""What is said of another place of the same fault, at the same level."""
ALSO = ("here too", AGAIN)
"""All that is said of such a place."""


@dataclass(frozen=True, slots=True)
class Related:
    """Another location that explains a hit."""

    path: str
    span: Span
    message: str


@dataclass(frozen=True, slots=True)
class Hit:
    """One location where a rule has a finding; the engine adds code, name and level.

    Paths are relative to the package; one that begins with `/` is relative to the root of the run.
    """

    path: str
    span: Span
    message: str
    level: Severity | None = None
    related: tuple[Related, ...] = ()
    fix: Fix | None = None


@dataclass(frozen=True, slots=True)
class Location:
    """A span of a file with its lines and columns (from 1, in code points; the end is exclusive)."""

    path: str
    span: Span
    line: int
    column: int
    end_line: int
    end_column: int


@dataclass(frozen=True, slots=True)
class Finding:
    """A hit with its rule, severity and location. Paths are relative to the root of the run."""

    code: str
    name: str
    severity: Severity
    message: str
    location: Location
    package: str
    excerpt: str = ""
    """The line of source at `place.line`."""
    related: tuple[tuple[Location, str], ...] = ()
    fix: Fix | None = None
    edit_locations: tuple[Location, ...] = ()
    """One for each Edit of `fix`, in order."""
    suppressed: str | None = None
    """Why this finding is not reported; None where it is."""
    external: bool = False
    """Whether the config or a baseline suppresses it, not a comment in the file."""

    @property
    def is_loud(self) -> bool:
        """Whether it is a warning or an error."""
        return self.severity is not Severity.INFO

    @property
    def fix_options(self) -> str:
        """The options of `rospkg lint` that apply the fix; "" where there is none."""
        if self.fix is None:
            return ""
        unsafe = " --unsafe-fixes" if self.fix.safety is Safety.UNSAFE else ""
        return f"--fix{unsafe}" + (" --fix-level info" if self.severity is Severity.INFO else "")

    @property
    def sort_key(self) -> tuple[str, int, str, str]:
        return (self.location.path, self.location.span.start, self.code, self.message)
