"""Arguments of ros_gz_bridge: `topic@package/msg/Type[gz.msgs.Type`. (ros_gz_bridge/src/parameter_bridge.cpp)"""

from __future__ import annotations

from collections.abc import Iterator

from ...lazy_regex import regex
from ...package.launch.text import LaunchText, Literal
from ...package.workspace import Workspace
from ...ros.core_messages import CORE_MESSAGES
from ...ros.interface_fields import known_interfaces
from ...ros.names import NameKind
from ...source import Span
from ...suggest import near_names
from ..fault import Fault
from .bridge_pairs import pair_problems
from .launch_context import LaunchContext

BRIDGES = frozenset({"ros_gz_bridge", "ros_ign_bridge"})
TYPE = regex(r"@([a-z]\w*)/(?:(\w+)/)?([A-Z]\w*)(?=[@\[\]\s]|$)")
KINDS = ("msg", "srv")
HARM = "the bridge goes on without the topic"


def bridge_faults(scope: LaunchContext) -> Iterator[Fault]:
    """Yield the misspelt packages, kinds and types; nothing of what may exist."""
    for node in scope.file.nodes:
        if node.package is not None and node.package.literal in BRIDGES:
            for argument in node.arguments:
                for part in argument.parts:
                    if isinstance(part, Literal):
                        wrong = list(type_faults(scope, argument, part))
                        yield from wrong or pair_faults(scope, argument, part)


def type_faults(scope: LaunchContext, argument: LaunchText, part: Literal) -> Iterator[Fault]:
    as_written = scope.file.source.slice(part.span) == part.text
    for match in TYPE.finditer(part.text):
        for group, better in wrong_groups(scope.workspace, match.group(1), match.group(2), match.group(3)):
            start, end = match.span(group)
            span = Span(part.span.start + start, part.span.start + end) if as_written else argument.span
            yield Fault(span, f"there is no `{match.group()[1:]}`: {HARM}; did you mean `{better}`?")


def pair_faults(scope: LaunchContext, argument: LaunchText, part: Literal) -> Iterator[Fault]:
    """Yield the pairs of types that no bridge knows; one that is built here may know others."""
    if any(scope.workspace.named(name) for name in BRIDGES):
        return
    as_written = scope.file.source.slice(part.span) == part.text
    for start, end, problem in pair_problems(part.text, is_whole=len(argument.parts) == 1):
        span = Span(part.span.start + start, part.span.start + end) if as_written else argument.span
        yield Fault(span, f"no pair of types in `{part.text[start:end]}`: {HARM}; {problem}")


def wrong_groups(workspace: Workspace, package: str, kind: str | None, name: str) -> Iterator[tuple[int, str]]:
    """Yield which part of a type is wrong, and what is near: of several the first."""
    facts = workspace.named(package)
    if facts is None and workspace.kind_of(package) is not NameKind.PACKAGE:
        known = {*CORE_MESSAGES, *(each.name for each in workspace.packages if each.interfaces)}
        near = near_names(package, known) or near_names(package, known_interfaces(), 1)
        if len(near) == 1:
            yield 1, near[0]
    elif kind is not None and kind not in KINDS:
        near = near_names(kind, KINDS)
        if near:
            yield 2, near[0]
    elif (kind or "msg") == "msg":
        of_package = {each.removeprefix("msg/") for each in facts.interfaces} if facts else CORE_MESSAGES.get(package)
        near = near_names(name, of_package) if of_package and name not in of_package else []
        if len(near) == 1:
            yield 3, near[0]
