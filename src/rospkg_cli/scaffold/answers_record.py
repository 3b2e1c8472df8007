"""What a package was asked for, kept in it: for `rospkg new --update`, which needs the answers and what was written."""

from __future__ import annotations

import json
import sys
import textwrap
from collections.abc import Iterator, Mapping, Sequence
from pathlib import Path
from typing import Any

from .. import __version__
from ..light_dataclasses import dataclass, field_names, replace
from ..tree import TreeEntry
from . import ScaffoldError
from .answers import Request
from .line_digests import digests
from .plan import Plan
from .render import RenderedFile

if sys.version_info >= (3, 11):
    import tomllib
else:
    import tomli as tomllib

RECORD = ".rospkg-answers.toml"

ABOUT = "what was asked for; `new --update` reads it"

HEAD = """\
# What `rospkg new` was asked for here, and a digest of each line that it wrote.
# `rospkg new --update` reads this file, and writes it anew; without it, nothing but --update is lost.
"""

LARGEST = 1_000_000
"""Bytes; a package with the most files that a template may write has less."""


@dataclass(frozen=True)
class AnswersRecord:
    request: Request
    lines: Mapping[str, tuple[str, ...]]
    """The digests of the lines of each file that was written, by its path in the package."""


def with_record(plan: Plan) -> Plan:
    """Return a plan that writes the record too; a minimal package is to be read as a whole, and has none."""
    if plan.asked.minimal:
        return plan
    lines = {file.path: digests(file.entry.data) for file in plan.files}
    record = RenderedFile(RECORD, TreeEntry("file", record_text(plan.asked, lines).encode()), ABOUT)
    return replace(plan, files=tuple(sorted((*plan.files, record), key=lambda file: file.path)))


def record_text(asked: Request, lines: Mapping[str, Sequence[str]]) -> str:
    """Return the text of a record; `lines` are the digests of each file's lines by its path."""
    return "\n".join(
        [
            f"{HEAD}rospkg = {quoted(__version__)}",
            "",
            "[answers]",
            *answer_lines(asked),
            "",
            "[lines]",
            *digest_lines(lines),
            "",
        ]
    )


def answer_lines(asked: Request) -> Iterator[str]:
    default = Request("")
    for name in field_names(asked):
        value = getattr(asked, name)
        if value != getattr(default, name) or name == "template":
            yield f"{name} = {json.dumps(value, ensure_ascii=False)}"


def digest_lines(lines: Mapping[str, Sequence[str]]) -> Iterator[str]:
    for path in sorted(lines):
        yield f'{quoted(path)} = """'
        yield from textwrap.wrap(" ".join(lines[path]), 99, break_on_hyphens=False, break_long_words=False)
        yield '"""'


def quoted(text: str) -> str:
    """Return a text as a basic string of TOML; it holds no control character."""
    return json.dumps(text, ensure_ascii=False)


def read_record(package: Path) -> AnswersRecord:
    """Return what a package was asked for; raises ScaffoldError where it does not say so."""
    path = package / RECORD
    try:
        with path.open("rb") as stream:
            data = stream.read(LARGEST)
    except FileNotFoundError:
        raise ScaffoldError(
            f"`{package}` has no `{RECORD}`, so what it was made with is unknown; `rospkg new NAME --diff` shows how "
            "it differs from a new one"
        ) from None
    except OSError as error:
        raise ScaffoldError(f"`{path}` can't be read: {error}") from error
    return record_in(data, str(path))


def record_in(text: bytes, path: str) -> AnswersRecord:
    """Return the record that a file at a path holds; raises ScaffoldError where it holds none."""
    try:
        data = tomllib.loads(text.decode())
        return AnswersRecord(request_of(data["answers"]), lines_of_files(data["lines"]))
    except UnicodeError as error:
        raise ScaffoldError(f"`{path}` can't be read: {error}") from error
    except KeyError as error:
        raise ScaffoldError(f"`{path}` lacks the key {error}; take it from git as it was written") from error
    except (ValueError, TypeError, AttributeError, RecursionError) as error:
        raise ScaffoldError(f"`{path}` is not as it was written: {error}; take it from git") from error


def request_of(answers: Mapping[str, Any]) -> Request:
    """Return the request; raises TypeError and ValueError for what is none."""
    default = Request("")
    values: dict[str, Any] = {"name": ""}
    for name, value in answers.items():
        if name not in field_names(default):
            raise ValueError(f"`{name}` is no answer that this version knows")
        kept = tuple(value) if isinstance(value, list) else value
        if type(kept) is not type(getattr(default, name)):
            raise TypeError(f"`{name}` is not what it should be")
        if isinstance(kept, tuple) and not all(isinstance(each, str) for each in kept):
            raise TypeError(f"`{name}` holds more than texts")
        values[name] = kept
    return Request(**values)


def lines_of_files(lines: Mapping[str, str]) -> dict[str, tuple[str, ...]]:
    if broken := [path for path in lines if not path.isprintable()]:
        raise ValueError(f"{broken[0]!a} is no path")
    return {path: tuple(text.split()) for path, text in lines.items()}
