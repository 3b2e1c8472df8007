"""Conditions of C++ on a parameter, or on a constant, whose default keeps them from holding."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from ...languages.cpp.code_text import code_text
from ...languages.cpp.enclosing import END, openings
from ...languages.cpp.file import CppFile
from ...lazy_regex import regex
from ...source import Span
from ..paths.home_path_texts import without_comments
from ..python.switch import Switch
from .given_variables import given_to

IF = regex(r"\s*if\s*(?:constexpr\s*)?\((.*)\)[^()]*$")
BARE = regex(r"\s*if\s*\(([^()]*)\)")
PLAIN = regex(r"\s*(!?)\s*\(?\s*((?:\w+\s*(?:\.|->|::)\s*)*\w+)\s*\)?\s*")
COMPARED = regex(r"\s*((?:\w+\s*(?:\.|->|::)\s*)*\w+)\s*(==|!=|>)\s*(true|false|0|1)\s*")


def switches_in_cpp(source: CppFile, span: Span, sources: Iterable[CppFile]) -> Iterator[Switch]:
    """Yield the conditions around a place that do not hold by default."""
    texts = [without_comments(each.path, each.source.text) for each in sources]
    for variable, is_on in conditions(code_text(source.source.text), span.start):
        given = given_to(variable, texts)
        if given is not None and given.state is not None and given.state is not is_on:
            yield Switch(variable, given.parameters, is_on)


def is_never(source: CppFile, span: Span) -> bool:
    """Return whether a place stands under `if (false)`."""
    return any(
        name in ("false", "0") and is_on for name, is_on in conditions(code_text(source.source.text), span.start)
    )


def conditions(code: str, at: int) -> Iterator[tuple[str, bool]]:
    """Yield the variables on which it depends whether a place runs, each with the truth that it has to have."""
    start = max((each.end() for each in END.finditer(code, max(0, at - 1000), at)), default=0)
    heads = [found[1] for each in openings(code, at) if (found := IF.fullmatch(each))]
    heads += [found[1] for found in [BARE.match(code[start:at])] if found]
    for head in heads:
        if "||" not in head:
            yield from (known for part in head.split("&&") if (known := condition(part)) is not None)


def condition(part: str) -> tuple[str, bool] | None:
    """Return the variable that a part of a condition asks for alone, by its last name, and the truth it asks for."""
    if found := PLAIN.fullmatch(part):
        return last_name(found[2]), not found[1]
    if found := COMPARED.fullmatch(part):
        is_set = found[3] in ("true", "1")
        return last_name(found[1]), is_set if found[2] == "==" else not is_set
    return None


def last_name(text: str) -> str:
    return text.replace("->", ".").replace("::", ".").rpartition(".")[2].strip()
