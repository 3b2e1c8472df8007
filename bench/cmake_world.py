"""A world in which the real CMake configures packages whose dependencies are not installed.

Whatever `find_package` asks for is found (a dependency provider of CMake 3.24 answers); Debian's ament packages and
rosidl are real; of packages among the given checkouts the CMake functions that they export are real too.  A command
that is still unknown is given an empty body, and CMake is started again.  All of it happens in a scratch folder, on a
copy of the package, without network: to configure a package is to run its code.
"""

from __future__ import annotations

import os
import re
import shutil
import subprocess
from collections.abc import Iterable, Iterator, Sequence
from dataclasses import dataclass, field
from pathlib import Path

from rospkg_cli.disk import DiskTree
from rospkg_cli.engine.discovery.discover import packages_below
from rospkg_cli.files import PackageFiles
from rospkg_cli.languages.cmake.evaluated_command import flags_and_values
from rospkg_cli.languages.cmake.values import Word
from rospkg_cli.package.cmake.cmake_project import CMake
from rospkg_cli.package.install_table import InstallTable
from rospkg_cli.package.manifest import Manifest
from rospkg_cli.package.package import Package

PROVIDER = Path(__file__).with_suffix(".cmake")
REAL_PREFIX = Path("/usr/share")
ALSO_REAL = ("Python3", "PythonInterp", "Threads", "GTest", "GMock")
PROGRAMS = ("generate_parameter_library_cpp", "generate_parameter_library_py")
"""Programs that exported CMake looks for."""
UNKNOWN = re.compile(r'Unknown CMake command "(\w+)"')
MAX_STARTS = 12
SECONDS = 120


def open_package(folder: Path) -> Package:
    return Package(PackageFiles(DiskTree(folder)))


def name_of(package: Package) -> str:
    manifest = package.parts(Manifest).only
    return manifest.name if manifest is not None else ""


def real_packages() -> list[str]:
    found = (path.parent.parent.name for path in REAL_PREFIX.glob("*/cmake/*Config.cmake"))
    return sorted({name for name in found if name.startswith(("ament_", "rosidl_"))} | set(ALSO_REAL))


def extras(cmake: CMake, name: str) -> Iterator[Word]:
    """Yield the files of CMake that a package gives to those who find it."""
    for call in cmake.named("ament_package", "ament_auto_package"):
        _, values, _ = flags_and_values(call.words, (), (), ("CONFIG_EXTRAS", "CONFIG_EXTRAS_POST", "INSTALL_TO_SHARE"))
        yield from (*values.get("CONFIG_EXTRAS", ()), *values.get("CONFIG_EXTRAS_POST", ()))
    for call in cmake.named("list", "set"):
        at = call.texts.index(f"{name}_CONFIG_EXTRAS") if f"{name}_CONFIG_EXTRAS" in call.texts[:2] else len(call.texts)
        yield from call.words[at + 1 :]


def write_extras(folder: Path, into: Path) -> None:
    """Write what find_package defines of a package that stands in a checkout: its CONFIG_EXTRAS.

    They are laid out as they are installed, by our own table, for they read what is installed beside them.
    """
    package = open_package(folder)
    cmake, table, name = package.parts(CMake).only, package.parts(InstallTable).only, name_of(package)
    if cmake is None or table is None or not name:
        return
    exported = {word.text for call in cmake.named("ament_export_dependencies") for word in call.words if word.is_known}
    lines = [f"if(NOT {each}_FOUND)\n  find_package({each} QUIET)\nendif()" for each in sorted(exported)]
    share = into / "share" / name
    for word in extras(cmake, name):
        file = folder / word.text
        if word.is_known and file.is_file():
            text = file.read_text(encoding="utf-8", errors="replace")
            if file.suffix == ".in":
                text = re.sub(r"@\w+@", "", text.replace("@PROJECT_NAME@", name))
            copy = share / "cmake" / file.name.removesuffix(".in")
            copy.parent.mkdir(parents=True, exist_ok=True)
            copy.write_text(text, encoding="utf-8")
            lines.append(f'include("{copy}")')
    for row in table.rows if share.exists() else ():
        copy = into / row.destination
        if copy.is_relative_to(share) and row.source and not copy.exists():
            copy.parent.mkdir(parents=True, exist_ok=True)
            copy.symlink_to(folder / row.source)
    if lines:
        head = f'set({name}_DIR "{share / "cmake"}")\n'
        (into / f"{name}.cmake").write_text(head + "\n".join(lines) + "\n", encoding="utf-8")


@dataclass
class World:
    scratch: Path
    stubs: Path
    cmake: str = "cmake"
    commands: set[str] = field(default_factory=set)
    """Those that were given an empty body, for any package."""

    @property
    def variables(self) -> dict[str, str]:
        home = self.scratch / "home"
        home.mkdir(exist_ok=True)
        programs = self.scratch / "bin"
        programs.mkdir(exist_ok=True)
        for name in PROGRAMS:
            if not (programs / name).exists():
                (programs / name).symlink_to("/bin/true")
        return {
            "PATH": f"{programs}:/usr/bin:/bin", "HOME": str(home), "LANG": "C.UTF-8", "ROS_VERSION": "2",
            "ROS_PYTHON_VERSION": "3", "ROS_DISTRO": "humble",
        }  # fmt: skip

    def run(self, command: Sequence[str], cwd: Path, seconds: int = SECONDS) -> subprocess.CompletedProcess[str]:
        sandbox = ["unshare", "--net"] if shutil.which("unshare") and os.geteuid() == 0 else []
        return subprocess.run(
            [*sandbox, *command], cwd=cwd, env=self.variables, capture_output=True, text=True, check=False,
            timeout=seconds, errors="replace",
        )  # fmt: skip

    def arguments(self, commands: Iterable[str]) -> list[str]:
        """Return what makes any CMake run happen in this world."""
        return [
            f"-DCMAKE_PROJECT_TOP_LEVEL_INCLUDES={PROVIDER}",
            f"-DBENCH_REAL={';'.join(real_packages())}",
            f"-DBENCH_STUBS={self.stubs}",
            f"-DBENCH_COMMANDS={';'.join(sorted(commands))}",
        ]

    def configure(self, source: Path, build: Path, *more: str) -> subprocess.CompletedProcess[str]:
        """Configure a package, as often as it takes until every command is known."""
        commands: set[str] = set()
        for _ in range(MAX_STARTS):
            shutil.rmtree(build, ignore_errors=True)
            query = build / ".cmake/api/v1/query/codemodel-v2"
            query.parent.mkdir(parents=True)
            query.touch()
            command = [self.cmake, "-S", str(source), "-B", str(build), *self.arguments(commands), *more]
            done = self.run(command, build)
            fresh = set(UNKNOWN.findall(done.stderr)) - commands
            if not fresh:
                break
            commands |= fresh
        self.commands |= commands
        return done


def make_world(scratch: Path, folders: Iterable[Path], cmake: str = "cmake") -> World:
    stubs = scratch / "stubs"
    stubs.mkdir(parents=True, exist_ok=True)
    for folder in folders:
        for package in packages_below(folder):
            write_extras(package, stubs)
    for name in ("rosidl_default_generators", "rosidl_core_generators"):
        (stubs / f"{name}.cmake").write_text("find_package(rosidl_cmake REQUIRED)\n")
    return World(scratch, stubs, cmake)
