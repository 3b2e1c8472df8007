"""Repairs that people made: does lint name the fault before, and not after?

    python -m bench.repairs --mirror FOLDER [--repairs LIST] [--class WORD] [--rosdistro FOLDER] [--write]

FOLDER holds bare repositories as OWNER+NAME/repo. A line of the list is one repair: repository, commit before and
after, package, class, the token that a finding has to name, and what was repaired. They were chosen by reading the
history, before lint was asked. `--write` puts the verdicts into the list; `first` says what lint told when it first
saw a repair, before the misses taught rules.
"""

from __future__ import annotations

import argparse
import json
import os
import tempfile
from collections import Counter
from pathlib import Path
from subprocess import CalledProcessError

from bench.faults.index import fetch_index
from bench.repairs.verdict import Repair, verdict

LIST = Path(__file__).parents[1] / "repairs.jsonl"


def main() -> None:
    parser = argparse.ArgumentParser(prog="python -m bench.repairs", description=__doc__)
    parser.formatter_class = argparse.RawDescriptionHelpFormatter
    parser.add_argument("--mirror", type=Path, required=True)
    parser.add_argument("--repairs", type=Path, default=LIST)
    parser.add_argument("--class", dest="word", default="")
    parser.add_argument("--rosdistro", type=Path, help="a copy of ros/rosdistro: lint with an index of it")
    parser.add_argument("--write", action="store_true")
    arguments = parser.parse_args()
    with tempfile.TemporaryDirectory(prefix="repairs-") as scratch:
        os.environ["XDG_CACHE_HOME"] = scratch
        os.environ.pop("ROS_DISTRO", None)
        if arguments.rosdistro:
            fetch_index(arguments.rosdistro)
        judge_all(arguments)


def judge_all(arguments: argparse.Namespace) -> None:
    repairs: list[Repair] = [json.loads(line) for line in arguments.repairs.read_text("utf-8").splitlines()]
    counts, left_out = Counter[str](), 0
    for repair in repairs:
        if arguments.word in repair["class"]:
            repair["verdict"] = judged(arguments.mirror, repair)
            counts[repair["verdict"]] += 1
            left_out += "excluded" in repair
            if repair["verdict"] != "solved":
                print(f"{repair['id']}: {repair['verdict']}: {repair['repo']} {repair['package']} {repair['token']}")
    if arguments.write:
        lines = [json.dumps(each, ensure_ascii=False) + "\n" for each in repairs]
        arguments.repairs.write_text("".join(lines), encoding="utf-8")
    total = sum(counts.values()) - counts["absent"]
    print(f"solved {counts['solved']} of {total} = {counts['solved'] / max(total, 1):.1%}; {dict(counts)}")
    print(f"{left_out} of them are excluded, each with its reason in the list")


def judged(mirror: Path, repair: Repair) -> str:
    try:
        return verdict(mirror, repair)
    except CalledProcessError:
        return "absent"


if __name__ == "__main__":
    main()
