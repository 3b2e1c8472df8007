"""Does the install table of CMake packages say what the build really installs?

python -m bench.install_truth FOLDER... --colcon PROGRAM [--limit 100]
python -m bench.install_truth FOLDER... --pretend [--every 4] [--limit 200]

With --colcon, packages that can be built without ROS are built by the real colcon: those that compile nothing, and
those that look for nothing but what this machine has.  With --pretend, any package is configured by the real CMake,
what a compiler and generators would make is there as empty files, and the real CMake installs it.  Both happen in the
world of cmake_world.py.  What lies below the prefix then, but for what ament, colcon and rosidl add to any package, is
compared with our table: *equal*, *not told* (we say that we don't know what differs) or *wrong*.  Exits with 1 where
something is wrong.
"""

from __future__ import annotations

import argparse
import json
import re
import shutil
import subprocess
import sys
import tempfile
from collections import Counter
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

from rospkg_cli.engine.discovery.discover import packages_below
from rospkg_cli.package.cmake.cmake_project import CMake
from rospkg_cli.package.inspection import Inspection, inspect_package
from rospkg_cli.package.install_table import InstallKind
from rospkg_cli.ros.distros import Targets

from .cmake_world import UNKNOWN, World, make_world, name_of, open_package, real_packages

PYTHON = re.compile(r"^(?:local/)?lib/python3(?:\.\d+)?/(?:site|dist)-packages/")
COMPILED = re.compile(r"\.cpython-\d+-[\w-]+\.so$")
ABSENT = re.compile(r'file INSTALL cannot find\s+"([^"]+)"|cannot find\s+"([^"]+)"')
ADDED = r"""
    share/ament_index/.* | share/colcon-core/.* | share/{name}/(?:local_setup|package)\.(?:bash|dsv|sh|zsh|ps1|bat)
  | share/{name}/(?:environment|hook)/.* | share/{name}/cmake/(?:.*Config(?:-version)?|.*-extras|.*Export(?:-\w+)?
  | export_\w+|\w+Targets(?:-\w+)?|{name}_\w+|ament_cmake_export_\w+|rosidl_cmake\w*|.*_export(?:-\w+)?)\.cmake
  | lib/lib\w+\.so\.[\d.]+ | lib/python/.*\.egg-info(?:/.*)? | .*__pycache__/.* | .*\.pyc
"""
GENERATED = r"""
    share/{name}/(?:msg|srv|action)/.*(?:\.idl|\.json|_(?:Request|Response|Event|Goal|Result|Feedback)\.msg|\.action
  | \.srv|\.msg) | include/{name}/{name}/(?:msg|srv|action)/.* | lib/lib{name}__rosidl.* | share/{name}/rosidl.*
"""


@dataclass(frozen=True)
class Verdict:
    package: Path
    rows: int = 0
    missing: tuple[str, ...] = ()
    """Installed, and not in our table."""
    invented: tuple[str, ...] = ()
    """In our table, and not installed."""
    untold: tuple[str, ...] = ()
    """Differences in parts of the table that we say we don't know."""
    failed: str = ""

    @property
    def word(self) -> str:
        if self.failed:
            return "not installed"
        return "wrong" if self.missing or self.invented else "not told" if self.untold else "equal"


def installed(prefix: Path) -> set[str]:
    """Return what stands below a prefix, with the folder of Python packages as we write it."""
    paths = (path.relative_to(prefix).as_posix() for path in prefix.rglob("*") if path.is_symlink() or path.is_file())
    return {COMPILED.sub(".so", PYTHON.sub("lib/python/", path)) for path in paths}


def what(destination: str, name: str) -> InstallKind:
    if destination.startswith((f"lib/{name}/", "bin/")):
        return "executable"
    parts: dict[str, InstallKind] = {"share": "share", "include": "header"}
    if destination.startswith("lib/python/"):
        return "module"
    return parts.get(destination.partition("/")[0], "library" if destination.startswith("lib/") else "other")


