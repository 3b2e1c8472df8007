"""The packages that a launch file needs when it runs."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Literal

from ...languages.python.evaluate.values import Text
from ...lazy_regex import regex
from ...light_dataclasses import dataclass, replace
from ...package.launch.launch_classes import class_of
from ...package.launch.launch_file import LaunchFile
from ...package.launch.python_to_text import text_of
from ...package.launch.text import LaunchText, Substitution
from ...package.launch.text import Literal as LiteralText
from ...source import Span
from .moveit_configs import moveit_configs
from .program_prefixes import program_prefixes
from .spawned_controllers import spawned_controllers

NAME = regex(r"[A-Za-z][A-Za-z0-9_-]*")

Failure = Literal["launch", "import", "component", "controller", "command", "program", "process"]
"""A node, or a search for files, stops the launch, and so do an import and a program that is run for its output. The
launch goes on without a component, a controller or another process, and an error is logged
(launch_ros/actions/load_composable_nodes and launch/actions/execute_local)."""

FILES_OF = "looks for files of"
"""What a file does with a package whose folder it asks for."""
PROGRAMS = {"xacro": "xacro", "rviz2": "rviz2", "rqt": "rqt_gui"}
"""Programs on the PATH that come with a package of ROS."""

WATCHES = "watches a node with"
"""What a file does with a tool of developers, or with the terminal that such a tool is started in."""

OF_DESKTOP = frozenset({"gnome-terminal"})
"""Programs that every desktop of Ubuntu has, without which they show nothing."""

STARTED_BY = ("executable", "node_executable", "plugin", "node_plugin")
"""Keywords that say which part of a package a node is."""

VERBS = {
    **{verb: f"ros2{verb}" for verb in ("action", "bag", "component", "lifecycle", "param", "service", "topic")},
    "control": "ros2controlcli",
}
"""Commands of `ros2` and their packages, but for those that come with whatever starts a launch file."""


@dataclass(frozen=True, slots=True)
class PackageReference:
    """A package that a launch file needs, and where it is used."""

    name: str
    path: str
    span: Span
    does: str
    """What the file does with it, as a sentence goes on: "starts a node of"."""
    is_late: bool = True
    """Whether nothing happens before the launch comes to it; a function of Python runs when the file is loaded."""
    fails: Failure = "launch"
    """What ends where the package is not there."""
    only_with: str = ""
    """The argument without which the file does not come to it: `sim:=true`; "" for what it does by default."""

    @property
    def is_usual(self) -> bool:
        """Whether any usual installation or desktop has it, or its name may be the user's own, or it is a tool of
        developers: it is said mildly.
        """
        return self.fails in ("command", "controller") or self.does == WATCHES or self.name in OF_DESKTOP


def package_references(file: LaunchFile) -> Iterator[PackageReference]:
    """Yield the packages that are named for certain, in the order of the text; none of a file for ROS 1."""
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


def package_named(file: LaunchFile, text: LaunchText | None, does: str) -> Iterator[PackageReference]:
    name = text.literal if text is not None else None
    if text is not None and name and NAME.fullmatch(name):
        yield PackageReference(name, file.path, text.span, does)


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


def run_by(file: LaunchFile, words: list[LaunchText]) -> Iterator[PackageReference]:
    """Yield what a command needs: the package of its program, and of `ros2 run` and `ros2 launch`."""
    first = next((word.parts[0] for word in words if word.parts), None)
    if isinstance(first, LiteralText):
        program = first.text.split(" ")[0].strip()
        if program in PROGRAMS:
            start = first.span.start + first.text.index(program)
            span = (
                Span(start, start + len(program))
                if first.span.end - first.span.start == len(first.text)
                else first.span
            )
            yield PackageReference(PROGRAMS[program], file.path, span, f"runs `{program}` of", fails="program")
    literals = [word.literal for word in words]
    if literals[:1] == ["ros2"] and literals[1:2] in (["run"], ["launch"]):
        yield from package_named(file, words[2] if len(words) > 2 else None, "runs a program of")
    command = (words[0].literal or "").split() if words else []
    verb = (literals[1] if len(literals) > 1 else None) if literals[:1] == ["ros2"] else "".join(command[1:2])
    if command[:1] == ["ros2"] and verb in VERBS:
        at = words[1].span if len(command) == 1 else words[0].span
        yield PackageReference(VERBS[verb], file.path, at, f"runs `ros2 {verb}` of", fails="command")


def program_of(file: LaunchFile, program: LaunchText) -> Iterator[PackageReference]:
    name = program.literal
    if name in PROGRAMS:
        yield PackageReference(PROGRAMS[name], file.path, program.span, f"runs `{name}` of", fails="program")
