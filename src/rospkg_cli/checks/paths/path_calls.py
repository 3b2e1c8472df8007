"""What becomes of a path among the arguments of a call in Python or C++."""

from __future__ import annotations

import re

from ...lazy_regex import regex
from ...source import Span
from .path_ends import COPIES, JOINS, OPENS, End, end_in
from .path_scopes import KEY
from .path_statements import KEYWORDS, REBOUND, TYPE, PathPlace, PathStatements

TEXTS = frozenset({"string", "path", "auto", "char", "Path", "string_view"})
KEYWORD = regex(r"(?:^|[\s&*])(\w+)\s*(?::(?!:)[^=]+)?=\s*[^=]*$")
ASKERS = {"add_argument": "", "DeclareLaunchArgument": "LaunchConfiguration"}
"""What declares an argument, and what reads it by its name."""
STREAM = regex(r"(\w+)\s*(?:\.|->)\s*$")
INITIALIZED = regex(r"(?:(?<!:):|,)\s*$")
NEAR = 240


class PathCalls(PathStatements):
    def in_call(self, place: PathPlace, called: re.Match[str], opener: int, todo: list[PathPlace]) -> PathPlace | End:
        """Return what becomes of an argument."""
        name, end = called[1], self.end_of(opener)
        argument = self.argument(opener, place.span.start)
        keyword = KEYWORD.search(self.code, argument.span.start, place.span.start)
        type_before = TYPE.search(self.code, max(0, called.start() - NEAR), called.start())
        if type_before is not None and type_before[1] == "def":
            if keyword is not None:
                self.bind(todo, place, keyword[1], self.function(end)[1])
            return "shown"  # the parameter itself stands nowhere else
        if not self.is_python:
            is_declared = type_before is not None and type_before[1] not in KEYWORDS
            if self.is_writing_stream(name) and not is_declared and name.endswith("_"):
                return "written"  # in the list of a constructor
            if self.is_declaration(place, called, type_before[1] if type_before else "", opener, todo):
                return "shown"
            name = type_before[1] if is_declared and type_before is not None else name
        elif REBOUND.match(self.code, place.span.end):
            return "shown"  # the name of a keyword
        if "parameter" in name or name in ASKERS:
            return self.in_parameter(place, called, opener, todo)
        if name in COPIES:
            return "written" if argument.index else "read"
        result = end_in(name, self.text[opener:end])
        if result == "path":
            return place.over(self.owned(called.start()), end, joins=name in JOINS)
        if result in ("read", "unknown") and self.is_of_writer(name, called):
            return "written"
        own = self.parameter(name, argument, keyword[1] if keyword is not None else "") if result == "unknown" else None
        if own is None:
            return result
        self.bind(todo, place, *own)
        return "shown"

    def is_declaration(
        self, place: PathPlace, called: re.Match[str], of_type: str, opener: int, todo: list[PathPlace]
    ) -> bool:
        """Return whether what looks like a call declares a parameter, a variable or a member, which may go on."""
        if TYPE.search(self.code, self.argument(opener, place.span.start).span.start, place.span.start):
            return True
        name = called[1]
        is_variable = of_type in TEXTS
        is_member = name.endswith("_") and INITIALIZED.search(self.code, max(0, called.start() - 40), called.start())
        if is_variable or is_member:
            self.bind(todo, place, name, self.scope(opener, is_declared=is_variable))
        return bool(is_variable or is_member)

    def is_of_writer(self, name: str, called: re.Match[str]) -> bool:
        """Return whether a call opens a stream that writes, gives a bag to one, or asks for a map to be saved."""
        if name == "StorageOptions":
            return "SequentialWriter" in self.code and "SequentialReader" not in self.code
        owner = STREAM.search(self.code, max(0, called.start() - 80), called.start())
        if owner is None or name not in (*OPENS, "Request"):
            return False
        if name == "Request":
            return owner[1] in ("SaveMap", "SerializePoseGraph")
        return "writer" in owner[1].lower() or self.is_writing_stream(owner[1])

    def is_writing_stream(self, name: str) -> bool:
        return re.search(rf"\bofstream\s+(?:\w+\s*,\s*)*{name}\b", self.code) is not None

    def in_parameter(
        self, place: PathPlace, called: re.Match[str], opener: int, todo: list[PathPlace]
    ) -> PathPlace | End:
        """Return what becomes of the default of a parameter, or of an argument of a command line."""
        key = KEY.search(self.text, opener, place.span.end)
        if key is None:
            return "unknown"
        if called[1] == "add_argument":
            self.bind(todo, place, "." + key[1].replace("-", "_"), Span(0, len(self.code)))
            return "shown"
        reader = ASKERS.get(called[1], r"get_parameter\w*")
        for found in re.finditer(rf"\b{reader}\s*\(\s*[\"']{re.escape(key[1])}[\"']\s*([,)])", self.text):
            start = self.text.index("(", found.start())
            if found[1] == ",":
                target = self.argument(start, found.end() + 1).span
                into = re.search(r"(\w+)\s*$", self.code[target.start : target.end])
                if into is not None:
                    self.bind(todo, place, into[1], self.scope(start, is_declared=False))
            else:
                todo.append(place.over(self.owned(found.start()), self.end_of(start)))
        if called[1] in ASKERS:
            return "shown"
        return place.over(self.owned(called.start()), self.end_of(opener))
