"""What does --fix do to real packages? `python bench/fix_real.py FOLDER…` (checkouts; they are copied, never changed)

After `rospkg lint --fix`: every package.xml that was well-formed still is, every Python file that compiled still does,
every file of CMake that the real CMake could read it still can, the dependencies as catkin_pkg reads them are the same
unless a DEP or XML2 rule changed them, no fix was taken back, and a second run changes nothing.  With --unsafe,
--unsafe-fixes is given too.
"""

from __future__ import annotations

import argparse
import ast
import json
import shutil
import subprocess
import sys
import tempfile
import warnings
import xml.etree.ElementTree as ET
from pathlib import Path

from catkin_pkg.package import InvalidPackage, parse_package

Dependencies = dict[str, list[str]] | None


def rospkg(*arguments: str) -> subprocess.CompletedProcess[str]:
    command = [sys.executable, "-m", "rospkg_cli", *arguments]
    return subprocess.run(command, capture_output=True, text=True, check=False)


def state(root: Path) -> dict[str, object]:
    """Return, for each manifest and Python file, what must survive."""
    found: dict[str, object] = {}
    for path in sorted(root.rglob("package.xml")):
        found[str(path.relative_to(root))] = well_formed(path), dependencies(path)
    for path in sorted(root.rglob("*.py")):
        found[str(path.relative_to(root))] = compiles(path)
    for path in sorted([*root.rglob("CMakeLists.txt"), *root.rglob("*.cmake")]):
        if path.is_file():
            found[str(path.relative_to(root))] = path.read_bytes()
    return found


def is_cmake(text: bytes) -> bool:
    """Return whether the real CMake can read a file: it reads all of it before it runs any, and here none is run."""
    with tempfile.NamedTemporaryFile(suffix=".cmake") as file:
        file.write(b"return()\n" + text)
        file.flush()
        return subprocess.run(["cmake", "-P", file.name], capture_output=True, check=False).returncode == 0


def well_formed(path: Path) -> bool:
    try:
        ET.fromstring(path.read_bytes())
    except ET.ParseError:
        return False
    return True


def compiles(path: Path) -> bool:
    try:
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")
            ast.parse(path.read_bytes())
    except (SyntaxError, ValueError):
        return False
    return True


def dependencies(path: Path) -> Dependencies:
    try:
        package = parse_package(str(path.parent))
    except (InvalidPackage, OSError, AssertionError, ValueError):
        return None
    kinds = ("build", "build_export", "buildtool", "buildtool_export", "exec", "test", "doc")
    return {kind: sorted(str(d.name) for d in getattr(package, f"{kind}_depends")) for kind in kinds}


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folders", nargs="+", type=Path)
    parser.add_argument("--unsafe", action="store_true")
    arguments = parser.parse_args()
    packages = fixed = faults = 0
    for folder in arguments.folders:
        with tempfile.TemporaryDirectory() as scratch:
            copy = Path(scratch) / folder.name
            shutil.copytree(folder, copy, symlinks=True)
            counts = judge(copy, arguments.unsafe)
        packages, fixed, faults = packages + counts[0], fixed + counts[1], faults + counts[2]
        print(f"{folder.name}: {counts[0]} packages, {counts[1]} repaired, {counts[2]} faults", flush=True)
    print(f"{packages} packages, {fixed} findings repaired, {faults} faults")
    return 1 if faults else 0


def judge(root: Path, unsafe: bool) -> tuple[int, int, int]:
    """Return packages, findings repaired, and faults found."""
    words = ["lint", "--pedantic", "--release", "--fix", "--format", "json", str(root), *(["--unsafe-fixes"] * unsafe)]
    before, report_before = state(root), json.loads(rospkg(*words[:3], *words[4:7]).stdout)
    done = rospkg(*words)
    report = json.loads(done.stdout)
    after = state(root)
    faults = [line for line in done.stderr.splitlines() if line]
    faults += [
        f"{path}: {said(before[path])} became {said(after.get(path))}"
        for path in before
        if broke(before[path], after, path)
    ]
    depends = {
        edit["path"]
        for f in report_before["findings"]
        if f["fix"] and f["code"].startswith(("DEP", "XML2", "XML30"))
        for edit in f["fix"]["edits"]
    }
    faults += [
        f"{path}: the dependencies changed"
        for path in before
        if path.endswith("package.xml")
        and before[path] != after.get(path)
        and not any(name.endswith(path) for name in depends)
        and dict(before)[path][1] is not None  # type: ignore[index]
    ]
    snapshot = {p: p.read_bytes() for p in root.rglob("*") if p.is_file() and not p.is_symlink()}
    rospkg(*words)
    again = {p: p.read_bytes() for p in root.rglob("*") if p.is_file() and not p.is_symlink()}
    faults += [f"{p}: a second run changed it" for p in set(snapshot) | set(again) if snapshot.get(p) != again.get(p)]
    for fault in faults:
        print(f"  {fault}")
    return report["summary"]["packages"], report["summary"]["fixed"], len(faults)


def said(state: object) -> object:
    return "CMake" if isinstance(state, bytes) else state


def broke(was: object, after: dict[str, object], path: str) -> bool:
    now = after.get(path)
    if isinstance(was, bytes):
        return now != was and is_cmake(was) and not (isinstance(now, bytes) and is_cmake(now))
    if isinstance(was, tuple):
        return bool(was[0]) and not (isinstance(now, tuple) and now[0])
    return bool(was) and not now


if __name__ == "__main__":
    sys.exit(main())
