"""To which share directory a text joins the name of a file: of the package in question, of another one, or of none."""

from __future__ import annotations

import re
from functools import cached_property

from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from .held_package_names import argument_defaults, held_names

LOOKUP = regex(
    r"(?:get_package_share_(?:directory|path)|FindPackageShare)\s*\(\s*(?:package(?:_name)?\s*=\s*)?"
    r"(?:[\"']([\w-]+)[\"']|LaunchConfiguration\(\s*[\"'](\w+)|(\w+))|\$\(find(?:-pkg-share)?\s+[\"']?([\w-]+)|package://([\w-]+)/"
)
"""A lookup of a share directory: of a literal package name, of one in an argument or a variable, or in a path."""
ASSIGNED = regex(
    r"[ \t]*(?:self\.|(?:const[ \t]+)?(?:auto|(?:\w+::)*(?:string|path))[ \t]+)?(\w+)(?:[ \t]*:[^=\n]*)?([ \t]*)=[^=]"
)
"""The beginning of a line that binds a name; an argument by its keyword has no blank, and ends with a comma."""
OPEN = ("(", "[", ",")
"""The ends of lines that the next one goes on with."""
LINES = 4
"""The most lines from the name that is bound to the lookup."""
WORD = regex(r"\w+")
REACH = 200
"""The most characters between a share directory and a name that is joined to it."""
ENDS = regex(r"\n[ \t]*\w+[ \t]*=[^=]|\n[ \t]*\n|\.\w{1,6}[\"']|[;<]")
"""What stands between names that have nothing to do with each other: another statement, or another file."""
PLACES = r"(?<![\w.-])(?:/home/|/root/|/Users/|~/|\$\{?HOME\b|(?<!/)(?:\./)?src/)(?![^\"'\n]*/share/)"
BASE = regex(
    rf"{PLACES}|\bexpanduser\(|\bget_?cwd\(|\bcurrent_path\(|\bPath\.(?:home|cwd)\(|\benv[ \t]+HOME\b"
    r"|(?:\benviron\b|\bgetenv\b|\bEnvironmentVariable\b)[^\n]{0,20}[\"'](?:HOME|PWD)[\"']"
)
"""Where a path begins that leads into the source folder or somebody's home."""
HELD_PLACE = regex(rf"(?m)^[ \t]*(?:self\.)?(\w+)[ \t]*=[ \t]*f?[\"']{PLACES}[^\"'\n]*[\"'][ \t]*(?:#.*)?$")
"""A name that is bound to such a path alone."""
UNKNOWN = ""
"""A package whose name is not known."""
ELSEWHERE = "/"
"""Of no package: what is joined to another folder."""


@dataclass(frozen=True)
class JoinedShares:
    text: str
    name: str
    """The package's."""

    def join(self, word: str) -> bool:
        """Return whether a name, as a pattern, is joined to the share directory of the package, or an unknown one."""
        found = re.compile(rf"(?<=[\"'/]){word}").finditer(self.text)
        return any(self.owner(match.start()) in (self.name, UNKNOWN) for match in found)

    def may_join(self, word: re.Pattern[str]) -> bool:
        """Return whether a name is joined to nothing of another package."""
        return any(self.is_joined_here(match.end()) for match in word.finditer(self.text))

    def is_joined_here(self, at: int) -> bool:
        """Return whether a name that ends at a place is joined to nothing of another package."""
        return self.owner(at) in (self.name, UNKNOWN, None)

    def owner(self, at: int) -> str | None:
        """Return the package in whose share directory a place names a file; None where it looks up none."""
        before = [(end, name) for end, name in self.lookups if at - REACH <= end <= at]
        start = before[-1][0] if before else max(at - REACH, self.text.rfind("\n", 0, at) + 1)
        if BASE.search(self.text, start, at):
            return ELSEWHERE
        if not before:
            return None
        end, name = before[-1]
        return None if ENDS.search(self.text, end, at) else name

    @cached_property
    def lookups(self) -> list[tuple[int, str]]:
        """The ends of lookups, and of variables that hold one, each with the package's name."""
        named, defaults = held_names(self.text), argument_defaults(self.text)
        found: list[tuple[int, str]] = []
        held: dict[str, str] = {}
        ends = {match.start(): match for match in LOOKUP.finditer(self.text)}
        places = {found.start(1): found[1] for found in HELD_PLACE.finditer(self.text)}
        for word in WORD.finditer(self.text) if ends else ():
            match = ends.get(word.start()) or ends.get(word.start() - 2)
            if word.start() in places:
                held[word[0]] = ELSEWHERE
                continue
            if match is not None:
                literal = match[1] or match[4] or match[5]
                name = literal or defaults.get(match[2] or "") or named.get(match[3] or "", UNKNOWN)
            elif word[0] in held:
                name = held[word[0]]
            else:
                continue
            found.append(((match or word).end(), name))
            if bound := self.bound_at(word.start()):
                held[bound] = name
        return found

    def bound_at(self, at: int) -> str:
        """Return the variable to which the statement around a place is bound; "" where there is none."""
        start, text = self.text.rfind("\n", 0, at) + 1, self.text
        for _ in range(LINES):
            line = ASSIGNED.match(text, start, at)
            if line is not None:
                end = text.find("\n", start)
                is_keyword = not line[2] and text[start : end if end >= 0 else None].rstrip().endswith(",")
                return "" if is_keyword else line[1]
            if not text[:start].rstrip().endswith(OPEN):
                return ""
            start = text.rfind("\n", 0, start - 1) + 1
        return ""
