"""Faults of launch files in Python that raise or start nothing: imports, calls, values."""

from __future__ import annotations

import re
from collections.abc import Iterator

from bench.faults.fault import PutFault
from bench.faults.kinds import kind
from bench.faults.launch_python import launch_spots
from bench.faults.setup_py import parses
from bench.faults.source_package import SourcePackage


@kind("launch python")
def launch_import_lost(package: SourcePackage) -> Iterator[PutFault]:
    for spot in launch_spots(package, r"^from [\w.]+ import (\w+)\n"):
        if len(re.findall(rf"\b{spot.word}\b", spot.text)) > 1:
            yield spot.drop()


@kind("launch python")
def launch_mistyped_import(package: SourcePackage) -> Iterator[PutFault]:
    for spot in launch_spots(package, r"^from launch(?:_ros)?\.(?:actions|substitutions) import (\w+)$"):
        yield spot.typo()


@kind("launch python")
def launch_mistyped_module(package: SourcePackage) -> Iterator[PutFault]:
    for spot in launch_spots(package, r"^from launch(?:_ros)?\.(actions|substitutions|conditions) import"):
        yield spot.put(spot.word[:-1])


@kind("launch python")
def launch_mistyped_variable(package: SourcePackage) -> Iterator[PutFault]:
    for spot in launch_spots(package, r"^\s+(?:ld|launch_description)\.add_action\((\w+)\)"):
        yield spot.typo()


@kind("launch python")
def launch_parenthesis_lost(package: SourcePackage) -> Iterator[PutFault]:
    yield from (spot.of_file("") for spot in launch_spots(package, r"\](\)),?[ \t]*\n"))


@kind("launch python")
def launch_bracket_lost_at_return(package: SourcePackage) -> Iterator[PutFault]:
    yield from (spot.of_file("(") for spot in launch_spots(package, r"^\s+return LaunchDescription(\(\[)"))


@kind("launch python")
def launch_comma_lost(package: SourcePackage) -> Iterator[PutFault]:
    yield from (spot.of_file("") for spot in launch_spots(package, r"executable\s*=\s*['\"][\w.-]+['\"](,)[ \t]*\n"))


@kind("launch python")
def launch_comma_between_actions(package: SourcePackage) -> Iterator[PutFault]:
    yield from parses(
        spot.of_file("") for spot in launch_spots(package, r"^\s+\)(,)[ \t]*\n\s+(?:Node|DeclareLaunchArgument)\(")
    )


@kind("launch python")
def launch_mistyped_keyword(package: SourcePackage) -> Iterator[PutFault]:
    yield from (
        spot.typo() for spot in launch_spots(package, r"^\s+(parameters|remappings|arguments|namespace)\s*=\s*[\['\"]")
    )


@kind("launch python")
def launch_old_keyword(package: SourcePackage) -> Iterator[PutFault]:
    for spot in launch_spots(package, r"package\s*=\s*['\"][\w-]+['\"],\s*(executable)\s*="):
        yield spot.put("node_executable")


@kind("launch python")
def launch_parameters_not_in_list(package: SourcePackage) -> Iterator[PutFault]:
    yield from (
        spot.put(spot.word[1:-1], "parameters") for spot in launch_spots(package, r"parameters\s*=\s*(\[\w+\])")
    )


@kind("launch python")
def launch_remapping_not_in_list(package: SourcePackage) -> Iterator[PutFault]:
    pattern = r"remappings\s*=\s*(\[\s*(\(['\"][^()\n]+\))\s*\])"
    yield from (spot.put(spot[2], "remappings") for spot in launch_spots(package, pattern))


@kind("launch python")
def launch_arguments_not_in_list(package: SourcePackage) -> Iterator[PutFault]:
    pattern = r"\barguments\s*=\s*(\[(['\"][^'\"\n]+['\"])\])"
    yield from (spot.put(spot[2], "arguments") for spot in launch_spots(package, pattern))


@kind("launch python")
def launch_function_renamed(package: SourcePackage) -> Iterator[PutFault]:
    yield from (
        spot.put("launch_description") for spot in launch_spots(package, r"^def (generate_launch_description)\(")
    )


@kind("launch python")
def launch_return_lost(package: SourcePackage) -> Iterator[PutFault]:
    for spot in launch_spots(package, r"^    (return (?:ld|launch_description))[ \t]*$"):
        yield spot.put("pass", "generate_launch_description", "return")


@kind("launch python")
def launch_condition_of_text(package: SourcePackage) -> Iterator[PutFault]:
    for spot in launch_spots(
        package, r"condition\s*=\s*(IfCondition\(\s*(?:LaunchConfiguration\(\s*['\"]\w+['\"]\s*\)|\w+)\s*\))"
    ):
        yield spot.put("'true'", "condition")


@kind("launch python")
def launch_condition_without_class(package: SourcePackage) -> Iterator[PutFault]:
    for spot in launch_spots(
        package, r"condition\s*=\s*(IfCondition\(\s*(LaunchConfiguration\(\s*['\"]\w+['\"]\s*\))\s*\))"
    ):
        yield spot.put(spot[2], "condition")


@kind("launch python")
def launch_mistyped_output(package: SourcePackage) -> Iterator[PutFault]:
    yield from (spot.put("scren") for spot in launch_spots(package, r"output\s*=\s*['\"](screen)['\"]"))


@kind("launch python")
def launch_arguments_as_dictionary(package: SourcePackage) -> Iterator[PutFault]:
    for spot in launch_spots(package, r"launch_arguments\s*=\s*\{[^{}]*\}(\.items\(\))"):
        yield spot.put("", "launch_arguments")


@kind("launch python")
def launch_description_unquoted(package: SourcePackage) -> Iterator[PutFault]:
    for spot in launch_spots(
        package,
        r"['\"](robot_description)['\"]\s*:\s*(ParameterValue\(\s*(Command\(\[[^\[\]]*\]\)),\s*value_type=str\s*,?\s*\))",
        2,
    ):
        yield spot.put(spot[3], spot[1])


@kind("launch python")
def launch_conflict_markers(package: SourcePackage) -> Iterator[PutFault]:
    for spot in launch_spots(package, r"^(from launch[\w.]* import \w+)\n"):
        yield spot.of_file(f"<<<<<<< HEAD\n{spot.word}\n=======\n>>>>>>> main")
