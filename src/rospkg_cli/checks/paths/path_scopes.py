"""Where Python or C++ code uses a name that holds a path, by its text."""

from __future__ import annotations

import re
from collections.abc import Iterator
from functools import cached_property

from ...lazy_regex import regex
from ...source import Span
from .code_brackets import TOP, BracketArgument, CodeBrackets

DEF = regex(r"(?m)^([ \t]*)(?:async[ \t]+)?def[ \t]+(\w+)[ \t]*\(")
INDENTED = regex(r"(?m)^([ \t]*)\S")
NO_BLOCK = regex(r"[\w>\]]\s*$")
BLOCK = regex(r"\b(?:else|try|do|const|override|noexcept|final|mutable|(?:class|struct|enum|namespace)\b[^;{}()]*)\s*$")
WIDE = regex(r"\b(?:class|struct|namespace|extern)\b[^;{}()]*$")
PARAMETERS = regex(r"\)[^;{}()]*$")
HEAD = regex(r"(\w+)\s*$")
OWNER = regex(r"(?:\b\w+\s*(?:\.|->|::)\s*)+$")
KEY = regex(r"[\"']-*([\w.-]+)[\"']")


class PathScopes(CodeBrackets):
    def __init__(self, text: str, *, is_python: bool) -> None:
        super().__init__(text)
        self.text = text
        self.is_python = is_python

    def is_block(self, opener: int) -> bool:
        """Return whether statements stand behind a bracket, or none is open."""
        if opener == TOP:
            return True
        before = self.code[max(0, opener - 200) : opener]
        is_brace = self.code[opener] == "{" and not self.is_python
        return is_brace and (NO_BLOCK.search(before) is None or BLOCK.search(before) is not None)

    def function(self, at: int) -> tuple[str, Span]:
        """Return the name and the text of the innermost function around a place; "" and all where there is none."""
        return self.python_function(at) if self.is_python else self.cpp_function(at)

    def python_function(self, at: int) -> tuple[str, Span]:
        around = [each for each in self.functions if each[1].start <= at < each[1].end]
        return around[-1] if around else ("", Span(0, len(self.code)))

    @cached_property
    def functions(self) -> list[tuple[str, Span]]:
        """The functions of Python, each with its text, in order."""
        found = []
        for head in DEF.finditer(self.code):
            lines = INDENTED.finditer(self.code, self.end_of(head.end() - 1))
            end = next((each.start() for each in lines if len(each[1]) <= len(head[1])), len(self.code))
            found.append((head[2], Span(head.start(), end)))
        return found

    def cpp_function(self, at: int) -> tuple[str, Span]:
        opener = self.opener(at)
        while opener != TOP:
            close = PARAMETERS.search(self.code, max(0, opener - 80), opener)
            if self.code[opener] == "{" and close is not None and (head := self.head(close.start())):
                return head, Span(opener, self.end_of(opener))
            opener = self.opener(opener)
        return "", Span(0, len(self.code))

    def head(self, close: int) -> str:
        """Return the name before the parentheses that close at a place."""
        found = HEAD.search(self.code, max(0, self.opener(close) - 80), self.opener(close))
        return found[1] if found is not None and found[1] not in ("if", "for", "while", "switch", "catch") else ""

    def scope(self, at: int, *, is_declared: bool) -> Span:
        """Return the text in which a name means what is bound to it at a place."""
        if self.is_python:
            return self.function(at)[1]
        opener = self.opener(at)
        while not self.is_block(opener):
            opener = self.opener(opener)
        if not is_declared or opener == TOP or WIDE.search(self.code, max(0, opener - 200), opener):
            return Span(0, len(self.code))
        return Span(opener, self.end_of(opener))

    def uses(self, name: str, scope: Span) -> Iterator[Span]:
        """Yield the places of a name, or of an attribute (`.name`), each with the object that has it."""
        is_member, word = name.startswith("."), name.lstrip(".")
        for found in re.compile(rf"{'(?<=[.>])' if is_member else ''}\b{re.escape(word)}\b").finditer(
            self.code, scope.start, scope.end
        ):
            string = self.string_around(found.start())
            if string is not None and not re.match(r"[rR]?[fF]", self.code[string.start : string.end]):
                continue
            yield Span(self.owned(found.start()), found.end())

    def owned(self, start: int) -> int:
        """Return where the object, the module or the namespace of a name begins: `os` of `os.path.join`."""
        owner = OWNER.search(self.code, max(0, start - 80), start)
        return owner.start() if owner is not None else start

    def parameter(self, name: str, given: BracketArgument, keyword: str) -> tuple[str, Span] | None:
        """Return the parameter of a function of this text that gets an argument, and the text of the function."""
        if self.is_python:
            found = re.search(rf"\bdef\s+{name}\s*\(|\bclass\s+{name}\b[\s\S]*?\bdef\s+__init__\s*\(", self.code)
        else:
            found = re.search(rf"[\w>&*]\s+(?:\w+::)?{name}\s*\((?=[^;{{}}]*\)[\s\w]*\{{)", self.code)
        if found is None:
            return None
        opener = found.end() - 1
        start, end = opener + 1, self.end_of(opener) - 1
        names = [name_of(each, is_python=self.is_python) for each in self.code[start:end].split(",")]
        names = [each for each in names if each not in ("self", "cls")]
        wanted = keyword if keyword in names else names[given.index] if given.index < len(names) else ""
        body = self.function(end + 1)[1] if self.is_python else self.body(end)
        return (wanted, body) if wanted else None

    def body(self, close: int) -> Span:
        opener = self.code.find("{", close)
        return Span(opener, self.end_of(opener))


def name_of(parameter: str, *, is_python: bool) -> str:
    """Return the name of a parameter: `path` of `path: str = ''` and of `const std::string & path = ""`."""
    found = re.match(r"\s*\**(\w+)", parameter) if is_python else HEAD.search(parameter.partition("=")[0])
    return found[1] if found is not None else ""
