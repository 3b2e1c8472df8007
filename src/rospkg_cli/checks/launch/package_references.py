"""The packages that a launch file needs when it runs."""

from __future__ import annotations

from collections.abc import Iterator

from ...languages.python.evaluate.values import Text
from ...light_dataclasses import replace
from ...package.launch.launch_classes import class_of
from ...package.launch.launch_file import LaunchFile
from ...package.launch.python_to_text import text_of
from ...package.launch.text import Substitution
from .command_packages import program_of, run_by
from .moveit_configs import moveit_configs
from .package_reference import FILES_OF, WATCHES, PackageReference, package_named
from .program_prefixes import program_prefixes
from .spawned_controllers import spawned_controllers

STARTED_BY = ("executable", "node_executable", "plugin", "node_plugin")
"""Keywords that say which part of a package a node is."""


def package_references(file: LaunchFile) -> Iterator[PackageReference]:
    """Yield the packages that are certainly named, in the order of the text; none of a file for ROS 1."""
    if file.is_ros1:
        return
    found = {(use.name, use.span): use for use in every_reference(file)}
    for use in sorted(found.values(), key=lambda each: each.span):
        if not file.is_guarded(use.name, use.span):
            yield use


def every_reference(file: LaunchFile) -> Iterator[PackageReference]:
    for node in file.nodes:
        if node.kind == "composable_node":
            uses = package_named(file, node.package, "loads a component of")
            yield from (replace(use, fails="component") for use in uses)
        else:
            yield from package_named(file, node.package, "starts a node of")
    yield from of_others(file)
    for each in file.substitutions:
        is_late = not file.source.slice(each.span).partition("(")[0].rpartition(".")[2].startswith("get_package_")
        yield from (replace(use, is_late=is_late) for use in found_by(file, each))
    for command in file.commands:
        for use in run_by(file, list(command.words)):
            yield use if use.fails == "command" else replace(use, fails="process")
    for prefix in program_prefixes(file):
        does = WATCHES if prefix.is_to_watch else "starts a node with"
        yield PackageReference(prefix.program, file.path, prefix.span, does, fails="process")
    for package, span in moveit_configs(file):
        yield PackageReference(package, file.path, span, "reads the MoveIt configuration of", is_late=False)
    for controller, span in spawned_controllers(file):
        yield PackageReference(controller, file.path, span, "loads the controller of", fails="controller")


def of_others(file: LaunchFile) -> Iterator[PackageReference]:
    """Yield the packages of nodes that classes and functions of other packages make: `nav2_common.launch.Node`.

    A function that nothing calls may be there for code that writes launch files.
    """
    evaluated = file.evaluated if file.has_entry_point else None
    for call in evaluated.calls if evaluated is not None else ():
        package = call.get("package") if not class_of(call) else None
        if evaluated is None or any(each.holds(call.span) for each in evaluated.deferred):
            continue
        if isinstance(package, Text) and any(call.get(each) is not None for each in STARTED_BY):
            yield from package_named(file, text_of(package), "starts a node of")


def found_by(file: LaunchFile, each: Substitution) -> Iterator[PackageReference]:
    match each:
        case Substitution(name="find-pkg-share" | "find-pkg-prefix", arguments=(package, *_)):
            yield from package_named(file, package, FILES_OF)
        case Substitution(name="exec-in-pkg", arguments=(_, package, *_)):
            yield from package_named(file, package, "runs a program of")
        case Substitution(name="find-exec", arguments=(program, *_)):
            yield from program_of(file, program)
        case Substitution(name="command", arguments=(command, *_)):
            yield from run_by(file, [command])
