"""Edits that replace ament_target_dependencies by target_link_libraries, in the same lines."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from ..checks.cmake.removed_command import RemovedCommand, ReplacedArgument, Replacement
from ..finding import Edit
from ..languages.cmake.file import CMakeFile
from ..package.line_width import AMENT_WIDTH
from ..source import Span
from .cmake_commands import listed, margin, remove

OLD, NEW = "ament_target_dependencies", "target_link_libraries"


def use_target_link_libraries(removed: RemovedCommand, replacement: Replacement) -> tuple[Edit, ...]:
    """Return the edits: the name, the packages, and the keyword where the target is linked with keywords."""
    file, command = removed.file, removed.command
    if not any(part.texts for part in replacement.parts):
        return (remove(file, command),)
    upper = file.source.slice(command.name_span).isupper()
    edits = [Edit(file.path, command.name_span, NEW.upper() if upper else NEW)]
    first = command.arguments[0].span.end
    keyword = " PUBLIC" if replacement.signature == "keyword" and not replacement.keyword else ""
    if keyword:
        edits.append(Edit(file.path, Span(first, first), keyword))
    edits += link_arguments(removed, replacement, len(keyword))
    if replacement.includes:
        edits.append(
            Edit(
                file.path,
                Span(command.span.end, command.span.end),
                include_directories_command(removed, replacement, upper),
            )
        )
    return tuple(edits)


def link_arguments(removed: RemovedCommand, replacement: Replacement, added: int) -> Iterator[Edit]:
    """Yield the edits of the packages: their targets, parted as the packages are, unless a line becomes too long.

    `added` characters come before them.
    """
    file, parts = removed.file, replacement.parts[1:]
    each_alone = becomes_too_long(removed, parts, added)
    wrap, column = f"\n{indent(removed)}", column_behind_target(removed) + added
    for part in parts:
        span, blanks = part.argument.span, blanks_before(removed, part.argument.span.start)
        wrap = "\n" + blanks.rpartition("\n")[2] if "\n" in blanks else wrap
        texts = (file.source.slice(span),) if part.texts is None else part.texts
        made = ""
        for text in texts:
            is_full = is_spread(removed) and column + len(text) + 1 >= AMENT_WIDTH
            is_alone = part.texts is not None and (each_alone or len(texts) > 2 or is_full)
            is_alone = is_alone or (bool(made) and "\n" in blanks)
            glue = wrap if is_alone and (made or "\n" not in blanks) else blanks or " "
            made += glue + text
            column = len(text) + (len(glue.rpartition("\n")[2]) if "\n" in glue else column + len(glue))
        if part.texts is not None:
            yield Edit(file.path, Span(span.start - len(blanks), span.end), made)
    if each_alone and closes_alone(file):
        end = removed.command.span.end - 1
        yield Edit(file.path, Span(end, end + 1), f"\n{margin(removed.file, removed.command)})")


def becomes_too_long(removed: RemovedCommand, parts: Sequence[ReplacedArgument], added: int) -> bool:
    """Return whether a command of one line becomes longer than a line may be."""
    source = removed.file.source
    line = source.slice(source.line_span(source.position(removed.command.span.start)[0]))
    grown = sum(len(" ".join(each.texts)) - len(source.slice(each.argument.span)) for each in parts if each.texts)
    return not is_spread(removed) and len(line) + added + len(NEW) - len(OLD) + grown > AMENT_WIDTH


def is_spread(removed: RemovedCommand) -> bool:
    """Return whether the command has several lines."""
    return "\n" in removed.file.source.slice(removed.command.span)


def closes_alone(file: CMakeFile) -> bool:
    """Return whether most commands of several lines have their closing bracket in a line of its own."""
    written = [file.source.slice(each.span) for each in file.syntax.commands]
    alone = [text.rpartition("\n")[2].strip() == ")" for text in written if "\n" in text]
    return 2 * sum(alone) > len(alone)


def column_behind_target(removed: RemovedCommand) -> int:
    """Return the column where the first argument ends, once the command has its new name."""
    source, end = removed.file.source, removed.command.arguments[0].span.end
    start = source.line_span(source.position(end)[0]).start
    return end - start + (len(NEW) - len(OLD) if start <= removed.command.span.start else 0)


def blanks_before(removed: RemovedCommand, at: int) -> str:
    """Return the blanks before an offset."""
    text = removed.file.source.text
    start = at
    while start > removed.command.inner.start and text[start - 1] in " \t\n":
        start -= 1
    return text[start:at]


def indent(removed: RemovedCommand) -> str:
    """Return the blanks before arguments on lines of their own."""
    return margin(removed.file, removed.command) + ("\t" if removed.file.indent.startswith("\t") else "  ")


def include_directories_command(removed: RemovedCommand, replacement: Replacement, upper: bool) -> str:
    """Return a command for the include directories that the targets don't bring."""
    source = removed.file.source
    name = "TARGET_INCLUDE_DIRECTORIES" if upper else "target_include_directories"
    target = source.slice(removed.command.arguments[0].span)
    keyword = replacement.keyword or "PUBLIC"
    before = margin(removed.file, removed.command)
    line = f"{before}{name}({target} {keyword} {' '.join(replacement.includes)})"
    if len(line) > AMENT_WIDTH:
        end = f"\n{before}" if closes_alone(removed.file) else ""
        line = f"{before}{name}({target} {keyword}{listed(replacement.includes, indent(removed))}{end})"
    return f"\n{line}"
