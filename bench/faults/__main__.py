"""Single faults put into real packages: does lint see them, and what does it say beside?

    python -m bench.faults REPOSITORY… [--seed N] [--kinds WORD…] [--per-kind 8] [--trials FILE] [--again FILE]

Every kind of fault is put into so many packages of the checkouts, one at a time, in a copy that shares all other files.
Killed: a finding of the default rules that was not there before, and names the thing (the old name, the new one, or the
file). Beside: all other new findings; added: those of them in whose place none is gone. Excluded: nothing fails, or
nobody could know, as the kind says.
"""

from __future__ import annotations

import argparse
import json
import os
import sys
import tempfile
from collections.abc import Iterator, Sequence
from contextlib import ExitStack
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from bench.faults.draw import draw
from bench.faults.fault import PutFault
from bench.faults.index import fetch_index
from bench.faults.kinds import KINDS, FaultKind
from bench.faults.load import load
from bench.faults.source_package import SourcePackage, packages_of
from bench.faults.table import place, table
from bench.faults.trial import Linter, Trial, attempt
from bench.faults.working_copy import WorkingCopy


def main() -> None:
    load()
    arguments = parser().parse_args()
    kinds = [each for name, each in KINDS.items() if not arguments.kinds or any(k in name for k in arguments.kinds)]
    packages = [each for repository in arguments.repositories for each in packages_of(repository.resolve())]
    with ExitStack() as scope:
        scratch = scope.enter_context(tempfile.TemporaryDirectory(prefix="faults-"))
        os.environ["XDG_CACHE_HOME"] = str(Path(scratch, "cache"))
        os.environ.pop("ROS_DISTRO", None)
        os.environ.pop("AMENT_PREFIX_PATH", None)
        if arguments.rosdistro:
            fetch_index(arguments.rosdistro)
        kept = scope.enter_context(arguments.trials.open("w", encoding="utf-8")) if arguments.trials else None
        trials, known = [], read_records(arguments.again)
        for trial in run(kinds, packages, arguments, Copies(Linter(arguments.preview), Path(scratch), known)):
            trials.append(trial)
            if kept:
                print(json.dumps(as_record(trial)), file=kept, flush=True)
    print(*table(trials), sep="\n")


def parser() -> argparse.ArgumentParser:
    made = argparse.ArgumentParser(prog="python -m bench.faults", description=__doc__)
    made.formatter_class = argparse.RawDescriptionHelpFormatter
    made.add_argument("repositories", nargs="+", type=Path)
    made.add_argument("--seed", type=int, default=1)
    made.add_argument("--kinds", nargs="*", metavar="WORD", help="those whose names hold a word")
    made.add_argument("--per-kind", type=int, default=8)
    made.add_argument("--preview", action="store_true")
    made.add_argument("--rosdistro", type=Path, help="a copy of ros/rosdistro: lint with an index of it")
    made.add_argument("--trials", type=Path, help="a file for one line of JSON a fault")
    made.add_argument("--again", type=Path, help="such a file of an earlier run: try only what was not killed there")
    return made


Record = dict[str, Any]


@dataclass
class Copies:
    """Tries faults in copies of the repositories, which are made when they are needed."""

    linter: Linter
    scratch: Path
    known: dict[tuple[str, str], Record]
    """What an earlier run killed, by kind and place: it is not tried again."""
    made: dict[Path, WorkingCopy] = field(default_factory=dict)

    def trial(self, kind: FaultKind, package: SourcePackage, fault: PutFault) -> Trial:
        if before := self.known.get((kind.name, place(package, fault))):
            return Trial(kind, package, fault, tuple(before["told"]), tuple(before["beside"]), before["reworded"])
        home = package.repository
        if home not in self.made:
            self.made[home] = WorkingCopy(home, self.scratch / f"{len(self.made)}" / home.name)
        return attempt(self.linter, self.made[home], kind, package, fault)


def run(
    kinds: Sequence[FaultKind], packages: Sequence[SourcePackage], arguments: argparse.Namespace, copies: Copies
) -> Iterator[Trial]:
    for number, kind in enumerate(kinds, 1):
        drawn = draw(kind, packages, arguments.per_kind, arguments.seed)
        found = [copies.trial(kind, package, fault) for package, fault in drawn]
        killed = sum(bool(each.told) for each in found)
        print(f"{number}/{len(kinds)} {kind.name}: {killed} of {len(found)}", file=sys.stderr, flush=True)
        yield from found


def read_records(file: Path | None) -> dict[tuple[str, str], Record]:
    """Return the killed faults of an earlier run."""
    lines = file.read_text("utf-8").splitlines() if file else []
    records: list[Record] = [json.loads(line) for line in lines]
    return {(each["kind"], each["place"]): each for each in records if each["killed"]}


def as_record(trial: Trial) -> Record:
    return {
        "kind": trial.kind.name,
        "family": trial.kind.family,
        "place": place(trial.package, trial.fault),
        "names": trial.fault.names,
        "package": trial.package.name,
        "killed": bool(trial.told),
        "told": trial.told,
        "beside": trial.beside,
        "reworded": trial.reworded,
        "excluded": trial.excluded,
    }


if __name__ == "__main__":
    main()
