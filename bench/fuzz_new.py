"""Ask `new` for packages with hostile texts and names: it refuses in one sentence, or writes what is right.

python -m bench.fuzz_new [--seconds 600] [--seed 1] [--case N]

What is written is linted by all rules and read by Python, expat, PyYAML and configparser; description and maintainer
have to come back as they were given, and nothing may appear outside of the package. A case depends on seed and number
alone: `--case N` shows one again. Exit status: 1 where something was found.
"""

from __future__ import annotations

import argparse
import contextlib
import io
import os
import random
import tempfile
import time
import traceback
import unicodedata
from collections import Counter
from collections.abc import Iterator
from dataclasses import asdict
from pathlib import Path

from rospkg_cli.cli import UsageError
from rospkg_cli.cli.new.run import new
from rospkg_cli.scaffold.answers import Request

from .fuzz_check import problems
from .fuzz_texts import request


def trial(asked: Request, outer: Path) -> tuple[str, list[str]]:
    """Run `new` below a folder; return `refused`, `written` or `raised`, and what is wrong."""
    into = outer / "ws/src"
    into.mkdir(parents=True)
    os.chdir(outer)
    said = io.StringIO()
    try:
        with contextlib.redirect_stdout(said), contextlib.redirect_stderr(said):
            new(asked, into)
    except UsageError as refused:
        return "refused", list(badly_refused(str(refused), outer))
    except Exception:
        return "raised", [traceback.format_exc(limit=-4)]
    wrong = [f"beside: {name}" for name in strays(outer, asked.name)]
    return "written", wrong + list(problems(into / asked.name, asked))


def badly_refused(said: str, outer: Path) -> Iterator[str]:
    if not said.strip() or any(unicodedata.category(char) in ("Cc", "Cs", "Zl", "Zp") for char in said):
        yield f"no sentence: {said!r}"
    if len(said) > 3000:
        yield f"a sentence of {len(said)} characters"
    yield from (f"refused, and there is {name}" for name in strays(outer, ""))


def strays(outer: Path, name: str) -> set[str]:
    """Return what lies below the folder and is neither `ws/src` nor in the package."""
    found = {path.relative_to(outer).as_posix() for path in outer.rglob("*")}
    return {path for path in found - {"ws", "ws/src"} if not name or not f"{path}/".startswith(f"ws/src/{name}/")}


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--seconds", type=float, default=600.0)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--case", type=int)
    options = parser.parse_args()
    counts: Counter[str] = Counter()
    home = Path.cwd()
    until, case = time.monotonic() + options.seconds, options.case or 0
    while time.monotonic() < until:
        asked = request(random.Random(f"{options.seed} {case}"))
        with tempfile.TemporaryDirectory() as folder:
            how, wrong = trial(asked, Path(folder))
            os.chdir(home)
        counts[how] += 1
        for each in wrong:
            counts["wrong"] += 1
            print(f"case {case}: {how}: {each}\n  { ({k: v for k, v in asdict(asked).items() if v})!a}", flush=True)
        if options.case is not None:
            break
        case += 1
    print(", ".join(f"{count} {how}" for how, count in sorted(counts.items())))
    return 1 if counts["wrong"] else 0


if __name__ == "__main__":
    raise SystemExit(main())
