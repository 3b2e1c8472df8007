"""Faults of entry points in setup.py."""

from __future__ import annotations

from collections.abc import Iterator

from bench.faults.fault import PutFault, typo
from bench.faults.kinds import kind
from bench.faults.setup_py import ENTRY, in_setup, parses, programs
from bench.faults.source_package import SourcePackage


@kind("setup.py")
def setup_comma_between_entry_points(package: SourcePackage) -> Iterator[PutFault]:
    for spot in in_setup(package, rf"{ENTRY}(,)[ \t]*\n\s*['\"](\w+)\s*=", 4):
        yield spot.put("", spot[1], spot[5])


@kind("setup.py")
def entry_point_mistyped_module(package: SourcePackage) -> Iterator[PutFault]:
    for spot in programs(package, 2):
        head, dot, last = spot.word.rpartition(".")
        if dot:
            yield spot.put(head + dot + typo(last), last, typo(last), spot[1])


@kind("setup.py")
def entry_point_mistyped_function(package: SourcePackage) -> Iterator[PutFault]:
    yield from (spot.typo(spot[1]) for spot in programs(package, 3))


@kind("setup.py")
def entry_point_other_package(package: SourcePackage) -> Iterator[PutFault]:
    for spot in programs(package, 2):
        own, dot, module = spot.word.partition(".")
        if dot:
            yield spot.put(f"my_package.{module}", spot[1], own, "my_package")


@kind("setup.py")
def entry_point_dot_for_colon(package: SourcePackage) -> Iterator[PutFault]:
    for spot in in_setup(package, r"['\"]\s*([\w-]+)\s*=\s*[\w.]+(:)\w+\s*['\"]", 2):
        yield spot.put(".", spot[1])


@kind("setup.py")
def entry_point_with_ending(package: SourcePackage) -> Iterator[PutFault]:
    for spot in in_setup(package, r"['\"]\s*([\w-]+)\s*=\s*([\w.]+)()[:]\w+\s*['\"]", 3):
        yield spot.put(".py", spot[1], f"{spot[2]}.py")


@kind("setup.py")
def entry_point_with_slash(package: SourcePackage) -> Iterator[PutFault]:
    for spot in in_setup(package, r"['\"]\s*([\w-]+)\s*=\s*\w+(\.)[\w.]+:\w+\s*['\"]", 2):
        yield spot.put("/", spot[1])


@kind("setup.py")
def entry_point_lost(package: SourcePackage) -> Iterator[PutFault]:
    for spot in in_setup(package, rf"^\s*{ENTRY},?[ \t]*\n", 2):
        module = spot.word.rpartition(".")[2]
        others = len(list(in_setup(package, ENTRY)))
        file = f"{spot.word.replace('.', '/')}.py"
        is_program = package.holds(rf"^{file}$", r"^if __name__ ==") or package.holds(
            r"launch", rf"['\"]{spot[1]}['\"]"
        )
        if others > 1:
            for fault in parses([spot.drop(spot[1], module)]):
                yield fault.known(is_program, "nothing says that the module is meant as a program")


@kind("setup.py")
def entry_points_of_console_script(package: SourcePackage) -> Iterator[PutFault]:
    for spot in in_setup(package, r"['\"](console_scripts)['\"]"):
        is_used = next(programs(package, 1), None) is not None
        yield spot.put("console_script").known(is_used, "no program stands below it")
