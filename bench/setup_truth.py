"""Does the static evaluation of setup.py say what setup.py really says?

    setup_truth.py FOLDER… [--python PYTHON] [--verbose]

For every package below the folders that colcon would build with its setup.py, that setup.py is run: on a read-only
copy, in a process without network (`unshare --net --mount`), with a setup() that only records.  What it was given is
compared with what we evaluated.  A package is *equal*, *known not to be evaluated* (the field that differs is one that
we say we don't know), or *wrong*: one that is wrong fails the run, and so does a share of equal ones below 97 %.
Nothing but this script ever runs a setup.py.
"""

from __future__ import annotations

import argparse
import collections
import json
import posixpath
import shutil
import subprocess
import sys
import tempfile
from collections.abc import Iterable, Iterator
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any

from rospkg_cli.disk import DiskTree
from rospkg_cli.engine.discovery.discover import packages_below
from rospkg_cli.files import PackageFiles
from rospkg_cli.package.package import Package
from rospkg_cli.package.setup.setup_py import SetupPy

RECORDER = Path(__file__).with_name("record_setup.py")
SECONDS = 60
WANTED = 0.97
Counts = collections.Counter[str]

MOUNTED = 'mount --bind "$1" "$1" && mount -o remount,ro,bind "$1" && shift && exec "$@"'
"""Make the copy read-only for whatever follows."""


@dataclass(frozen=True)
class Verdict:
    folder: Path
    repository: str
    wrong: tuple[str, ...] = ()
    """Fields that differ although we say that we know them."""
    unknown: tuple[str, ...] = ()
    """Fields that we say we don't know."""
    failed: str = ""
    """Why the truth could not be had."""
    stubs: tuple[str, ...] = ()
    details: dict[str, tuple[Any, Any]] = field(default_factory=dict)
    size: Counts = field(default_factory=collections.Counter)
    """How many data files, packages and entry points were compared."""


def truth(folder: Path, python: str) -> dict[str, Any]:
    """Return what the real setup.py says; raises OSError, ValueError, subprocess.SubprocessError."""
    with tempfile.TemporaryDirectory() as scratch:
        copy, output = Path(scratch, "package", folder.name), Path(scratch, "out.json")
        shutil.copytree(folder, copy, symlinks=True, ignore_dangling_symlinks=True)
        command = [python, "-W", "ignore", str(RECORDER), str(copy), str(output)]
        environment = {"PATH": "/usr/bin:/bin", "HOME": scratch, "ROS_VERSION": "2", "ROS_PYTHON_VERSION": "3"}
        sandbox = ["unshare", "--net", "--mount", "sh", "-c", MOUNTED, "sh", str(copy)]
        subprocess.run([*sandbox, *command], env=environment, capture_output=True, timeout=SECONDS, check=True)
        found: dict[str, Any] = json.loads(output.read_text(encoding="utf-8"))
        return found


def lines(value: Any) -> Iterator[str]:
    """Yield the lines of a text or of texts in lists, however deep, as setuptools does."""
    if isinstance(value, str):
        stripped = (line.strip() for line in value.splitlines())
        yield from ("".join(line.split()) for line in stripped if line and not line.startswith("#"))
    else:
        for each in value or ():
            yield from lines(each)


def groups(value: Any) -> dict[str, list[str]]:
    found: dict[str, list[str]] = collections.defaultdict(list)
    if isinstance(value, str):
        group = ""
        for line in lines(value):
            if line.startswith("["):
                group = line.strip("[]")
            else:
                found[group].append(line)
    else:
        for group, entries in (value or {}).items():
            found[group] += lines(entries)
    return {group: sorted(entries) for group, entries in found.items() if entries}


def data_files(value: Any) -> list[tuple[str, str]]:
    """Return pairs of destination and source, as clean as paths can be."""
    found = []
    for entry in value or ():
        if isinstance(entry, str):
            found.append(("", posixpath.normpath(entry)))
            continue
        sources = [entry[1]] if isinstance(entry[1], str) else entry[1]
        found += [(posixpath.normpath(entry[0] or "."), posixpath.normpath(source)) for source in sources]
    return sorted(found)


def theirs(options: dict[str, Any]) -> dict[str, Any]:
    return {
        "name": options["name"],
        "version": options["version"],
        "packages": sorted(options["packages"] or ()),
        "py_modules": sorted(options["py_modules"] or ()),
        "scripts": sorted(map(posixpath.normpath, options["scripts"] or ())),
        "package_dir": {key: value.rstrip("/") for key, value in (options["package_dir"] or {}).items()},
        "data_files": data_files(options["data_files"]),
        "entry_points": groups(options["entry_points"]),
    }


