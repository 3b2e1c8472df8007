"""Calls in launch files that launch's evaluator knows: those that find, join and make paths."""

from __future__ import annotations

from ...languages.python.evaluate.known_functions import LIBRARY
from ...languages.python.evaluate.operators import path_join
from ...languages.python.evaluate.path_functions import PATH_FUNCTIONS
from ...languages.python.evaluate.state import EvaluationState
from ...languages.python.evaluate.values import Call, Constant, PartialText, Text, Unknown, Value
from .evaluated_launch import SubstitutionUse
from .include_helpers import KNOWN as HELPERS
from .include_helpers import made
from .launch_classes import class_of, is_substitution
from .substitution_tracking import SubstitutionTracker


def found_path(machine: EvaluationState, call: Call) -> Value:
    """get_package_share_path: what is joined to it with `/` is a path below it."""
    machine.calls.append(call)
    return PartialText(call.span, (call,), is_path=True)


def as_path(machine: EvaluationState, call: Call) -> Value | None:
    """PathSubstitution(text): a path of one text, to be joined with `/`."""
    path = call.get("path", 0)
    return PartialText(call.span, (path,), is_path=True) if isinstance(path, Call) else None


def passed_on(machine: EvaluationState, call: Call) -> Value | None:
    """os.path.realpath and the like: of a path that is known only in part, the same path."""
    first = call.positional[0] if call.positional else None
    if isinstance(first, Text) and not first.text.startswith("/") and not call.callee.endswith("normpath"):
        return current_folder(machine, call)
    return first if isinstance(first, Call | PartialText) else PATH_FUNCTIONS[call.callee](machine, call)


def current_folder(machine: EvaluationState, call: Call) -> Value | None:
    """os.getcwd: the folder that the launch is started in, as a rule that of the workspace."""
    return machine.unknown(call.span, "it depends on the current folder")


def joined(receiver: PartialText, call: Call) -> Value | None:
    """Return what a method makes of a path in a share directory; None for a method that makes no path of it."""
    if call.callee == "joinpath":
        return path_join([receiver, *call.positional], call.span, path=True)
    return receiver if call.callee in SAME_PATH else None


def found_folder(machine: EvaluationState, finder: Call, call: Call) -> Value | None:
    """FindPackageShare(x).find(y): the folder of y; x is never looked for."""
    package = call.argument("package_name", 0)
    if package is None or len(call.arguments) != 1:
        return None
    if machine.calls and machine.calls[-1] is finder:
        machine.calls.pop()
    found = made(call, FINDERS[class_of(finder)], package)
    machine.calls.append(found)
    return found


def with_default(machine: EvaluationState, call: Call) -> Value | None:
    """os.environ.get and os.getenv: a default that is no text is a value that the launch may get."""
    found, name, default = LIBRARY[call.callee](machine, call), call.get("key", 0), call.get("default", 1)
    if isinstance(found, Unknown) and isinstance(default, Constant) and default.value is not None:
        shown = f"`{name.text}`" if isinstance(name, Text) else "the variable"
        return Unknown(found.span, f"{shown} may not be set", options=(default,))
    return found


def as_text(machine: EvaluationState, call: Call) -> Value | None:
    """str(x): whatever x may be, it is a text then; of a substitution the name of the object."""
    given = call.positional[0] if call.positional else None
    if given is not None and is_substitution(given):
        if isinstance(machine, SubstitutionTracker):
            machine.uses.append(SubstitutionUse(call.span, "operator", "str()", (given,)))
        return Unknown(call.span, "it holds the name of an object")
    found = LIBRARY["str"](machine, call)
    return Unknown(call.span, found.why) if isinstance(found, Unknown) and found.options else found


FINDERS = {
    "FindPackageShare": "ament_index_python.packages.get_package_share_directory",
    "FindPackagePrefix": "ament_index_python.packages.get_package_prefix",
    "FindPackage": "ament_index_python.packages.get_package_prefix",
}
"""Substitutions that find a folder, and the functions that return what their method `find` does."""
SAME_PATH = frozenset({"resolve", "absolute", "expanduser"})
PATHS = {
    "ament_index_python.get_package_share_path": found_path,
    "ament_index_python.packages.get_package_share_path": found_path,
    "launch.substitutions.PathSubstitution": as_path,
    "os.path.abspath": passed_on,
    "os.path.realpath": passed_on,
    "os.path.normpath": passed_on,
    "os.getcwd": current_folder,
    "pathlib.Path.cwd": current_folder,
    "os.environ.get": with_default,
    "os.getenv": with_default,
    "str": as_text,
    **HELPERS,
}
"""What makes a path that others are joined to, what gives it back, and what includes a file."""
