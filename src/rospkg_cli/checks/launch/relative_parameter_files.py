"""Parameter files that a node is given by a relative path: it is looked for in the current directory."""

from __future__ import annotations

import re
from collections.abc import Iterator

from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.launch.argument_defaults import literal_defaults
from ...package.launch.launch_file import LaunchFile
from ...package.launch.launched_parts import LaunchedNode
from ...package.launch.text import LaunchText, Substitution
from ...source import Span
from ..fault import Fault
from .launch_context import LaunchContext
from .missing_reference import MissingReference
from .who_meets import level_met

PATH = regex(r"[/\\~]|\.(?:ya?ml|params?)$")
FOR_FILES = regex(r"file|path|ya?ml|conf|param", re.IGNORECASE)
"""Names of arguments that are given a file, whatever their defaults."""
RELATIVE = regex(r"\w[\w.-]*(?:/[\w.-]+)*\.ya?ml")


@dataclass(frozen=True, slots=True)
class RelativeParameterFile:
    span: Span
    path: str
    installed: str
    """The file that is probably intended, relative to the share directory."""
    is_default: bool
    """Whether it is the default of an argument."""


def relative_parameter_files(scope: LaunchContext) -> Iterator[RelativeParameterFile]:
    """Yield the relative paths among `parameters` for which the package installs a file of that name."""
    file = scope.file
    if file.is_ros1 or scope.is_unused_test:
        return
    seen = set()
    for text, is_default in given_files(file):
        path = text.literal or ""
        installed = scope.package.share_files if RELATIVE.fullmatch(path) else frozenset[str]()
        found = sorted(each for each in installed if f"/{each}".endswith(f"/{path}"))
        if found and text.span not in seen:
            seen.add(text.span)
            yield RelativeParameterFile(text.span, path, found[0], is_default)


def relative_faults(scope: LaunchContext) -> Iterator[Fault]:
    """Yield a fault for each of these paths, a warning at most."""
    for found in relative_parameter_files(scope):
        softer, why = level_met(scope.file, found.span, scope.workspace)
        where = f"the share directory of `{scope.package.name}`"
        text = f"`{found.path}` is looked for in the current directory: elsewhere the node does not find its parameters"
        text = f"{text}{why and ', '}{why}; join it to {where}: `{found.installed}`"
        yield Fault(found.span, text, softer or "warning")


def given_files(file: LaunchFile) -> Iterator[tuple[LaunchText, bool]]:
    """Yield the files among the parameters of nodes, and whether each is the default of an argument."""
    for node in file.nodes:
        yield from files_of(file, node)


def files_of(file: LaunchFile, node: LaunchedNode) -> Iterator[tuple[LaunchText, bool]]:
    """Yield those of one node."""
    known = literal_defaults(file.arguments, file.assigned)
    defaults = {each.name.literal: each.default for each in file.arguments if each.name.literal in known}
    for given in node.parameters:
        match given.file.parts if given.file else ():
            case (Substitution(name="var", arguments=(name, *inline)),):
                default = defaults.get(name.literal)
                if default is None and name.literal not in file.set_configurations:
                    default = next(iter(inline), None)
                if default is not None:
                    yield default, True
            case _ if given.file is not None:
                yield given.file, False


def values_as_files(file: LaunchFile) -> Iterator[Fault]:
    """Yield the arguments that stand among parameters, where launch_ros takes a file, and whose default is none."""
    for text, is_default in given_files(file):
        value = (text.literal or "").strip()
        if is_default and value and not PATH.search(value):
            names = [each.name.literal for each in file.arguments if each.default is text]
            name = next(iter(names), None) or next(named_inline(file, text), None) or "name"
            if FOR_FILES.search(name):
                continue
            message = f"`{name}` stands among parameters, where launch_ros takes files; its default `{value}` is none"
            yield Fault(text.span, f"{message}: the node does not get it; write `{{'{name}': …}}`", "warning")


def named_inline(file: LaunchFile, default: LaunchText) -> Iterator[str]:
    """Yield the launch configuration that has a default where it is used: `LaunchConfiguration('x', default=…)`."""
    for each in file.configurations():
        if each.arguments[1:] == (default,) and each.arguments[0].literal:
            yield each.arguments[0].literal


def is_for_nodes(scope: LaunchContext, missing: MissingReference) -> bool:
    """Return whether it is a parameter file of nodes alone: launch_ros leaves out one that is no file, and warns."""
    texts = [text.span for text, _ in given_files(scope.file)]
    spans = (missing.span, *missing.other_spans)
    return all(any(text.contains(span) for text in texts) for span in spans)


def has_other_values(scope: LaunchContext, missing: MissingReference) -> bool:
    """Return whether each node that is given a missing file has other parameters, too, which set what they hold."""
    spans = (missing.span, *missing.other_spans)
    has_more = []
    for node in scope.file.nodes:
        given = {each.file.span if each.file is not None else each.span for each in node.parameters}
        lost = {text.span for text, _ in files_of(scope.file, node) if any(map(text.span.contains, spans))}
        has_more += [len(given) > len(lost)] if lost else []
    return bool(has_more) and all(has_more)
