"""The outcome by kind and by family."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from bench.faults.fault import PutFault
from bench.faults.source_package import SourcePackage
from bench.faults.trial import Trial

HEAD = f"{'':44}{'tried':>6}{'killed':>7}{'beside':>7}{'added':>6}{'excluded':>9}"


def table(trials: Sequence[Trial]) -> Iterator[str]:
    """Yield the lines of the table: families, their kinds, and all."""
    yield HEAD
    for family in dict.fromkeys(each.kind.family for each in trials):
        of_family = [each for each in trials if each.kind.family == family]
        yield row(family, of_family)
        for name in dict.fromkeys(each.kind.name for each in of_family):
            yield row(f"  {name}", [each for each in of_family if each.kind.name == name])
    yield row("all", trials)
    yield summary(trials)


def row(name: str, trials: Sequence[Trial]) -> str:
    killed = sum(bool(each.told) for each in trials)
    beside = sum(each.beside_count for each in trials)
    added = sum(each.added_count for each in trials)
    excluded = sum(bool(each.excluded) for each in trials)
    return f"{name:44}{len(trials):>6}{killed:>7}{beside:>7}{added:>6}{excluded:>9}"


def summary(trials: Sequence[Trial]) -> str:
    killed = sum(bool(each.told) for each in trials)
    counted = [each for each in trials if not each.excluded]
    rest = sum(bool(each.told) for each in counted)
    beside = sum(each.beside_count for each in trials)
    added = sum(each.added_count for each in trials)
    kinds, places = {each.kind.name for each in trials}, {each.package.repository for each in trials}
    return (
        f"{len(kinds)} kinds, {len(places)} repositories: killed {share(killed, len(trials))} of all, "
        f"{share(rest, len(counted))} of those not excluded ({share(len(trials) - len(counted), len(trials))}); "
        f"{beside / max(len(trials), 1):.2f} findings beside, {added / max(len(trials), 1):.2f} added"
    )


def share(part: int, whole: int) -> str:
    return f"{part / max(whole, 1):.1%}"


def place(package: SourcePackage, fault: PutFault) -> str:
    """Return where a fault lies, and by what names it may be called: always the same for the same fault."""
    names = " ".join(fault.names[:4]).replace("\n", " ")[:100]
    return f"{package.repository.name}/{fault.path}" + (f":{fault.line}" if fault.line else "") + f"  [{names}]"
