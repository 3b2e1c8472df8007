"""Convert the evaluator's values to launch texts, as the classes of launch and launch_ros do."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from ...languages.python.evaluate.values import AttributeValue, Call, Constant, PartialText, Sequence, Text, Value
from ...source import Span
from .launch_classes import class_of
from .text import LaunchText, Literal, Substitution, plain_text, unknown_text

NAMED: Mapping[str, tuple[str, tuple[tuple[str, int], ...]]] = {
    "LaunchConfiguration": ("var", (("variable_name", 0), ("default", 1))),
    "FindPackageShare": ("find-pkg-share", (("package", 0),)),
    "FindPackagePrefix": ("find-pkg-prefix", (("package", 0),)),
    "FindPackage": ("find-pkg-prefix", (("package", 0),)),
    "get_package_share_directory": ("find-pkg-share", (("package_name", 0),)),
    "get_package_share_path": ("find-pkg-share", (("package_name", 0),)),
    "get_package_prefix": ("find-pkg-prefix", (("package_name", 0),)),
    "EnvironmentVariable": ("env", (("name", 0), ("default_value", 1))),
    "Command": ("command", (("command", 0),)),
    "PythonExpression": ("eval", (("expression", 0), ("python_modules", 1))),
    "FindExecutable": ("find-exec", (("name", 0),)),
    "ExecutableInPackage": ("exec-in-pkg", (("executable", 0), ("package", 1))),
    "ThisLaunchFileDir": ("dirname", ()),
    "ThisLaunchFile": ("filename", ()),
}
"""Classes and functions that are a substitution: its name in XML, and its arguments by keyword and place."""

WRAPPERS: Mapping[str, tuple[str, int]] = {
    "TextSubstitution": ("text", 0),
    "PythonLaunchDescriptionSource": ("launch_file_path", 0),
    "AnyLaunchDescriptionSource": ("launch_file_path", 0),
    "FrontendLaunchDescriptionSource": ("launch_file_path", 0),
    "XMLLaunchDescriptionSource": ("launch_file_path", 0),
    "YAMLLaunchDescriptionSource": ("launch_file_path", 0),
    "ParameterFile": ("param_file", 0),
    "ParameterValue": ("value", 0),
}
"""Classes that only wrap a text."""

PASSING = frozenset({"perform", "as_posix", "resolve", "absolute"})
"""Methods that give the same text."""

MAX_DEPTH = 30


def substitution(call: Call, depth: int = 0) -> Substitution | None:
    """Return the substitution that a call makes; None where it makes none."""
    named = NAMED.get(class_of(call))
    if named is None:
        return None
    name, parameters = named
    given = [call.get(keyword, place) for keyword, place in parameters]
    while given and given[-1] is None:
        given.pop()
    arguments = tuple(unknown_text(call.span) if v is None else text_of(v, depth + 1) for v in given)
    return Substitution(name, arguments, call.span)


def text_of(value: Value, depth: int = 0) -> LaunchText:
    """Return what launch makes of a value where it takes text: a list is its items one after the other."""
    if depth > MAX_DEPTH:
        return unknown_text(value.span)
    match value:
        case Text():
            return plain_text(value.text, value.literal or value.span)
        case Constant():
            return plain_text(str(value.value), value.span)
        case Sequence():
            return one_after_another(value.items, value.span, depth) if value.is_complete else unknown_text(value.span)
        case PartialText():
            return one_after_another(list(value.parts), value.span, depth)
        case AttributeValue(of=of, name="parent" | "as_posix"):
            return LaunchText(value.span, (*text_of(of, depth + 1).parts, *unknown_text(value.span).parts))
        case Call():
            return of_call(value, depth)
    return unknown_text(value.span)


def one_after_another(values: list[Value], span: Span, depth: int) -> LaunchText:
    parts = [part for value in values for part in text_of(value, depth + 1).parts]
    return LaunchText(span, tuple(parts))


def of_call(call: Call, depth: int) -> LaunchText:
    found = substitution(call, depth)
    if found is not None:
        return LaunchText(call.span, (found,))
    if call.receiver is not None and call.callee in PASSING:
        return text_of(call.receiver, depth + 1)
    special = SPECIAL.get(class_of(call))
    if special is not None:
        return special(call, depth)
    wrapper = WRAPPERS.get(class_of(call))
    inner = call.get(*wrapper) if wrapper else None
    return unknown_text(call.span) if inner is None else text_of(inner, depth + 1)


def path_join(call: Call, depth: int) -> LaunchText:
    items = call.get("substitutions", 0)
    if not isinstance(items, Sequence) or not items.is_complete:
        return unknown_text(call.span)
    parts: list[Literal | Substitution] = []
    for index, item in enumerate(items.items):
        found = text_of(item, depth + 1)
        if index:
            parts.append(Literal("/", found.span))
        parts += found.parts
    return LaunchText(call.span, tuple(parts))


SPECIAL: Mapping[str, Callable[[Call, int], LaunchText]] = {"PathJoinSubstitution": path_join}
