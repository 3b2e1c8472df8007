"""Faults of setup.cfg and of the small files of a package in Python."""

from __future__ import annotations

from collections.abc import Iterator

from bench.faults.fault import PutFault, Spot
from bench.faults.kinds import kind
from bench.faults.setup_py import programs
from bench.faults.source_package import SourcePackage

CFG = r"^setup\.cfg$"
SCRIPTS = r"install[_-]scripts\s*=\s*(\$base/lib/[\w-]+)"


def in_cfg(package: SourcePackage, pattern: str) -> Iterator[Spot]:
    """Yield places in the setup.cfg of a package that has executables: without any, nothing is put anywhere."""
    if package.is_python and next(programs(package, 1), None):
        yield from package.spots(CFG, pattern)


@kind("setup.cfg")
def cfg_lost(package: SourcePackage) -> Iterator[PutFault]:
    if package.is_python and next(programs(package, 1), None):
        yield from (package.removed(file, "setup.cfg", "lib") for file in package.matching(CFG))


@kind("setup.cfg")
def cfg_scripts_into_bin(package: SourcePackage) -> Iterator[PutFault]:
    yield from (spot.put("$base/bin", "bin", "install_scripts") for spot in in_cfg(package, SCRIPTS))


@kind("setup.cfg")
def cfg_scripts_into_lib(package: SourcePackage) -> Iterator[PutFault]:
    yield from (spot.put("$base/lib", "install_scripts") for spot in in_cfg(package, SCRIPTS))


@kind("setup.cfg")
def cfg_scripts_of_another_package(package: SourcePackage) -> Iterator[PutFault]:
    yield from (spot.put("$base/lib/my_package", "my_package") for spot in in_cfg(package, SCRIPTS))


@kind("setup.cfg")
def cfg_without_install_section(package: SourcePackage) -> Iterator[PutFault]:
    for spot in in_cfg(package, r"^\[install\]\n(install)[_-]scripts\s*=[^\n]*\n?"):
        yield spot.drop("install_scripts", "setup.cfg")


@kind("setup.cfg")
def cfg_without_section_name(package: SourcePackage) -> Iterator[PutFault]:
    yield from (spot.drop("install_scripts", "setup.cfg") for spot in in_cfg(package, r"^\[(install)\]\n"))


@kind("setup.cfg")
def cfg_mistyped_section(package: SourcePackage) -> Iterator[PutFault]:
    yield from (spot.put("instal", "setup.cfg") for spot in in_cfg(package, r"^\[(install)\]"))


@kind("setup.cfg")
def cfg_mistyped_option(package: SourcePackage) -> Iterator[PutFault]:
    yield from (spot.put("install_script") for spot in in_cfg(package, r"^(install_scripts)\s*="))


@kind("setup.cfg")
def cfg_dashes(package: SourcePackage) -> Iterator[PutFault]:
    yield from (spot.put("install-scripts") for spot in in_cfg(package, r"^(install_scripts)\s*="))


@kind("setup.cfg")
def cfg_bracket_lost(package: SourcePackage) -> Iterator[PutFault]:
    yield from (spot.of_file("") for spot in in_cfg(package, r"^\[install(\])"))


def markers(package: SourcePackage) -> list[str]:
    return package.matching(rf"^resource/{package.name}$") if package.is_python else []


@kind("files")
def marker_lost(package: SourcePackage) -> Iterator[PutFault]:
    yield from (package.removed(file, f"resource/{package.name}") for file in markers(package))


@kind("files")
def marker_misnamed(package: SourcePackage) -> Iterator[PutFault]:
    for file in markers(package):
        yield package.renamed(file, "resource/my_package", f"resource/{package.name}")


@kind("files")
def init_lost(package: SourcePackage) -> Iterator[PutFault]:
    if package.is_python and package.holds("^setup.py$", rf"{package.name}\.\w+:|= ?find_packages"):
        yield from (package.removed(file, package.name) for file in package.matching(rf"^{package.name}/__init__\.py$"))


@kind("files")
def init_misnamed(package: SourcePackage) -> Iterator[PutFault]:
    for file in package.matching(rf"^{package.name}/__init__\.py$"):
        if package.is_python and package.holds("^setup.py$", rf"{package.name}\.\w+:|= ?find_packages"):
            yield package.renamed(file, f"{package.name}/init.py", package.name)


@kind("files")
def registered_module_renamed(package: SourcePackage) -> Iterator[PutFault]:
    for spot in package.spots("^setup.py$", r"['\"]\s*([\w-]+)\s*=\s*(\w+)\.(\w+):\w+", 3):
        file = f"{spot[2]}/{spot.word}.py"
        if file in package.files:
            yield package.renamed(file, f"{spot[2]}/{spot.word}_node2.py", spot.word, spot[1])


@kind("files")
def setup_py_lost(package: SourcePackage) -> Iterator[PutFault]:
    if package.is_python:
        yield from (package.removed(file, "ament_python") for file in package.matching(r"^setup\.py$"))


@kind("files")
def cmake_lists_lost(package: SourcePackage) -> Iterator[PutFault]:
    if not package.is_python:
        yield from (package.removed(file, "ament_cmake") for file in package.matching(r"^CMakeLists\.txt$"))
