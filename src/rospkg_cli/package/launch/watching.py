"""Notice where a launch file treats a substitution as if its text were known while the file is read."""

from __future__ import annotations

import ast
from collections.abc import Mapping

from ...languages.python.evaluate.evaluator import Evaluator
from ...languages.python.evaluate.known_functions import LIBRARY
from ...languages.python.evaluate.sandbox_filesystem import SandboxFilesystem
from ...languages.python.evaluate.state import EvaluationState, Intrinsic
from ...languages.python.evaluate.values import Call, Constant, Joined, Symbol, Text, Value
from ...languages.python.file import PythonFile
from ...source import Span
from .misuse import Misuse, is_late, is_substitution, kind_of
from .values import class_of

TEXT_METHODS = frozenset(dir(str)) - frozenset(dir(object))
TEXTS_ONLY = frozenset({"int", "float", "open", "os.path.join", "os.path.exists", "os.path.isfile", "os.path.dirname"})
"""Functions that raise for a substitution."""

LATER = "its text is known only when the launch runs"


class Watching(Evaluator):
    """An evaluator that records such misuse; `judged` holds the truth values that were made of substitutions."""

    def __init__(
        self, file: PythonFile, folder: SandboxFilesystem, knows: Mapping[str, Intrinsic], *, name: str
    ) -> None:
        super().__init__(file, folder, knows, name=name)
        self.misused: list[Misuse] = []
        self.judged: dict[Span, str] = {}
        """Where `not`, `and` and `or` were asked of substitutions, and what Python makes of it."""
        known = self.library
        watched = {name: self.watched(name, known.get(name)) for name in TEXTS_ONLY}
        self.library = {**known, **watched, "isinstance": is_instance}

    def watched(self, name: str, known: Intrinsic | None) -> Intrinsic:
        def function(machine: EvaluationState, call: Call) -> Value | None:
            odd = next((given for given in call.positional if is_substitution(given)), None)
            if odd is not None:
                better = "use PathJoinSubstitution" if name == "os.path.join" else "do it in an OpaqueFunction"
                self.misuse(call.span, f"`{name}` raises TypeError for {kind_of(odd)}: {LATER}; {better}")
            return known(machine, call) if known is not None else None

        return function

    def misuse(self, span: Span, message: str) -> None:
        self.misused.append(Misuse(span, message))

    def known_call(self, function: Value, receiver: Value | None, call: Call) -> Value | None:
        finds = call.callee == "find"  # FindPackageShare(x).find(x)
        if receiver is not None and call.callee in TEXT_METHODS and not finds and is_substitution(receiver):
            self.misuse(call.span, f"{kind_of(receiver)} has no `{call.callee}`: {LATER}; do it in an OpaqueFunction")
        return super().known_call(function, receiver, call)

    def made_of(self, node: ast.expr, *operands: Value) -> None:
        odd = next(filter(is_late, operands), None)
        if odd is None:
            return
        span, plain = self.span(node), any(isinstance(each, Text | Joined) for each in operands)
        match node:
            case ast.BinOp(op=ast.Add()) if plain:
                self.misuse(span, f"`+` raises TypeError for {kind_of(odd)} and a text: put both into a list, `[a, b]`")
            case ast.JoinedStr() | ast.FormattedValue():
                shown = "the f-string holds the name of an object, `<launch… object at 0x…>`"
                self.misuse(span, f"{shown}, and not what {kind_of(odd)} stands for; make it a list of its parts")
            case ast.Compare(ops=[ast.Eq() | ast.NotEq()]) if plain or any(map(is_bool, operands)):
                never = "never" if isinstance(node.ops[0], ast.Eq) else "always"
                better = "use EqualsSubstitution or PythonExpression, or compare in an OpaqueFunction"
                self.misuse(span, f"this is {never} true, since {LATER}: it compares {kind_of(odd)} itself; {better}")
                self.judged[span] = ""
            case ast.UnaryOp(op=ast.Not()):
                self.judged[span] = f"`not` makes False of {kind_of(odd)}, whatever it is at run time"
            case ast.BoolOp() if len(operands) > 1 and all(map(is_late, operands)):
                word, taken = ("or", "first") if isinstance(node.op, ast.Or) else ("and", "last")
                of = ", ".join(dict.fromkeys(map(kind_of, operands)))
                self.judged[span] = f"Python's `{word}` just takes the {taken} of these ({of}), whatever they are then"


def is_instance(machine: EvaluationState, call: Call) -> Value | None:
    """Tell substitutions from texts."""
    given = call.positional
    if len(given) == 2 and isinstance(given[0], Call) and is_substitution(given[0]) and isinstance(given[1], Symbol):
        asked = given[1].name.rpartition(".")[2]
        if asked in ("Substitution", class_of(given[0])):
            return Constant(call.span, True)
        return Constant(call.span, False) if asked in ("str", "int", "float", "bool", "list", "dict") else None
    return LIBRARY["isinstance"](machine, call)


def is_bool(value: Value) -> bool:
    return isinstance(value, Constant) and isinstance(value.value, bool)
