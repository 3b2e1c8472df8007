"""Edits of entry points in setup.py: repair and add."""

from __future__ import annotations

import io

from ..finding import Edit
from ..languages.python.evaluate.values import Sequence
from ..lazy_regex import regex
from ..package.setup.entry_point import EntryPoint, parse_entry_point
from ..package.setup.setup_py import SetupPy
from ..package.setup.setup_text import SetupText
from ..source import Span
from .setup_py import add_item, quoted_as, replace_text

# Linear: it has to fit one whole line of entry points, and `:` and `=` stand in none of its other parts.
SLASHES = regex(r"(?P<name>[\w.-]+\s*=\s*)(?P<module>[\w./]+?)(?:\.py)?\s*:\s*(?P<attribute>\w+)(?:\(\))?")
SPACED = regex(r"\s=|=\s")


def repair_entry_point(setup: SetupPy, entry: EntryPoint) -> tuple[Edit, ...]:
    """Return the edits that repair a malformed entry point; none where the intention isn't clear."""
    if entry.fault == "joined":
        return separate_with_commas(setup, entry)
    if entry.fault == "no-attribute" and "." in entry.module:
        is_attribute = setup.file_of(entry.module.rpartition(".")[0]) and not setup.file_of(entry.module)
        head, _, attribute = entry.text.rpartition(".")
        return rewrite_entry_point(entry, f"{head}:{attribute}") if is_attribute else ()
    match = SLASHES.fullmatch(entry.text)
    if match is None:
        return ()
    module = match["module"].strip("/").replace("/", ".")
    return rewrite_entry_point(entry, f"{match['name']}{module}:{match['attribute']}") if setup.file_of(module) else ()


def rewrite_entry_point(entry: EntryPoint, text: str) -> tuple[Edit, ...]:
    return (
        replace_text(entry.setup_text, text)
        if not parse_entry_point(entry.group, SetupText("", text, Span(0, 0))).fault
        else ()
    )


def separate_with_commas(setup: SetupPy, entry: EntryPoint) -> tuple[Edit, ...]:
    """Put commas between the strings that Python joined, if each of them is an entry point."""
    pieces = strings(setup.source.slice(entry.setup_text.span))
    texts = [setup.source.slice(entry.setup_text.span)[start:end].strip("'\"") for start, end in pieces]
    if len(pieces) < 2 or any(parse_entry_point(entry.group, SetupText("", t, Span(0, 0))).fault for t in texts):
        return ()
    ends = [entry.setup_text.span.start + end for _, end in pieces[:-1]]
    return tuple(Edit(entry.path, Span(end, end), ",") for end in ends)


def strings(code: str) -> list[tuple[int, int]]:
    """Return where the string literals of an expression stand; none where there is anything else."""
    import tokenize

    lines = code.splitlines(keepends=True)
    starts = [0]
    for line in lines:
        starts.append(starts[-1] + len(line))
    begins, ends = (getattr(tokenize, name, None) for name in ("FSTRING_START", "FSTRING_END"))  # Python 3.12
    found, first, depth = [], (1, 0), 0
    try:
        for token in tokenize.generate_tokens(io.StringIO(f"({code}\n)").readline):
            first = token.start if not depth else first
            depth += (token.type == begins) - (token.type == ends)
            if token.type in (tokenize.STRING, ends) and not depth:
                shift = [1 if row == 1 else 0 for row in (first[0], token.end[0])]
                at = starts[first[0] - 1] + first[1] - shift[0]
                found.append((at, starts[token.end[0] - 1] + token.end[1] - shift[1]))
            elif token.type == tokenize.NAME and not depth:
                return []
    except (tokenize.TokenError, SyntaxError, IndexError):
        return []
    return found


def add_script(setup: SetupPy, scripts: Sequence, text: str) -> tuple[Edit, ...]:
    """Put an entry point into a list of them, in the hand of the last one: its quotes, and no blanks if it has none."""
    last = setup.source.slice(scripts.places[-1]) if scripts.places else ""
    name, sign, target = text.partition(" = ")
    written = f"{name}={target}" if sign and "=" in last and not SPACED.search(last) else text
    return add_item(setup, scripts, quoted_as(setup, last, written))
