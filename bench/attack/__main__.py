"""Does anything that lies in a folder make us stumble? `python -m bench.attack FOLDER… [--cases 0-9999] [--jobs 2]`

Takes the small packages below some folders, damages a file of each of 16 kinds in turn (bytes, words, lines, pieces of
other files, depth, repeats, encodings) or the working tree itself (links, FIFOs, sockets, odd names, empty folders),
and runs each input through the commands in this process: lint with all rules and every format, inspect, --fix (of some
inputs with the unsafe ones) and format on copies, each twice.  An input fails where a rule or command raises, a command
takes over 5 s of CPU or over 1 GiB, an output holds a raw control character, a workflow command or what stands outside
of the package, is no JSON or XML, a well-formed file is so no more, a second repair changes anything, lint changes
anything, or anything changes outside of the package.  A process that hangs or dies is one failed input.
An input follows from --seed and its number, as long as the folders hold the same: `--cases 17 --keep DIR` makes one
again and leaves its tree there.

What the sample can't show: what only many packages together do, several processes, the shell's streams and signals,
what a fuzzer that is led by coverage would find, and damage to files over 400 kB or packages of over 60 files.
"""

from __future__ import annotations

import argparse
import json
import os
import re
import sys
import tempfile
import time
from collections import Counter, defaultdict
from collections.abc import Iterable
from pathlib import Path

from rospkg_cli.cli.explain import options as explain  # noqa: F401  (so that no process has to import them)
from rospkg_cli.cli.lint import options as lint  # noqa: F401

from .case import make_case, write_case
from .corpus import read_corpus
from .kinds import KINDS
from .work import Plan, Row, run_all, run_case


def numbers_of(text: str) -> range:
    """Return the numbers that A-B means."""
    first, _, last = text.partition("-")
    return range(int(first), int(last or first) + 1)


def arguments() -> argparse.Namespace:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folders", nargs="+", type=Path, help="real packages; they are only read")
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--cases", type=numbers_of, default=range(10_000), metavar="A-B")
    parser.add_argument("--only", type=Path, metavar="RESULTS", help="only those that failed there")
    parser.add_argument("--jobs", type=int, default=2)
    parser.add_argument("--results", type=Path, default=Path("attack.jsonl"), help="a line for each failed input")
    parser.add_argument("--keep", type=Path, metavar="DIR", help="leave the trees of failed inputs there")
    parser.add_argument("--room", type=Path, help="where the trees are made (else in memory, where that can be had)")
    return parser.parse_args()


def main() -> int:
    given = arguments()
    for name in ("ROS_DISTRO", "AMENT_PREFIX_PATH"):
        os.environ.pop(name, None)
    numbers = list(given.cases)
    if given.only:
        numbers = [json.loads(line)["case"] for line in given.only.read_text().splitlines()]
    memory = Path("/dev/shm")
    with tempfile.TemporaryDirectory(dir=given.room or (memory if memory.is_dir() else None)) as room:
        os.environ["HOME"] = os.environ["XDG_CACHE_HOME"] = room
        plan = Plan(read_corpus(given.folders), given.seed, Path(room))
        run_case(plan, 0)  # imports what every process will want
        began, rows = time.monotonic(), []
        with given.results.open("w") as stream:
            for row in run_all(plan, numbers, given.jobs):
                rows.append(row)
                if row["faults"]:
                    stream.write(json.dumps(row) + "\n")
                    stream.flush()
                    if given.keep:
                        write_case(make_case(plan.corpus, given.seed, row["case"]), given.keep / str(row["case"]))
                if len(rows) % 200 == 0:
                    print(
                        f"{len(rows)} of {len(numbers)}, {time.monotonic() - began:.0f} s", file=sys.stderr, flush=True
                    )
    print("\n".join(summary(rows)))
    return 1 if any(row["faults"] for row in rows) else 0


def summary(rows: Iterable[Row]) -> Iterable[str]:
    """Yield a table of the kinds, and the causes with the first inputs of each."""
    rows = sorted(rows, key=lambda row: row["case"])
    yield f"{'kind':<16}{'inputs':>8}{'failed':>8}{'CPU s':>9}{'most':>7}"
    for kind in KINDS:
        of_kind = [row for row in rows if row["kind"] == kind]
        spent = [sum(row["seconds"].values()) for row in of_kind] or [0.0]
        failed = sum(bool(row["faults"]) for row in of_kind)
        yield f"{kind:<16}{len(of_kind):>8}{failed:>8}{sum(spent):>9.1f}{max(spent):>7.2f}"
    total = sum(sum(row["seconds"].values()) for row in rows)
    failed = sum(bool(row["faults"]) for row in rows)
    yield f"{len(rows)} inputs, {failed} failed, {total / max(len(rows), 1):.3f} s of CPU each"
    statuses = Counter(f"{step} {status}" for row in rows for step, status in row["statuses"].items())
    yield "exit status: " + ", ".join(f"{each} × {count}" for each, count in sorted(statuses.items()))
    yield f"memory grew by at most {max((row['memory'] for row in rows), default=0):.0f} MiB in one input"
    causes: dict[tuple[str, str], list[str]] = defaultdict(list)
    for row in rows:
        for fault in row["faults"]:
            causes[sort_of(fault["what"]), fault["where"]].append(f"{row['case']} ({fault['step']})")
    for (what, where), cases in sorted(causes.items(), key=lambda each: -len(each[1])):
        yield f"{len(cases):>5}  {what}  {where or '-'}  {', '.join(list(dict.fromkeys(cases))[:6])}"


def sort_of(what: str) -> str:
    """Return what is common to faults of one cause: without names, numbers and what follows a colon."""
    first, _, rest = what.partition(": ")
    kept = first if "Error" in first or not rest else f"{first}: {rest}"
    return re.sub(r"\d+", "N", " ".join(kept.split()[:5]))[:70]


if __name__ == "__main__":
    sys.exit(main())
