"""Whose parameters C++ code gets: those of its own node, of another one, or of one whose base class is elsewhere."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence
from functools import cached_property

from ...languages.cpp.call import CppCall
from ...languages.cpp.code_text import code_text
from ...languages.cpp.enclosing import class_around
from ...languages.cpp.file import CppFile
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.params.cpp_parameters import NAMED
from .own_python_reads import CLIENT, NODE

RECEIVER = regex(r"([A-Za-z_]\w*)\s*(?:\(\s*\)\s*)?(?:->|\.)\s*(?:template\s+)?$")
CLASS = regex(r"\b(?:class|struct)\s+(?:[A-Z_]+\s+)?(\w+)(?:\s+final)?\s*(?::(?!:)\s*([^{;]+))?\{")
BASE = regex(r"(?:(?:public|protected|private|virtual)\s+)*(?:::)?([\w:]+)")
NODES = regex(r"(?:(?:rclcpp|rclcpp_lifecycle|nav2_util|nav2)::)?(?:Lifecycle)?Node")
CALLED_NODE = regex(r"(?:^|:)\w*Node\w*$")
TEMPLATE = regex(r"<[^<>]*>")
GIVEN = regex(r"\b(?:this|shared_from_this\s*\(\s*\))\s*[,)}]")
TAKER = regex(r"[\w:]+(?:\s*<[\w:<>,\s*]*>)?(?:\s+\w+)?\s*$")
NAMESPACE = regex(r"\b(\w+)\s*::")
KNOWN = frozenset({
    "std", "rclcpp", "rclcpp_action", "rclcpp_lifecycle", "tf2", "tf2_ros", "image_transport", "message_filters",
    "diagnostic_updater", "realtime_tools", "placeholders", "boost",
})  # fmt: skip
"""Name spaces of what gets a node and declares nothing, but under names that are known."""


@dataclass(frozen=True)
class OwnReads:
    files: Sequence[CppFile]

    def is_of_others(self, file: CppFile, call: CppCall) -> bool:
        """Return whether a call asks a client of parameters, or an object that nothing here declares any for."""
        name = receiver(file, call)
        if NODE.search(name) and not CLIENT.search(name):
            return False
        return bool(name) and (CLIENT.search(name) is not None or name not in self.declaring)

    def may_inherit(self, file: CppFile, call: CppCall) -> bool:
        """Return whether the class around a call has its node of a base class elsewhere, which may declare more."""
        name = class_around(code_text(file.source.text), call.span.start) if not receiver(file, call) else ""
        return bool(name) and not self.is_closed(name, frozenset())

    def is_closed(self, name: str, seen: frozenset[str]) -> bool:
        """Return whether a class is known to be a node of rclcpp, by itself or by its base classes."""
        bases = self.classes.get(name, ())
        if any(NODES.fullmatch(each) for each in bases):
            return True
        return any(self.is_closed(each.rpartition(":")[2], seen | {name}) for each in bases if name not in seen)

    @cached_property
    def declaring(self) -> frozenset[str]:
        """The variables whose parameters code declares."""
        return frozenset(
            receiver(file, call) for file in self.files for call in file.calls if NAMED.fullmatch(call.name)
        )

    @cached_property
    def classes(self) -> dict[str, tuple[str, ...]]:
        """The classes of the package with their base classes."""
        return {name: bases for file in self.files for name, bases in classes_in(file)}

    @cached_property
    def has_foreign_base(self) -> bool:
        """Whether a class has a base class elsewhere that is called a node."""
        named = (name for name, bases in self.classes.items() if any(CALLED_NODE.search(each) for each in bases))
        return any(not self.is_closed(name, frozenset()) for name in named)

    @cached_property
    def is_handed_out(self) -> bool:
        """Whether code hands a node to a class or a function that is not here."""
        spaces = {each for file in self.files for each in re.findall(r"\bnamespace\s+(\w+)", file.source.text)}
        known = KNOWN | spaces | self.classes.keys()
        return any(not known.issuperset(each) for file in self.files for each in takers(file))


def receiver(file: CppFile, call: CppCall) -> str:
    """Return the last name before a call of a member; "" for `this`, and where there is none."""
    at = call.span.start
    found = RECEIVER.search(file.source.text, max(0, at - 200), at)
    return found[1] if found is not None and found[1] != "this" else ""


def classes_in(file: CppFile) -> Iterator[tuple[str, tuple[str, ...]]]:
    for found in CLASS.finditer(code_text(file.source.text)):
        listed = TEMPLATE.sub("", found[2] or "")
        yield found[1], tuple(base[1] for part in listed.split(",") if (base := BASE.match(part.strip())))


def takers(file: CppFile) -> Iterator[list[str]]:
    """Yield the name spaces of each function and class that is handed the node, with those between `<` and `>`."""
    code = code_text(file.source.text)
    for found in GIVEN.finditer(code):
        opener = opener_before(code, found.start())
        taker = TAKER.search(code, max(0, opener - 200), opener) if code[opener] != "[" else None
        if taker is not None:
            yield NAMESPACE.findall(taker[0])


def opener_before(code: str, at: int) -> int:
    """Return where the innermost bracket around a place is opened; 0 where none is near."""
    depth = 0
    for place in range(at - 1, max(0, at - 2_000), -1):
        depth += (code[place] in ")]}") - (code[place] in "([{")
        if depth < 0:
            return place
    return 0
