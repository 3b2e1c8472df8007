"""Variables that code sets and that nothing reads: what they are set to does not matter."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterable

from ...languages.cpp.call import CppCall
from ...languages.cpp.file import CppFile
from ...languages.cpp.lexer import TOKEN
from ...languages.python.file import PythonFile
from ...languages.python.nodes import nodes_of_kind
from ...lazy_regex import regex
from ...source import Span

VARIABLE = regex(r"(?:this\s*->\s*)?([A-Za-z_]\w*)")
SETS = r"\bget_parameter\s*\([^(),;]*,\s*(?:this\s*->\s*)?{0}\s*\)"
ASSIGNS = r"(?:\bthis\s*->\s*)?\b{0}\s*=\s*(?:[A-Za-z_]\w*\s*(?:->|\.)\s*)*(?:get|declare)_parameter\b"
DECLARES = r"(?:(?<=\w)|(?<=[\w>]>))(?<!\breturn)\s+{0}\s*(?=[;={{])(?!==)"
"""A type and the name, with a value or without one."""
BY_NAME = regex(r"\b(?:getattr|vars|__dict__|__slots__|dataclass)\b")
"""How Python reads members whose names the code may not hold."""
INTO = 1


def is_dropped_in_cpp(call: CppCall, files: Iterable[CppFile]) -> bool:
    """Return whether a parameter is got into a variable whose name stands nowhere else but where it is declared.

    One that no file declares is of a base class from elsewhere, which may read it.
    """
    arguments = call.arguments or ()
    found = VARIABLE.fullmatch(arguments[INTO].text) if len(arguments) == INTO + 1 else None
    return found is not None and is_never_read(found[1], files, SETS)


def is_never_read(variable: str, files: Iterable[CppFile], setting: str = ASSIGNS) -> bool:
    """Return whether a variable is declared, and its name stands nowhere else but where a parameter is got into it."""
    word = re.compile(rf"\b{variable}\b")
    texts = [code_of(file) for file in files if word.search(file.source.text)]
    sets, declares = (re.compile(each.format(variable)) for each in (setting, DECLARES))
    is_own = any(declares.search(text) for text in texts)
    return is_own and not any(word.search(declares.sub(" ", sets.sub(" ", text))) for text in texts)


def code_of(file: CppFile) -> str:
    """Return the text of a file without comments and literals, but with the lines of the preprocessor."""
    return TOKEN.sub(lambda match: match[0] if match[0].startswith("#") else " ", file.source.text)


def is_dropped_in_python(file: PythonFile, place: Span, files: Iterable[PythonFile]) -> bool:
    """Return whether a parameter is got for a member of `self` alone, and nothing reads a member of that name."""
    for each in nodes_of_kind(file.tree, ast.Assign):
        match each.targets:
            case [ast.Attribute(value=ast.Name(id="self"), attr=name)] if file.span(each.value).holds(place):
                return not any(reads_member(other, name) for other in files)
    return False


def reads_member(file: PythonFile, name: str) -> bool:
    """Return whether a file may read a member: it does so, or reads members whose names it computes."""
    if BY_NAME.search(file.source.text):
        return True
    members = nodes_of_kind(file.tree, ast.Attribute)
    return any(each.attr == name and not isinstance(each.ctx, ast.Store) for each in members)
