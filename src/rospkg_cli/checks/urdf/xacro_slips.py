"""Slips in xacro that xacro reports at another place, or never: an extra brace, a lost `$`, an argument in its own
default."""

from __future__ import annotations

import re
from collections.abc import Iterator

from ...languages.xml.parser import Element
from ...lazy_regex import regex
from ...light_dataclasses import replace
from ...package.urdf.expansion.macros import MacroParameter, parameters_of
from ...source import Span
from ..fault import Fault, softer
from .joint_check import JOINT_NUMBERS

SURPLUS = regex(r"\$\{[^{}]*\}\}")
"""An expression with a brace behind it that closes nothing."""
OWN = regex(r"\$\(\s*arg\s+([^\s)]+)\s*\)")
EXPRESSION = regex(r"\$\{[^{}]*\}")
IN_BRACES = regex(r"\{\$?([\s\d.*/+()-]*)([^\W\d]\w*)([\s\d.*/+()-]*)\}")
"""A name in braces, or one that is reckoned with: `{pi}`, `{-2*pi}`."""
MUST_BE_GIVEN = "unless it is given, xacro stops"
NOT_READ = frozenset({"xacro:macro"})
"""Whose attributes are no values."""


def xacro_slips(root: Element, path: str) -> Iterator[Fault]:
    if not is_expanded(root, path):
        yield from left_names(root)
        return
    for macro in root.walk():
        if macro.tag == "xacro:macro":
            yield from lost_signs(macro)
    for element in root.walk():
        yield from surplus_braces(element)
        if element.tag == "xacro:arg":
            yield from own_default(element)
    yield from unread_names(root)


def is_expanded(root: Element, path: str) -> bool:
    """Return whether xacro reads a file, by its name or by what it holds; what xacro wrote keeps its comments alone."""
    is_named = path.endswith(".xacro") or "xmlns:xacro" in root.attributes
    return is_named or any(each.tag.startswith("xacro:") for each in root.walk())


def left_names(root: Element) -> Iterator[Fault]:
    """Yield each `{pi}` of a file that nothing expands, and that xacro has left as it was."""
    for fault in unread_names(root):
        said = fault.message.partition(",")[0]
        yield replace(fault, level="info", message=f"{said}: nothing expands this file; write the number")


def surplus_braces(element: Element) -> Iterator[Fault]:
    """Yield each expression of an attribute in which one brace more is closed than opened."""
    for attribute in element.attributes.values():
        text = attribute.value
        found = SURPLUS.search(text) if text.count("}") == text.count("{") + 1 else None
        if found is not None:
            name = element.get("name") or element.tag
            start = f"a `}}` too many in `{found[0]}` of `{name}`"
            message = f"{start}: write `{found[0][:-1]}`, or the value is text with a brace"
            yield Fault(attribute.value_span, message, "warning")


def lost_signs(macro: Element) -> Iterator[Fault]:
    """Yield each attribute that has a parameter of the macro in braces without a `$` before them."""
    names = {each.name.lstrip("*") for each in parameters_of(macro.get("params") or "")}
    for element in macro.walk():
        for attribute in element.attributes.values() if element is not macro else ():
            text = EXPRESSION.sub(lambda found: " " * len(found[0]), attribute.value)
            found = next((each for each in IN_BRACES.finditer(text) if each[2] in names), None)
            if found is not None:
                shown = attribute.value[: found.start()].split(" ")[-1] + found[0]
                yield Fault(attribute.value_span, without_sign(shown, found, is_argument=False), "warning")


def unread_names(root: Element) -> Iterator[Fault]:
    """Yield each value that has a property, an argument or pi in braces without a `$` before them.

    Parameters of macros are left to `lost_signs`. A value with other braces may be text in another language.
    """
    arguments = {each.get("name") or "" for each in root.walk() if each.tag == "xacro:arg"}
    properties = {each.get("name") or "" for each in root.walk() if each.tag == "xacro:property"}
    parameters = {each.name.lstrip("*") for macro in root.walk() for each in macro_parameters(macro)}
    names = ({"pi"} | arguments | properties) - parameters
    for element in root.walk():
        if not NOT_READ & {element.tag, *element.attributes}:
            values = [(each.value, each.value_span, is_number_of(element, name))
                      for name, each in element.attributes.items()]  # fmt: skip
            for value, span, is_read in (*values, (element.text, element.inner, True)):
                for fault in unread_name(value, span, names, arguments - properties):
                    yield fault if is_read else softer(fault, "info", "but nothing reads it there")


def is_number_of(element: Element, name: str) -> bool:
    """Return whether urdfdom may read an attribute: of parts of a joint it is known which it does."""
    if element.tag == "mimic" and name == "joint":
        return True
    return element.tag not in JOINT_NUMBERS or any(name in names for names in JOINT_NUMBERS[element.tag])


def macro_parameters(element: Element) -> Iterator[MacroParameter]:
    if element.tag == "xacro:macro":
        yield from parameters_of(element.get("params") or "")


def unread_name(value: str, span: Span, names: set[str], arguments: set[str]) -> Iterator[Fault]:
    text = EXPRESSION.sub(lambda found: " " * len(found[0]), value) if "{" in value else ""
    found = IN_BRACES.search(text)
    if found is None or found[2] not in names or any(mark in IN_BRACES.sub("", text) for mark in "{}\n"):
        return
    yield Fault(span, without_sign(found[0], found, is_argument=found[2] in arguments), "warning")


def without_sign(shown: str, found: re.Match[str], *, is_argument: bool) -> str:
    """Return the sentence about an expression in braces; an argument that is reckoned with is text in one."""
    before, name, after = found.groups()
    value = f"$(arg {name})" if is_argument else name
    right = value if is_argument and not before + after else f"${{{before}{value}{after}}}"
    return f"`{shown}` is read as it stands, for no `$` is right before the brace: write `{right}`"


def own_default(argument: Element) -> Iterator[Fault]:
    name, default = argument.get("name"), argument.attributes.get("default")
    if name and default is not None and name in OWN.findall(default.value):
        message = f"the default of `{name}` is `{name}` itself: {MUST_BE_GIVEN}; write a value"
        yield Fault(default.value_span, message, "warning")
