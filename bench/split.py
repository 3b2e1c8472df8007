"""What a cold run takes its time for, part by part: `python -m bench.split WORKSPACE [--rounds 3]`

Each row is a process of its own that does what the rows above it do and one thing more, in one process and without the
cache (parsing alone stands apart); all rows are run in turn. CPU seconds, medians, and multiples of the floor
(`bench/floor.py`). No rule runs but in the last row: what is above it no cleverness in rules can save. The line below
the table is what two processes take at best: what each must do for itself (start, imports, the list of files) and half
of the rest.
"""

from __future__ import annotations

import argparse
import gc
import importlib
import json
import subprocess
import sys
import tempfile
from collections.abc import Callable
from contextlib import suppress
from pathlib import Path
from typing import TYPE_CHECKING

from .paired import Command, run_in_turn

if TYPE_CHECKING:
    from rospkg_cli.engine.run.session import Session
    from rospkg_cli.engine.run.worker import Worker
    from rospkg_cli.source import Source

REPOSITORY = Path(__file__).parents[1]
LINT = ("lint", "--no-cache", "--jobs", "1", "--format", "json", ".")
LIST_MODULES = f"""
import json, sys
sys.argv = ['rospkg', *{LINT}]
from rospkg_cli.__main__ import main
main()
print(json.dumps([name for name in sys.modules if name != '__main__']), file=sys.stderr)
"""
STAGES = ("imports", "list of files", "parsing alone", "all models", "facts")


def run_stage(stage: str, folder: Path, modules: Path) -> None:
    """Do in this process what one row says."""
    gc.set_threshold(200_000, 20, 100)  # as the command does
    import_all(modules)
    if stage != "imports":
        worker, session = worker_in(folder)
        if stage == "parsing alone":
            parse_all(worker)
        if stage in ("all models", "facts"):
            make_models(worker)
        if stage == "facts":
            worker.collect_facts(session.scope.folders)
    gc.freeze()


def import_all(modules: Path) -> None:
    for name in json.loads(modules.read_text()):
        with suppress(ImportError):
            importlib.import_module(name)


def worker_in(folder: Path) -> tuple[Worker, Session]:
    """Return the packages of a folder as a lint without options has them, and its session."""
    from rospkg_cli.cli.lint.lint_options import LintOptions
    from rospkg_cli.cli.lint.session import make_session
    from rospkg_cli.config.hierarchy import NO_CONFIGS
    from rospkg_cli.engine.discovery.locate import locate

    session = make_session(LintOptions(jobs="1"), NO_CONFIGS, locate([folder]), lambda _: None)
    return session.make_pool(session.tree, session.scope, session.targets, session.settings).worker, session


def parse_all(worker: Worker) -> None:
    """Parse each file once by the parser that lint has for it, and keep nothing."""
    from rospkg_cli.languages.cmake.parser import parse as parse_cmake
    from rospkg_cli.languages.cpp.file import read_cpp
    from rospkg_cli.languages.python.syntax import parse as parse_python
    from rospkg_cli.languages.xml.parser import read_xml
    from rospkg_cli.languages.yaml.nodes import documents
    from rospkg_cli.unreadable import UnreadableError

    from .floor import CPP, XML

    kinds: tuple[tuple[tuple[str, ...], Callable[[Source], object]], ...] = (
        ((".py",), parse_python), (XML, read_xml), ((".yaml", ".yml"), documents), (CPP, read_cpp),
        (("CMakeLists.txt", ".cmake"), parse_cmake),
    )  # fmt: skip
    for folder in list(worker.packages):
        files = worker.packages.pop(folder).files
        for path in files.paths:
            for parser in (parser for endings, parser in kinds if path.endswith(endings)):
                with suppress(UnreadableError):
                    parser(files.source(path))


def make_models(worker: Worker) -> None:
    """Make all models of all packages."""
    from rospkg_cli.package.readers import READERS

    for package in worker.packages.values():
        for kind in READERS:
            package.parts(kind)


def print_table(folder: Path, rounds: int) -> None:
    with tempfile.TemporaryDirectory() as temporary:
        done = subprocess.run([sys.executable, "-c", LIST_MODULES], cwd=folder, capture_output=True, text=True)
        modules = Path(temporary, "modules.json")
        modules.write_text(done.stderr.splitlines()[-1])
        own = (sys.executable, "-m", "bench.split", str(folder), "--modules", str(modules), "--stage")
        commands = [
            Command("floor", (sys.executable, "-m", "bench.floor", str(folder)), REPOSITORY),
            *(Command(stage, (*own, stage), REPOSITORY) for stage in STAGES),
            Command("the whole run", (sys.executable, "-m", "rospkg_cli", *LINT), folder),
        ]
        found = {name: figures.median for name, figures in run_in_turn(commands, rounds).items()}
    print(f"{folder.name}\n\n| | CPU s | × floor |\n|---|---|---|")
    for name, seconds in found.items():
        print(f"| {name} | {seconds:.2f} | {seconds / found['floor']:.1f} |")
    each = found["list of files"]
    best = each + (found["the whole run"] - each) / 2
    print(f"\nTwo processes at best: {best:.2f} s, {best / found['floor']:.1f} × the floor")


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("workspace", type=Path)
    parser.add_argument("--rounds", type=int, default=3)
    parser.add_argument("--stage", choices=STAGES, help=argparse.SUPPRESS)
    parser.add_argument("--modules", type=Path, help=argparse.SUPPRESS)
    asked = parser.parse_args()
    if asked.stage:
        run_stage(asked.stage, asked.workspace, asked.modules)
    else:
        print_table(asked.workspace.resolve(), asked.rounds)


if __name__ == "__main__":
    main()
