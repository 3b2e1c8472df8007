"""Everything that a Python launch file hands to launch and that launch can't take."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping

from ...languages.python.evaluate.values import Argument, Call, Constant, Function, Sequence, Value
from ...ros.launch_calls import ACTIONS, SIGNATURES
from ...source import Span
from .called import ill_called, named_arguments
from .evaluation import LaunchEvaluator
from .kinds import CHECKS, not_visited
from .misuse import Misuse, kind_of
from .values import class_of

DESCRIBES = "generate_launch_description"


def misuses(evaluator: LaunchEvaluator, calls: Iterable[Call]) -> tuple[Misuse, ...]:
    """Return what is misused, in the order of the text, each place once."""
    found: dict[Span, Misuse] = {}
    for each in every_misuse(evaluator, calls):
        found.setdefault(each.span, each)
    judged = [span for span in found if span in evaluator.judged]
    inside = {a for a in found for b in judged if a != b and b.start <= a.start and a.end <= b.end}
    return tuple(found[span] for span in sorted(found) if span not in inside)


def every_misuse(evaluator: LaunchEvaluator, calls: Iterable[Call]) -> Iterator[Misuse]:
    for call in calls:
        signature = SIGNATURES.get(name := class_of(call))
        if signature is None:
            continue
        yield from ill_called(call, name, signature)
        for keyword, argument in named_arguments(call, signature):
            yield from of_argument(call, keyword, argument, evaluator.judged)
    yield from evaluator.misused
    for function, value in evaluator.results.values():
        if function.name == DESCRIBES and function.scope is evaluator.scope and not function.decorated:
            yield from no_description(evaluator, function, value)
    for call in calls:
        if class_of(call) == "OpaqueFunction":
            yield from opaque(call, evaluator)


def of_argument(call: Call, keyword: str, argument: Argument, judged: Mapping[Span, str]) -> Iterator[Misuse]:
    """Yield what is wrong with one argument: how it was judged by Python, or its kind."""
    signature = SIGNATURES[name := class_of(call)]
    kind, value = signature.kinds.get(keyword, "any"), argument.value
    what = f"`{keyword}` of `{name}`"
    if kind == "condition" or keyword == "predicate_expression":
        whole = Span(value.span.start, value.span.end)
        if why := judged.get(whole):
            yield Misuse(whole, f"{why}: combine them in a PythonExpression, or with AndSubstitution, OrSubstitution")
            return
        if whole in judged:
            return
    if keyword in signature.optional and isinstance(value, Constant) and value.value is None:
        return
    if kind in CHECKS:
        yield from CHECKS[kind](argument, what)


def no_description(evaluator: LaunchEvaluator, function: Function, value: Value) -> Iterator[Misuse]:
    """Yield what `generate_launch_description` returns instead of a LaunchDescription."""
    returned = kind_of(value)
    wrong = isinstance(value, Constant | Sequence) or (isinstance(value, Call) and class_of(value) in ACTIONS)
    if wrong:
        start = evaluator.file.source.text.index(DESCRIBES, function.span.start)
        span = Span(start, start + len(DESCRIBES))
        yield Misuse(span, f"`{DESCRIBES}` returns {returned} and no LaunchDescription: the launch stops")


def opaque(call: Call, evaluator: LaunchEvaluator) -> Iterator[Misuse]:
    """Yield what is wrong with the function of an OpaqueFunction: it takes the context and returns a list."""
    function = call.get("function", 0)
    if isinstance(function, Sequence | Constant):
        message = f"`function` of `OpaqueFunction` takes a function, not what it returns ({kind_of(function)})"
        yield Misuse(function.span, f"{message}: launch raises TypeError")
    if not isinstance(function, Function):
        return
    arguments = function.node.args
    if not (arguments.posonlyargs or arguments.args or arguments.vararg):
        yield Misuse(call.span, f"launch calls `{function.name}` with the context, and it takes no argument: TypeError")
    _, value = evaluator.results.get(id(function.node), (None, None))
    what = f"what `{function.name}` returns"
    if isinstance(value, Call) and (class_of(value) in ACTIONS or class_of(value) == "LaunchDescription"):
        yield Misuse(value.span, f"{what} has to be a list of actions, not {kind_of(value)}: the launch stops")
    elif isinstance(value, Sequence):
        yield from not_visited(value, what)
