"""Whether a page, a script or a comment of the repository calls a package or a library optional."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterable, Iterator
from functools import cached_property

from ...files import PackageFiles
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.missing_repositories import COMMON
from ..repository.container_files import files_called

TELLING = regex(r"(?i)(?:\.(?:md|rst|sh|bash)|(?:^|/)(?:makefile|[^/]*dockerfile[^/]*))$")
SAYS_SO = regex(
    r"(?im)^.*(?:可选(?!参数)|オプション|선택|\b(?:opcional|opzionale|optionnel|facultati|opt[- ]in\b)"
    r"|\boptional(?:ly)?\b(?![ \t]+(?:arg|param|flag|field|set|value|over|topic|frame|key|name))"
    r"|\bonly (?:needed|required|necessary) (?:for|if|when|to)\b|\bif you (?:want|wish|plan|like) to use\b).*$"
)
"""A line that calls a part of the software optional, and not an argument."""
CELL = regex(r"[ \t]*\|([^|\n]*)")
ITEM = regex(r"[ \t]*(?:[-*+]|\d+\.)[ \t]+[*_]*`([^`\n]*)`")
"""The subject of a line of a table, or of a list element that begins with code."""
HEADING = regex(r"[ \t]*(#{1,6})[ \t]|.*:[*_]*[ \t]*$")
"""What stands above a part of a page, or above a list."""
LISTED = regex(r"[ \t]*(?:[-*+|$]|\d+\.|(?:RUN[ \t]+)?(?:sudo|apt|apt-get|pip3?|conda)[ \t])")
"""An element of a list, a line of a table, or a command, which names what the words above it speak of."""
COMMENT = regex(r"<!--((?s:.)*?)-->|(?m:(?:^|[ \t])#[ \t]*(.*)$)")
OF_ANYTHING = COMMON | frozenset(
    "bluetooth camera depth diagnostic hardware image interactive joint laser micro navigation network point "
    "pointcloud requests sensor serial socket static state teleop topic twist vision websocket".split()
)
"""Words that are too common to stand for one package in a page."""
MIN_LETTERS = 5
XML = (".xml", ".xacro", ".urdf", ".sdf", ".world")
MAX_LISTED = 25
"""Lines below a heading that are looked through."""
OPTIONAL = "; a page here calls it optional"
BY_COMMENT = "; a comment here calls it optional"


@dataclass(frozen=True)
class OptionalParts:
    files: PackageFiles

    def why(self, names: Iterable[str], paths: Iterable[str] = ()) -> str:
        """Return what is said of what a page, or a comment in package.xml or in some files, calls optional by one of
        its names, or by the first word of one that says most; "" for others.
        """
        found = {each for name in names for each in wanted(name.replace("-", "_"))}
        patterns = [re.compile(pattern(name), re.IGNORECASE) for name in sorted(found)]
        if any(each.search(line) for each in patterns for line in self.lines):
            return OPTIONAL
        comments = [line for path in ("package.xml", *paths) for line in self.comments(path)] if patterns else []
        return BY_COMMENT if any(each.search(line) for each in patterns for line in comments) else ""

    def comments(self, path: str) -> Iterator[str]:
        """Yield the lines of comments of a file that call something optional."""
        for found in COMMENT.finditer(self.files.readable_text(path)):
            if found[2] is None or not path.endswith(XML):
                yield from SAYS_SO.findall(found[1] or found[2] or "")

    @cached_property
    def lines(self) -> tuple[str, ...]:
        texts = [whole.readable_text(path) for whole, path in files_called(self.files, TELLING) if self.is_near(path)]
        said = (subject(line) for text in texts for line in SAYS_SO.findall(text))
        return (*said, *(line for text in texts for line in listed_below(text)))

    def is_near(self, path: str) -> bool:
        """Return whether a page is of the package or of the whole repository: not of another package."""
        around = {path[:at] for at, sign in enumerate(path) if sign == "/"} | {""}
        others = around & self.packages - {self.files.folder}
        return all(f"{self.files.folder}/".startswith(f"{each}/" if each else "") for each in others)

    @cached_property
    def packages(self) -> frozenset[str]:
        whole = self.files.whole if self.files.whole is not None else self.files.tree
        return frozenset(posixpath.dirname(path) for path in whole.files() if path.endswith("package.xml"))


def wanted(package: str) -> list[str]:
    """Return the names by which a page may mean a package."""
    words = package.split("_")
    first = words[0].rstrip("0123456789")
    found = {package} if len(package) >= MIN_LETTERS and package not in OF_ANYTHING else set()
    return sorted(found | ({first} if len(first) >= MIN_LETTERS and first not in OF_ANYTHING else set()))


def pattern(name: str) -> str:
    """Return a pattern for a name in a page (`ros_gz` bridge) that does not match arguments (`use_gazebo`)."""
    words = "[-_` ]{1,3}".join(map(re.escape, name.split("_")))
    return rf"(?<![A-Za-z0-9_/:=]){words}\d?(?![A-Za-z0-9_/:=])"


def subject(line: str) -> str:
    """Return the part of a line that says what is optional."""
    found = CELL.match(line) or ITEM.match(line)
    return found[1] if found else line


def listed_below(text: str) -> Iterator[str]:
    """Yield the lines of a list, or the commands, below a heading that calls all of them optional."""
    lines = text.replace("\\\n", " ").split("\n") if SAYS_SO.search(text) else []
    for number, line in enumerate(lines):
        if HEADING.match(line) and SAYS_SO.match(line) and not LISTED.match(line):
            below = lines[number + 1 : number + 1 + MAX_LISTED]
            ends = (at for at, each in enumerate(below) if each.strip() and is_next(each, line))
            yield from (subject(each) for each in below[: next(ends, len(below))] if LISTED.match(each))


def is_next(line: str, heading: str) -> bool:
    """Return whether a line begins another part than a heading, or is prose behind the list of another line."""
    if HEADING.match(line) and not LISTED.match(line):
        return True
    return not heading.lstrip().startswith("#") and not line.startswith((" ", "\t", "`")) and not LISTED.match(line)
