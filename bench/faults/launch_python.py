"""Faults of launch files in Python."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from functools import lru_cache

from bench.faults.fault import PutFault, Spot
from bench.faults.kinds import kind
from bench.faults.known import WELL_KNOWN, is_in_repository
from bench.faults.source_package import SourcePackage

FILES = r"((^|/)launch/.*|\.launch|_launch)\.py$"
NODE = r"\b(?:Node|LifecycleNode|ComposableNodeContainer)\("


def launch_spots(package: SourcePackage, pattern: str, group: int = 1) -> Iterator[Spot]:
    for spot in package.spots(FILES, pattern, group):
        is_test = spot.path.rpartition("/")[2].startswith("test_")
        if "generate_launch_description" in spot.text and not is_test and is_python(spot.text):
            yield spot


@lru_cache(maxsize=200)
def is_python(text: str) -> bool:
    """Return whether a file is right without a fault: one that is broken already hides all others."""
    try:
        ast.parse(text)
    except (SyntaxError, ValueError):
        return False
    return True


def is_read(spot: Spot) -> bool:
    """Return whether the statement of a place sets no variable, or one that is read behind it."""
    line = spot.text[spot.text.rfind("\n", 0, spot.match.start()) + 1 : spot.match.start()]
    name = re.match(r"\s*(\w+)\s*=", line)
    return name is None or re.search(rf"\b{name[1]}\b", spot.text[spot.match.end() :]) is not None


@kind("launch python")
def launch_mistyped_sibling(package: SourcePackage) -> Iterator[PutFault]:
    for spot in launch_spots(package, r"package\s*=\s*['\"]([\w-]+)['\"]"):
        if spot.word in package.siblings:
            yield spot.typo()


@kind("launch python")
def launch_mistyped_package(package: SourcePackage) -> Iterator[PutFault]:
    for spot in launch_spots(package, r"package\s*=\s*['\"]([\w-]+)['\"]"):
        if spot.word not in package.siblings:
            yield spot.typo()


@kind("launch python")
def launch_mistyped_executable_of_sibling(package: SourcePackage) -> Iterator[PutFault]:
    for spot in launch_spots(package, r"package\s*=\s*['\"]([\w-]+)['\"],\s*executable\s*=\s*['\"]([\w.-]+)['\"]", 2):
        if spot[1] in package.siblings:
            yield spot.typo()


@kind("launch python")
def launch_mistyped_executable(package: SourcePackage) -> Iterator[PutFault]:
    for spot in launch_spots(package, r"package\s*=\s*['\"]([\w-]+)['\"],\s*executable\s*=\s*['\"]([\w.-]+)['\"]", 2):
        if spot[1] in WELL_KNOWN:
            yield spot.typo()


@kind("launch python")
def launch_without_package(package: SourcePackage) -> Iterator[PutFault]:
    for spot in launch_spots(
        package, rf"{NODE}\s*package\s*=\s*['\"]([\w-]+)['\"],\s*(?=executable\s*=\s*['\"]([\w.-]+))"
    ):
        start = spot.match.group().index("package")
        text = spot.text[: spot.match.start() + start] + spot.text[spot.match.end() :]
        yield spot.rewritten(text, "package", spot.word, spot[2]).known(spot[2] != "rviz2", "rviz2 is on the PATH, too")


@kind("launch python")
def launch_without_executable(package: SourcePackage) -> Iterator[PutFault]:
    for spot in launch_spots(package, r"^\s*(executable)\s*=\s*['\"][\w.-]+['\"],[ \t]*\n"):
        yield spot.drop()


@kind("launch python")
def launch_mistyped_configuration(package: SourcePackage) -> Iterator[PutFault]:
    for spot in launch_spots(package, r"LaunchConfiguration\(\s*['\"](\w+)['\"]\s*\)"):
        if re.search(rf"DeclareLaunchArgument\(\s*(?:name=)?['\"]{spot.word}['\"]", spot.text):
            yield spot.typo()


@kind("launch python")
def launch_mistyped_declaration(package: SourcePackage) -> Iterator[PutFault]:
    for spot in launch_spots(package, r"DeclareLaunchArgument\(\s*(?:name=)?['\"](\w+)['\"]"):
        if re.search(rf"LaunchConfiguration\(\s*['\"]{spot.word}['\"]", spot.text):
            yield spot.typo()


@kind("launch python")
def launch_declaration_not_added(package: SourcePackage) -> Iterator[PutFault]:
    for spot in launch_spots(package, r"^\s+(?:ld|launch_description)\.add_action\((declare_\w+|\w+_arg)\)[ \t]*\n"):
        found = re.search(rf"{spot.word}\s*=\s*DeclareLaunchArgument\(\s*(?:name=)?['\"](\w+)['\"]", spot.text)
        if found and re.search(rf"LaunchConfiguration\(\s*['\"]{found[1]}['\"]", spot.text):
            yield spot.drop(found[1])


@kind("launch python")
def launch_action_not_added(package: SourcePackage) -> Iterator[PutFault]:
    for spot in launch_spots(package, r"^\s+(?:ld|launch_description)\.add_action\((\w+)\)[ \t]*\n"):
        if re.search(rf"^\s+{spot.word}\s*=\s*(Node|IncludeLaunchDescription|GroupAction)\(", spot.text, re.MULTILINE):
            yield spot.drop()


@kind("launch python")
def launch_node_not_listed(package: SourcePackage) -> Iterator[PutFault]:
    for spot in launch_spots(package, r"^\s{8,}(\w+),[ \t]*\n"):
        is_node = re.search(rf"^    {spot.word}\s*=\s*(Node|IncludeLaunchDescription)\(", spot.text, re.MULTILINE)
        if is_node and len(re.findall(rf"\b{spot.word}\b", spot.text)) == 2:
            yield spot.drop()


@kind("launch python")
def launch_mistyped_include(package: SourcePackage) -> Iterator[PutFault]:
    for spot in launch_spots(package, r"['\"](?:launch/)?(\w+)(?:\.launch)?\.py['\"]"):
        if package.matching(rf"(^|/){spot.word}(\.launch)?\.py$"):
            yield spot.typo()


@kind("launch python")
def launch_mistyped_file(package: SourcePackage) -> Iterator[PutFault]:
    for spot in launch_spots(package, r"['\"](?:\w+/)*([\w-]+\.(?:ya?ml|rviz|urdf|xacro|urdf\.xacro|sdf|world))['\"]"):
        if package.matching(rf"(^|/){re.escape(spot.word)}$"):
            yield spot.typo()


@kind("launch python")
def launch_mistyped_folder(package: SourcePackage) -> Iterator[PutFault]:
    pattern = r"['\"](launch|config|params|urdf|rviz|maps|worlds)['\"],\s*['\"]([\w.-]+\.\w+)['\"]"
    for spot in launch_spots(package, pattern):
        if f"{spot.word}/{spot[2]}" in package.files:
            yield spot.typo(spot[2]).known(is_read(spot), "nothing reads the variable that holds the path")


@kind("launch python")
def launch_mistyped_share(package: SourcePackage) -> Iterator[PutFault]:
    for spot in launch_spots(
        package,
        r"(?:get_package_share_directory|FindPackageShare|get_package_share_path)\(\s*['\"](\w+)['\"](?!\s*\)\.find\()",
    ):  # `.find(name)` looks for its own name alone
        yield spot.typo()


@kind("launch python")
def launch_mistyped_include_argument(package: SourcePackage) -> Iterator[PutFault]:
    for spot in launch_spots(package, r"launch_arguments\s*=\s*\{\s*['\"](\w+)['\"]\s*:"):
        included = re.findall(r"['\"/]([\w.-]+\.launch\.\w+|\w+_launch\.\w+)['\"]", spot.text[: spot.match.start()])
        if included and is_in_repository(package, included[-1], spot.path):
            bound = re.findall(
                r"^\s*(\w+)\s*=\s*(?:\w+\.)*IncludeLaunchDescription\(", spot.text[: spot.match.start()], re.M
            )
            is_added = not bound or len(re.findall(rf"\b{bound[-1]}\b", spot.text)) > 1
            yield spot.typo().known(is_added, "nothing adds the action")


COMPONENT = r"package\s*=\s*['\"](\w+)['\"],\s*plugin\s*=\s*['\"](?:\w+::)+(\w+)['\"]"


@kind("launch python")
def launch_mistyped_component_of_sibling(package: SourcePackage) -> Iterator[PutFault]:
    for spot in launch_spots(package, COMPONENT, 2):
        if spot[1] in package.siblings:
            yield spot.typo()


@kind("launch python")
def launch_mistyped_component(package: SourcePackage) -> Iterator[PutFault]:
    for spot in launch_spots(package, COMPONENT, 2):
        if spot[1] in WELL_KNOWN:
            yield spot.typo()


@kind("launch python")
def launch_file_renamed(package: SourcePackage) -> Iterator[PutFault]:
    included = package.words(FILES, r"['\"/](\w+(?:\.launch)?\.py)['\"]")
    for file in package.matching(FILES):
        if file.rpartition("/")[2] in included:
            yield package.renamed(file, file.replace(".py", "2.py"))


@kind("launch python")
def launch_wrong_ending(package: SourcePackage) -> Iterator[PutFault]:
    for spot in launch_spots(package, r"['\"](?:launch/)?(\w+\.launch\.py)['\"]"):
        if package.matching(rf"(^|/){spot.word}$"):
            yield spot.put(spot.word.replace(".launch.py", ".launch"))
