"""Detect Python that only a newer version than the running one can parse.

The proof: a copy can be parsed in which each newer construct is replaced by what it holds, in older words. So a file
with a plain mistake is never taken for a newer one, even if its lines hold newer syntax.
"""

from __future__ import annotations

import re
import sys
from functools import cached_property
from itertools import pairwise

from ...lazy_regex import regex
from ...light_dataclasses import dataclass, field
from .newer_strings import NotNewerError, can_be_parsed, tokens_of

RUNNING = sys.version_info[:2]
NEWEST = (3, 14)
"""Whose grammar is known here: PEP 654 and 646 (3.11), 695 and 701 (3.12), 696 (3.13), 750 and 758 (3.14)."""

CLOSES = {"(": ")", "[": "]", "{": "}"}
WORD = regex(r"\w+")
PARAMETER = regex(r"\s*\*{0,2}(\s*\w+\s*(?::.*?)?(?:=\s*\*?.*)?)", re.DOTALL)


def needs_newer(text: str) -> bool:
    """Return whether a text that can't be parsed is right for a Python newer than ours; linear in its length."""
    return RUNNING < NEWEST and is_newer(text)


def is_newer(text: str) -> bool:
    try:
        return can_be_parsed(Older(tokens_of(text)[0], text).written())
    except NotNewerError:
        return False


@dataclass
class Older:
    """Writes tokens in words that Python 3.10 knows; raises NotNewerError where they can't be right in any Python."""

    tokens: list[str]
    text: str
    at: int = 0
    out: list[str] = field(default_factory=list)
    brackets: list[str] = field(default_factory=list)
    last: list[str] = field(default_factory=lambda: ["\n"] * 4)
    """The last four tokens that are neither blanks nor line ends in brackets."""
    close_at: int = -1
    """Before which token a parenthesis is closed that the text doesn't have."""

    def written(self) -> str:
        while self.at < len(self.tokens):
            self.step()
        return "".join(self.out)

    def step(self) -> None:
        token, fresh = self.tokens[self.at], not self.brackets and self.last[-1] in ("\n", "\r", "\r\n", ";", ":")
        if token == "type" and fresh and self.names_a_type():
            self.at = self.following(self.at + 1)
            self.copy_to_name()
            self.drop_parameters()
        elif token in ("def", "class") and not self.brackets:
            self.keep()
            self.copy_to_name()
            self.drop_parameters()
        elif token == "except" and fresh:
            self.keep()
            self.handler()
        elif token == "*" and self.is_newer_star():
            self.at += 1
        else:
            self.keep()

    def keep(self) -> None:
        """Copy one token."""
        token = self.tokens[self.at]
        self.out.append(")" + token if self.at == self.close_at else token)
        self.at += 1
        if token in CLOSES:
            self.brackets.append(token)
        elif token in CLOSES.values() and self.brackets:
            self.brackets.pop()
        if not token.isspace() or not (self.brackets or token.strip("\r\n")):
            self.last = [*self.last[1:], token]

    def following(self, at: int) -> int:
        """Return the index of the first token from `at` on that is not blank."""
        while at < len(self.tokens) and self.tokens[at].strip(" \t\f\\\r\n") == "":
            at += 1
        return at

    def token(self, at: int) -> str:
        return self.tokens[at] if at < len(self.tokens) else ""

    def names_a_type(self) -> bool:
        name = self.following(self.at + 1)
        return self.token(name).isidentifier() and self.token(self.following(name + 1)) in ("=", "[")

    def copy_to_name(self) -> None:
        end = self.following(self.at) + 1
        while self.at < min(end, len(self.tokens)):
            self.keep()

    def closing(self, at: int) -> int:
        """Return the index of the bracket that closes the one at `at`."""
        open_ones = 0
        for index in range(at, len(self.tokens)):
            open_ones += (self.tokens[index] in CLOSES) - (self.tokens[index] in CLOSES.values())
            if not open_ones:
                return index
        raise NotNewerError

    def top_level(self, start: int, end: int, sign: str) -> list[int]:
        """Return where a sign stands between two tokens outside of brackets."""
        found, depth = [], 0
        for index in range(start, end):
            depth += (self.tokens[index] in CLOSES) - (self.tokens[index] in CLOSES.values())
            if not depth and self.tokens[index] == sign:
                found.append(index)
        return found

    def drop_parameters(self) -> None:
        """Leave out `[T: int = str, *Ts, **P]` behind a name, where each of them can be read as a parameter."""
        start = self.following(self.at)
        if self.token(start) != "[":
            return
        end = self.closing(start)
        cuts = [start, *self.top_level(start + 1, end, ","), end]
        parts = ["".join(self.tokens[a + 1 : b]) for a, b in pairwise(cuts)]
        if len(parts) > 1 and not parts[-1].strip():
            parts.pop()
        for part in parts:
            parameter = PARAMETER.fullmatch(part)
            plain = re.sub(r"=\s*\*", "=", parameter.group(1)) if parameter else ""
            if not plain or not can_be_parsed(f"def _({plain}): pass"):
                raise NotNewerError
        self.at = end + 1

    def handler(self) -> None:
        """Behind `except`: leave out the star of a group, and put parentheses around several types."""
        star = self.following(self.at)
        if self.token(star) == "*" and self.token(self.following(star + 1)) != ":":
            self.at = star + 1
            self.out.append(" ")
        start = self.at
        end = next(iter(self.top_level(start, self.line_end(start), ":")), None)
        commas = self.top_level(start, end, ",") if end is not None else []
        if end is None or not commas or self.top_level(start, end, "as"):
            return
        if len(commas) == 1 and self.is_python2("".join(self.tokens[commas[0] + 1 : end]).strip()):
            raise NotNewerError
        self.out.append(" (")
        self.close_at = end

    def line_end(self, start: int) -> int:
        depth = 0
        for index in range(start, len(self.tokens)):
            depth += (self.tokens[index] in CLOSES) - (self.tokens[index] in CLOSES.values())
            if not depth and self.tokens[index] in ("\n", "\r", "\r\n"):
                return index
        return len(self.tokens)

    def is_python2(self, name: str) -> bool:
        """Return whether `except Error, name:` binds a name, as Python 2 did: in 3.14 it would be a second type."""
        if not name.isidentifier() or not name[:1].islower():
            return False
        return name not in self.introduced

    @cached_property
    def introduced(self) -> frozenset[str]:
        """The words of all lines that import something or begin a class."""
        lines = (line for line in self.text.splitlines() if "import" in line or "class" in line)
        return frozenset(word for line in lines for word in WORD.findall(line))

    def is_newer_star(self) -> bool:
        """Return whether this star unpacks in a subscript (`a[*b]`), or in what `*args` is said to be."""
        if self.token(self.at + 1) == "*" or not self.brackets:
            return False
        if self.brackets[-1] == "[":
            return self.last[-1] in ("[", ",")
        before = self.last
        return before[-1] == ":" and before[-2].isidentifier() and before[-3] == "*" and before[-4] in ("(", ",")