def ours(setup: SetupPy) -> dict[str, Any]:
    entries: dict[str, list[str]] = collections.defaultdict(list)
    for entry in setup.entry_points:
        entries[entry.group].append("".join(entry.text.split()))
    pairs = []
    for each in setup.data_entries:
        into = posixpath.normpath(each.destination.text or ".") if each.destination else ""
        pairs += [(into, posixpath.normpath(file.setup_text.text)) for file in each.files]
    texts = {name: said.text if (said := setup.setup_text(name)) else None for name in ("name", "version")}
    return {
        **texts,
        "packages": sorted(said.text for said in setup.packages),
        "py_modules": sorted(said.text for said in setup.py_modules),
        "scripts": sorted(posixpath.normpath(said.text) for said in setup.scripts),
        "package_dir": dict(setup.package_dir),
        "data_files": sorted(pairs),
        "entry_points": {group: sorted(found) for group, found in entries.items()},
    }


def judge(folder: Path, repository: str, python: str) -> Verdict | None:
    """Compare one package; None where colcon does not run its setup.py."""
    parts = Package(PackageFiles(DiskTree(folder))).parts(SetupPy)
    if not parts.good and not parts.broken:
        return None
    try:
        found = truth(folder, python)
    except (OSError, ValueError, subprocess.SubprocessError) as error:
        return Verdict(folder, repository, failed=str(error))
    stubs = tuple(found["stubs"])
    if "options" not in found:
        return Verdict(folder, repository, failed=found.get("error", f"{found['calls']} calls of setup()"), stubs=stubs)
    if parts.only is None:
        return Verdict(folder, repository, unknown=("setup.py",), stubs=stubs)
    setup, real = parts.only, theirs(found["options"])
    said = ours(setup)
    copied = {key: rooted(value, folder) for key, value in real.items()}
    differing = [name for name in copied if said[name] != copied[name]]
    wrong = tuple(name for name in differing if setup.knows(name))
    unknown = tuple(name for name in differing if not setup.knows(name))
    details = {name: (said[name], copied[name]) for name in differing}
    size: Counts = collections.Counter({name: len(real[name]) for name in ("data_files", "packages")})
    size["entry_points"] = sum(map(len, real["entry_points"].values()))
    return Verdict(folder, repository, wrong, unknown, "", stubs, details, size)


def rooted(value: Any, folder: Path) -> Any:
    """Return a recorded value in which the absolute path of the copy is ours."""
    mark = f"/package/{folder.name}"
    if isinstance(value, str) and value.startswith("/") and mark in value:
        return "/<package>" + value.partition(mark)[2]
    if isinstance(value, list | tuple):
        return type(value)(rooted(each, folder) for each in value)
    return value


def repository_of(folder: Path, roots: Iterable[Path]) -> str:
    for root in roots:
        if folder.is_relative_to(root):
            inside = folder.relative_to(root).parts
            return inside[0] if inside else root.name
    return str(folder)


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folders", nargs="+", type=Path)
    parser.add_argument("--python", default=sys.executable, help="runs setup.py; needs setuptools")
    parser.add_argument("--verbose", action="store_true", help="show what differs")
    options = parser.parse_args()
    roots = [folder.resolve() for folder in options.folders]
    folders = [package for root in roots for package in packages_below(root) if (package / "setup.py").is_file()]
    verdicts = [v for f in folders if (v := judge(f, repository_of(f, roots), options.python)) is not None]
    return tell(verdicts, options.verbose)


def tell(verdicts: list[Verdict], verbose: bool) -> int:
    had = [verdict for verdict in verdicts if not verdict.failed]
    equal = [verdict for verdict in had if not verdict.wrong and not verdict.unknown]
    for verdict in verdicts:
        if verdict.failed:
            print(f"no truth  {verdict.folder}: {verdict.failed}")
        elif verdict.wrong or verdict.unknown:
            word = "WRONG    " if verdict.wrong else "unknown  "
            print(f"{word} {verdict.folder}: {', '.join(verdict.wrong or verdict.unknown)}")
            for name, (we, they) in verdict.details.items() if verbose else ():
                print(f"            {name}\n              ours   {we}\n              theirs {they}")
    stubs = collections.Counter(stub.partition(".")[0] for verdict in had for stub in verdict.stubs)
    wrong = [verdict for verdict in had if verdict.wrong]
    share = len(equal) / len(had) if had else 0.0
    repositories = len({verdict.repository for verdict in had})
    size = sum((verdict.size for verdict in had), collections.Counter[str]())
    print("compared: " + ", ".join(f"{count} {name}" for name, count in size.items()))
    print(f"stubbed: {', '.join(f'{name} ({count})' for name, count in stubs.most_common()) or 'nothing'}")
    print(
        f"{len(equal)} of {len(had)} packages from {repositories} repositories equal ({share:.1%}), "
        f"{len(had) - len(equal) - len(wrong)} known not to be evaluated, {len(wrong)} wrong, "
        f"{len(verdicts) - len(had)} whose setup.py does not run"
    )
    return 0 if share >= WANTED and not wrong else 1


if __name__ == "__main__":
    sys.exit(main())
