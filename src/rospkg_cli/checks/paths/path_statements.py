"""What becomes of a path by the statement of Python or C++ that it is a value of."""

from __future__ import annotations

import re

from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...source import Span
from .path_ends import End
from .path_scopes import PathScopes

TYPE = regex(r"(\w+)>?[ \t&*]+$")
KEYWORDS = frozenset({"return", "new", "throw", "else", "case", "if"})
ASSIGNED = regex(r"(?:^|[\s&*(])((?:\w+\s*(?:\.|->)\s*)*)(\w+)\s*(?::(?!:)[^=\n]+)?\+?=(?!=)[^=]*$")
ASKS = regex(r"\s*(?:if|elif|while|assert|not)\b|.*\b(?:cout|cerr|clog)\b", re.DOTALL)
REBOUND = regex(r"\s*(?::[^=\n()]+)?[+]?=(?!=)")
STREAMED = regex(r"\s*(\w+)\s*<<")
SAVES = r"\s*=\s*[\w.:<]*\b(?:SaveMap|SerializePoseGraph)\b"
"""A variable that holds the request to write a map."""


@dataclass(frozen=True, slots=True)
class PathPlace:
    span: Span
    is_joined: bool = False
    """Whether the path goes on behind what was asked for: a file in the folder."""

    def over(self, start: int, end: int, *, joins: bool = False) -> PathPlace:
        return PathPlace(Span(start, end), self.is_joined or joins)


class PathStatements(PathScopes):
    def in_statement(self, place: PathPlace, todo: list[PathPlace]) -> End:
        """Return what becomes of a path by the statement that it is a value of."""
        start, end = place.span.start, place.span.end
        ends = ("\n",) if self.is_python else (";", "{", "}")
        head = self.code[max(self.code.rfind(each, 0, start) for each in ends) + 1 : start]
        rest = self.code[end : end + 40]
        joined = PathPlace(place.span, place.is_joined or bool(set("+/%") & set(head + rest.partition("\n")[0])))
        assigned = ASSIGNED.search(head)
        if assigned is not None:
            owner, name = assigned[1].replace(" ", ""), assigned[2]
            if owner and owner not in ("self.", "cls.", "this->"):
                holder = owner.rstrip(".->").rpartition(".")[2]
                return "written" if re.search(rf"\b{re.escape(holder)}{SAVES}", self.code) else "unknown"
            is_declared = bool(head[: assigned.start(1)].strip())
            if owner and self.is_python:
                self.bind(todo, joined, f".{name}", Span(0, len(self.code)))
            else:
                self.bind(todo, joined, name, self.scope(start, is_declared=is_declared))
            return "shown"
        stream = STREAMED.match(head)
        if stream is not None and re.search(rf"\bo?stringstream\s+{stream[1]}\b", self.code):
            self.bind(todo, PathPlace(place.span, is_joined=True), stream[1], self.scope(start, is_declared=True))
            return "shown"
        if not head.strip() or ASKS.match(head) or REBOUND.match(rest):
            return "shown"
        if head.strip() == "return":
            return self.returned(joined, todo)
        is_declaration = TYPE.search(head) is not None and head.split()[0] not in KEYWORDS and not self.is_python
        return "shown" if is_declaration and re.match(r"\s*[;{(]", rest) else "unknown"

    def returned(self, place: PathPlace, todo: list[PathPlace]) -> End:
        """Add the calls of the function that returns a path."""
        name = self.function(place.span.start)[0]
        calls = [*re.finditer(rf"(?<![\w:]){name}\s*\(", self.code)] if name else []
        for found in calls:
            before = self.code[max(0, found.start() - 40) : found.start()]
            if TYPE.search(before) and not re.search(r"\b(?:return|in|else|and|or|not)\s+$", before):
                continue  # its definition
            todo.append(place.over(self.owned(found.start()), self.end_of(found.end() - 1)))
        return "shown" if len(calls) > 1 else "unknown"

    def bind(self, todo: list[PathPlace], place: PathPlace, name: str, scope: Span) -> None:
        todo += [PathPlace(each, place.is_joined) for each in self.uses(name, scope) if not each.holds(place.span)]
