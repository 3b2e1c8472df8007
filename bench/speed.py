"""How fast lint is: `python -m bench.speed WORKSPACE [--package FOLDER] [--larger FOLDER] [--rounds 5] [--imports]`

Prints a table: CPU and wall seconds (medians; of all processes), the peak of memory of the largest process, and the CPU
as a multiple of `import typer` (start-up) or of the floor (`bench/floor.py`: read and parse each file once). All rows
of a table are run in turn, with bytecode, on a copy of the folder; a figure alone means little on a machine that does
other things, a ratio within one table holds. `--package` is the one that is linted alone within WORKSPACE. `--imports`
says instead which modules the start of a lint takes its time for. How it grows from 10 to 10,000: `bench.many`.
"""

from __future__ import annotations

import argparse
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

from .paired import Command, Figures, run_in_turn
from .start import print_imports

PYTHON = sys.executable
LINT = (PYTHON, "-m", "rospkg_cli", "lint", "--format", "json")
REPOSITORY = Path(__file__).parents[1]


def start_up(package: Path, rounds: int) -> None:
    """Print how long one small package takes."""
    cache = package.parent / "cache"
    commands = [
        Command("`import typer`", (PYTHON, "-c", "import typer"), package),
        Command("`rospkg --version`", (PYTHON, "-m", "rospkg_cli", "--version"), package),
        Command("one package, cold", (*LINT, "--no-cache", "."), package),
        Command("one package, warm", (*LINT, "."), package, {"XDG_CACHE_HOME": str(cache)}),
        *ruff(package),
    ]
    found = run_in_turn(commands, rounds)
    print_table("One package fresh from `rospkg new`", found, "`import typer`")


def workspace(folder: Path, package: Path | None, rounds: int) -> None:
    """Print how long a workspace takes, and one package in it."""
    cache = {"XDG_CACHE_HOME": str(folder.parent / "cache")}
    changed = next(iter(sorted(folder.rglob("package.xml")))).parent / "package.xml"
    commands = [
        Command("floor", (PYTHON, "-m", "bench.floor", str(folder)), REPOSITORY),
        Command("cold, 1 job", (*LINT, "--no-cache", "--jobs", "1", "."), folder),
        Command("cold, 2 jobs", (*LINT, "--no-cache", "--jobs", "2", "."), folder),
        Command("warm", (*LINT, "."), folder, cache),
        Command("one file changed", (*LINT, "."), folder, cache, lambda: add_a_line(changed)),
        *ruff(folder),
    ]
    if package is not None:
        one = (*LINT, "--no-cache", "--workspace", ".", str(package))
        commands.append(Command(f"`{package}` alone, cold", one, folder))
    print_table(f"{folder.name}: {count_of(folder)} packages", run_in_turn(commands, rounds), "floor")


def add_a_line(path: Path) -> None:
    with path.open("a") as stream:
        stream.write("\n")


def count_of(folder: Path) -> int:
    return sum(1 for _ in folder.rglob("package.xml"))


def ruff(folder: Path) -> list[Command]:
    """Return ruff with its default rules, on the Python files alone, where it is installed."""
    there = shutil.which("ruff", path=str(Path(PYTHON).parent)) or shutil.which("ruff")
    return [Command("ruff (Python alone)", (there, "check", "--no-cache", "--isolated", "."), folder)] if there else []


def print_table(title: str, found: dict[str, Figures], unit: str) -> None:
    print(f"\n{title}\n\n| | CPU s | wall s | MiB | × {unit} |\n|---|---|---|---|---|")
    for name, figures in found.items():
        wall = sorted(figures.wall)[len(figures.wall) // 2]
        ratio = figures.median / found[unit].median
        print(f"| {name} | {figures.median:.3f} | {wall:.2f} | {figures.peak:.0f} | {ratio:.1f} |", flush=True)


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("workspace", type=Path, nargs="?")
    parser.add_argument("--package", type=Path, help="relative to the workspace")
    parser.add_argument("--larger", type=Path, help="a second, larger folder of packages")
    parser.add_argument("--rounds", type=int, default=5)
    parser.add_argument("--imports", action="store_true")
    asked = parser.parse_args()
    with tempfile.TemporaryDirectory() as temporary:
        here = Path(temporary)
        subprocess.run(
            [PYTHON, "-m", "rospkg_cli", "new", "my_pkg", "--node", "talker"], cwd=here, check=True, capture_output=True
        )
        if asked.imports:
            print_imports(here / "my_pkg")
            return
        start_up(here / "my_pkg", asked.rounds)
        for folder, package in ((asked.workspace, asked.package), (asked.larger, None)):
            if folder is not None:
                copy = here / folder.resolve().name
                shutil.copytree(folder, copy, symlinks=True, ignore=shutil.ignore_patterns(".git"))
                workspace(copy, package, asked.rounds)


if __name__ == "__main__":
    main()
