"""Faults of setup.py: what it raises, names and installs."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterable, Iterator

from bench.faults.fault import PutFault, Spot
from bench.faults.kinds import kind
from bench.faults.source_package import SourcePackage

SETUP = r"^setup\.py$"
ENTRY = r"['\"]\s*([\w-]+)\s*=\s*([\w.]+):(\w+)\s*['\"]"


def parses(faults: Iterable[PutFault]) -> Iterator[PutFault]:
    """Yield the faults that leave the file Python."""
    for fault in faults:
        try:
            ast.parse((fault.files[fault.path] or b"").decode())
        except SyntaxError:
            continue
        yield fault


def in_setup(package: SourcePackage, pattern: str, group: int = 1) -> Iterator[Spot]:
    """Yield places in a setup.py that builds the package: with another build type nobody runs it."""
    if package.is_python:
        yield from package.spots(SETUP, pattern, group)


def programs(package: SourcePackage, group: int) -> Iterator[Spot]:
    """Yield places in the entry points of console scripts that work: a module that is not there is a fault already."""
    if package.holds(SETUP, r"['\"]console_scripts['\"]"):
        for spot in in_setup(package, ENTRY, group):
            file = re.escape(spot[2].replace(".", "/"))
            if package.matching(rf"(^|/){file}(\.py|/__init__\.py)$"):
                yield spot


def lost_import(package: SourcePackage, name: str, use: str) -> Iterator[PutFault]:
    if package.holds(SETUP, use):
        for spot in in_setup(package, rf"^(?:from \w+ )?import ({name})\n"):
            yield spot.drop()


@kind("setup.py")
def setup_without_import_of_glob(package: SourcePackage) -> Iterator[PutFault]:
    yield from lost_import(package, "glob", r"\bglob(\.glob)?\(")


@kind("setup.py")
def setup_without_import_of_os(package: SourcePackage) -> Iterator[PutFault]:
    yield from lost_import(package, "os", r"\bos\.")


@kind("setup.py")
def setup_without_import_of_find_packages(package: SourcePackage) -> Iterator[PutFault]:
    if package.holds(SETUP, r"=\s*find_packages\("):
        for spot in in_setup(package, r"import (find_packages, |)setup(, find_packages|)$", 0):
            yield spot.put("import setup", "find_packages")


@kind("setup.py")
def setup_mistyped_variable(package: SourcePackage) -> Iterator[PutFault]:
    for spot in in_setup(package, r"\+\s*(package_name)\b|[(,=]\s*(package_name)\b", 0):
        at = spot.match.group().index("package_name")
        yield spot.put(spot.word[:at] + "pacakge_name", "pacakge_name")


@kind("setup.py")
def setup_comma_between_tuples(package: SourcePackage) -> Iterator[PutFault]:
    yield from parses(spot.of_file("") for spot in in_setup(package, r"\][ \t]*\)(,)[ \t]*\n\s*\("))


@kind("setup.py")
def setup_comma_between_keywords(package: SourcePackage) -> Iterator[PutFault]:
    yield from (spot.of_file("") for spot in in_setup(package, r"^\s+(?:version|name|license)=[^,\n]+(,)$"))


@kind("setup.py")
def setup_parenthesis_lost(package: SourcePackage) -> Iterator[PutFault]:
    yield from (spot.of_file("") for spot in in_setup(package, r"\](\)),[ \t]*\n"))


@kind("setup.py")
def setup_bracket_lost_beside_fstring(package: SourcePackage) -> Iterator[PutFault]:
    yield from (spot.of_file("") for spot in in_setup(package, r"^[^\n]*f['\"][^\n]*(\])\)"))


@kind("setup.py")
def setup_quote_lost(package: SourcePackage) -> Iterator[PutFault]:
    yield from (spot.of_file("") for spot in in_setup(package, r"\['package\.xml(')\]"))


@kind("setup.py")
def setup_keyword_entry_point(package: SourcePackage) -> Iterator[PutFault]:
    yield from (spot.put("entry_point") for spot in in_setup(package, r"^\s+(entry_points)\s*="))


@kind("setup.py")
def setup_keyword_data_file(package: SourcePackage) -> Iterator[PutFault]:
    yield from (spot.put("data_file") for spot in in_setup(package, r"^\s+(data_files)\s*="))


@kind("setup.py")
def setup_keyword_package(package: SourcePackage) -> Iterator[PutFault]:
    yield from (spot.put("package") for spot in in_setup(package, r"^\s+(packages)\s*="))


@kind("setup.py")
def setup_without_packages(package: SourcePackage) -> Iterator[PutFault]:
    for spot in in_setup(package, r"^\s+(packages)\s*=[^\n]*,\n"):
        yield from parses([spot.drop(package.name, "packages")])


@kind("setup.py")
def setup_other_packages(package: SourcePackage) -> Iterator[PutFault]:
    for spot in in_setup(package, r"^\s+packages\s*=\s*(\[[^\]\n]*\]|find_packages\([^)\n]*\)),\n"):
        if f"{package.name}/__init__.py" in package.files:
            yield spot.put("['my_package']", "my_package", package.name)


@kind("setup.py")
def setup_other_name(package: SourcePackage) -> Iterator[PutFault]:
    for spot in in_setup(package, r"^\s+name\s*=\s*(package_name|['\"][\w-]+['\"])"):
        yield spot.put("'my_package'", "my_package")


@kind("setup.py")
def setup_other_version(package: SourcePackage) -> Iterator[PutFault]:
    for spot in in_setup(package, r"^\s+version\s*=\s*['\"](\d+\.\d+\.\d+)['\"]"):
        yield spot.put("91.0.0")


@kind("setup.py")
def setup_tests_require(package: SourcePackage) -> Iterator[PutFault]:
    pattern = r"^(\s+)(zip_safe\s*=\s*True,)"
    if not package.holds(SETUP, "tests_require|extras_require"):
        for spot in in_setup(package, pattern, 2):
            yield spot.put(f"{spot.word} tests_require=['pytest'],", "tests_require")


@kind("setup.py")
def setup_conflict_markers(package: SourcePackage) -> Iterator[PutFault]:
    for spot in in_setup(package, r"^(\s+version\s*=[^\n]+)\n"):
        yield spot.of_file(f"<<<<<<< HEAD\n{spot.word}\n=======\n>>>>>>> main")
