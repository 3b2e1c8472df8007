"""Read a Python launch file by evaluating it: what it builds, as far as that is known."""

from __future__ import annotations

import posixpath
from collections import Counter
from collections.abc import Iterable, Iterator

from ...languages.python.evaluate.evaluator import Evaluator
from ...languages.python.evaluate.sandbox_filesystem import SandboxFilesystem
from ...languages.python.evaluate.values import Call, Constant, Mapping, PartialText, Sequence, Text, Value
from ...languages.python.file import PythonFile
from .argument_defaults import literal_defaults
from .collect_texts import caught_references, file_references
from .configuration_lookups import names_set
from .evaluated_launch import EvaluatedLaunch
from .exception_guards import ABSENT, guarded_in, silent_in
from .launch_classes import class_of
from .launch_evaluator import ENTRIES, LaunchEvaluator
from .launch_file import LaunchFile
from .python_actions import NODES, argument_of, argument_text, command_of, include_of, node_of
from .python_events import python_events
from .python_to_text import substitution

MAX_DEPTH = 8


def read_python_launch(file: PythonFile, folder: SandboxFilesystem) -> LaunchFile:
    evaluator = LaunchEvaluator(file, folder)
    evaluator.run_all()
    calls = list(once(evaluator.calls))
    of: dict[str, list[Call]] = {}
    for call in calls:
        of.setdefault(class_of(call), []).append(call)
    arguments = tuple(map(argument_of, of.get("DeclareLaunchArgument", ())))
    assigned = (*(argument_text(call, "name") for call in of.get("SetLaunchConfiguration", ())), *names_set(file))
    bare, defaults = tuple(guarded_in(file, ABSENT)), literal_defaults(arguments, assigned)
    every = (node_of(call, kind) for name, kind in NODES.items() for call in of.get(name, ()))
    return LaunchFile(
        file.source,
        "python",
        nodes=tuple(sorted(every, key=lambda node: node.span)),
        includes=tuple(map(include_of, of.get("IncludeLaunchDescription", ()))),
        arguments=arguments,
        commands=tuple(map(command_of, [*of.get("ExecuteProcess", ()), *of.get("ExecuteLocal", ())])),
        substitutions=tuple(found for call in calls if (found := substitution(call)) is not None),
        assigned=assigned,
        every_path=tuple(file_references(calls, posixpath.dirname(file.source.path), bare, defaults)),
        caught_paths=tuple(caught_references(calls, posixpath.dirname(file.source.path), tuple(silent_in(file)))),
        is_complete=not evaluator.gave_up,
        has_entry_point=any(has_name(file, evaluator, name) for name in ENTRIES),
        events=python_events(evaluator),
        evaluated=EvaluatedLaunch(
            file,
            evaluator.scope,
            tuple(calls),
            evaluator.results,
            tuple(evaluator.uses),
            tuple(evaluator.deferred),
        ),
    )


def has_name(file: PythonFile, evaluator: Evaluator, name: str) -> bool:
    """Return whether a file defines a name, may have it from elsewhere, or is a program that needs none."""
    is_known = not (file.star_imports or file.has_dynamic_names or "__main__" in file.source.text)
    return not is_known or name in file.definitions or evaluator.get(name) is not None


def once(calls: Iterable[Call]) -> Iterator[Call]:
    """Yield calls without equal ones at the same span, which loops make."""
    calls, seen = list(calls), set()
    count = Counter((call.span.start, call.span.end) for call in calls)
    for call in calls:
        if count[call.span.start, call.span.end] == 1:
            yield call
            continue
        key = (call.span, call.callee, tuple((a.name, shown(a.value)) for a in call.arguments), call.is_certain)
        if key not in seen:
            seen.add(key)
            yield call


def shown(value: Value, depth: int = 0) -> object:
    """Return a key that differs for different values of the same span."""
    if depth > MAX_DEPTH:
        return value.span
    match value:
        case Text():
            return value.text
        case Constant():
            return value.value
        case Sequence():
            return value.span, tuple(shown(item, depth + 1) for item in value.items)
        case Mapping():
            return value.span, tuple((shown(k, depth + 1), shown(v, depth + 1)) for k, v in value.items.values())
        case PartialText():
            return value.span, tuple(shown(part, depth + 1) for part in value.parts)
        case Call():
            return value.span, value.callee, tuple(shown(argument.value, depth + 1) for argument in value.arguments)
    return value.span
