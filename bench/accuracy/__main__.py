"""python -m bench.accuracy count FOLDER… | sheet FOLDER… [--warnings N --seed N] [--base PYTHON --most N] |
tally SHEET FIRST SECOND

With --base the sheet has what the rospkg_cli of another Python does not say.

Options of lint follow a `--`: python -m bench.accuracy count ~/src/* -- --target jazzy
"""

from __future__ import annotations

import argparse
import sys
from pathlib import Path

from bench.accuracy.count import count
from bench.accuracy.new import new_reports
from bench.accuracy.reports import reports
from bench.accuracy.sheet import read_lines, sheet
from bench.accuracy.tally import tally


def main() -> None:
    arguments = sys.argv[1:]
    cut = arguments.index("--") if "--" in arguments else len(arguments)
    given, options = parser().parse_args(arguments[:cut]), arguments[cut + 1 :]
    if given.verb == "count":
        print(count(list(reports(given.folders, options))))
    elif given.verb == "sheet":
        found = reports(given.folders, options)
        if given.base:
            found = new_reports(given.folders, given.base, options, given.most, given.seed)
        print(*sheet(list(found), given.warnings, given.seed), sep="\n")
    else:
        print(tally(read_lines(given.sheet), given.first, given.second))


def parser() -> argparse.ArgumentParser:
    made = argparse.ArgumentParser(prog="python -m bench.accuracy", description=__doc__)
    verbs = made.add_subparsers(dest="verb", required=True)
    for verb in ("count", "sheet"):
        parts = verbs.add_parser(verb)
        parts.add_argument("folders", nargs="+", type=Path)
        parts.add_argument("--warnings", type=int, default=150)
        parts.add_argument("--seed", type=int, default=1)
        parts.add_argument("--base", default="")
        parts.add_argument("--most", type=int, default=5)
    parts = verbs.add_parser("tally")
    for name in ("sheet", "first", "second"):
        parts.add_argument(name, type=Path)
    return made


if __name__ == "__main__":
    main()
