"""A file that a robot names and that is not there, and the sentences about it."""

from __future__ import annotations

from typing import Literal

from ...light_dataclasses import dataclass
from ...source import Span
from ..other_places import goes_elsewhere, how_to_find_it

SHOWN = 4
"""How many other files a message names."""
State = Literal["absent", "not installed", "elsewhere"]


@dataclass(frozen=True, slots=True)
class MissingResource:
    """A file that is referenced and does not exist at run time; or several in one folder that does not."""

    span: Span
    package: str
    path: str
    state: State
    is_include: bool
    suggestion: str | None = None
    """The likely path: of the file, or of the folder where that is missing; for `elsewhere`, where it is installed."""
    folder: str = ""
    """The outermost folder of the path that does not exist."""
    others: tuple[MissingResource, ...] = ()
    """Other places that refer to it, or to what the same missing folder should hold."""
    is_model: bool = False
    """Whether `package` is a model of Gazebo, and no package."""

    @property
    def spans(self) -> tuple[Span, ...]:
        return (self.span, *(each.span for each in self.others))

    @property
    def other_paths(self) -> frozenset[str]:
        return frozenset(each.path for each in self.others) - {self.path}


def wrong(missing: MissingResource, own: str) -> str:
    several = listed(sorted(missing.other_paths))
    if missing.state == "not installed":
        verb, them = ("are", "them") if several else ("is", "it")
        return f"`{missing.path}`{several} {verb} there, but `{missing.package}` does not install {them}"
    if missing.state == "elsewhere":
        more = f" (and {len(missing.other_paths)} more elsewhere, too)" if several else ""
        return goes_elsewhere(missing.package, missing.path, missing.suggestion or "") + more
    verb = "has" if missing.package == own else "installs"
    if missing.is_model:
        return f"the model `{missing.package}` has no file `{missing.path}`{several}"
    if missing.folder:
        return f"`{missing.package}` {verb} no folder `{missing.folder}` for `{missing.path}`{several}"
    return f"`{missing.package}` {verb} no file `{missing.path}`{several}"


def listed(others: list[str]) -> str:
    """Return the names of a few others, and how many there are more."""
    if not others:
        return ""
    shown, more = others[:SHOWN], len(others) - SHOWN
    last = f" and {more} more" if more > 0 else f" and `{shown.pop()}`"
    return "".join(f", `{each}`" for each in shown) + last


def advice(missing: MissingResource) -> str:
    if missing.state == "not installed":
        folder = missing.path.rpartition("/")[0] or missing.path
        return f"; install `{folder}` (`data_files` in setup.py, `install(…)` in CMakeLists.txt)"
    if missing.state == "elsewhere":
        return f"; {how_to_find_it(missing.package, missing.path, missing.suggestion or '')}"
    return f"; did you mean `{missing.suggestion}`?" if missing.suggestion else "; add it, or correct the path"


def also(missing: MissingResource, other: MissingResource) -> str:
    return "here too" if other.path == missing.path else f"`{other.path}` too"
