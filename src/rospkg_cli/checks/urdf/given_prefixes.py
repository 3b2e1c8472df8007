"""Whether a call of a macro gives one of its parameters a text that is not empty, as far as the texts of robots say."""

from __future__ import annotations

import re
from collections.abc import Iterator, Sequence

from ...languages.xml.parser import Element
from ...lazy_regex import regex
from ...package.urdf.expansion.macros import macro_name, parameters_of

WHOLE = regex(r"\$\{\s*(\w+)\s*\}")
ARGUMENT = regex(r"\$\(arg\s+([\w.-]+)\s*\)")
VALUE = r"""\s*=\s*(?:"([^"]*)"|'([^']*)')"""
STEPS = 4
"""Through how many properties and parameters a value is followed."""


def gives_text(macro: Element, parameter: str, near: Sequence[str], texts: Sequence[str]) -> bool | None:
    """Return whether a call gives a text, or the default that a call keeps has one; None where nothing calls it.

    A call in a text that may include the macro is one of this macro, and not of another one of its name.
    """
    default = next((each.default for each in parameters_of(macro.get("params") or "") if each.name == parameter), None)
    tags = [tag for text in near for tag in calls_of(macro_name(macro), text)]
    tags = tags or [tag for text in texts for tag in calls_of(macro_name(macro), text)]
    found = [value_in(tag, parameter) for tag in tags]
    if not tags:
        return None
    return any(is_text(default if each is None else each, texts) for each in found)


def calls_of(name: str, text: str) -> Iterator[str]:
    """Yield the tags that call a macro."""
    call = rf"<xacro:(?:[\w-]+\.)?{re.escape(name)}(?=[\s/>])(?:[^<>\"']|\"[^\"]*\"|'[^']*')*>"
    return (match.group() for match in re.finditer(call, text))


def value_in(tag: str, name: str) -> str | None:
    found = re.search(rf"\s{re.escape(name)}{VALUE}", tag)
    return None if found is None else found.group(1) or found.group(2) or ""


def is_text(value: str | None, texts: Sequence[str], steps: int = STEPS) -> bool:
    """Return whether a value is certainly not empty somewhere: that of a property or an argument is looked up."""
    value = (value or "").strip().strip("\"'")
    if not value or not steps:
        return False
    whole, argument = WHOLE.fullmatch(value), ARGUMENT.fullmatch(value)
    if argument is not None:
        return any(is_text(each, texts, steps - 1) for each in named("arg", argument[1], "default", texts))
    if whole is None:
        return True
    every = (
        each
        for text in texts
        for found in re.finditer(rf"<xacro:(?!macro\b)[^<>]*?\s{whole[1]}{VALUE}", text)
        for each in found.groups()
    )
    return any(is_text(each, texts, steps - 1) for each in (*named("property", whole[1], "value", texts), *every))


def named(tag: str, name: str, attribute: str, texts: Sequence[str]) -> Iterator[str]:
    """Yield an attribute of each property or argument of a name."""
    for text in texts:
        for found in re.finditer(rf"<xacro:{tag}\s[^<>]*>", text):
            if value_in(found.group(), "name") == name and (value := value_in(found.group(), attribute)):
                yield value
