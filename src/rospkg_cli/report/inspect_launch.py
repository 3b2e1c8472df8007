"""What launch files start and which files they pass, for people and for programs."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import Any

from ..control_characters import visible
from ..package.launch.launch_file import LaunchFile
from ..package.launch.launched_parts import DeclaredArgument, Include, LaunchedNode
from ..package.launch.text import LaunchText
from .color import paint

At = Callable[[str, int], dict[str, Any]]


def launch_lines(file: LaunchFile, color: bool) -> Iterator[str]:
    """Yield the lines of one launch file: its arguments, and what it starts, each with its parameter files."""
    arguments = visible(", ".join(argument_text(argument) for argument in file.arguments))
    yield f"    {visible(file.path)}" + (paint(f"  ({arguments})", "dim", color) if arguments else "")
    for node in file.nodes:
        given = visible(", ".join(parameter_files(node)))
        maybe = "" if node.is_certain else paint("  (perhaps)", "dim", color)
        yield f"      {visible(node_text(node))}" + (paint(f"  <- {given}", "dim", color) if given else "") + maybe
    for include in file.includes:
        passed = visible(", ".join(f"{name.shown}:={value.shown}" for name, value in include.arguments))
        yield f"      includes {visible(include.file.shown)}" + (paint(f"  ({passed})", "dim", color) if passed else "")
    for command in file.commands:
        yield f"      runs {visible(' '.join(word.shown for word in command.words))}"
    if not file.is_fully_known:
        yield paint("      … and what can't be determined", "yellow", color)


def argument_text(argument: DeclaredArgument) -> str:
    name = argument.name.shown
    return name if argument.default is None else f"{name}:={argument.default.shown}"


def node_text(node: LaunchedNode) -> str:
    what = node.plugin if node.kind == "composable_node" else node.executable
    words = [shown(node.package) or "", shown(what) or "…"]
    named = f" as {shown(node.name)}" if node.name is not None else ""
    return f"{'loads' if node.kind == 'composable_node' else 'starts'} {' '.join(filter(None, words))}{named}"


def parameter_files(node: LaunchedNode) -> list[str]:
    return [given.file.shown for given in node.parameters if given.file is not None]


def shown(text: LaunchText | None) -> str | None:
    return None if text is None else text.shown


def launch_document(file: LaunchFile, at: At) -> dict[str, Any]:
    """Return one launch file; texts are written as XML would write them, `…` is what can't be determined."""
    return {
        "said": at(file.path, 0),
        "frontend": file.frontend,
        "complete": file.is_fully_known,
        "arguments": [argument_document(argument, file, at) for argument in file.arguments],
        "nodes": [node_document(node, file, at) for node in file.nodes],
        "includes": [include_document(include, file, at) for include in file.includes],
        "commands": [
            {"words": [word.shown for word in command.words], "said": at(file.path, command.span.start)}
            for command in file.commands
        ],
    }


def argument_document(argument: DeclaredArgument, file: LaunchFile, at: At) -> dict[str, Any]:
    return {
        "name": argument.name.shown,
        "default": shown(argument.default),
        "choices": list(argument.choices),
        "said": at(file.path, argument.span.start),
    }


def node_document(node: LaunchedNode, file: LaunchFile, at: At) -> dict[str, Any]:
    return {
        "kind": node.kind,
        "package": shown(node.package),
        "executable": shown(node.executable),
        "plugin": shown(node.plugin),
        "name": shown(node.name),
        "namespace": shown(node.namespace),
        "parameter_files": parameter_files(node),
        "parameters": {name.shown: value.shown for given in node.parameters for name, value in given.values},
        "remappings": [[source.shown, target.shown] for source, target in node.remappings],
        "certain": node.is_certain,
        "said": at(file.path, node.span.start),
    }


def include_document(include: Include, file: LaunchFile, at: At) -> dict[str, Any]:
    return {
        "file": include.file.shown,
        "arguments": {name.shown: value.shown for name, value in include.arguments},
        "certain": include.is_certain,
        "said": at(file.path, include.span.start),
    }
