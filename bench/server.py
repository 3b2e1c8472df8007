"""The language server over random edits: its diagnostics against a fresh lint, its latency, its memory.

    python -m bench.server REPOSITORY [--edits 500] [--check-every 25] [--seed 1]

Works on a copy. Each edit goes to the server as unsaved text and is followed by a hover; every so often the text is
saved, linted afresh by the command, and compared with what the server has published by then.
"""

from __future__ import annotations

import argparse
import json
import random
import shutil
import statistics
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from pathlib import Path

from lsprotocol import types

sys.path.insert(0, str(Path(__file__).parents[1] / "tests"))

from editor import Editor  # type: ignore[import-not-found]  # the tests' own

NAMES = (".xml", ".txt", ".py", ".yaml", ".msg", ".srv", ".action", ".cfg", ".cpp", ".hpp", ".xacro", ".urdf")

Seen = set[tuple[str, int, int, str, str]]


def files(root: Path) -> list[Path]:
    """Return the files that are edited, in no folder that begins with a dot."""
    found = (path for path in sorted(root.rglob("*")) if path.suffix in NAMES and path.is_file())
    return [path for path in found if not any(part.startswith(".") for part in path.relative_to(root).parts)]


def edited(text: str, chance: random.Random) -> str:
    """Return a text with a line gone, twice, changed places with the next, or with a letter changed."""
    lines = text.split("\n")
    at = chance.randrange(len(lines))
    match chance.randrange(4):
        case 0:
            del lines[at]
        case 1:
            lines.insert(at, lines[at])
        case 2 if at + 1 < len(lines):
            lines[at], lines[at + 1] = lines[at + 1], lines[at]
        case _:
            line = lines[at]
            where = chance.randrange(len(line) + 1)
            lines[at] = line[:where] + chance.choice("aez_<>\"'(") + line[where + 1 :]
    return "\n".join(lines)


def fresh(root: Path) -> Seen:
    """Return what a lint of the saved texts says."""
    command = [sys.executable, "-m", "rospkg_cli", "lint", "--no-cache", "--format", "json", str(root)]
    found = json.loads(subprocess.run(command, capture_output=True, text=True, check=False, cwd=root).stdout)
    return {(each["path"], each["line"], each["column"], each["code"], each["message"]) for each in found["findings"]}


def published(editor: Editor, root: Path) -> Seen:
    """Return the same of the server's diagnostics; its columns count UTF-16 units, which these texts hardly have."""
    return {
        (path.relative_to(root).as_posix(), d.range.start.line + 1, d.range.start.character + 1, str(d.code), d.message)
        for path, found in editor.diagnostics.items()
        for d in found
    }


def memory(editor: Editor) -> float:
    """Return the resident memory of the server, in MiB."""
    status = Path(f"/proc/{editor.process_id}/status").read_text()
    return int(status.partition("VmRSS:")[2].split()[0]) / 1024


def hover_seconds(editor: Editor, path: Path, line: int) -> float:
    began = time.perf_counter()
    at = types.HoverParams(types.TextDocumentIdentifier(path.as_uri()), types.Position(line, 3))
    editor.run(editor.client.text_document_hover_async(at))
    return time.perf_counter() - began


def run(root: Path, edits: int, every: int, chance: random.Random) -> Iterator[str]:
    import os

    editor = Editor(root, PATH=os.environ["PATH"], HOME=os.environ.get("HOME", "/"), XDG_CACHE_HOME="/dev/null")
    editor.settle()
    began, latencies, wrong, checks = memory(editor), [], 0, 0
    texts = {path: path.read_text(errors="surrogateescape") for path in files(root)}
    for number in range(1, edits + 1):
        path = chance.choice(sorted(texts))
        before, texts[path] = texts[path], edited(texts[path], chance)
        if path not in editor.versions:
            path.write_text(before, errors="surrogateescape")
            editor.open(path)
        editor.type(path, texts[path])
        latencies.append(hover_seconds(editor, path, chance.randrange(40)))
        if number % every == 0:
            editor.settle()
            for file, text in texts.items():
                file.write_text(text, errors="surrogateescape")
            checks += 1
            ours, theirs = published(editor, root), fresh(root)
            wrong += ours != theirs
            for what, rest in (("only the server", ours - theirs), ("only lint", theirs - ours)):
                for each in sorted(rest)[:3]:
                    yield f"  after edit {number}, {what}: {each}"
    yield f"{edits} edits, {checks} comparisons, {wrong} differ"
    latencies.sort()
    median, late = statistics.median(latencies), latencies[int(len(latencies) * 0.95)]
    yield f"a hover right after an edit: median {median:.3f} s, 95 % {late:.3f} s, worst {latencies[-1]:.3f} s"
    yield f"memory: {began:.0f} MiB at first, {memory(editor):.0f} MiB at the end"
    editor.quit()


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("repository", type=Path)
    parser.add_argument("--edits", type=int, default=500)
    parser.add_argument("--check-every", type=int, default=25)
    parser.add_argument("--seed", type=int, default=1)
    asked = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        root = Path(folder).resolve() / asked.repository.name
        shutil.copytree(asked.repository, root, symlinks=True)
        for line in run(root, asked.edits, asked.check_every, random.Random(asked.seed)):
            print(line, flush=True)


if __name__ == "__main__":
    main()
