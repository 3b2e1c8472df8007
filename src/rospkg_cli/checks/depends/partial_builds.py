"""Whether a page has people build a package on purpose without a part of its repository: the simulator, some tools."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from ...files import PackageFiles
from ...lazy_regex import regex
from .installing_texts import texts_called

PAGE = regex(r"(?:.*/)?[^/]*\.(?:md|rst|sh|bash)")
BUILD = regex(r"\bcolcon\s+build\b[^\n#|&;]{0,200}?\s--packages-(?:up-to|select)((?:\s+\w[\w.-]*)+)")
ANY_BUILD = regex(r"\bcolcon\s+build\b")
HEADING = regex(r"#+\s|[=~^-]{3,}\s*$")
LEFT = regex(
    r"(?i)(?:\b(?:without|w/o|no|not including|exclud(?:es?|ing)|except|skip(?:s|ping)?|leav(?:es?|ing) out|ohne|sans"
    r"|sin|sem|senza)\s+|(?:不含|不包含|不包括|不带|不帶|不编译?|无)\s*)(\w[\w-]*(?:[ /]+\w[\w-]*){0,3})"
)
"""Words that say that a part is left out."""
WORD = regex(r"[^\W\d_]{2,}")
SIMULATOR = regex(r"sim(?:s|ulat\w*|ulad\w*|ulaci\w*)?|gazebo|gz|mujoco|webots|isaac\w*|(?:仿真|模拟|模擬)\w*")
BLANK = frozenset(
    ("the", "and", "any", "its", "all", "other", "need", "package", "packages", "errors", "ros", "src", "launch")
)
MAX_LINES = 8
"""The greatest distance between these words and the command, in lines."""
LEFT_OUT = "; a page here has people build this package without that part on purpose"


def is_built_without(files: PackageFiles, own: str, other: str, paths: Iterable[str]) -> bool:
    """Return whether a page builds a package without another and says that it leaves a part out, by a word that all
    launch files have in their paths which need the other: who does not build the simulator does not launch it either.
    """
    wanted = [*map(words_in, paths)]
    for _, text in texts_called(files, lambda path: PAGE.fullmatch(path) is not None):
        for said in said_of_builds(text, own, other) if "--packages-" in text else ():
            left = {word for part in LEFT.findall(said) for word in words_in(part)}
            if left and all(are_of_one(left, words) for words in wanted):
                return True
    return False


def said_of_builds(text: str, own: str, other: str) -> Iterator[str]:
    """Yield what stands at each command that builds a package and not another one, up to its heading."""
    lines = text.replace("\\\n", " ").split("\n")
    for number, line in enumerate(lines):
        for command in BUILD.finditer(line):
            if own in (names := command[1].split()) and other not in names:
                yield "\n".join((line, *lines_above(lines, number)))


def lines_above(lines: list[str], number: int) -> Iterator[str]:
    for line in reversed(lines[max(0, number - MAX_LINES) : number]):
        if ANY_BUILD.search(line):
            return
        yield line
        if HEADING.match(line):
            return


def words_in(text: str) -> frozenset[str]:
    """Return the words of a text or a path, with one for all that simulates."""
    words = frozenset(word.lower() for word in WORD.findall(text)) - BLANK
    return words | ({"simulator"} if any(map(SIMULATOR.fullmatch, words)) else frozenset())


def are_of_one(left: Iterable[str], words: Iterable[str]) -> bool:
    """Return whether two words are one, but for their ends."""
    stems = {word.rstrip("s") for word in words}
    return any(word.rstrip("s") in stems for word in left)
