"""Single faults put into real packages: does lint see them, and what does it say beside?

    python -m bench.faults REPOSITORY… [--seed N] [--kinds WORD…] [--per-kind 8] [--rosdistro FOLDER] [--trials FILE]

Every kind of fault is put into so many packages of the checkouts, one at a time, in a copy that shares all other files.
Killed: a finding of the default rules that was not there before, and names the thing (the old name, the new one, or the
file). Beside: all other new findings. Excluded: nothing fails, or nobody could know, as the kind says.
"""

from __future__ import annotations

import argparse
import json
import os
import subprocess
import sys
import tempfile
from collections.abc import Iterator, Sequence
from contextlib import ExitStack
from pathlib import Path

from bench.faults.draw import draw
from bench.faults.kinds import KINDS, FaultKind
from bench.faults.load import load
from bench.faults.source_package import SourcePackage, packages_of
from bench.faults.table import described, table
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
        trials = []
        for trial in run(kinds, packages, arguments, Linter(arguments.preview), Path(scratch)):
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
    return made


def run(
    kinds: Sequence[FaultKind],
    packages: Sequence[SourcePackage],
    arguments: argparse.Namespace,
    linter: Linter,
    scratch: Path,
) -> Iterator[Trial]:
    copies: dict[Path, WorkingCopy] = {}
    for number, kind in enumerate(kinds, 1):
        found = []
        for package, fault in draw(kind, packages, arguments.per_kind, arguments.seed):
            home = package.repository
            copies[home] = copies.get(home) or WorkingCopy(home, scratch / f"{len(copies)}" / home.name)
            found.append(attempt(linter, copies[home], kind, package, fault))
        killed = sum(bool(each.told) for each in found)
        print(f"{number}/{len(kinds)} {kind.name}: {killed} of {len(found)}", file=sys.stderr, flush=True)
        yield from found


def as_record(trial: Trial) -> dict[str, object]:
    return {
        "kind": trial.kind.name,
        "family": trial.kind.family,
        "place": described(trial),
        "package": trial.package.name,
        "killed": bool(trial.told),
        "told": trial.told,
        "beside": trial.beside,
        "excluded": trial.excluded,
    }


def fetch_index(rosdistro: Path) -> None:
    command = [sys.executable, "-m", "rospkg_cli", "index", "update", "--source", str(rosdistro), "--quiet"]
    subprocess.run(command, check=True)


if __name__ == "__main__":
    main()
