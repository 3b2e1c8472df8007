"""Parse setup.cfg as configparser does, keeping positions, and refuse what configparser refuses."""

from __future__ import annotations

from collections.abc import Iterator

from ...files import ReaderInput
from ...lazy_regex import regex
from ...read_problem import ReadProblem
from ...source import Source, Span
from ...unreadable import UnreadableError
from .setup_cfg import CfgOption, CfgSection, SetupCfg
from .setup_text import SetupText

SECTION = regex(r"\[(?P<name>.+)\]")
OPTION = regex(r"(?P<key>[^=:\s]*(?:\s+[^=:\s]+)*)\s*(?:(?P<sign>[=:])\s*(?P<value>.*))?$")
APART = regex(r"\S[^\S\n]{200,}\S")
"""Blanks for which a pattern of configparser takes time in the square of their number."""

MAX_CHARACTERS = 200_000
"""The largest setup.cfg that is parsed."""

COMMENTS = ("#", ";")


def read_setup_cfg(reading: ReaderInput) -> Iterator[SetupCfg]:
    """Read setup.cfg; raises UnreadableError where configparser refuses it."""
    if reading.files.exists("setup.cfg"):
        yield parse_setup_cfg(reading.files.source("setup.cfg"))


def parse_setup_cfg(source: Source) -> SetupCfg:
    """Parse setup.cfg; raises UnreadableError where configparser refuses it."""
    refuse(source)
    return SetupCfg(source, {section.name: section for section in sections(source)})


def refuse(source: Source) -> None:
    """Raise UnreadableError at the line that configparser complains about."""
    if len(source.text) > MAX_CHARACTERS:
        raise UnreadableError(source.path, Span(0, 0), ReadProblem.CFG_LENGTH, f"{MAX_CHARACTERS:,}", skipped=True)
    if apart := APART.search(source.text):
        raise UnreadableError(source.path, Span(*apart.span()), ReadProblem.CFG_BLANKS, skipped=True)
    import configparser

    parser = configparser.RawConfigParser()
    parser.optionxform = str  # type: ignore[assignment,method-assign]  # as setuptools sets it
    try:
        parser.read_string(source.text)
    except configparser.MissingSectionHeaderError as error:
        fail(source, error.lineno, ReadProblem.CFG_NO_SECTION)
    except configparser.ParsingError as error:
        fail(source, error.errors[0][0] if error.errors else 1, ReadProblem.CFG_LINE)
    except configparser.DuplicateOptionError as error:
        fail(source, error.lineno or 1, ReadProblem.CFG_OPTION_TWICE, error.option, error.section)
    except configparser.DuplicateSectionError as error:
        fail(source, error.lineno or 1, ReadProblem.CFG_SECTION_TWICE, error.section)
    except configparser.Error as error:
        fail(source, 1, ReadProblem.CFG_OTHER, str(error).splitlines()[0])


def fail(source: Source, line: int, code: ReadProblem, *details: str) -> None:
    """Raise UnreadableError at a line."""
    span = source.line_span(min(line, len(source.line_starts)))
    raise UnreadableError(source.path, span, code, *details)


def sections(source: Source) -> Iterator[CfgSection]:
    """Yield the sections of a file that configparser accepts."""
    section: CfgSection | None = None
    key: tuple[str, Span] | None = None
    value: list[Span] = []
    indent = 0
    for number in range(1, len(source.line_starts) + 1):
        whole = source.line_span(number)
        line = strip(source, whole)
        text = source.slice(line)
        if not text or text.startswith(COMMENTS):
            continue
        if key and section and line.start - whole.start > indent:
            value.append(line)
            continue
        if key and section:
            add(source, section, key, value)
            key = None
        indent = line.start - whole.start
        if (header := SECTION.match(text)) is not None:
            if section is not None:
                yield section
            section = CfgSection(header["name"], Span(line.start, line.start + header.end()))
        elif section is not None and (match := OPTION.match(text)) is not None:
            key = match["key"], Span(line.start, line.start + match.end("key"))
            at = line.start + (match.start("value") if match["sign"] else len(text))
            value = [Span(at, line.end)]
    if key and section:
        add(source, section, key, value)
    if section is not None:
        yield section


def strip(source: Source, span: Span) -> Span:
    """Return a span without the white space at both ends."""
    text = source.slice(span)
    start = span.start + len(text) - len(text.lstrip())
    return Span(start, max(start, span.start + len(text.rstrip())))


def add(source: Source, section: CfgSection, key: tuple[str, Span], lines: list[Span]) -> None:
    """Add an option to its section; the value is the text from its first line to its last."""
    name, span = key
    filled = [line for line in lines if line.start < line.end] or lines[:1]
    whole = Span(filled[0].start, filled[-1].end)
    value = SetupText(source.path, source.slice(whole), whole, whole)
    option = CfgOption(name, span, value, Span(span.start, max(lines[-1].end, span.end)))
    section.options[option.key] = option
