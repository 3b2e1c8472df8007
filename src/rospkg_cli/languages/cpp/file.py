"""One C++ file: its includes, macros, and calls that register classes or declare parameters."""

from __future__ import annotations

from collections.abc import Iterator
from typing import cast

from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...source import Source, Span
from .call import MAX_LENGTH, CppArgument, CppCall, arguments, template_end
from .lexer import CppToken, tokens

INCLUDED = regex(r'<([^>\n"]+)>|"([^"\n]+)"')
DEFINED = regex(r"\w+")
VARIABLE = regex(r"[\s>&*]*(?P<variable>[A-Za-z_]\w*)?\s*")
WANTED = regex(
    r"\w*(REGISTER|EXPORT)\w*|ClassLoader|\w*declare_parameter\w*|declare_or_get_parameter|declareParameter|get_parameter(?:_or)?"
)
MAX_FOLLOWED = 500_000
FOLLOWED_AGAIN = 10
"""Calls are read over so many characters, and over so many times the length of their file: they may hold others."""
BEFORE = regex(r'(?:(?<=[\s,:.(])|^)([A-Za-z_]\w*)\s*[({]\s*("[^"\n]*")\s*,\s*$')


@dataclass(frozen=True, slots=True)
class IncludeDirective:
    path: str
    span: Span
    """Of the path, between its brackets or quotes."""
    is_angled: bool
    is_conditional: bool
    """Whether it is inside an `#if` other than a header's include guard."""


@dataclass(frozen=True, slots=True)
class MacroDefinition:
    """A macro that the file defines."""

    name: str
    span: Span
    body: str


@dataclass(frozen=True)
class CppFile:
    source: Source
    includes: tuple[IncludeDirective, ...]
    defines: tuple[MacroDefinition, ...]
    calls: tuple[CppCall, ...]
    """Macros whose name says that they register or export something, `ClassLoader<…>`, functions that declare or get
    parameters, and what is given a string and the name of a class as two literals: `loader_("package", "ns::Base")`.
    In order."""

    @property
    def path(self) -> str:
        return self.source.path

    def calls_to(self, *names: str) -> Iterator[CppCall]:
        return (call for call in self.calls if call.name in names)


CppParts = tuple[tuple[IncludeDirective, ...], tuple[MacroDefinition, ...], tuple[CppCall, ...]]


def read_cpp(source: Source) -> CppFile:
    """Read one file, once for each Source; what is not C++ is skipped."""
    known = vars(source)
    if "cpp_parts" not in known:  # without the file, which has the source: the two could not be freed at once
        known["cpp_parts"] = read_anew(source)
    return CppFile(source, *cast(CppParts, known["cpp_parts"]))


def read_anew(source: Source) -> CppParts:
    includes: list[IncludeDirective] = []
    defines: list[MacroDefinition] = []
    calls: list[CppCall] = []
    room = MAX_FOLLOWED + FOLLOWED_AGAIN * len(source.text)
    for token in tokens(source.text):
        if token.kind == "directive":
            if token.word == "include":
                includes += include_directive(source.text, token)
            else:
                defines += macro_definition(source.text, token)
        elif token.kind == "name":
            if room > 0 and WANTED.fullmatch(source.text, token.start, token.end):
                found = list(call_at(source, token))
                closed = bool(found) and all(call.arguments is not None for call in found)
                room -= sum(call.span.end - call.span.start for call in found) if closed else MAX_LENGTH
                calls += found
        else:
            calls += initializer_call(source, token)
    return tuple(includes), tuple(defines), tuple(calls)


def include_directive(text: str, token: CppToken) -> Iterator[IncludeDirective]:
    found = INCLUDED.match(text, token.at, token.end)
    if found is not None:
        group = 1 if found.group(1) is not None else 2
        yield IncludeDirective(found.group(group).strip(), Span(*found.span(group)), group == 1, token.is_conditional)


def macro_definition(text: str, token: CppToken) -> Iterator[MacroDefinition]:
    found = DEFINED.match(text, token.at, token.end)
    if found is not None:
        yield MacroDefinition(found.group(), Span(*found.span()), text[found.end() : token.end])


def call_at(source: Source, token: CppToken) -> Iterator[CppCall]:
    """Yield the call at a name; nothing where the name is not called."""
    text, at, kind = source.text, token.at, ""
    if text[at] == "<":
        end = template_end(text, at)
        if end is None:
            return
        kind, at = " ".join(text[at + 1 : end - 1].split()), end
    behind = VARIABLE.match(text, at) if kind else None
    variable = (behind.group("variable") or "") if behind else ""
    at = behind.end() if behind else at
    name = text[token.start : token.end]
    if text[at : at + 1] in ("(", "{") and (found := arguments(source, at)) is not None:
        yield CppCall(name, kind, found[0], variable, Span(token.start, found[1]), token.is_conditional)
    elif kind:
        yield CppCall(name, kind, None, variable, Span(token.start, at), token.is_conditional)


def initializer_call(source: Source, token: CppToken) -> Iterator[CppCall]:
    """Yield `name("text", "ns::Class")` at its second literal, where these are all arguments."""
    before = source.text[max(0, token.start - 200) : token.start]
    found = BEFORE.search(before)
    behind = source.text[token.end : token.end + 40].lstrip()
    if found is None or behind[:1] not in (")", "}"):
        return
    base = token.start - len(before)
    first = CppArgument(found.group(2), Span(base + found.start(2), base + found.end(2)))
    second = CppArgument(source.text[token.start : token.end], Span(token.start, token.end))
    end = source.text.index(behind[0], token.end) + 1
    yield CppCall(found.group(1), "", (first, second), "", Span(base + found.start(1), end), token.is_conditional)
