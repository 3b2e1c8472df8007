"""What is said of Python files that end at a module of ROS 1 (DEP101)."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from ..checks.depends.import_use import ImportUse
from ..checks.depends.undeclared_imports import ImportDependencies
from ..finding import Hit, Related, Severity

LEFT = "; nothing starts or imports this module"
OPTIONAL = "; this module is imported only where that may fail"


def unneeded(imports: ImportDependencies, places: Iterable[ImportUse]) -> str:
    """Return the end of a message on modules that nothing needs; "" for others."""
    return LEFT if imports.reach.is_left(places) else OPTIONAL if imports.reach.are_optional(places) else ""


def ros1_leftovers(imports: ImportDependencies) -> Iterator[Hit]:
    """Yield one finding for all files that are used, and one for each reason why the others are not."""
    by_reason: dict[str, list[ImportUse]] = {}
    for each in imports.ends.leftovers():
        by_reason.setdefault(why_unmet(imports, each), []).append(each)
    for why, places in by_reason.items():
        yield ros1_leftover(places, why)


def why_unmet(imports: ImportDependencies, place: ImportUse) -> str:
    from ..checks.repository.run_under_ros1 import why_for_ros1  # few packages have such a file

    why = unneeded(imports, [place]) or imports.reach.why_unstarted([place]) or why_for_ros1(imports.files, place.path)
    is_beside = imports.places is not None and imports.places.unimported.is_skipped_by_importers(place.path)
    return why or (LEFT if is_beside else "")


def ros1_leftover(places: list[ImportUse], why: str) -> Hit:
    first, *others = places
    files, ends = (f"this file and {len(others)} more", "end") if others else ("this file", "ends")
    them, what = "them" if others else "it", f"`{first.module}` is a module of ROS 1"
    todo = f"port {them} to rclpy, or do not install {them}"
    message = f"{what}: {files} {ends} with ModuleNotFoundError before anything else; {todo}"
    also = tuple(Related(each.path, each.span, "and here") for each in others)
    return Hit(first.path, first.span, f"{message}{why}", Severity.INFO if why else None, also)
