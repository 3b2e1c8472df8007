"""What xacro certainly evaluates: it expands a macro where it is called, and reads a property where `${…}` names it.

(xacro/__init__.py, branch ros2: Macro, Table.__getitem__, eval_all)
"""

from __future__ import annotations

import re
from collections import Counter
from functools import cached_property

from ...languages.xml.parser import Element
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.launch.text import uncommented
from ...package.package_facts import PackageFacts
from ...package.workspace import Workspace
from ..fault import Fault, softer
from .enclosing_elements import CONDITIONS, ancestors
from .xacro_includes import XacroIncludes

CALL = regex(r"<xacro:([^\s<>/\"']+)")
MACRO = regex(r"<xacro:macro\s[^>]*?\bname\s*=\s*[\"'](?:xacro:)?([^\"']+)")
EXPRESSION = regex(r"\$\{([^}]*)")
WORD = regex(r"[A-Za-z_]\w*")
INSERTED = regex(r"<xacro:insert_block\s+name=\"([^\"]*)\"")


@dataclass(frozen=True)
class XacroCalls:
    """The macros that a package's robots call, and the properties that they read; other packages may do both."""

    package: PackageFacts
    workspace: Workspace
    includes: XacroIncludes

    def weighed(self, root: Element, fault: Fault) -> Fault:
        """Return a fault at the level of its place: xacro may skip conditions, unused macros and unused properties."""
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

    def is_defined(self, name: str) -> bool:
        """Return whether any file defines a macro, a property, a parameter or an argument of a name."""
        word = re.escape(name)
        written = re.compile(rf"\bname\s*=\s*[\"']{word}[\"']|\bparams\s*=\s*(?:\"[^\"]*|'[^']*)\b{word}\b")
        return any(written.search(text) for text in self.includes.texts)

    def is_set_elsewhere(self, argument: str, text: str) -> bool:
        """Return whether another file than that of a text has an argument of a name: the first one is kept."""
        written = re.compile(rf"<xacro:arg\s[^>]*?\bname\s*=\s*[\"']{re.escape(argument)}[\"']")
        return any(written.search(each) for each in self.includes.texts if each is not text and each != text)

    def is_unprefixed(self, tag: str, name: str) -> bool:
        """Return whether any file defines something by an element without `xacro:`."""
        written = re.compile(rf"<{tag}\s[^>]*?\bname\s*=\s*[\"']{re.escape(name)}[\"']")
        return any(written.search(text) for text in self.includes.texts)

    @cached_property
    def macros(self) -> frozenset[str]:
        """The names of the macros that any file defines."""
        return frozenset(match.group(1) for text in self.includes.texts for match in MACRO.finditer(text))

    def is_called(self, macro: str) -> bool:
        """Return whether a file calls a macro, of the package or of another one that names the package."""
        name, own = macro.removeprefix("xacro:"), self.package.name
        others = (facts for facts in self.workspace.packages if facts.name != own)
        return name in self.called or any({name, own} <= words for facts in others for words in facts.robot_words)

    @cached_property
    def called(self) -> frozenset[str]:
        """The names behind `xacro:` in the tags of all files, without the namespace of an include."""
        texts = (uncommented(".xml", text) for text in self.includes.texts)
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
        for text in self.includes.texts:
            found += read_in(text)
            found.update(match.group(1) for match in INSERTED.finditer(text))
        return found


def read_in(text: str) -> Counter[str]:
    return Counter(word for match in EXPRESSION.finditer(text) for word in WORD.findall(match.group(1)))
