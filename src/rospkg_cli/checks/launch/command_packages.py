"""Packages whose programs a launch file runs as commands: xacro, ros2 run, gnome-terminal."""

from __future__ import annotations

from collections.abc import Iterator

from ...package.launch.launch_file import LaunchFile
from ...package.launch.text import LaunchText
from ...package.launch.text import Literal as LiteralText
from ...source import Span
from .package_reference import PackageReference, package_named

PROGRAMS = {"xacro": "xacro", "rviz2": "rviz2", "rqt": "rqt_gui"}
"""Programs on the PATH that come with a package of ROS."""
VERBS = {
    **{verb: f"ros2{verb}" for verb in ("action", "bag", "component", "lifecycle", "param", "service", "topic")},
    "control": "ros2controlcli",
}
"""Commands of `ros2` and their packages, but for those that come with whatever starts a launch file."""


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
