"""Faults of data_files in setup.py: what is installed, and where."""

from __future__ import annotations

import re
from collections.abc import Iterator

from bench.faults.fault import PutFault
from bench.faults.kinds import kind
from bench.faults.setup_py import in_setup, parses
from bench.faults.source_package import SourcePackage


@kind("setup.py")
def setup_without_marker(package: SourcePackage) -> Iterator[PutFault]:
    pattern = r"^\s*\(\s*f?['\"]share/(ament_index)/resource_index/packages['\"],\s*\[[^\]]*\]\s*\),[ \t]*\n"
    yield from parses(spot.drop("resource_index", "marker", package.name) for spot in in_setup(package, pattern))


@kind("setup.py")
def setup_without_manifest(package: SourcePackage) -> Iterator[PutFault]:
    pattern = r"^\s*\([^()\n]*\[['\"](package\.xml)['\"]\]\s*\),[ \t]*\n"
    yield from parses(spot.drop() for spot in in_setup(package, pattern))


@kind("setup.py")
def setup_marker_elsewhere(package: SourcePackage) -> Iterator[PutFault]:
    for spot in in_setup(package, r"['\"]share/ament_index/(resource_index)/packages['\"]"):
        yield spot.put("resources_index", "resource_index/packages", package.name)


def data_lines(package: SourcePackage, folder: str) -> Iterator[PutFault]:
    pattern = rf"^\s*\([^\n]*\b({folder})\b[^\n]*\]?\),?[ \t]*\n"
    for spot in in_setup(package, pattern):
        if package.matching(rf"^{folder}/"):
            yield from parses([spot.drop()])


@kind("setup.py")
def data_of_launch_lost(package: SourcePackage) -> Iterator[PutFault]:
    yield from data_lines(package, "launch")


@kind("setup.py")
def data_of_another_folder_lost(package: SourcePackage) -> Iterator[PutFault]:
    for folder in ("config", "urdf", "rviz", "worlds", "meshes", "params", "maps", "models"):
        yield from data_lines(package, folder)


@kind("setup.py")
def data_pattern_with_wrong_ending(package: SourcePackage) -> Iterator[PutFault]:
    for spot in in_setup(package, r"glob\([^\n]*\*(\.(?:launch\.)?\w+|launch\.py)['\"]"):
        yield spot.put(spot.word.replace("py", "pyy") if "py" in spot.word else ".txxt", "glob", "setup.py")


@kind("setup.py")
def data_pattern_with_wrong_folder(package: SourcePackage) -> Iterator[PutFault]:
    yield from (spot.typo() for spot in in_setup(package, r"glob\((?:os\.path\.join\()?['\"](\w+)(?=['\"/])"))


@kind("setup.py")
def data_file_mistyped(package: SourcePackage) -> Iterator[PutFault]:
    for spot in in_setup(package, r"\[\s*['\"](?!package)((?:\w+/)*[\w.]+\.\w+)['\"]"):
        if not re.search(r"py_modules\s*=\s*\[[^\]]*$", spot.text[: spot.match.start(1)]):
            yield spot.typo(spot.word.rpartition("/")[2])


@kind("setup.py")
def data_without_package_name(package: SourcePackage) -> Iterator[PutFault]:
    joined = r"os\.path\.join\(['\"]share['\"](,\s*package_name)\s*,\s*['\"](\w+)"
    pattern = rf"{joined}|['\"]share/['\"] ?(\+ ?package_name \+ ?['\"]/)(\w+)"
    for spot in in_setup(package, pattern, 0):
        lost, new = spot[1] or spot[3], "" if spot[1] else "+ '"
        new = spot.word.replace(lost, new, 1)
        yield from parses([spot.put(new, f"share/{spot[2] or spot[4]}", spot[2] or spot[4])])


@kind("setup.py")
def data_into_mistyped_share(package: SourcePackage) -> Iterator[PutFault]:
    for spot in in_setup(package, r"['\"](share)['\"],\s*package_name,\s*['\"](\w+)"):
        ending = re.search(r"\*([\w.*-]*)['\"]", spot.text[spot.match.end() :].split("\n", 1)[0])
        files = package.matching(
            rf"^{spot[2]}/.*{re.escape(ending[1]).replace(chr(92) + '*', '.*') if ending else ''}$"
        )
        yield spot.put("shre", spot[2]).known(bool(files), "the pattern takes no file there")
