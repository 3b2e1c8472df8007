"""Words that a launch file gives a node on its command line, where the node's program reads none (LCH003)."""

from __future__ import annotations

from ...lazy_regex import regex
from ...package.launch.launched_parts import LaunchedNode
from ...package.launch.text import uncommented
from ...source import Span
from .launch_context import LaunchContext

UNREAD = "but `{}` reads no argument"
STARTS = regex(
    r"def\s+main\s*\(\s*args\s*(?::[^=)]*)?=\s*None\s*\)"
    r"|\brclpy\.init\(\s*(?:args\s*=\s*)?(?:sys\.argv|args)\s*\)"
)
"""What nearly every node does with its command line, from which rclpy takes the arguments for ROS."""
READS = regex(r"\b(?:sys\.)?argv\b|\bargs\b|(?i:arg_?parse|optparse|getopt|docopt|absl|\bclick\b|\btyper\b|\bfire\b)")
"""What a program reads its command line with, and by what it may hand it on."""


def why_unread(scope: LaunchContext, node: LaunchedNode, place: Span) -> str:
    """Return that a node's program does not read a word of its command line; "" where it may, and for other places.

    What begins with a dash may be for ROS, which opens files itself: `--params-file`.
    """
    words, program = node.arguments, node.executable.literal if node.executable is not None else None
    is_own = node.package is not None and node.package.literal == scope.package.name
    if not (program and is_own and any(each.span.contains(place) for each in words)):
        return ""
    if any(each.literal is None or each.literal.startswith("-") for each in words if not each.span.contains(place)):
        return ""
    source = source_of(scope, program)
    if not source or not scope.files.has_file(source):
        return ""
    text = STARTS.sub("", uncommented(source, scope.files.readable_text(source)))
    return "" if READS.search(text) or "import *" in text else UNREAD.format(program)


def source_of(scope: LaunchContext, program: str) -> str:
    """Return the Python file of a program that the package installs; "" where it is another one, or not known."""
    rows = scope.table.of("executable") if scope.table is not None else ()
    found = [row for row in rows if row.destination.rpartition("/")[2] == program]
    if len(found) != 1:
        return ""
    module = found[0].entry.partition(":")[0].replace(".", "/")
    source = f"{module}.py" if module else found[0].source
    return source if source.endswith(".py") else ""