def judge(package: Path, inspection: Inspection, prefix: Path, generates: bool) -> Verdict:
    name = inspection.name
    pattern = ADDED + ("|" + GENERATED if generates else "")
    added = re.compile(pattern.replace("{name}", re.escape(name)), re.VERBOSE)
    real = installed(prefix)
    ours = {row.destination for row in inspection.table.rows}
    missing = sorted(path for path in real - ours if not added.fullmatch(path))
    untold = [path for path in missing if not inspection.table.knows(what(path, name))]
    invented = sorted({row.destination for row in inspection.table.rows if not row.maybe} - real)
    for path in (path for path in missing if path.endswith(".a") and f"{path[:-2]}.so" in invented):
        untold.append(path)  # whether such a library is shared, a package that is not there decides
        invented.remove(f"{path[:-2]}.so")
    return Verdict(
        package, len(ours), tuple(p for p in missing if p not in untold), tuple(invented), tuple(untold)
    )  # fmt: skip


def inspected(package: Path) -> tuple[Inspection, bool]:
    """Return our table, and whether the package generates interfaces."""
    opened = open_package(package)
    cmake = opened.parts(CMake).only
    return inspect_package(opened, package.name, Targets()), cmake is not None and bool(cmake.interface_targets)


# ---- really built


def can_be_built(package: Path) -> bool:
    """Return whether a package compiles nothing, or looks for nothing that only ROS has."""
    opened = open_package(package)
    cmake = opened.parts(CMake).only
    if cmake is None or not cmake.ends_a_package or cmake.interface_targets:
        return False
    here = {*real_packages(), "Threads"}
    makes = any(target.is_built and not target.call.testing for target in cmake.targets)
    return not makes or all(found.name in here or found.call.testing for found in cmake.packages)


def build(world: World, colcon: str, packages: Sequence[Path]) -> Iterator[Verdict]:
    """Build packages in one workspace, and again those that lack a command."""
    space = world.scratch / "space"
    for package in packages:
        shutil.copytree(package, space / "src" / package.name, symlinks=True, ignore_dangling_symlinks=True)
    names = {package: name_of(open_package(package)) for package in packages}
    waiting, commands = set(names.values()), set[str]()
    for _ in range(6):
        command = [
            colcon, "build", "--executor", "sequential", "--continue-on-error", "--packages-select", *sorted(waiting),
            "--cmake-force-configure", "--cmake-args", *world.arguments(commands),
            "-DPython3_EXECUTABLE=/usr/bin/python3",
        ]  # fmt: skip
        world.run(command, space, seconds=3000)
        logs = {name: space / "log/latest_build" / name / "stderr.log" for name in waiting}
        said = {name: log.read_text(errors="replace") if log.is_file() else "" for name, log in logs.items()}
        lacking = {name: set(UNKNOWN.findall(text)) for name, text in said.items()}
        waiting = {name for name, found in lacking.items() if found - commands}
        commands |= set().union(*lacking.values())
        if not waiting:
            break
    for package, name in names.items():
        prefix = space / "install" / name
        ended = space / "build" / name / "colcon_build.rc"
        if not ended.is_file() or ended.read_text().strip() != "0":
            log = next(iter(sorted((space / "log").glob(f"build_*/{name}/stderr.log"), reverse=True)), None)
            yield Verdict(package, failed=first_error(log.read_text(errors="replace") if log else ""))
        else:
            yield judge(package, *inspected_as(package, prefix))


def inspected_as(package: Path, prefix: Path) -> tuple[Inspection, Path, bool]:
    inspection, generates = inspected(package)
    return inspection, prefix, generates


def first_error(text: str) -> str:
    said = text.partition("Error")[2] or text
    return " ".join(said.split())[:160] or "no message"


# ---- pretended


