"""What xacro certainly evaluates: it expands a macro where it is called, and reads a property where `${…}` names it.

(xacro/__init__.py, branch ros2: Macro, Table.__getitem__, eval_all)
"""

from __future__ import annotations

import re
from collections import Counter
from collections.abc import Iterator
from fnmatch import fnmatchcase
from functools import cached_property

from ...files import PackageFiles
from ...languages.xml.parser import Document, Element
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.launch.text import uncommented
from ...package.package_facts import PackageFacts
from ...package.urdf.robot_file import RobotFile
from ...package.workspace import Workspace
from ...source import Span
from ..fault import Fault, softer

CALL = regex(r"<xacro:([^\s<>/\"']+)")
MACRO = regex(r"<xacro:macro\s[^>]*?\bname\s*=\s*[\"'](?:xacro:)?([^\"']+)")
EXPRESSION = regex(r"\$\{([^}]*)")
WORD = regex(r"[A-Za-z_]\w*")
INSERTED = regex(r"<xacro:insert_block\s+name=\"([^\"]*)\"")
INCLUDED = regex(r"<xacro:include\s[^>]*?filename\s*=\s*[\"']([^\"']*)")
COMPUTED = regex(r"\$\{[^}]*\}|\$\([^()]*\)")
STARTS = (".py", ".launch", ".launch.xml", ".yaml")
"""Files that start robots under their names."""

CONDITIONS = ("xacro:if", "xacro:unless")


