"""Compare our verdict on plain URDF with that of check_urdf (Debian: liburdfdom-tools), on real and on damaged files.

python -m bench.urdf FOLDER... [--mutations 1000] [--seed 1] [--check check_urdf]

Files that xacro makes something of first, and pieces without links and joints, are left out.  XML that is none is left
to the two XML readers.  What we refuse on purpose and check_urdf takes is counted by itself.
"""

from __future__ import annotations

import argparse
import random
import re
import subprocess
import tempfile
from collections import Counter
from collections.abc import Iterator, Sequence
from pathlib import Path

from rospkg_cli.checks.urdf.validation import robot_faults
from rospkg_cli.package.urdf.reader import robot_file
from rospkg_cli.package.urdf.robot_file import RobotFile
from rospkg_cli.source import Source
from rospkg_cli.unreadable import UnreadableError

ON_PURPOSE = ("child of two joints", "in a circle", "no joint of the robot is called", "the link has no `name`")
PIECE = "a piece without links and joints"

NAME = re.compile(r'(?:name|link|joint|type)="[^"]*"')
VALUE = re.compile(r'"[^"]*"')
ELEMENT = re.compile(r"<(\w+)[^<>]*/>")
WORDS = ("", "1", "x", "1 2", "0 0 0", "1e-3", "-.5", "1.", "0,0,0", "nan", "0 0  0", " 1", "1 ", "revolute", "fixed")


def mutate(text: str, chance: random.Random) -> str:
    for _ in range(chance.choice((1, 1, 2))):
        text = chance.choice((other_value, swapped_name, without_element, doubled, without_attribute, renamed))(
            text, chance
        )
    return text


def one(pattern: re.Pattern[str], text: str, chance: random.Random) -> re.Match[str] | None:
    found = list(pattern.finditer(text))
    return chance.choice(found) if found else None


def replaced(text: str, match: re.Match[str] | None, new: str) -> str:
    return text if match is None else text[: match.start()] + new + text[match.end() :]


def other_value(text: str, chance: random.Random) -> str:
    return replaced(text, one(VALUE, text, chance), f'"{chance.choice(WORDS)}"')


def swapped_name(text: str, chance: random.Random) -> str:
    match, other = one(NAME, text, chance), one(VALUE, text, chance)
    return replaced(text, match, f"{match.group().partition('=')[0]}={other.group()}") if match and other else text


def without_element(text: str, chance: random.Random) -> str:
    return replaced(text, one(ELEMENT, text, chance), "")


def doubled(text: str, chance: random.Random) -> str:
    match = one(re.compile(r"<(link|joint|material)\b.*?</\1>", re.DOTALL), text, chance)
    return replaced(text, match, match.group() * 2) if match else text


def without_attribute(text: str, chance: random.Random) -> str:
    return replaced(text, one(re.compile(r'\s\w+="[^"]*"'), text, chance), "")


def renamed(text: str, chance: random.Random) -> str:
    match = one(ELEMENT, text, chance)
    other = chance.choice(("box", "mesh", "foo", "limit"))
    return replaced(text, match, match.group().replace(match.group(1), other, 1)) if match else text


def files_in(folder: Path) -> Iterator[str]:
    for path in sorted(folder.rglob("*.urdf")):
        if path.is_file():
            text = path.read_bytes().decode("utf-8", "replace").lstrip("\ufeff").replace("\r\n", "\n")
            if not re.search(r"xacro:|\$|<!DOCTYPE", text) and (found := read(text)) and (found.links or found.joints):
                yield text


def read(text: str) -> RobotFile | None:
    try:
        return robot_file(Source("robot.urdf", text))
    except UnreadableError:
        return None


def ours(text: str) -> list[str] | None:
    """Return what urdfdom refuses, as we see it; None where the XML is broken."""
    found = read(text)
    if found and not found.links and not found.joints and not robot_faults(found):
        return [PIECE]
    return None if found is None else [fault.message for fault in robot_faults(found) if fault.level is None]


def taken(text: str, program: str) -> bool:
    with tempfile.NamedTemporaryFile("w", suffix=".urdf", encoding="utf-8") as file:
        file.write(text)
        file.flush()
        return subprocess.run([program, file.name], capture_output=True).returncode == 0


def compare(title: str, texts: Sequence[str], program: str) -> int:
    count: Counter[str] = Counter()
    for text in texts:
        messages = ours(text)
        if messages is None:
            count["broken XML"] += 1
            continue
        if messages == [PIECE]:
            count["pieces, left alone"] += 1
            continue
        accepted = taken(text, program)
        if accepted is not bool(messages):
            count["both take it" if accepted else "both refuse it"] += 1
        elif messages and all(any(word in message for word in ON_PURPOSE) for message in messages):
            count["refused on purpose"] += 1
        else:
            count["differ"] += 1
            print(f"  check_urdf {'takes' if accepted else 'refuses'} it; ours: {messages}")
    print(f"{title}: {len(texts)}: " + ", ".join(f"{number} {what}" for what, number in sorted(count.items())))
    return count["differ"]


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folders", nargs="+", type=Path)
    parser.add_argument("--check", default="check_urdf")
    parser.add_argument("--mutations", type=int, default=1000)
    parser.add_argument("--seed", type=int, default=1)
    args = parser.parse_args()
    real = list(dict.fromkeys(text for folder in args.folders for text in files_in(folder)))
    chance = random.Random(args.seed)
    damaged = [mutate(chance.choice(real), chance) for _ in range(args.mutations)]
    return 1 if compare("real", real, args.check) + compare("damaged", damaged, args.check) else 0


if __name__ == "__main__":
    raise SystemExit(main())
