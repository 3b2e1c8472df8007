"""Compare our verdict on interface files with that of the real rosidl, on real files and on damaged ones.

python -m bench.interfaces FOLDER... [--mutations 3000] [--seed 1] [--python /usr/bin/python3]

A verdict says that adapter and parser take the text (file names and unknown types aside); what differs on purpose is
counted by itself.  Exits with 1 where anything else differs.
"""

from __future__ import annotations

import argparse
import json
import random
import subprocess
from collections import Counter
from collections.abc import Iterator, Sequence
from pathlib import Path

from rospkg_cli.checks.interfaces.grammar_sentences import sentence_of
from rospkg_cli.checks.interfaces.member_names import is_accepted
from rospkg_cli.package.interfaces.text import parse_interface
from rospkg_cli.source import Source

from .mutate import mutate

Case = tuple[str, str, str]
"""Kind, name, text."""

WORDS = (
    " ", "\t", "#", "[", "]", "[3]", "[<=3]", "[]", "<=", "<=5", "=", " = ", "---", "\n---\n", "\n", "\n ", "\"",
    "'", " 5", " -1", " 300", " 0x1F", " 1e-3", " nan", " true", " [1, 2]", " \"a\"", " \"a#b\"", " 'it\\'s'",
    " [\"a\", 'b']", "\\", "\\n", "\\x", " # C:\\Users", " [m/s]", "# [m", "m]", "_", "__", "A", "std_msgs/Header",
    "std_msgs/msg/Header", "Header", "time", "int", "string<=10", "wstring", "Foo", "int32 A=1\n", "int32 a\n",
    "float64[2] x [1, 2]\n", "\nstring s 'x, y'\n", "\nstring[] s ['x', \"y\"]\n", "é", ";", ",", "/", "\u00a0",
    "\r",
)  # fmt: skip

ON_PURPOSE = ("even inside quotes",)
"""Words of the messages about what rosidl takes silently, and otherwise than it is written."""


def files_in(folder: Path) -> Iterator[Case]:
    """Yield the interface files below a folder, each as rosidl reads it."""
    for path in sorted(folder.rglob("*")):
        if path.suffix in (".msg", ".srv", ".action") and path.is_file():
            yield path.suffix[1:], path.stem, universal(path.read_bytes().decode("utf-8", "replace"))


def universal(text: str) -> str:
    return text.replace("\r\n", "\n").replace("\r", "\n")


def ours(case: Case) -> tuple[bool, list[str]]:
    found = parse_interface(Source(f"{case[0]}/{case[1]}.{case[0]}", case[2]), case[0])
    return is_accepted(found), [sentence_of(problem) for problem in found.problems]


def theirs(cases: Sequence[Case], python: str) -> list[str | None]:
    script = Path(__file__).with_name("rosidl_verdicts.py")
    asked = "".join(json.dumps((kind, "Foo", text)) + "\n" for kind, _, text in cases)
    done = subprocess.run([python, "-B", str(script)], input=asked, capture_output=True, text=True, check=True, env={})
    return [json.loads(line) for line in done.stdout.splitlines()]


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folders", nargs="+", type=Path)
    parser.add_argument("--mutations", type=int, default=3000)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--python", default="/usr/bin/python3")
    args = parser.parse_args()
    found = [list(files_in(folder)) for folder in args.folders]
    real = [case for cases in found for case in cases]
    chance = random.Random(args.seed)
    picked = [chance.choice(real) for _ in range(args.mutations)]
    damaged = [(kind, name, universal(mutate(text, WORDS, chance))) for kind, name, text in picked]
    print(f"{len(real)} files of {sum(map(bool, found))} folders, {len(damaged)} mutations")
    wrong = compare("real", real, args.python) + compare("damaged", damaged, args.python)
    return 1 if wrong else 0


def compare(title: str, cases: Sequence[Case], python: str) -> int:
    count: Counter[str] = Counter()
    for case, error in zip(cases, theirs(cases, python), strict=True):
        accepted, messages = ours(case)
        if accepted == (error is None):
            count["both take it" if accepted else "both refuse it"] += 1
        elif error is None and messages and all(any(word in m for word in ON_PURPOSE) for m in messages):
            count["differ on purpose"] += 1
        else:
            count["differ"] += 1
            print(f"  {case[0]} {case[1]}: rosidl: {error or 'takes it'}; ours: {messages or accepted}\n{case[2]!r}")
    print(f"{title}: " + ", ".join(f"{number} {what}" for what, number in sorted(count.items())))
    return count["differ"]


if __name__ == "__main__":
    raise SystemExit(main())
