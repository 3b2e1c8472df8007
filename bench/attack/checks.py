"""What must hold of an output and of a file, whatever the input was."""

from __future__ import annotations

import ast
import json
import os
import re
import stat
import xml.parsers.expat
from collections.abc import Iterator
from pathlib import Path, PurePosixPath

import yaml

from .trees import SECRET

RAW = re.compile("[\x00-\x08\x0b-\x1f\x7f-\x9f\u061c\u200e\u200f\u202a-\u202e\u2066-\u2069\ud800-\udfff]")
"""What a terminal obeys, or can't be written as UTF-8; a tab and the end of a line are let through."""
COMMAND = re.compile(r"^\s*::", re.MULTILINE)
"""How a line begins that GitHub obeys."""
GITHUB = re.compile(r"::(error|warning|notice|debug|group|endgroup)[ :]")

Tree = dict[str, tuple[int, bytes]]
"""Path → mode, and what a file holds or where a link leads."""


def faults_of_output(name: str, text: str) -> Iterator[str]:
    """Yield what is wrong with an output of a format (`said` is a message of the command)."""
    if raw := RAW.search(text):
        yield f"raw {raw[0]!a} in ...{text[max(raw.start() - 60, 0) : raw.end() + 20]!a}"
    if SECRET in text:
        at = text.index(SECRET)
        yield f"shows what stands outside: ...{text[max(at - 80, 0) : at + 30]!a}"
    if name in ("text", "concise", "inspect", "said", "markdown") and (found := COMMAND.search(text)):
        yield f"a line that is a workflow command: {text[found.start() : found.start() + 60]!a}"
    if name == "github":
        odd = [line for line in text.splitlines() if line.lstrip().startswith("::") and not GITHUB.match(line)]
        yield from (f"an odd workflow command: {line[:60]!a}" for line in odd[:1])
    try:
        if name in ("json", "sarif", "gitlab", "rdjson", "inspect json"):
            json.loads(text)
        elif name == "junit":
            xml.parsers.expat.ParserCreate().Parse(text.encode(), True)
    except (ValueError, xml.parsers.expat.ExpatError) as error:
        yield f"is no {name}: {error}"


def is_well_formed(path: str, data: bytes) -> bool | None:
    """Return whether a file can be parsed; None for a file that is of no such kind."""
    suffix = PurePosixPath(path).suffix
    try:
        if suffix in (".xml", ".urdf", ".xacro"):
            xml.parsers.expat.ParserCreate().Parse(data, True)
        elif suffix in (".yaml", ".yml"):
            for _ in yaml.parse(data, Loader=yaml.CSafeLoader):  # events: they do not recurse, as composing does
                pass
        elif suffix == ".py":
            ast.parse(data)
        else:
            return None
    except (xml.parsers.expat.ExpatError, yaml.YAMLError, SyntaxError, ValueError, RecursionError, MemoryError):
        return False
    return True


def snapshot(folder: Path) -> Tree:
    """Return everything below a folder; no link is followed, and nothing but files is opened."""
    found: Tree = {}
    left = [str(folder)]
    while left:
        for each in os.scandir(left.pop()):
            mode, data = each.stat(follow_symlinks=False).st_mode, b""
            if stat.S_ISDIR(mode):
                left.append(each.path)
            elif stat.S_ISLNK(mode):
                data = os.fsencode(Path(each.path).readlink())
            elif stat.S_ISREG(mode):
                data = Path(each.path).read_bytes()
            found[os.path.relpath(each.path, folder)] = (mode, data)
    return found


def differing(before: Tree, after: Tree) -> list[str]:
    """Return the paths at which two trees differ."""
    return sorted(path for path in before.keys() | after.keys() if before.get(path) != after.get(path))


def faults_of_change(before: Tree, after: Tree) -> Iterator[str]:
    """Yield what a command spoilt in a tree that it may change."""
    for path in differing(before, after):
        shown = ascii(path)
        if not path.startswith("ws/pkg/"):
            yield f"changed outside of the package: {shown}"
        elif path not in before and re.search(r"/\.[^/]*$", path):
            yield f"left a stray file: {shown}"
        elif path in before and path in after:
            (mode, old), (new_mode, new) = before[path], after[path]
            if stat.S_IFMT(mode) != stat.S_IFMT(new_mode):
                yield f"became another kind of file: {shown}"
            elif is_well_formed(path, old) and is_well_formed(path, new) is False:
                yield f"was well-formed, and is not: {shown}"
