"""Methods and attributes of texts, paths, lists, dicts and opened files."""

from __future__ import annotations

import posixpath
from dataclasses import replace

from .conversion import join, lift
from .dict_methods import DICTS
from .formatting import as_text, braces
from .iterables import items_of, many, pure, read_rest
from .limits import MAX_TEXT, STEP, spend
from .list_methods import LISTS, unfollowed
from .operators import path_join
from .path_functions import PATHS, path_glob, recorded
from .sandbox_filesystem import OutsideError
from .state import EvaluationState
from .values import Argument, Call, Constant, Opened, Sequence, Text, Value
from .values import Mapping as MappingValue

NONE_OF_THEM = frozenset({"zfill", "ljust", "rjust", "center", "expandtabs", "translate", "encode"})
"""Methods of str whose result may be of any size, or is no text."""

PURE = (
    frozenset(name for name in dir(str) if not name.startswith("_")) - NONE_OF_THEM - {"join", "format", "format_map"}
)


SEARCHES = frozenset({"rfind", "rindex", "rsplit", "rpartition", "strip", "lstrip", "rstrip"})
MAX_SEARCH = 10_000_000
"""Methods of str that take the time of the product of both lengths, and the bound of that."""


def method(machine: EvaluationState, value: Value, call: Call) -> Value | None:
    """Return what a method of a value returns; None where it isn't known."""
    name = call.callee
    if call.rest is not None and not isinstance(value, Sequence | MappingValue):
        return None
    match value:
        case Text() if value.path:
            return path_method(machine, value, call)
        case Text():
            return text_method(machine, value, call)
        case Sequence():
            found = LISTS.get(name)
            return found(machine, value, call) if found else unfollowed(machine, value, call)
        case MappingValue():
            found_too = DICTS.get(name)
            return found_too(machine, value, call) if found_too else unfollowed(machine, value, call)
        case Opened():
            return file_method(machine, value, call)
    return None


def text_method(machine: EvaluationState, value: Text, call: Call) -> Value | None:
    if call.callee == "join" and call.positional:
        items = items_of(machine, call.positional[0])
        if items is None or any(map(many, items)):
            return None
        between: list[Value] = []
        for item in items:
            between += [Text(call.span, value.text), item]
        return join(between[1:], call.span)
    if call.callee == "format":
        return braces(value.text, list(call.positional), lambda name: call.get(name), call.span)
    if call.callee not in PURE:
        return None
    if call.callee == "replace" and not fits(value.text, call):
        return None
    if call.callee in SEARCHES and any(
        isinstance(given, Text) and len(given.text) * len(value.text) > MAX_SEARCH for given in call.positional
    ):
        return None
    machine.tick(1 + len(value.text) // 100)
    return pure(getattr(value.text, call.callee))(machine, call)


def fits(text: str, call: Call) -> bool:
    """Return whether the result of a replacement stays small."""
    new = call.positional[1] if len(call.positional) > 1 else None
    return isinstance(new, Text) and (len(text) + 1) * max(len(new.text), 1) <= MAX_TEXT


def file_method(machine: EvaluationState, value: Opened, call: Call) -> Value | None:
    if call.callee == "close":
        return Constant(call.span, None)
    start = value.at
    rest = read_rest(machine, value) if call.callee in ("read", "readline", "readlines") else None
    if rest is None or call.arguments:
        return None
    lines = rest.splitlines(keepends=True)
    if call.callee == "read":
        return Text(call.span, rest)
    if call.callee == "readline":
        value.at = start + len(lines[0] if lines else "")
        return Text(call.span, lines[0] if lines else "")
    return machine.new_list(call.span, [Text(call.span, line) for line in lines])


BY_FUNCTION = {
    "exists": "os.path.exists",
    "is_file": "os.path.isfile",
    "is_dir": "os.path.isdir",
    "resolve": "os.path.abspath",
    "absolute": "os.path.abspath",
    "open": "open",
}


def path_method(machine: EvaluationState, value: Text, call: Call) -> Value | None:
    if call.callee in BY_FUNCTION:
        arguments = (Argument("", value, value.span), *call.arguments)
        found = PATHS[BY_FUNCTION[call.callee]](machine, replace(call, arguments=arguments))
        return replace(found, path=True) if isinstance(found, Text) else found
    first = call.positional[0] if call.positional else None
    match call.callee:
        case "as_posix" | "__str__" | "__fspath__":
            return as_text(value, call.span)
        case "joinpath":
            return path_join([value, *call.positional], call.span, path=True)
        case "with_suffix" | "with_name" if isinstance(first, Text) and len(value.text) + len(first.text) > MAX_TEXT:
            return None
        case "with_suffix" if isinstance(first, Text):
            return Text(call.span, posixpath.splitext(value.text)[0] + first.text, path=True)
        case "with_name" if isinstance(first, Text):
            return Text(call.span, posixpath.join(posixpath.dirname(value.text), first.text), path=True)
        case "relative_to" if isinstance(first, Text):
            start = posixpath.join(machine.cwd, first.text)
            whole = posixpath.join(machine.cwd, value.text)
            inside = posixpath.relpath(whole, start)
            return None if inside.startswith("..") else Text(call.span, inside, path=True)
        case "read_text":
            opened = path_method(machine, value, replace(call, callee="open", arguments=()))
            content = read_rest(machine, opened) if isinstance(opened, Opened) else None
            return None if content is None else Text(call.span, content)
        case "glob" | "rglob" | "iterdir":
            return path_listing(machine, value, call, first)
    return None


def path_listing(machine: EvaluationState, value: Text, call: Call, first: Value | None) -> Value | None:
    pattern = "*" if call.callee == "iterdir" else first.text if isinstance(first, Text) else None
    if pattern is None:
        return None
    pattern = f"**/{pattern}" if call.callee == "rglob" else pattern
    try:
        found = path_glob(machine, value.text, pattern)
    except OutsideError:
        return None
    return recorded(machine, call, posixpath.join(value.text, pattern), found, path=True)


def attribute(value: Value, name: str, call: Call) -> Value | None:
    """Return a data attribute of a path."""
    if not isinstance(value, Text) or not value.path:
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
            return Text(span, head or ".", path=True)
        case "parents":
            return lift(ancestors(value.text), span, path=True)
        case "parts":
            return lift(tuple(part for part in value.text.split("/") if part), span)
    return None


def ancestors(path: str) -> list[str]:
    found = []
    while posixpath.dirname(path) != path and path not in ("", "."):
        spend(len(path) + STEP)
        path = posixpath.dirname(path)
        found.append(path or ".")
    return found
