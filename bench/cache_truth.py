"""Does the cache ever lie? `python -m bench.cache_truth FOLDER… [--edits 300] [--packages 3] [--seed 1]`

Copies some packages of each folder (repositories of ROS 2 packages) into one workspace, changes one random thing after
another, and compares what lint says with its cache to what it says with --no-cache: exit status and JSON, all rules.
Every fourth time the cached run is repeated, so that a run that was just kept is served. In every second round files
count as old at once, so that looks decide and not contents. Prints each difference with the edit that led to it, how
many packages were checked anew, and leaves with 1 where there was a difference.
"""

from __future__ import annotations

import argparse
import os
import random
import shutil
import sys
import tempfile
from collections import Counter
from collections.abc import Callable
from pathlib import Path
from typing import Any

from rospkg_cli import disk_trace
from rospkg_cli.__main__ import main as rospkg
from rospkg_cli.engine.run.package_results import PackageResults
from rospkg_cli.engine.run.worker import Worker
from rospkg_cli.rule import all_rules

ARGUMENTS = ["lint", ".", "--format", "json", "--pedantic", "--release", "--preview", "--jobs", "1"]
WORDS = (
    "rclcpp rclpy std_msgs unheard_of share config launch True ${prefix} 0.5 # -- <a/> find_package(x) my_msgs".split()
)
MARKERS = ("COLCON_IGNORE", ".gitignore", "LICENSE", "rospkg.toml", "ours.repos", "setup.cfg", ".gitmodules")
TEXTS = ("", "config/\n", "[submodule 'a']\n\tpath = a\n", "pedantic = true\n", "Apache License 2.0\n", "x: [1, 2]\n")
CONFIGS = ("pedantic = true\n", "select = ['DEP', 'SET']\n", "ignore = { XML = 'not now' }\n", "exclude = ['*_msgs']\n")


class Workspace:
    """A copy of some packages that is changed at random; each edit returns what it did."""

    def __init__(self, root: Path, chance: random.Random) -> None:
        self.root, self.chance = root, chance
        self.edits: tuple[Callable[[], str], ...] = (
            *(self.change_line, self.change_line, self.swap_names, self.drop_line, self.remove, self.copy, self.move),
            *(self.add_marker, self.touch, self.mode, self.link, self.same_look, self.remove_folder, self.new_launch),
        )

    def files(self) -> list[Path]:
        return sorted(path for path in self.root.rglob("*") if path.is_file() and not path.is_symlink())

    def file(self, *endings: str) -> Path:
        found = self.files()
        return self.chance.choice([path for path in found if path.name.endswith(endings)] or found)

    def edit(self) -> str:
        try:
            return self.chance.choice(self.edits)()
        except OSError as error:
            return f"nothing: {error}"

    def change_line(self) -> str:
        path = self.file("package.xml", "CMakeLists.txt", ".py", ".yaml", ".cpp", ".hpp", ".msg", ".launch.xml")
        lines = path.read_text("utf-8", "replace").split("\n")
        at = self.chance.randrange(len(lines))
        lines[at] = lines[at] + " " + self.chance.choice(WORDS)
        path.write_text("\n".join(lines))
        return f"a word at {path}:{at + 1}"

    def drop_line(self) -> str:
        path = self.file("package.xml", "CMakeLists.txt", "setup.py", ".yaml", ".hpp", ".launch.py")
        lines = path.read_text("utf-8", "replace").split("\n")
        del lines[self.chance.randrange(len(lines))]
        path.write_text("\n".join(lines))
        return f"a line less in {path}"

    def swap_names(self) -> str:
        one, other = self.file("package.xml"), self.file("package.xml")
        path = self.file("package.xml", "CMakeLists.txt", ".py", ".yaml")
        path.write_text(path.read_text("utf-8", "replace").replace(one.parent.name, other.parent.name, 1))
        return f"{one.parent.name} is {other.parent.name} in {path}"

    def remove(self) -> str:
        path = self.file()
        path.unlink()
        return f"{path} is gone"

    def remove_folder(self) -> str:
        path = self.file().parent
        if path != self.root and self.chance.random() < 0.5:
            shutil.rmtree(path)
        return f"{path} may be gone"

    def copy(self) -> str:
        path, folder = self.file(), self.file().parent
        shutil.copy(path, folder / path.name)
        return f"{path} is in {folder}, too"

    def move(self) -> str:
        path = self.file()
        path.rename(path.with_name(f"moved_{path.name}"))
        return f"{path} has another name"

    def add_marker(self) -> str:
        path = self.file().parent / self.chance.choice(MARKERS)
        path.write_text(self.chance.choice(CONFIGS if path.suffix == ".toml" else TEXTS))
        return f"{path} is written"

    def touch(self) -> str:
        path = self.file()
        path.touch()
        return f"{path} is touched"

    def mode(self) -> str:
        path = self.file(".py", "")
        path.chmod(self.chance.choice((0o644, 0o755)))
        return f"the mode of {path}"

    def link(self) -> str:
        path, target = self.file(), self.file()
        path.unlink()
        path.symlink_to(self.chance.choice((target, Path(os.path.relpath(target, path.parent)), target.parent)))
        return f"{path} is a link to {path.readlink()}"

    def same_look(self) -> str:
        path = self.file("package.xml", ".py", ".yaml", "CMakeLists.txt")
        before, text = path.stat(), path.read_bytes()
        path.write_bytes(text.replace(b"e", b"f", 1))
        os.utime(path, ns=(before.st_atime_ns, before.st_mtime_ns))
        return f"one letter of {path}, with its old time"

    def new_launch(self) -> str:
        package = self.file("package.xml").parent.name
        path = self.file("package.xml").parent / "launch" / "more.launch.xml"
        path.parent.mkdir(exist_ok=True)
        path.write_text(
            f'<launch><node pkg="{package}" exec="x"/><include file="$(find-pkg-share {package})/y"/></launch>'
        )
        return f"{path} is written"


