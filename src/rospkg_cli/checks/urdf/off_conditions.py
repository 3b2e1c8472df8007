"""Conditions of xacro that never hold: literally, by a property, or by a default that nothing replaces."""

from __future__ import annotations

import re
from functools import cached_property

from ...files import PackageFiles
from ...languages.xml.parser import Element
from ...lazy_regex import regex
from ...light_dataclasses import dataclass
from ...package.file_role import role_of
from ...package.launch.text import uncommented
from ...package.package_facts import PackageFacts
from ...package.workspace import Workspace

ROBOTS = (".xacro", ".urdf")
GIVING = (".py", ".xml", ".launch", ".yaml", ".yml", ".json", ".sh", ".bash", ".md", ".rst", ".txt", ".cpp", ".hpp")
HOLDS = {"xacro:if": frozenset(("false", "False", "0")), "xacro:unless": frozenset(("true", "True", "1"))}
"""The values with which xacro skips what is in a condition."""
READ = regex(r"\$\(arg\s+(?P<argument>\w+)\s*\)|\$\{\s*(?P<property>\w+)\s*\}")
ELEMENT = regex(r"<xacro:(arg|property|macro)\b([^>]*)>")
ATTRIBUTE = regex(r"\b(name|default|value|params)\s*=\s*(?:\"([^\"]*)\"|'([^']*)')")
GIVEN = (
    r"[\"']{0}[\"']\s*[,:]\s*(?:default_value\s*=\s*)?[\"'](\w+)[\"']|\b{0}:=[\"']?(\w+)"
    r"|\bname=\"{0}\"\s+(?:default|value)=\"(\w+)\""
)
"""How Python, a command and XML give an argument a literal value, or declare one of its name with it."""
STEPS = 3
"""The most names that refer to each other: a property whose value is an argument, for example."""


@dataclass(frozen=True)
class OffConditions:
    files: PackageFiles
    package: PackageFacts
    workspace: Workspace

    def has(self, condition: Element) -> bool:
        """Return whether xacro never enters a condition."""
        return self.value_of(condition.get("value") or "") in HOLDS.get(condition.tag, ())

    def argument_of(self, condition: Element) -> str:
        """Return the argument that is the whole value of a condition; "" for others."""
        found = READ.fullmatch((condition.get("value") or "").strip())
        return (found["argument"] or "") if found is not None else ""

    def is_given_so(self, condition: Element) -> bool:
        """Return whether all literal values that this package gives its argument turn the condition off."""
        argument = self.argument_of(condition)
        others = (facts for facts in self.workspace.packages if facts.name != self.package.name)
        if not argument or any(argument in words for facts in others for words in facts.robot_words):
            return False
        ways = re.compile(GIVEN.format(re.escape(argument)))
        given = {next(filter(None, each.groups()), "") for text in self.givers for each in ways.finditer(text)}
        return bool(given) and given <= HOLDS.get(condition.tag, frozenset())

    def value_of(self, text: str) -> str:
        """Return the value that a text has in every run, following names that have a single value; "" for any value."""
        for _ in range(STEPS):
            found = READ.fullmatch(text.strip())
            if found is None:
                return text.strip()
            name = found["argument"] or found["property"]
            values = self.arguments.get(name, set()) if found["argument"] else self.properties.get(name, set())
            if len(values) != 1 or name in self.parameters or (found["argument"] and self.is_given(name)):
                return ""
            (text,) = values
        return ""

    def is_given(self, argument: str) -> bool:
        """Return whether anything other than robots names an argument, and so may give it a value."""
        word = re.compile(rf"(?<![\w.-]){re.escape(argument)}(?![\w.-])")
        others = (facts for facts in self.workspace.packages if facts.name != self.package.name)
        is_elsewhere = any(argument in words for facts in others for words in facts.robot_words)
        return is_elsewhere or any(map(word.search, self.givers))

    @cached_property
    def givers(self) -> tuple[str, ...]:
        paths = (path for path in self.files.paths if path.endswith(GIVING) and role_of(path) != "test")
        return tuple(uncommented(path, self.files.readable_text(path)) for path in paths if path != "package.xml")

    @cached_property
    def arguments(self) -> dict[str, set[str]]:
        return self.defined("arg", "default")

    @cached_property
    def properties(self) -> dict[str, set[str]]:
        return self.defined("property", "value")

    def defined(self, kind: str, key: str) -> dict[str, set[str]]:
        """Return by the name of each argument or property the values that the robots of the package give it."""
        found: dict[str, set[str]] = {}
        for tag, attributes in self.elements:
            if tag == kind:
                found.setdefault(attributes.get("name", ""), set()).add(attributes.get(key, ""))
        return found

    @cached_property
    def parameters(self) -> frozenset[str]:
        """The words in the parameters of all macros, which hide properties of their names."""
        return frozenset(
            word for _, each in self.elements for word in re.findall(r"[A-Za-z_]\w*", each.get("params", ""))
        )

    @cached_property
    def elements(self) -> tuple[tuple[str, dict[str, str]], ...]:
        paths = (path for path in self.files.paths if path.endswith(ROBOTS))
        texts = (uncommented(".xml", self.files.readable_text(path)) for path in paths)
        return tuple(
            (found[1], {each[1]: each[2] or each[3] or "" for each in ATTRIBUTE.finditer(found[2])})
            for text in texts
            for found in ELEMENT.finditer(text)
        )
