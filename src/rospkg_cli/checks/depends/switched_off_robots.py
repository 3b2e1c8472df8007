"""Parts of a robot that xacro leaves out for the defaults of its arguments, and macros that nothing calls (DEP106)."""

from __future__ import annotations

import ast
from collections.abc import Mapping
from functools import cached_property

from ...languages.xml.parser import Element
from ...lazy_regex import regex
from ...package.launch.plain_values import NotKnownError, plain_value
from ...source import Span
from ..urdf.enclosing_elements import CONDITIONS, ancestors

ARGUMENT = regex(r"\$\(arg\s+(\w+)\s*\)")
EXPRESSION = regex(r"\s*\$\{([^{}]*)\}\s*")
PARAMETER = regex(r"[A-Za-z_]\w*")
WORDS: Mapping[str, bool] = {"true": True, "1": True, "false": False, "0": False}
STEPS = 12


class RobotDefaults:
    """What the arguments and properties of one file are that it gives a value to once."""

    def __init__(self, root: Element) -> None:
        self.root = root
        self.steps = 0

    def leaves_out(self, place: Span) -> bool:
        """Return whether a place lies in a condition that the defaults of the same file switch off."""
        around = list(ancestors(self.root, place))
        given = (each.get("params") or "" for each in around if each.tag == "xacro:macro")
        hidden = frozenset(word for each in given for word in PARAMETER.findall(each))
        return any(self.is_off(each, hidden) for each in around if each.tag in CONDITIONS)

    def macros_around(self, place: Span) -> list[str]:
        """Return the names of the macros in which a place lies."""
        return [each.get("name") or "" for each in ancestors(self.root, place) if each.tag == "xacro:macro"]

    def is_off(self, condition: Element, hidden: frozenset[str] = frozenset()) -> bool:
        self.steps = 0
        try:
            holds = truth(self.value_of(condition.get("value") or "", hidden))
        except (NotKnownError, SyntaxError, ValueError, TypeError, RecursionError):
            return False
        return holds is not (condition.tag == "xacro:if")

    def value_of(self, text: str, hidden: frozenset[str]) -> object:
        """Return the value of a text of xacro, but for the names that a macro hides; raises NotKnownError."""
        self.steps += 1
        if self.steps > STEPS:
            raise NotKnownError
        filled = ARGUMENT.sub(lambda found: self.argument(found[1], found[0]), text)
        expression = EXPRESSION.fullmatch(filled)
        if "$(" in filled or ("${" in filled and not expression):
            raise NotKnownError
        if expression is None:
            return WORDS.get(filled.strip().lower(), filled.strip())
        return plain_value(ast.parse(expression[1].strip(), mode="eval").body, lambda node: self.known(node, hidden))

    def known(self, node: ast.expr, hidden: frozenset[str]) -> object:
        match node:
            case ast.Name(id=name) if name not in hidden and self.properties.get(name) is not None:
                return self.value_of(self.properties[name] or "", hidden)
            case ast.Call(func=ast.Attribute(value=ast.Name(id="xacro"), attr="arg"), args=[ast.Constant(value=name)]):
                return self.value_of(self.argument(str(name), "$("), hidden)
        raise NotKnownError

    def argument(self, name: str, otherwise: str) -> str:
        """Return the default of an argument; something else where the file has none, or several."""
        found = self.arguments.get(name)
        return otherwise if found is None else found

    @cached_property
    def arguments(self) -> dict[str, str | None]:
        return self.given_once("xacro:arg", "default")

    @cached_property
    def properties(self) -> dict[str, str | None]:
        return self.given_once("xacro:property", "value")

    def given_once(self, tag: str, key: str) -> dict[str, str | None]:
        """Return by name what elements of a tag give; None for what several give, or one without a value."""
        found: dict[str, str | None] = {}
        for each in self.root.walk():
            if each.tag == tag:
                name = each.get("name") or ""
                found[name] = None if name in found else each.get(key)
        return found


def truth(value: object) -> bool:
    if isinstance(value, str):
        raise NotKnownError
    return bool(value)