def lint(root: Path, output: Path, *options: str) -> tuple[int, bytes]:
    """Return the exit status and the output of a run in a process of its own, in which all is imported already."""
    child = os.fork()
    if not child:
        os.chdir(root)
        os.environ["PWD"] = str(root)
        with output.open("wb") as stream:
            os.dup2(stream.fileno(), 1)
            os.dup2(os.open(os.devnull, os.O_WRONLY), 2)
        sys.stdout = open(1, "w", encoding="utf-8", closefd=False)  # noqa: SIM115
        if "--no-cache" not in options:
            count_checks(output.with_name("checks"))
        sys.argv = ["rospkg", *ARGUMENTS, *options]
        status = rospkg()
        sys.stdout.flush()
        os._exit(status)
    return os.waitstatus_to_exitcode(os.waitpid(child, 0)[1]), output.read_bytes()


def count_checks(file: Path) -> None:
    """Write a line for each package whose rules run in this process."""
    check = Worker.check

    def counted(self: Worker, folder: str, *others: Any) -> PackageResults:
        with file.open("a") as stream:
            stream.write(f"{folder}\n")
        return check(self, folder, *others)

    Worker.check = counted  # type: ignore[assignment]


def copy_packages(folders: list[Path], into: Path, count: int, chance: random.Random) -> None:
    """Copy some packages of each folder, where the folder has so many."""
    for folder in folders:
        found = sorted(path.parent for path in folder.rglob("package.xml"))
        for package in chance.sample(found, min(count, len(found))):
            if not (into / package.name).exists():
                shutil.copytree(package, into / package.name, symlinks=True)


def run_round(folders: list[Path], arguments: argparse.Namespace, seed: int, edits: int) -> list[str]:
    """Return the edits after which the cache said something else."""
    chance, found = random.Random(seed), []
    with tempfile.TemporaryDirectory() as name:
        top = Path(name).resolve()
        os.environ["XDG_CACHE_HOME"] = str(top / "cache")
        workspace = Workspace(top / "ws/src", chance)
        workspace.root.mkdir(parents=True)
        copy_packages(folders, workspace.root, arguments.packages, chance)
        statuses: Counter[int] = Counter()
        packages = 0
        (top / "checks").touch()
        for number in range(edits):
            done = "; ".join(workspace.edit() for _ in range(chance.choice((1, 1, 1, 2, 5))))
            told = [lint(workspace.root, top / "out") for _ in range(2 if number % 4 == 0 else 1)]
            truth = lint(workspace.root, top / "out", "--no-cache")
            statuses[truth[0]] += 1
            packages += sum(1 for _ in workspace.root.rglob("package.xml"))
            if any(each != truth for each in told):
                found.append(f"seed {seed}, edit {number}: {done}")
                print(found[-1], file=sys.stderr)
        checked = (top / "checks").read_text().count("\n")
        print(f"seed {seed}: {edits} edits, {len(found)} differences; exit statuses {dict(statuses)}", end="; ")
        print(f"{checked} packages were checked, {packages} were there", flush=True)
    return found


def main() -> int:
    parser = argparse.ArgumentParser(description=(__doc__ or "").partition("\n")[0])
    parser.add_argument("folders", nargs="+", type=Path)
    parser.add_argument("--edits", type=int, default=300)
    parser.add_argument("--packages", type=int, default=3)
    parser.add_argument("--seed", type=int, default=1)
    arguments = parser.parse_args()
    all_rules()
    import rospkg_cli.cli.app
    import rospkg_cli.cli.lint.run
    import rospkg_cli.report.json  # noqa: F401

    rounds = max(1, arguments.edits // 50)
    found: list[str] = []
    for number in range(rounds):
        disk_trace.YOUNG = 2_000_000_000 if number % 2 == 0 else -(10**15)
        found += run_round(arguments.folders, arguments, arguments.seed + number, arguments.edits // rounds)
    print(f"{arguments.edits} edits: {len(found)} differences")
    return bool(found)


if __name__ == "__main__":
    sys.exit(main())
