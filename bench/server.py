"""The language server over random edits: its diagnostics against a fresh lint, its latency, its memory.

    python -m bench.server REPOSITORY [--edits 500] [--check-every 25] [--seed 1] [--pause 0.3] [--together 1]

Works on a copy. Each edit goes to the server as unsaved text and is followed by a request (hover, definition,
completion, actions or formatting) at the place of the edit, and by a pause of up to twice `--pause` seconds, in which
as many requests as `--together` says are sent four times, so that the run over the last edit often goes on beside
them, and beside the next edits. A refused request counts as answered: how many were is told apart. Every so often all
texts are saved, linted afresh by the command, and compared with what the server has published by then. At most OPEN
files are open at once: others are saved and closed.
"""

from __future__ import annotations

import argparse
import asyncio
import json
import os
import random
import shutil
import statistics
import subprocess
import sys
import tempfile
import time
from collections import Counter
from collections.abc import Callable, Coroutine, Iterator
from dataclasses import dataclass
from pathlib import Path
from types import MappingProxyType
from typing import Any

from lsprotocol import types
from pygls.exceptions import JsonRpcException

sys.path.insert(0, str(Path(__file__).parents[1] / "tests"))

from editor import Editor  # type: ignore[import-not-found]  # the tests' own

NAMES = (".xml", ".txt", ".py", ".yaml", ".msg", ".srv", ".action", ".cfg", ".cpp", ".hpp", ".xacro", ".urdf")

SOON = 0.2
"""Seconds within which each request is to be answered or refused."""

OPEN = 20
"""Files that are open at once."""

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


def processes(editor: Editor) -> list[Path]:
    """Return the folders of the server's processes in /proc: the one that was started, and the one behind it."""
    first = Path(f"/proc/{editor.process_id}")
    return [first, *(Path(f"/proc/{each}") for each in (first / f"task/{first.name}/children").read_text().split())]


def memory(editor: Editor) -> float:
    """Return the memory of the server, in MiB; what its processes share counts once."""
    found = [(each / "smaps_rollup").read_text() for each in processes(editor)]
    return sum(int(each.partition("\nPss:")[2].split()[0]) for each in found) / 1024


def processor_seconds(editor: Editor) -> float:
    """Return the time that the server has had a processor, in all its threads, by 0.01 s."""
    stats = [(each / "stat").read_text().rpartition(")")[2].split() for each in processes(editor)]
    return sum(int(fields[11]) + int(fields[12]) for fields in stats) / os.sysconf("SC_CLK_TCK")


def waited(editor: Editor) -> float:
    """Return the seconds that the threads between a request and its answer were ready and had no processor.

    Those of the server but the one that has run most, which is that of the runs, and the one that asks; on Linux.
    """
    tasks = [path.read_text().split() for each in processes(editor) for path in each.glob("task/*/schedstat")]
    on_the_way = sorted(tasks, key=lambda task: int(task[0]))[:-1]
    own = Path("/proc/thread-self/schedstat").read_text().split()
    return sum(int(task[1]) for task in [*on_the_way, own]) / 1e9


@dataclass(frozen=True)
class Answer:
    """How long one request took."""

    seconds: float
    kind: str
    is_refused: bool


def is_refused(given: Answer) -> bool:
    return given.is_refused


def is_late(given: Answer) -> bool:
    """Return whether something was answered, and not soon."""
    return not given.is_refused and given.seconds > SOON


def requests(editor: Editor, path: Path, line: int) -> dict[str, Callable[[], Coroutine[Any, Any, Any]]]:
    """Return what may be asked at a line, by its kind."""
    document, position = types.TextDocumentIdentifier(path.as_uri()), types.Position(line, 12)
    at: dict[str, Any] = {"text_document": document, "position": position}
    span, context, options = (
        types.Range(position, position),
        types.CodeActionContext([]),
        types.FormattingOptions(2, True),
    )
    client = editor.client
    return {
        "hover": lambda: client.text_document_hover_async(types.HoverParams(**at)),
        "definition": lambda: client.text_document_definition_async(types.DefinitionParams(**at)),
        "completion": lambda: client.text_document_completion_async(types.CompletionParams(**at)),
        "actions": lambda: client.text_document_code_action_async(types.CodeActionParams(document, span, context)),
        "formatting": lambda: client.text_document_formatting_async(types.DocumentFormattingParams(document, options)),
    }


async def answer(kind: str, request: Callable[[], Coroutine[Any, Any, Any]]) -> Answer:
    """Ask for something, and return how long it took to be answered or refused."""
    began = time.perf_counter()
    try:
        await request()
    except JsonRpcException as error:
        if error.code != types.LSPErrorCodes.ContentModified:
            raise
        return Answer(time.perf_counter() - began, kind, is_refused=True)
    return Answer(time.perf_counter() - began, kind, is_refused=False)


class PlainEditor(Editor):  # type: ignore[misc]  # an import of the tests
    """One that waits for answers as long as others do."""

    options = MappingProxyType[str, object]({})


