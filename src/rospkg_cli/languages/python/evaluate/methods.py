"""Methods and attributes of texts, paths, lists, dicts and opened files."""

from __future__ import annotations

import posixpath

from ....light_dataclasses import replace
from .conversion import from_python, join_texts
from .dict_methods import DICT_METHODS
from .formatting import as_text, brace_format
from .iterables import is_many, items_of, plain_function, read_rest
from .limits import MAX_TEXT, STEP, spend
from .list_methods import LIST_METHODS, mark_unknown
from .operators import path_join
from .path_functions import PATH_FUNCTIONS, pathlib_glob, record_glob
from .sandbox_filesystem import OutsideError
from .state import EvaluationState
from .values import Argument, Call, Constant, OpenedFile, Sequence, Text, Value
from .values import Mapping as MappingValue

NONE_OF_THEM = frozenset({"zfill", "ljust", "rjust", "center", "expandtabs", "translate", "encode"})
"""Methods of str whose result may be very large, or is not a text."""

PURE = (
    frozenset(name for name in dir(str) if not name.startswith("_")) - NONE_OF_THEM - {"join", "format", "format_map"}
)


SEARCHES = frozenset({"rfind", "rindex", "rsplit", "rpartition", "strip", "lstrip", "rstrip"})
MAX_SEARCH = 10_000_000
"""Methods of str that take the time of the product of both lengths, and the bound of that."""


def call_method(state: EvaluationState, value: Value, call: Call) -> Value | None:
    """Return what a method of a value returns; None where it isn't known."""
    name = call.callee
    if call.rest is not None and not isinstance(value, Sequence | MappingValue):
        return None
    match value:
        case Text() if value.is_path:
            return path_method(state, value, call)
        case Text():
            return text_method(state, value, call)
        case Sequence():
            found = LIST_METHODS.get(name)
            return found(state, value, call) if found else mark_unknown(state, value, call)
        case MappingValue():
            found_too = DICT_METHODS.get(name)
            return found_too(state, value, call) if found_too else mark_unknown(state, value, call)
        case OpenedFile():
            return file_method(state, value, call)
    return None


def text_method(state: EvaluationState, value: Text, call: Call) -> Value | None:
    if call.callee == "join" and call.positional:
        items = items_of(state, call.positional[0])
        if items is None or any(map(is_many, items)):
            return None
        between: list[Value] = []
        for item in items:
            between += [Text(call.span, value.text), item]
        return join_texts(between[1:], call.span)
    if call.callee == "format":
        return brace_format(value.text, list(call.positional), lambda name: call.get(name), call.span)
    if call.callee not in PURE:
        return None
    if call.callee == "replace" and not is_small_replacement(value.text, call):
        return None
    if call.callee in SEARCHES and any(
        isinstance(given, Text) and len(given.text) * len(value.text) > MAX_SEARCH for given in call.positional
    ):
        return None
    state.tick(1 + len(value.text) // 100)
    return plain_function(getattr(value.text, call.callee))(state, call)


def is_small_replacement(text: str, call: Call) -> bool:
    """Return whether the result of a replacement stays small."""
    new = call.positional[1] if len(call.positional) > 1 else None
    return isinstance(new, Text) and (len(text) + 1) * max(len(new.text), 1) <= MAX_TEXT


def file_method(state: EvaluationState, value: OpenedFile, call: Call) -> Value | None:
    if call.callee == "close":
        return Constant(call.span, None)
    start = value.at
    rest = read_rest(state, value) if call.callee in ("read", "readline", "readlines") else None
    if rest is None or call.arguments:
        return None
    lines = rest.splitlines(keepends=True)
    if call.callee == "read":
        return Text(call.span, rest)
    if call.callee == "readline":
        value.at = start + len(lines[0] if lines else "")
        return Text(call.span, lines[0] if lines else "")
    return state.computed_list(call.span, [Text(call.span, line) for line in lines])


BY_FUNCTION = {
    "exists": "os.path.exists",
    "is_file": "os.path.isfile",
    "is_dir": "os.path.isdir",
    "resolve": "os.path.abspath",
    "absolute": "os.path.abspath",
    "open": "open",
}


def path_method(state: EvaluationState, value: Text, call: Call) -> Value | None:
    if call.callee in BY_FUNCTION:
        arguments = (Argument("", value, value.span), *call.arguments)
        found = PATH_FUNCTIONS[BY_FUNCTION[call.callee]](state, replace(call, arguments=arguments))
        return replace(found, is_path=True) if isinstance(found, Text) else found
    first = call.positional[0] if call.positional else None
    match call.callee:
        case "as_posix" | "__str__" | "__fspath__":
            return as_text(value, call.span)
        case "joinpath":
            return path_join([value, *call.positional], call.span, path=True)
        case "with_suffix" | "with_name" if isinstance(first, Text) and len(value.text) + len(first.text) > MAX_TEXT:
            return None
        case "with_suffix" if isinstance(first, Text):
            return Text(call.span, posixpath.splitext(value.text)[0] + first.text, is_path=True)
        case "with_name" if isinstance(first, Text):
            return Text(call.span, posixpath.join(posixpath.dirname(value.text), first.text), is_path=True)
        case "relative_to" if isinstance(first, Text):
            start = posixpath.join(state.cwd, first.text)
            whole = posixpath.join(state.cwd, value.text)
            inside = posixpath.relpath(whole, start)
            return None if inside.startswith("..") else Text(call.span, inside, is_path=True)
        case "read_text":
            opened = path_method(state, value, replace(call, callee="open", arguments=()))
            content = read_rest(state, opened) if isinstance(opened, OpenedFile) else None
            return None if content is None else Text(call.span, content)
        case "glob" | "rglob" | "iterdir":
            return path_listing(state, value, call, first)
    return None


def path_listing(state: EvaluationState, value: Text, call: Call, first: Value | None) -> Value | None:
    pattern = "*" if call.callee == "iterdir" else first.text if isinstance(first, Text) else None
    if pattern is None:
        return None
    pattern = f"**/{pattern}" if call.callee == "rglob" else pattern
    try:
        found = pathlib_glob(state, value.text, pattern)
    except OutsideError:
        return None
    return record_glob(state, call, posixpath.join(value.text, pattern), found, path=True)


def path_attribute(value: Value, name: str, call: Call) -> Value | None:
    """Return a data attribute of a path."""
    if not isinstance(value, Text) or not value.is_path:
        return None
    span, head, tail = call.span, posixpath.dirname(value.text), posixpath.basename(value.text)
    match name:
        case "name":
            return Text(span, tail)
        case "stem":
            return Text(span, posixpath.splitext(tail)[0])
        case "suffix":
            return Text(span, posixpath.splitext(tail)[1])
        case "parent":
            return Text(span, head or ".", is_path=True)
        case "parents":
            return from_python(ancestors(value.text), span, path=True)
        case "parts":
            return from_python(tuple(part for part in value.text.split("/") if part), span)
    return None


def ancestors(path: str) -> list[str]:
    found = []
    while posixpath.dirname(path) != path and path not in ("", "."):
        spend(len(path) + STEP)
        path = posixpath.dirname(path)
        found.append(path or ".")
    return found
