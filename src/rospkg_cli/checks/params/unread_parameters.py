"""Parameters that code declares, and whose values nothing uses: that one is dropped changes nothing."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterable, Sequence

from ...languages.cpp.call import CppCall
from ...languages.cpp.file import CppFile
from ...languages.cpp.lexer import TOKEN
from ...languages.python.file import PythonFile
from ...languages.python.nodes import nodes_of_kind
from ...lazy_regex import regex
from ...package.package_facts import PackageFacts
from .unread_variables import is_dropped_in_cpp, is_dropped_in_python, is_never_read

SEVERAL = regex(r"\b(?:get_parameters(?:_by_prefix)?|list_parameters|get_parameter_overrides|ParameterEventHandler)\b")
"""How code gets parameters whose names it need not write."""
DECLARES, GETS = "declare_parameter", "get_parameter"
BEFORE = regex(r"(?:(?P<variable>[A-Za-z_]\w*)\s*=\s*)?(?:[A-Za-z_]\w*\s*(?:->|\.)\s*)*$")
"""What a call stands behind: a variable that gets its value, and the node."""


def is_unread_by(name: str, package: PackageFacts, cpp: Sequence[CppFile], python: Sequence[PythonFile]) -> bool:
    """Return whether the code of a package declares a parameter, and uses its value nowhere."""
    paths = [each.path for each in package.parameters if each.name == name and not each.tail]
    in_cpp = [file for file in cpp if name in file.source.text]
    in_python = [file for file in python if name in file.source.text]
    files = {*(file.path for file in in_cpp), *(file.source.path for file in in_python)}
    if not paths or not files.issuperset(paths):
        return False
    is_unread = not in_cpp or is_unread_in_cpp(name, cpp)
    return is_unread and (not in_python or is_unread_in_python(name, python))


def is_unread_in_cpp(name: str, files: Sequence[CppFile]) -> bool:
    """Return whether C++ names a parameter, and nowhere to use its value."""
    written = re.compile(rf'"{re.escape(name)}"')
    calls = [(file, call) for file in files for call in file.calls if is_of(call, name)]
    count = sum(len(written.findall(without_comments(file))) for file in files)
    if not calls or count != len(calls) or any(SEVERAL.search(file.source.text) for file in files):
        return False
    is_got = any(call.name == GETS or variable_of(file, call) for file, call in calls)
    return is_got and all(is_dropped_in_cpp(call, files) or is_idle(file, call, files) for file, call in calls)


def is_of(call: CppCall, name: str) -> bool:
    return call.name in (DECLARES, GETS) and bool(call.arguments) and (call.arguments or ())[0].literal == name


def is_idle(file: CppFile, call: CppCall, files: Iterable[CppFile]) -> bool:
    """Return whether a call is a statement that declares, or sets a variable that nothing reads."""
    variable = variable_of(file, call)
    if variable:
        return is_never_read(variable, files)
    text = file.source.text
    return variable is not None and call.name == DECLARES and text[call.span.end :].lstrip()[:1] == ";"


def variable_of(file: CppFile, call: CppCall) -> str | None:
    """Return the variable that gets what a call returns; "" where none does, None where something else may."""
    text = TOKEN.sub(lambda match: " " * len(match[0]), file.source.text)
    start = max(text.rfind(sign, 0, call.span.start) for sign in ";{}") + 1
    found = BEFORE.search(text, start, call.span.start)
    if found is None or found["variable"]:
        return found["variable"] if found is not None else None
    return None if text[start : found.start()].strip() else ""


def without_comments(file: CppFile) -> str:
    return re.sub(r"//[^\n]*|/\*.*?\*/", "", file.source.text, flags=re.DOTALL)


def is_unread_in_python(name: str, files: Sequence[PythonFile]) -> bool:
    """Return whether Python names a parameter, and nowhere to use its value."""
    if any(SEVERAL.search(file.source.text) for file in files):
        return False
    found = [(file, each) for file in files for each in nodes_of_kind(file.tree, ast.Constant) if each.value == name]
    is_declared = [is_declaration(file, each) for file, each in found]
    return not all(is_declared) and all(
        declared or is_dropped_in_python(file, file.span(each), files)
        for declared, (file, each) in zip(is_declared, found, strict=True)
    )


def is_declaration(file: PythonFile, name: ast.Constant) -> bool:
    """Return whether a name stands in a statement that declares a parameter."""
    for each in nodes_of_kind(file.tree, ast.Expr):
        match each.value:
            case ast.Call(func=ast.Attribute(attr="declare_parameter"), args=[first, *_]) if first is name:
                return True
    return False
