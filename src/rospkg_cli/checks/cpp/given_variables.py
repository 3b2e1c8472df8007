"""What C++ gives to a variable: literals, or the value of parameters, each with its default."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator

from ...lazy_regex import regex
from ...light_dataclasses import dataclass

LITERAL = r"false|true|-?\d+(?:\.\d*)?[fuUlL]?|\"[^\"\n]*\""
LITERALS = regex(LITERAL)
WRAP = r"(?:(?:rclcpp::)?ParameterValue\s*[({]\s*)?"
READ = regex(
    rf"(?:\w+\s*(?:::|\.|->)\s*)*(\w*[pP]aram\w*)\s*(?:<[^;()]*>)?\s*\(\s*\"([^\"\n]+)\"\s*(?:,\s*{WRAP}({LITERAL})\s*[)}},]|\))"
)
"""`declare_parameter<bool>("a", false)`, `get_parameter("a")`, or a function of the package whose name says as much."""
INTO = regex(r"(\w+)\s*(?:<[^;()]*>)?\s*\(\s*\"([^\"\n]*)\"\s*,\s*$")
FALLBACK = regex(rf"\s*(?:,\s*({LITERAL})\s*)?\)")
FILLS = regex(
    r"(?i)(?:param\w*|get\w*|load\w*|read\w*|parse\w*|ref|tie|swap|exchange|store)\s*(?:<[^;()]*>)?\([^;()]*$"
)
LOGS = regex(r"(?i)\w*(?:printf|info|warn|debug|error|fatal|log)\w*")
TYPE = regex(r"\b(?:bool|u?int\w*|auto|float|double|string|long|unsigned|short|size_t)\s*&?\s*$")
CONSTANT = regex(r"\b(?:const|constexpr|static)\b[^;{}]*$")
"""Of others code of another package may set what a header offers."""
CHANGED = regex(r"\s*(?:[-+*/|&^%]=|<<=|>>=|\+\+|--)")
ASSIGNED = regex(r"\s*(?:=(?!=)\s*([^;]*);|\{([^{};]*)\}|\(((?:[^();]|\([^();]*\))*)\)\s*[,;{])")
NEAR = 200


@dataclass(frozen=True, slots=True)
class GivenVariable:
    parameters: tuple[str, ...]
    state: bool | None
    """The value of the variable while no parameter is set; None where that is not one value."""


def given_to(name: str, texts: Iterable[str]) -> GivenVariable | None:
    """Return what code without comments gives to a variable of a name; None where it may give anything."""
    having, word = [each for each in texts if name in each], re.compile(rf"(?<![\w\"]){re.escape(name)}(?![\w\"])")
    names, first, states = set[str](), list[bool | None](), list[bool | None]()
    for text, found in ((each, found) for each in having for found in word.finditer(each)):
        before, behind = text[max(0, found.start() - NEAR) : found.start()], text[found.end() :][:NEAR]
        value = given_here(before, behind)
        if value == "unknown":
            return None
        if isinstance(value, tuple):
            names.add(value[0])
            states += [state_of(value[1])] if value[1] else declared(value[0], having)
        elif value is not None:
            is_open = TYPE.search(before) is not None and not CONSTANT.search(before)
            (first if TYPE.search(before) else states).append(state_of(None if is_open else value))
    if not names:
        states += first
    return GivenVariable(tuple(sorted(names)), states[0] if len(set(states)) == 1 else None)


def given_here(before: str, behind: str) -> str | tuple[str, str] | None:
    """Return what a mention gives a variable: a literal, a parameter and its default, "unknown", or None for naught."""
    if CHANGED.match(behind) or before.endswith(">> ") or (before.endswith("&") and not before.endswith("&&")):
        return "unknown"
    if into := INTO.search(before):
        default = FALLBACK.match(behind)
        if "param" in into[1].lower() and default and not (into[1].startswith("declare") and not default[1]):
            return into[2], default[1] or ""
        return None if LOGS.fullmatch(into[1]) else "unknown"
    if FILLS.search(before) or (TYPE.search(before) and behind.lstrip()[:1] in (",", ")")):
        return "unknown"
    given = ASSIGNED.match(behind)
    if given is None:
        return None
    value = next(each for each in given.groups() if each is not None).strip()
    if LITERALS.fullmatch(value):
        return value
    read = READ.match(value)
    return (read[2], read[3] or "") if read else "unknown"


def declared(name: str, texts: Iterable[str]) -> Iterator[bool | None]:
    """Yield the truth of each default that code declares a parameter with."""
    call = re.compile(rf"declare_param\w*\s*(?:<[^;()]*>)?\s*\(\s*\"{re.escape(name)}\"\s*,\s*{WRAP}({LITERAL})?")
    found = [each[1] for text in texts for each in call.finditer(text)]
    yield from map(state_of, found) if found else [None]


def state_of(literal: str | None) -> bool | None:
    if literal is None:
        return None
    return literal not in ("false", '""') and not re.fullmatch(r"-?0+(?:\.0*)?[fuUlL]?", literal)
