"""Parameters declared in C++: `declare_parameter<T>(name, default)` and its like in nav2_util and others."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import cast

from ...languages.cpp.call import CppArgument, CppCall
from ...languages.cpp.enclosing import always_called
from ...languages.cpp.file import CppFile
from ...languages.cpp.unconditional import CONTROL, last_word, unconditional
from ...lazy_regex import regex
from .cpp_parameter_types import MAX_LENGTH, TypeOf, inferred, plain_value, typed
from .declared_parameter import DeclaredParameter

NAMED = regex(
    r"declare_parameter|declareParameter|declare_parameter_if_not_declared|(?:get_or_declare|declare_or_get)_parameter"
)
"""Functions of rclcpp, nav2 and autoware that declare one parameter."""
OF_LAYER = "declareParameter"
"""A function of nav2_costmap_2d::Layer: it puts the name of the layer before that of the parameter."""
IGNORES = 2
"""Where a call may say to ignore overrides, behind the default and the descriptor."""
FREE = 2
"""Arguments of a free function that declares a parameter without a default: the node, and the name."""
OVERRIDDEN = regex(r"\b(?:append_parameter_override|parameter_overrides)\s*\(")
"""How a program gives its own node values."""
SEVERAL = "declare_parameters"
PAIR = regex(r'\{\s*"(?P<name>[^"\\]+)"\s*,')
NODE = regex("node|parent|shared_from_this", re.IGNORECASE)
"""What is in the name of a first argument that is the node, where the function is none of its own."""

WRAPPED = regex(r'std::string\s*[({]\s*("[^"]*")\s*[)}]')
TAIL = regex(r'(?P<before>(?:.*[^"\s]\s*|)\+\s*)?(?P<text>"[^"\\]*"(?:\s*\+\s*"[^"\\]*")*)', re.DOTALL)
"""A name, or what stands behind the last part of one that is computed: `name + "." + "rate"`."""
JOINT = regex(r'"\s*\+\s*"|^"|"$')


def declared_in(file: CppFile, type_of: TypeOf) -> Iterator[DeclaredParameter]:
    """Yield what a file declares under a name of which at least the end is literal."""
    certain = unconditional_calls(file)
    for call in file.calls:
        arguments = call.arguments or ()
        if call.name == SEVERAL and not call.variable:
            yield from several(call, file.path)
        if not NAMED.fullmatch(call.name) or call.variable:
            continue
        free = call.name != "declare_parameter" and arguments and is_node(arguments[0].text)
        place = 1 if free else 0
        if len(arguments) <= place:
            continue
        name = name_in(arguments[place])
        if name is not None:
            rest = arguments[place + 1 :]
            kind = typed(call.template) or (inferred(rest[0].text, type_of) if rest else "")
            kind = (
                "" if len(rest) > IGNORES and rest[IGNORES].text == "true" else kind
            )  # overrides are ignored, whatever their type
            required = bool(call.template) and not rest and not call.is_conditional
            required = required and call.span.start in certain
            is_tail, default = name[1] or call.name == OF_LAYER, plain_value(rest[0].text) if rest else ""
            yield DeclaredParameter(name[0], is_tail, kind, required, file.path, default)


def several(call: CppCall, path: str) -> Iterator[DeclaredParameter]:
    """Yield the parameters of one name space that a call declares together: `("gains", {{"p", 1.0}, {"i", 0.1}})`."""
    space, values, *_ = (*(call.arguments or ()), None, None)
    if space and values and space.literal is not None and values.text.startswith("{"):
        prefix = f"{space.literal}." if space.literal else ""
        for pair in PAIR.finditer(values.text):
            yield DeclaredParameter(prefix + pair.group("name"), False, typed(call.template), False, path)


def unconditional_calls(file: CppFile) -> set[int]:
    """Return where calls with a template argument begin that every run of their function makes; found out once.

    What is tried may be caught.
    """
    known, text = vars(file), file.source.text
    if "unconditional_calls" not in known:
        starts = [call.span.start for call in file.calls if call.template and len(call.arguments or ()) <= FREE]
        found = unconditional(text, starts, CONTROL | {"try"}) if starts and not OVERRIDDEN.search(text) else set()
        known["unconditional_calls"] = {each for each in found if always_called(text, each)}
    return cast("set[int]", known["unconditional_calls"])


def is_node(text: str) -> bool:
    """Return whether an argument is a node: `this`, or what ends with a name like `node_` or `get_parent()`."""
    bare = text.removesuffix("()")
    return text.lower() in ("this", "*this") or NODE.search(last_word(bare)) is not None


def read_in(file: CppFile) -> Iterator[tuple[DeclaredParameter, CppCall]]:
    """Yield the parameters that a file gets by name."""
    for call in file.calls:
        if call.name in ("get_parameter", "get_parameter_or") and call.arguments:
            name = name_in(call.arguments[0])
            if name is not None:
                yield DeclaredParameter(*name, "", False, file.path), call


def has_computed_cpp_names(file: CppFile) -> bool:
    """Return whether a file declares parameters under names of which not even the end is literal."""
    for call in file.calls:
        arguments = call.arguments or ()
        if call.name == SEVERAL or (NAMED.fullmatch(call.name) and call.arguments is None):
            return True
        if NAMED.fullmatch(call.name) and not call.variable and not any(map(name_in, arguments[:2])):
            return True
    return False


def name_in(argument: CppArgument) -> tuple[str, bool] | None:
    """Return a name, and whether only its end is known; None where nothing is."""
    if len(argument.text) > MAX_LENGTH:
        return None
    found = TAIL.fullmatch(WRAPPED.sub(r"\1", argument.text))
    text = JOINT.sub("", found.group("text")) if found else ""
    return (text, found.group("before") is not None) if found and text.strip(".") else None


def asked_variables(file: CppFile) -> Iterator[str]:
    """Yield the variables whose types determine those of a file's parameters."""
    asked: list[str] = []
    list(declared_in(file, lambda name: asked.append(name) or ""))  # type: ignore[func-returns-value]
    yield from asked