class Session:
    """An editor over a copy of a repository, whose texts are edited here and there."""

    def __init__(self, root: Path, chance: random.Random) -> None:
        kept = {name: os.environ[name] for name in ("PATH", "HOME", "PYTHONPATH") if name in os.environ}
        self.editor, self.root, self.chance = PlainEditor(root, **kept, XDG_CACHE_HOME="/dev/null"), root, chance
        self.editor.settle()
        self.paths = files(root)
        self.open: dict[Path, str] = {}
        self.behind_edits: list[Answer] = []
        self.beside_runs: list[Answer] = []
        self.undisturbed: list[float] = []
        """How long the answers behind edits had taken if other programs had left a processor free."""
        self.processor: list[float] = []
        """The time that the server had a processor until it answered, a run beside it included."""

    def edit(self, pause: float, together: int) -> None:
        """Edit one file, mostly one that is open, ask for something at once, and for more in the pause behind it."""
        path = self.chance.choice(list(self.open) if self.open and self.chance.random() < 0.7 else self.paths)
        if path not in self.open:
            if len(self.open) == OPEN:
                self.close(next(iter(self.open)))
            path.write_text(path.read_text(errors="surrogateescape"), encoding="utf-8", errors="replace")
            self.open[path] = path.read_text()
            self.editor.open(path)
        before = self.open[path]
        self.open[path] = edited(before, self.chance)
        self.editor.type(path, self.open[path])
        lines = [*zip(before.split("\n"), self.open[path].split("\n"), strict=False)]
        line = next((number for number, (old, new) in enumerate(lines) if old != new), 0)
        spent, lost = processor_seconds(self.editor), waited(self.editor)
        self.behind_edits += self.asked(path, line, 1)
        self.undisturbed.append(max(0, self.behind_edits[-1].seconds - waited(self.editor) + lost))
        self.processor.append(processor_seconds(self.editor) - spent)
        for _ in range(4 if pause else 0):
            self.editor.loop.run_until_complete(asyncio.sleep(pause * self.chance.random() / 2))
            self.beside_runs += self.asked(path, line, together)

    def asked(self, path: Path, line: int, together: int) -> list[Answer]:
        """Ask for some things at once."""
        possible = requests(self.editor, path, line)
        kinds = [self.chance.choice([*possible]) for _ in range(together)]

        async def ask() -> list[Answer]:
            return await asyncio.gather(*(answer(kind, possible[kind]) for kind in kinds))

        found: list[Answer] = self.editor.run(ask())
        return found

    def save(self) -> None:
        for path in self.open:
            self.editor.save(path)

    def close(self, path: Path) -> None:
        path.write_text(self.open.pop(path))
        self.editor.close(path)

    def quality(self) -> Iterator[str]:
        """Yield how fast it was."""
        for what, answers in (("right behind an edit", self.behind_edits), ("in pauses", self.beside_runs)):
            if not answers:
                continue
            seconds = sorted(each.seconds for each in answers)
            median, most, worst = statistics.median(seconds), seconds[int(len(seconds) * 0.95)], seconds[-1]
            yield f"asked {what}: median {median:.3f} s, 95 % {most:.3f} s, worst {worst:.3f} s of {len(seconds)}"
            refused, late = (Counter(each.kind for each in answers if which(each)) for which in (is_refused, is_late))
            for how, number in (("refused", refused), ("above 0.2 s, answered", late)):
                yield f"  {how}: {number.total()}, {dict(number)}"
            yield f"  above 0.2 s, refused: {sum(each.is_refused and each.seconds > SOON for each in answers)}"
        for what, spent in (("less what other programs took", self.undisturbed), ("on a processor", self.processor)):
            spent.sort()
            median, most = statistics.median(spent), spent[int(len(spent) * 0.95)]
            yield f"right behind an edit, {what}: median {median:.3f} s, 95 % {most:.3f} s, worst {spent[-1]:.3f} s"
        yield f"  above 0.2 s less what other programs took: {sum(each > SOON for each in self.undisturbed)}"


def run(given: argparse.Namespace, root: Path) -> Iterator[str]:
    edits, every, settle, chance = given.edits, given.check_every, given.settle_every, random.Random(given.seed)
    began = time.perf_counter()
    session = Session(root, chance)
    editor = session.editor
    yield f"all packages judged after {time.perf_counter() - began:.1f} s, memory {memory(editor):.0f} MiB"
    wrong = checks = 0
    for number in range(1, edits + 1):
        session.edit(given.pause, given.together)
        if number % max(1, edits // 20) == 0:
            yield f"  after edit {number}: {memory(editor):.0f} MiB"
        if settle and number % settle == 0:
            editor.settle()
        if every and number % every == 0:
            session.save()
            editor.settle()
            checks += 1
            ours, theirs = published(editor, root), fresh(root)
            wrong += ours != theirs
            for what, rest in (("only the server", ours - theirs), ("only lint", theirs - ours)):
                for each in sorted(rest)[:3]:
                    yield f"  after edit {number}, {what}: {each}"
    yield f"{edits} edits, {checks} comparisons, {wrong} differ"
    yield from session.quality()
    editor.quit()


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("repository", type=Path)
    parser.add_argument("--edits", type=int, default=500)
    parser.add_argument("--check-every", type=int, default=25)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--settle-every", type=int, default=0, help="for many edits without a pause")
    parser.add_argument("--pause", type=float, default=0.3)
    parser.add_argument("--together", type=int, default=1, help="requests at once")
    given = parser.parse_args()
    with tempfile.TemporaryDirectory() as folder:
        root = Path(folder).resolve() / given.repository.name
        shutil.copytree(given.repository, root, symlinks=True)
        for line in run(given, root):
            print(line, flush=True)


if __name__ == "__main__":
    main()
