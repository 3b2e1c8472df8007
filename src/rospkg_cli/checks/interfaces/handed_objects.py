"""Functions that rclpy calls with objects of its own (goal handles, futures), whatever their annotations say."""

from __future__ import annotations

import ast
from collections.abc import Iterator

from ...languages.python.file import PythonFile
from ...languages.python.nodes import last_name, nodes_below, nodes_of_kind

HANDLES = ("execute_callback", "handle_accepted_callback", "cancel_callback")
OBJECTS: dict[str, tuple[int, tuple[str, ...]]] = {
    "ActionServer": (3, HANDLES),
    "add_done_callback": (0, ()),
    "add_on_set_parameters_callback": (0, ("callback",)),
    "add_post_set_parameters_callback": (0, ("callback",)),
    "add_pre_set_parameters_callback": (0, ("callback",)),
    "create_guard_condition": (0, ("callback",)),
    "create_timer": (1, ("callback",)),
    "register_cancel_callback": (0, ("cancel_callback",)),
    "register_execute_callback": (0, ("execute_callback",)),
    "register_handle_accepted_callback": (0, ("handle_accepted_callback",)),
    "send_goal": (1, ("feedback_callback",)),
    "send_goal_async": (1, ("feedback_callback",)),
}
"""Which argument of a call is the callback, by position or by one of some names, for what rclpy calls with an object
of its own: a goal's handle, a future, a message around the feedback, parameters, the time of a timer."""
SUBSCRIBES, RECEIVES = "create_subscription", (2, ("callback",))
"""What takes a callback that gets bytes with `raw`."""


def handed_objects(file: PythonFile) -> frozenset[str]:
    """Return the names of the functions that a file registers for rclpy to call with an object of rclpy."""
    if not any(name in file.source.text for name in (*OBJECTS, "raw")):
        return frozenset()
    calls = nodes_of_kind(file.tree, ast.Call)
    return frozenset(name for call in calls for given in callbacks(call) for name in functions(given))


def callbacks(call: ast.Call) -> Iterator[ast.expr]:
    """Yield the arguments of a call that rclpy will call with an object of rclpy."""
    name = last_name(call.func)
    position, names = OBJECTS.get(name, (len(call.args), ()))
    if name == SUBSCRIBES and any(each.arg == "raw" and is_set(each.value) for each in call.keywords):
        position, names = RECEIVES
    yield from call.args[position : position + 1]
    yield from (each.value for each in call.keywords if each.arg in names)


def is_set(value: ast.expr) -> bool:
    return not (isinstance(value, ast.Constant) and not value.value)


def functions(given: ast.expr) -> Iterator[str]:
    """Yield the function that is given, or those that a `partial` around it names; what a lambda calls is called."""
    if isinstance(given, ast.Name | ast.Attribute):
        yield given.attr if isinstance(given, ast.Attribute) else given.id
    elif isinstance(given, ast.Call):
        for node in nodes_below(given):
            if isinstance(node, ast.Name | ast.Attribute):
                yield node.attr if isinstance(node, ast.Attribute) else node.id
