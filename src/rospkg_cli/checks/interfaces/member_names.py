"""Names in interface files: what rosidl refuses, and what the generated code can't use."""

from __future__ import annotations

import re
from collections.abc import Iterator

from ...lazy_regex import regex
from ...package.interfaces.interface_file import InterfaceFile, Member, MessageSection
from ...ros.interfaces import CONSTANT_NAME, CPP_KEYWORDS, FIELD_NAME, IDL_KEYWORDS, PYTHON_KEYWORDS

HUMP = regex(r"(?<=[a-z0-9])(?=[A-Z])|(?<=[A-Z])(?=[A-Z][a-z])")


def is_valid(member: Member) -> bool:
    """Return whether rosidl takes the name of a field or a constant."""
    return (CONSTANT_NAME if member.is_constant else FIELD_NAME).fullmatch(member.name) is not None


def repeated(section: MessageSection) -> Iterator[tuple[Member, Member]]:
    """Yield each field and constant whose name is used before in the same section, with the first of that name."""
    seen: dict[tuple[bool, str], Member] = {}
    for member in section.members:
        key = member.is_constant, member.name
        if key in seen:
            yield member, seen[key]
        else:
            seen[key] = member


def suggestion(member: Member) -> str | None:
    """Return the name in the case that rosidl accepts; None where there is none."""
    words = re.sub(r"[-_]+", "_", HUMP.sub("_", member.name)).strip("_")
    name = words.upper() if member.is_constant else words.lower()
    return name if (CONSTANT_NAME if member.is_constant else FIELD_NAME).fullmatch(name) else None


def language_of(member: Member) -> str | None:
    """Return the language in which a field's name is a keyword, so that its generated code does not work."""
    for words, language in ((PYTHON_KEYWORDS, "Python"), (CPP_KEYWORDS, "C++"), (IDL_KEYWORDS, "OMG IDL")):
        if member.name in words and not member.is_constant:
            return language
    return None


def is_accepted(interface: InterfaceFile) -> bool:
    """Return whether rosidl builds the file, whatever it is called and whatever types it names."""
    return not interface.problems and all(
        all(map(is_valid, section.members)) and not any(repeated(section)) for section in interface.sections
    )