def pretend(world: World, package: Path) -> Verdict | None:
    """Install a package of which nothing was compiled; None where CMake is not asked."""
    opened = open_package(package)
    cmake = opened.parts(CMake).only
    if cmake is None or not cmake.ends_a_package:
        return None
    with tempfile.TemporaryDirectory(dir=world.scratch) as folder:
        source, build, prefix = Path(folder, "src", package.name), Path(folder, "build"), Path(folder, "install")
        shutil.copytree(package, source, symlinks=True, ignore_dangling_symlinks=True)
        no_rpath = ("-DCMAKE_SKIP_RPATH=ON", "-DCMAKE_SKIP_INSTALL_RPATH=ON")
        done = world.configure(source, build, f"-DCMAKE_INSTALL_PREFIX={prefix}", *no_rpath)
        if done.returncode:
            return Verdict(package, failed=first_error(done.stderr))
        make_artifacts(world, build)
        for _ in range(200):
            done = world.run([world.cmake, "--install", str(build)], build)
            absent = [first or second for first, second in ABSENT.findall(done.stderr)]
            if done.returncode == 0 or not absent:
                break
            for path in absent:
                touch(Path(path), folder=path.endswith("/"))
        if done.returncode:
            return Verdict(package, failed=first_error(done.stderr))
        return judge(package, *inspected_as(package, prefix))


def make_artifacts(world: World, build: Path) -> None:
    """Make what the targets of a build would make, as empty files; scripts of Python packages are really made."""
    replies = (build / ".cmake/api/v1/reply").glob("target-*.json")
    targets = [json.loads(file.read_text(encoding="utf-8")) for file in replies]
    names = [target["name"] for target in targets]
    if scripts := [name for name in names if name.startswith("ament_cmake_python_build_")]:
        world.run([world.cmake, "--build", str(build), "--target", *scripts], build)
    for target in targets:
        made = [each["path"] for each in target.get("artifacts", ())]
        made += [each["path"] for each in target.get("sources", ()) if each.get("isGenerated")]
        for path in made:
            if not path.endswith(".rule"):
                touch(build / path)


def touch(path: Path, folder: bool = False) -> None:
    if folder:
        path.mkdir(parents=True, exist_ok=True)
    else:
        path.parent.mkdir(parents=True, exist_ok=True)
        path.touch(mode=0o755)


# ---- told


def pretended(world: World, packages: Iterable[Path]) -> Iterator[Verdict]:
    for package in packages:
        try:
            verdict = pretend(world, package)
        except subprocess.TimeoutExpired:
            verdict = Verdict(package, failed="takes too long")
        if verdict is not None:
            yield verdict


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folders", nargs="+", type=Path)
    how = parser.add_mutually_exclusive_group(required=True)
    how.add_argument("--colcon", help="of an environment in which CMake finds ament")
    how.add_argument("--pretend", action="store_true")
    parser.add_argument("--only", nargs="*", default=[], help="names of packages")
    parser.add_argument("--every", type=int, default=1, help="take each n-th package")
    parser.add_argument("--limit", type=int, default=sys.maxsize)
    options = parser.parse_args()
    found = [
        p for folder in options.folders for p in packages_below(folder.resolve()) if (p / "CMakeLists.txt").is_file()
    ]
    packages = list({package.name: package for package in found}.values())
    if options.only:
        packages = [package for package in packages if package.name in options.only]
    verdicts: list[Verdict] = []
    with tempfile.TemporaryDirectory() as scratch:
        world = make_world(Path(scratch), options.folders)
        if options.pretend:
            running = pretended(world, packages[:: options.every][: options.limit])
        else:
            picked = [package for package in packages if can_be_built(package)]
            running = build(world, options.colcon, picked[:: options.every][: options.limit])
        for verdict in running:
            verdicts.append(verdict)
            tell(verdict)
    count = Counter(verdict.word for verdict in verdicts)
    real = [verdict for verdict in verdicts if not verdict.failed]
    repositories = len({verdict.package.parts[:4] for verdict in real})
    print(f"{len(real)} packages of {repositories} repositories installed, {sum(v.rows for v in real)} rows")
    print(", ".join(f"{number} {word}" for word, number in count.most_common()))
    return 1 if count["wrong"] else 0


def tell(verdict: Verdict) -> None:
    if verdict.word != "equal":
        print(f"{verdict.word}: {verdict.package} {verdict.failed}")
    for title, paths in (("missing", verdict.missing), ("invented", verdict.invented), ("untold", verdict.untold)):
        for path in paths[:8]:
            print(f"    {title:<9}{path}")
        if len(paths) > 8:
            print(f"    … {len(paths) - 8} more {title}")
    sys.stdout.flush()


if __name__ == "__main__":
    sys.exit(main())