@dataclass(frozen=True)
class XacroCalls:
    """The macros that a package's robots call, and the properties that they read; other packages may do both."""

    files: PackageFiles
    package: PackageFacts
    workspace: Workspace

    def weighed(self, root: Element, fault: Fault) -> Fault:
        """Return a fault at the level of its place: xacro may pass over conditions, unused macros and properties."""
        for around in ancestors(root, fault.span):
            name = around.get("name") or ""
            if around.tag in CONDITIONS:
                return softer(fault, "warning", "where the condition around it holds")
            if around.tag == "xacro:macro" and not self.is_called(name):
                return self.in_macro(name, fault)
            if around.tag == "xacro:property" and around.get("lazy_eval") != "false" and not self.is_read(around):
                return softer(fault, "info", f"as soon as something reads `{name}`")
        return fault

    def in_macro(self, name: str, fault: Fault) -> Fault:
        """Return a fault in a macro as an info where nothing calls that."""
        if self.is_called(name):
            return fault
        return softer(fault, "info", f"as soon as something calls the macro `{name}`")

    def is_robot(self, robot: RobotFile) -> bool:
        """Return whether a file is a robot of its own: it has a name, and no other file mentions it."""
        return self.is_top(robot.document)

    def is_top(self, document: Document) -> bool:
        """Return whether the root of a file has a name, and no other file mentions it, nor another package's robot."""
        name = document.source.path.rpartition("/")[2]
        named = document.root.get("name") is not None
        texts = [text for text in self.texts if text is not document.source.text and "xacro:include" in text]
        if not named or any(name in text for text in texts):
            return False
        is_included = (document.source.path in self.included_elsewhere) or any(
            may_include(text, name) for text in texts
        )
        return self.is_launched(name) or not is_included

    def is_part(self, document: Document) -> bool:
        """Return whether a robot includes a file that code and launch files do not name: it need not be whole."""
        path, name = document.source.path, document.source.path.rpartition("/")[2]
        own = any(may_include(text, name) for text in self.texts if text is not document.source.text)
        return (own or path in self.included_elsewhere) and not self.is_launched(name)

    @cached_property
    def included_elsewhere(self) -> frozenset[str]:
        """The files of the package that robots of other packages include."""
        others = (facts for facts in self.workspace.packages if facts.name != self.package.name)
        named = (each for facts in others for each in facts.robot_includes)
        return frozenset(path for package, path, _ in named if package == self.package.name)

    def is_launched(self, name: str) -> bool:
        """Return whether code or a launch file names a robot."""
        paths = (path for path in self.files.paths if path.endswith(STARTS))
        return any(name in self.files.readable_text(path) for path in paths)

    def is_defined(self, name: str) -> bool:
        """Return whether any file defines a macro, a property, a parameter or an argument of a name."""
        word = re.escape(name)
        written = re.compile(rf"\bname\s*=\s*[\"']{word}[\"']|\bparams\s*=\s*(?:\"[^\"]*|'[^']*)\b{word}\b")
        return any(written.search(text) for text in self.texts)

    def is_set_elsewhere(self, argument: str, text: str) -> bool:
        """Return whether another file than that of a text has an argument of a name: the first one is kept."""
        written = re.compile(rf"<xacro:arg\s[^>]*?\bname\s*=\s*[\"']{re.escape(argument)}[\"']")
        return any(written.search(each) for each in self.texts if each is not text and each != text)

    def is_unprefixed(self, tag: str, name: str) -> bool:
        """Return whether any file defines something by an element without `xacro:`."""
        written = re.compile(rf"<{tag}\s[^>]*?\bname\s*=\s*[\"']{re.escape(name)}[\"']")
        return any(written.search(text) for text in self.texts)

    @cached_property
    def macros(self) -> frozenset[str]:
        """The names of the macros that any file defines."""
        return frozenset(match.group(1) for text in self.texts for match in MACRO.finditer(text))

    def is_called(self, macro: str) -> bool:
        """Return whether a file calls a macro, of the package or of another one that names the package."""
        name, own = macro.removeprefix("xacro:"), self.package.name
        others = (facts for facts in self.workspace.packages if facts.name != own)
        return name in self.called or any({name, own} <= words for facts in others for words in facts.robot_words)

    @cached_property
    def called(self) -> frozenset[str]:
        """The names behind `xacro:` in the tags of all files, without the namespace of an include."""
        texts = (uncommented(".xml", text) for text in self.texts)
        found = {match.group(1) for text in texts for match in CALL.finditer(text)}
        return frozenset(found | {name.rpartition(".")[2] for name in found})

    def is_read(self, element: Element) -> bool:
        """Return whether anything but its own value names a property."""
        name = element.get("name") or ""
        values = (attribute.value for each in element.walk() for attribute in each.attributes.values())
        own = sum(read_in(value)[name] for value in values) + sum(read_in(each.text)[name] for each in element.walk())
        return self.read[name] > own

    @cached_property
    def read(self) -> Counter[str]:
        """How often `${…}` and `<xacro:insert_block>` name a property, for each name."""
        found: Counter[str] = Counter()
        for text in self.texts:
            found += read_in(text)
            found.update(match.group(1) for match in INSERTED.finditer(text))
        return found

    def including(self, name: str) -> tuple[str, ...]:
        """Return the texts that may include a file of a name."""
        return tuple(text for text in self.texts if may_include(text, name))

    @cached_property
    def texts(self) -> tuple[str, ...]:
        paths = (path for path in self.files.paths if path.endswith((".xacro", ".urdf", ".xml")))
        return tuple(map(self.files.readable_text, paths))


def may_include(text: str, name: str) -> bool:
    """Return whether a file includes another one of this name, or by a computed path that may be it."""
    for match in INCLUDED.finditer(text):
        last = COMPUTED.sub("*", match.group(1)).rpartition("/")[2]
        if last == name or ("*" in last and fnmatchcase(name, last)):
            return True
    return False


def read_in(text: str) -> Counter[str]:
    return Counter(word for match in EXPRESSION.finditer(text) for word in WORD.findall(match.group(1)))


def ancestors(root: Element, place: Span) -> Iterator[Element]:
    """Yield the elements in which a place lies, from the outermost on; a condition's own attributes are outside."""
    waiting = [root]
    while waiting:
        for child in waiting.pop().children:
            if child.span.contains(place):
                if child.tag not in CONDITIONS or place.start >= child.inner.start:
                    yield child
                waiting = [child]
                break
