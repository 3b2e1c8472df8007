"""Functions that a compiled file calls and that only a file in no target defines, outside of classes (CMK202)."""

from __future__ import annotations

import posixpath
import re
from collections.abc import Iterator, Mapping

from ...languages.cpp.file import CppFile
from ...lazy_regex import regex
from ...source import Span

CLASS = regex(r"\b(?:class|struct|union|enum)\b[^;{}()]*\{")
PARAMETERS = r"\((?:[^(){};]|\([^(){};]*\))*\)\s*(?:noexcept\b\s*)?(?:->[^;{}=]*)?"
DECLARED = regex(rf"(?<=[\s&*])([A-Za-z_]\w*)\s*{PARAMETERS};")
DEFINED = regex(rf"(?<=[\s&*])([A-Za-z_]\w*)\s*{PARAMETERS}\{{")
BEFORE = regex(r"[^;{}]*\Z")
OWN_EACH = regex(r"\b(?:static|inline|constexpr|consteval|template|friend|typedef|using|return|else|new|operator)\b|=")
"""Words before a name that say that each file has its own function, or that it is none."""
KEYWORDS = frozenset("if for while switch catch return sizeof decltype alignas noexcept defined main".split())
NAMESPACE = regex(r"\bnamespace\s+([\w:]+)")


def called_functions(
    source: CppFile, header: CppFile, texts: Mapping[str, str], files: Mapping[str, CppFile], code: str
) -> Iterator[tuple[Span, str, str]]:
    """Yield the place, the name and the caller of each function that nothing compiled defines."""
    declared = names(DECLARED, without_classes(texts[header.path]))
    spaces = {each for found in NAMESPACE.findall(texts[header.path]) for each in found.split("::")}
    known = {name for text in texts.values() for name in defined_anywhere(text)}
    for name, span in names(DEFINED, without_classes(code)).items():
        if name in declared and name not in known:
            user = next((path for path in texts if calls(name, path, header, texts, files, spaces)), "")
            if user and user != source.path:
                yield span, name, user


def names(pattern: re.Pattern[str], text: str) -> dict[str, Span]:
    """Return the functions of a text with a type before their names, and where each stands first."""
    found: dict[str, Span] = {}
    for each in pattern.finditer(text):
        before = BEFORE.search(text, max(0, each.start() - 300), each.start(1))
        words = before[0].strip() if before else ""
        if words and not words.endswith("::") and not OWN_EACH.search(words) and each[1] not in KEYWORDS:
            found.setdefault(each[1], Span(*each.span(1)))
    return found


def defined_anywhere(text: str) -> set[str]:
    return {each[1] for each in DEFINED.finditer(text)}


def calls(
    name: str, path: str, header: CppFile, texts: Mapping[str, str], files: Mapping[str, CppFile], spaces: set[str]
) -> bool:
    """Return whether a source includes the header itself and calls the function by its name or its namespace."""
    own = posixpath.basename(header.path)
    if path == header.path or not any(posixpath.basename(each.path) == own for each in files[path].includes):
        return False
    for found in re.finditer(rf"(?:(\w+)\s*::\s*)?(?<![\w.>])\b{re.escape(name)}\s*\(", texts[path]):
        before = texts[path][: found.start()].rstrip()
        if not before.endswith((".", "->", "::")) and (found[1] is None or found[1] in spaces):
            return True
    return False


def without_classes(text: str) -> str:
    """Return a text of the same length in which the bodies of classes are blank."""
    at = 0
    while (found := CLASS.search(text, at)) is not None:
        end = closing(text, found.end())
        text = text[: found.end()] + " " * (end - found.end()) + text[end:]
        at = end
    return text


def closing(text: str, at: int) -> int:
    """Return where the brace closes that stands before an offset, or the end of the text."""
    depth = 1
    for found in re.finditer(r"[{}]", text[at:]):
        depth += 1 if found[0] == "{" else -1
        if not depth:
            return at + found.start()
    return len(text)
