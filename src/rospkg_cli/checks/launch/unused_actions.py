"""Actions that a Python launch file makes and that nothing adds to its launch description."""

from __future__ import annotations

from collections.abc import Iterator

from ...languages.python.evaluate.values import Call
from ...languages.python.undefined_names import undefined_names
from ...light_dataclasses import dataclass
from ...package.launch.launch_classes import class_of
from ...package.launch.python_to_text import text_of
from ...package.workspace import Workspace
from ...ros.launch_calls import ACTIONS
from ...source import Span
from ...suggest import near_names
from .awaited_actions import only_awaited
from .launch_configurations import LaunchConfigurations
from .unread_bindings import is_mentioned, overwritten, unread
from .unset_configurations import unset, unused

HARM = {
    "Node": "it is never started",
    "LifecycleNode": "it is never started",
    "ComposableNodeContainer": "it is never started",
    "ExecuteProcess": "it is never started",
    "IncludeLaunchDescription": "nothing is included",
}


@dataclass(frozen=True, slots=True)
class UnusedAction:
    span: Span
    what: str
    harm: str
    is_gone: bool = False
    """Whether it starts an executable that its package, one of the workspace, does not install: a leftover."""
    starter: str = ""
    """The launch file that starts the same by another action."""
    again: int = 0
    """The line that binds its name to something else."""
    is_awaited: bool = False
    """Whether an event handler waits for it, and no comment mentions it."""
    is_vain: bool = False
    """Whether what the event handler holds is added by itself, too."""
    written: str = ""
    """How it is made."""


def unused_actions(configurations: LaunchConfigurations) -> Iterator[UnusedAction]:
    """Yield the actions that are bound to a local name which nothing reads, or that are a statement of their own."""
    file, launch = configurations.file.python, configurations.file.evaluated
    if file is None or launch is None or not configurations.file.has_entry_point:
        return
    calls = {call.span: call for call in launch.calls if class_of(call) in ACTIONS}
    reported = reported_arguments(configurations)
    for each in only_awaited(file):
        call = calls.get(file.span(each.value))
        if call is not None and class_of(call) in HARM:
            waits = "what waits for it starts at once" if each.is_vain else "neither is what waits for it"
            harm, is_met = f"{HARM[class_of(call)]}, and {waits}", not (each.is_vain or is_mentioned(each.name, file))
            span, what = file.span(each.target), f"`{each.name}`"
            written = file.source.slice(call.span)
            yield UnusedAction(span, what, harm, is_awaited=is_met, is_vain=each.is_vain, written=written)
    for name, node, value, line in (*((*each, 0) for each in unread(file)), *overwritten(file)):
        call = calls.get(file.span(value))
        if call is None or uses_reported(call, reported) or (not line and is_mentioned(name, file)):
            continue
        unknown = {each.name for each in undefined_names(file)} if name else ()
        if not near_names(name, unknown):  # a misspelt use is reported by LCH013
            what = f"`{name}`" if name else f"this `{class_of(call)}`"
            kind = class_of(call)
            harm = HARM.get(kind, "it has no effect")
            is_gone = starts_nothing(call, configurations.workspace)
            from .started_elsewhere import started_elsewhere  # what few launch files need

            starter = started_elsewhere(call, configurations.file, configurations.around)
            written = file.source.slice(call.span)
            yield UnusedAction(file.span(node), what, harm, is_gone, starter, line, written=written)


def starts_nothing(call: Call, workspace: Workspace) -> bool:
    """Return whether a node's package is one of the workspace, and certainly has no such executable."""
    package, executable = (
        text_of(value).literal if (value := call.get(name)) is not None else None for name in ("package", "executable")
    )
    facts = workspace.named(package) if package and executable else None
    if facts is None or executable is None or not facts.knows("executables"):
        return False
    return executable not in facts.executables | facts.misplaced_executables and not facts.may_write(executable)


def reported_arguments(configurations: LaunchConfigurations) -> frozenset[str]:
    """Return the arguments that LCH008 and LCH017 report."""
    names = {each.name for each in unset(configurations)}
    return frozenset(names | {argument.name.literal or "" for argument in unused(configurations)})


def uses_reported(call: Call, reported: frozenset[str]) -> bool:
    name = call.get("name", 0) if class_of(call) == "DeclareLaunchArgument" else None
    return name is not None and (text_of(name).literal or "") in reported
