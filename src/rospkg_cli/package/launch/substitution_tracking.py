"""Record where a launch file works on a substitution as if its text were known while the file is read."""

from __future__ import annotations

import ast
from collections.abc import Mapping as MappingType

from ...languages.python.evaluate.evaluator import Evaluator
from ...languages.python.evaluate.known_functions import LIBRARY
from ...languages.python.evaluate.sandbox_filesystem import SandboxFilesystem
from ...languages.python.evaluate.state import EvaluationState, Intrinsic
from ...languages.python.evaluate.values import Call, Constant, Mapping, PartialText, Sequence, Symbol, Text, Value
from ...languages.python.file import PythonFile
from .evaluated_launch import SubstitutionUse
from .launch_classes import class_of, is_resolved_at_run_time, is_substitution

STRING_METHODS = frozenset(dir(str)) - frozenset(dir(object))
STRING_FUNCTIONS = frozenset({
    "int", "float", "open", "os.path.join", "os.path.exists", "os.path.isfile", "os.path.dirname",
})  # fmt: skip
"""Functions that raise for a substitution."""
OF_PATHS = frozenset({"os.path.join", "os.path.dirname"})
"""Of these those that raise for a list and a tuple too."""


class SubstitutionTracker(Evaluator):
    """An evaluator that records every use of a substitution by Python itself."""

    def __init__(
        self, file: PythonFile, folder: SandboxFilesystem, knows: MappingType[str, Intrinsic], *, name: str
    ) -> None:
        super().__init__(file, folder, knows, name=name)
        self.uses: list[SubstitutionUse] = []
        known = self.library
        tracked = {name: tracked_function(name, known.get(name)) for name in STRING_FUNCTIONS}
        self.library = {**known, **tracked, "isinstance": is_instance}

    def known_call(self, function: Value, receiver: Value | None, call: Call) -> Value | None:
        finds = call.callee == "find"  # FindPackageShare(x).find(x)
        if receiver is not None and call.callee in STRING_METHODS and not finds and is_substitution(receiver):
            self.uses.append(SubstitutionUse(call.span, "method", call.callee, (receiver,)))
        if isinstance(receiver, Mapping) and call.callee == "get" and is_key(call):
            self.uses.append(SubstitutionUse(call.span, "lookup", "get", (call.positional[0],)))
        return super().known_call(function, receiver, call)

    def on_operands(self, node: ast.expr, *operands: Value) -> None:
        operator = operator_of(node)
        if operator and any(map(is_resolved_at_run_time, operands)):
            self.uses.append(SubstitutionUse(self.span(node), "operator", operator, operands))
        elif self.certain and (refused := refused_by(node, operands)):
            self.uses.append(
                SubstitutionUse(self.span(node), "refused", refused, tuple(filter(is_container, operands)))
            )


def tracked_function(name: str, known: Intrinsic | None) -> Intrinsic:
    """Return a function that records each use of a substitution with the tracker that calls it."""

    def function(machine: EvaluationState, call: Call) -> Value | None:
        found = next((argument for argument in call.positional if is_substitution(argument)), None)
        if found is not None and isinstance(machine, SubstitutionTracker):
            machine.uses.append(SubstitutionUse(call.span, "function", name, (found,)))
        elif name in OF_PATHS and machine.certain and isinstance(machine, SubstitutionTracker):
            wrong = tuple(filter(is_container, call.positional))
            machine.uses += [SubstitutionUse(call.span, "refused", name, wrong)] if wrong else []
        return known(machine, call) if known is not None else None

    return function


def is_container(value: Value) -> bool:
    return isinstance(value, Sequence | Mapping)


def refused_by(node: ast.expr, operands: tuple[Value, ...]) -> str:
    """Return the operator that raises TypeError: of a text and a container, or a container as part of a path."""
    contain = any(map(is_container, operands))
    match node:
        case ast.BinOp(op=ast.Add()) if contain and any(isinstance(each, Text | PartialText) for each in operands):
            return "+"
        case ast.BinOp(op=ast.Div()) if contain:
            return "/"
    return ""


def is_key(call: Call) -> bool:
    """Return whether a substitution is looked up in a dict."""
    return bool(call.positional) and is_substitution(call.positional[0])


def operator_of(node: ast.expr) -> str:
    """Return the operator of an expression that needs the text of a substitution; "" for any other expression."""
    match node:
        case ast.BinOp(op=ast.Add()):
            return "+"
        case ast.BinOp(op=ast.BitAnd()):
            return "&"
        case ast.BinOp(op=ast.BitOr()):
            return "|"
        case ast.JoinedStr() | ast.FormattedValue():
            return 'f""'
        case ast.Compare(ops=[ast.Eq()]):
            return "=="
        case ast.Compare(ops=[ast.NotEq()]):
            return "!="
        case ast.UnaryOp(op=ast.Not()):
            return "not"
        case ast.BoolOp():
            return "or" if isinstance(node.op, ast.Or) else "and"
    return ""


def is_instance(machine: EvaluationState, call: Call) -> Value | None:
    """Evaluate `isinstance` of a substitution, which is no string."""
    given = call.positional
    if len(given) == 2 and isinstance(given[0], Call) and is_substitution(given[0]) and isinstance(given[1], Symbol):
        asked = given[1].name.rpartition(".")[2]
        if asked in ("Substitution", class_of(given[0])):
            return Constant(call.span, True)
        return Constant(call.span, False) if asked in ("str", "int", "float", "bool", "list", "dict") else None
    return LIBRARY["isinstance"](machine, call)
