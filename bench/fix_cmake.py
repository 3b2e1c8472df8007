"""Does CMake still configure what --fix writes? `python bench/fix_cmake.py FOLDER…` (checkouts; they are copied)

Every package of ament_cmake is configured by the real CMake and Debian's ament, before and after
`rospkg lint --fix --unsafe-fixes --target lyrical`; whatever other package it asks for is found, with nothing in it.
What could be configured still can, installs no less, and calls nothing that Lyrical removed.  To configure a package is
to run its code: give checkouts that you trust, or a machine that you don't mind.
"""

from __future__ import annotations

import argparse
import json
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path
from xml.etree import ElementTree

from rospkg_cli.ros.read_table import rows

PROVIDER = Path(__file__).with_suffix(".cmake")
REAL = ("Python3", "PythonInterp", "Threads", "GTest", "GMock")
UNKNOWN = re.compile(r'Unknown CMake command "(\w+)"')
INSTALLED = re.compile(r'file\(INSTALL DESTINATION "([^"]*)" TYPE (\w+)[^)]*? FILES\s([^)]*)\)')
REMOVED = re.compile(r"^\s*ament_target_dependencies\s*\(", re.MULTILINE)
MAX_STARTS = 12
SECONDS = 120


def real_packages() -> str:
    found = (path.parent.parent.name for path in Path("/usr/share").glob("*/cmake/*Config.cmake"))
    return ";".join(sorted({name for name in found if name.startswith("ament_")} | set(REAL)))


def packages(root: Path) -> list[Path]:
    """Return the folders of the packages that ament_cmake builds."""
    found = []
    for path in sorted(root.rglob("package.xml")):
        try:
            build_type = ElementTree.parse(path).getroot().findtext("export/build_type")
        except ElementTree.ParseError:
            continue
        if build_type == "ament_cmake" and path.with_name("CMakeLists.txt").is_file():
            found.append(path.parent)
    return found


def configure(package: Path, scratch: Path) -> tuple[str, set[tuple[str, ...]]]:
    """Return what CMake refuses ("" where it does not), and what would be installed where."""
    commands: set[str] = set()
    build = scratch / "build"
    known = scratch / "compilers"
    for _ in range(MAX_STARTS):
        shutil.rmtree(build, ignore_errors=True)
        if known.exists():
            shutil.copytree(known, build / "CMakeFiles")
        command = [
            "cmake", "-S", str(package), "-B", str(build), "-Wno-dev", "-DBUILD_TESTING=OFF",
            f"-DCMAKE_PROJECT_TOP_LEVEL_INCLUDES={PROVIDER}", f"-DBENCH_REAL={real_packages()}",
            f"-DBENCH_COMMANDS={';'.join(sorted(commands))}", f"-DBENCH_THERE={';'.join(sorted(brought(package)))}",
            "-DPython3_EXECUTABLE=/usr/bin/python3",
        ]  # fmt: skip
        try:
            done = subprocess.run(command, capture_output=True, text=True, check=False, timeout=SECONDS)
        except subprocess.TimeoutExpired:
            return "it takes too long", set()
        fresh = set(UNKNOWN.findall(done.stderr)) - commands
        if not fresh:
            break
        commands |= fresh
    remember(build, known)
    return (done.stderr if done.returncode else ""), installed(build, package)


def brought(package: Path) -> set[str]:
    """Return the packages that a CMakeLists.txt speaks of: some are found by others that are only stubs here."""
    words = set(re.findall(r"\w+", (package / "CMakeLists.txt").read_text(errors="replace")))
    known = {each for name, needs in rows("exported_dependencies.txt").items() for each in (name, *needs)}
    return {name for name in known if name in words and not name.startswith("ament_")}


def remember(build: Path, known: Path) -> None:
    """Keep what CMake found out of the compilers, which takes it longer than all the rest."""
    for found in build.glob("CMakeFiles/*/CMakeCXXCompiler.cmake"):
        if not known.exists() and found.with_name("CMakeCCompiler.cmake").exists():
            shutil.copytree(found.parent, known / found.parent.name)


def installed(build: Path, package: Path) -> set[tuple[str, ...]]:
    found: set[tuple[str, ...]] = set()
    for script in build.rglob("cmake_install.cmake"):
        for destination, kind, files in INSTALLED.findall(script.read_text(errors="replace")):
            for name in re.findall(r'"([^"]*)"', files):
                found.add((destination, kind, name.replace(str(build), "").replace(str(package), "")))
    return found


def fix(root: Path, ignored: str) -> int:
    """Mend a checkout and return how many findings were repaired."""
    words = [
        "lint",
        "--select",
        "CMK,IDL",
        *(["--ignore", ignored] if ignored else []),
        "--fix",
        "--unsafe-fixes",
        "--target",
        "lyrical",
        "--format",
        "json",
    ]
    command = [sys.executable, "-m", "rospkg_cli", *words, "--allow-empty", str(root)]
    done = subprocess.run(command, capture_output=True, text=True, check=False)
    return int(json.loads(done.stdout)["summary"]["fixed"])


def main() -> int:
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folders", nargs="+", type=Path)
    parser.add_argument("--all", action="store_true", help="also packages in which nothing was repaired")
    parser.add_argument("--ignore", default="", metavar="CODES", help="leave the faults of these rules")
    arguments = parser.parse_args()
    total, faults = [0, 0, 0], 0
    for folder in arguments.folders:
        with tempfile.TemporaryDirectory() as place:
            scratch = Path(place)
            before, after = scratch / "before" / folder.name, scratch / "after" / folder.name
            shutil.copytree(folder, before, symlinks=True)
            shutil.copytree(folder, after, symlinks=True)
            repaired = fix(after, arguments.ignore)
            for package in packages(before):
                other = after / package.relative_to(before)
                if arguments.all or texts(package) != texts(other):
                    result = compare(
                        package,
                        other,
                        scratch,
                        str(package.relative_to(scratch / "before")),
                        "CMK005" not in arguments.ignore,
                    )
                    total = [a + b for a, b in zip(total, result, strict=True)]
                    faults += result[2]
        print(f"{folder.name}: {repaired} repaired", flush=True)
    print(f"{total[0]} packages changed, {total[1]} of them could be configured before, {total[2]} faults")
    return 1 if faults else 0


def texts(package: Path) -> dict[str, bytes]:
    files = [*package.rglob("CMakeLists.txt"), *package.rglob("*.cmake")]
    return {str(path.relative_to(package)): path.read_bytes() for path in files if path.is_file()}


def compare(before: Path, after: Path, scratch: Path, name: str, removed: bool) -> tuple[int, int, int]:
    """Return one package, whether it could be configured, and what is wrong with it now."""
    refused, had = configure(before, scratch)
    if refused:
        print(f"  {name}: it can't be configured as it is: {first_line(refused)}")
        return 1, 0, 0
    refused, has = configure(after, scratch)
    faults = [f"CMake refuses it now: {refused}"] if refused else [f"{row} is gone" for row in sorted(had - has)]
    left = [path for path, text in texts(after).items() if REMOVED.search(text.decode(errors="replace"))]
    faults += [f"{path} still calls ament_target_dependencies" for path in left if removed]
    for fault in faults:
        print(f"  {name}: {fault}")
    for row in sorted(has - had):
        print(f"  {name}: installs {row}")
    return 1, 1, len(faults)


def first_line(text: str) -> str:
    return " ".join(line.strip() for line in text.splitlines() if line.strip())[:200]


if __name__ == "__main__":
    sys.exit(main())
