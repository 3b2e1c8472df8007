"""Compare our verdict on parameter files with that of the real rcl, on real files and on damaged ones.

python -m bench.params FOLDER... --rcl PROGRAM [--mutations 3000] [--seed 1]

PROGRAM is rcl_verdicts.c, built as it says.  What we refuse on purpose and rcl takes is counted by itself: empty lists
(rclcpp stops at them), lists of lists and of mappings (rcl makes parameters of them that nobody wrote),
documents and blocks that are no mappings.
"""

from __future__ import annotations

import argparse
import random
import subprocess
import tempfile
from collections import Counter
from collections.abc import Iterator, Sequence
from pathlib import Path

from rospkg_cli.checks.params.rcl_validation import rcl_faults
from rospkg_cli.checks.params.ros_parameters_key import key_faults
from rospkg_cli.languages.yaml.nodes import documents
from rospkg_cli.package.params.parameter_file import ParameterFile, has_placeholder
from rospkg_cli.package.params.read_parameter_files import is_parameter_file
from rospkg_cli.source import Source
from rospkg_cli.unreadable import UnreadableError

from .mutate import mutate

WORDS = (
    " ", "  ", "\n", "\n  ", "\n    ", ":", ": ", "- ", "[", "]", "[1, 2.0]", "[1, x]", "[]", "{}", "{a: 1}", ",",
    "&a ",
    "*a", "!!str ", "'", '"', "#", " #", "ros__parameters:", "ros_parameters:", "/**:\n", "my_node:\n", "/", "-", "1",
    "1.0", "1e-9", "true", "y", "null", "~", "a: 1\n", "\n    extra:\n", "\n  stray: 1\n", "\n---\n", "|\n", "<<: ",
    "\n      - 1\n", "\n      - b: 1\n", "1_000", "0x1F", "010", "$(var x)", "\t",
)  # fmt: skip

ON_PURPOSE = ("empty list", "a list inside", "a mapping inside", "empty mapping", "is a mapping:", "nothing else")


def files_in(folder: Path) -> Iterator[str]:
    for path in sorted(folder.rglob("*")):
        if path.suffix in (".yaml", ".yml") and path.is_file():
            text = path.read_bytes().decode("utf-8", "replace")
            if is_parameter_file(Source("", text)):
                yield text


def ours(text: str) -> list[str]:
    """Return what we find; nothing where the file is taken."""
    source = Source("params.yaml", text)
    try:
        file = ParameterFile(source, tuple(documents(source)))
        return [fault.message for fault in (*key_faults(file), *rcl_faults(file))]
    except UnreadableError as error:
        return [error.unreadable.message]


def theirs(texts: Sequence[str], program: str) -> list[str]:
    with tempfile.TemporaryDirectory() as folder:
        paths = [Path(folder, f"{number}.yaml") for number in range(len(texts))]
        for path, text in zip(paths, texts, strict=True):
            path.write_text(text, encoding="utf-8", newline="")
        asked = "".join(f"{path}\n" for path in paths)
        return subprocess.run([program], input=asked, capture_output=True, text=True, check=True).stdout.splitlines()


def compare(title: str, texts: Sequence[str], program: str) -> int:
    count: Counter[str] = Counter()
    for text, said in zip(texts, theirs(texts, program), strict=True):
        messages = ours(text)
        if bool(messages) == said.startswith("ERR"):
            count["both refuse it" if messages else "both take it"] += 1
        elif not messages and has_placeholder(text):
            count["left alone: filled in at launch"] += 1
        elif messages and all(any(word in message for word in ON_PURPOSE) for message in messages):
            count["refused on purpose"] += 1
        else:
            count["differ"] += 1
            print(f"  rcl: {said}; ours: {messages or 'takes it'}\n{text!r}")
    print(f"{title}: " + ", ".join(f"{number} {what}" for what, number in sorted(count.items())))
    return count["differ"]


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folders", nargs="+", type=Path)
    parser.add_argument("--rcl", required=True)
    parser.add_argument("--mutations", type=int, default=3000)
    parser.add_argument("--seed", type=int, default=1)
    args = parser.parse_args()
    real = [text for folder in args.folders for text in files_in(folder)]
    chance = random.Random(args.seed)
    short = [text for text in real if len(text) < 2000] or real
    damaged = [mutate(chance.choice(short), WORDS, chance) for _ in range(args.mutations)]
    return 1 if compare("real", real, args.rcl) + compare("damaged", damaged, args.rcl) else 0


if __name__ == "__main__":
    raise SystemExit(main())
