"""Edits that replace ament_target_dependencies by target_link_libraries, in the same lines."""

from __future__ import annotations

from ..checks.cmake.ament_target_dependencies import RemovedCommand, ReplacedArgument, Replacement
from ..finding import Edit
from ..source import Span
from .cmake_commands import remove


def use_target_link_libraries(removed: RemovedCommand, replacement: Replacement) -> tuple[Edit, ...]:
    """Return the edits: the name, the packages, and the keyword where the target is linked with keywords."""
    file, command = removed.file, removed.command
    if not any(part.texts for part in replacement.parts):
        return (remove(file, command),)
    upper = file.source.slice(command.name_span).isupper()
    name = "TARGET_LINK_LIBRARIES" if upper else "target_link_libraries"
    edits = [Edit(file.path, command.name_span, name)]
    first = command.arguments[0].span.end
    keyword = " PUBLIC" if replacement.signature == "keyword" and not replacement.keyword else ""
    if keyword:
        edits.append(Edit(file.path, Span(first, first), keyword))
    edits += [edit for part in replacement.parts if (edit := link_argument(removed, part)) is not None]
    if replacement.includes:
        edits.append(
            Edit(
                file.path,
                Span(command.span.end, command.span.end),
                include_directories_command(removed, replacement, upper),
            )
        )
    return tuple(edits)


def link_argument(removed: RemovedCommand, part: ReplacedArgument) -> Edit | None:
    """Return the edit of one argument: its targets, parted as the arguments are; the blanks before it go with it."""
    if part.texts is None:
        return None
    file, span = removed.file, part.argument.span
    before = blanks_before(removed, span.start)
    if not part.texts:
        return Edit(file.path, Span(span.start - len(before), span.end), "")
    if "\n" in before or len(part.texts) < 3:
        return Edit(file.path, span, (before or " ").join(part.texts))
    lines = "".join(f"\n{indent(removed)}{text}" for text in part.texts)
    return Edit(file.path, Span(span.start - len(before), span.end), lines)


def blanks_before(removed: RemovedCommand, at: int) -> str:
    """Return the blanks before an offset."""
    text = removed.file.source.text
    start = at
    while start > removed.command.inner.start and text[start - 1] in " \t\n":
        start -= 1
    return text[start:at]


def indent(removed: RemovedCommand) -> str:
    source = removed.file.source
    line = source.slice(source.line_span(source.position(removed.command.span.start)[0]))
    return line[: len(line) - len(line.lstrip())] + "  "


def include_directories_command(removed: RemovedCommand, replacement: Replacement, upper: bool) -> str:
    """Return a command for the include directories that the targets don't bring."""
    source = removed.file.source
    name = "TARGET_INCLUDE_DIRECTORIES" if upper else "target_include_directories"
    target = source.slice(removed.command.arguments[0].span)
    keyword = replacement.keyword or "PUBLIC"
    return f"\n{indent(removed)[:-2]}{name}({target} {keyword} {' '.join(replacement.includes)})"
