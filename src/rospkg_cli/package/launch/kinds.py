"""What is passed to the classes of launch, against the kinds of value that these take."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping

from ...languages.python.evaluate.values import Argument, Call, Constant, Joined, Sequence, Text, Unknown, Value
from ...languages.python.evaluate.values import Mapping as Dict
from ...ros.launch_calls import ACTIONS, OUTPUTS, Kind
from ...source import Span
from .misuse import Misuse, is_condition, is_late, is_substitution, kind_of, place_of, within
from .parameter_kinds import not_parameters, not_remappings
from .values import class_of

Check = Callable[[Argument, str], Iterator[Misuse]]


def misuse_at(value: Value, place: Span, message: str, mend: str = "") -> Misuse:
    """Complain about a value at the place where it is handed over; it can be mended where it is written there."""
    return Misuse(place, message, (place, mend) if mend and value.span == place else None)


def quoted(value: Value) -> str:
    return f"'{value.value}'" if isinstance(value, Constant) and value.value is not None else ""


def is_path(value: Value) -> bool:
    """Return whether a value is a pathlib.Path; what PathSubstitution makes is a substitution."""
    if isinstance(value, Joined) and is_substitution(value.parts[0]):
        return False
    return isinstance(value, Text | Joined) and value.path


def not_text(given: Argument, what: str) -> Iterator[Misuse]:
    """Yield what is no text: launch takes a str, a substitution, or a list of these."""
    yield from not_a_text(given.value, place_of(given), what)


def not_a_text(value: Value, place: Span, what: str) -> Iterator[Misuse]:
    if isinstance(value, Sequence):
        for item, at in zip(value.items, value.places, strict=True):
            if isinstance(item, Constant):
                message = (
                    f"{what} takes texts and substitutions, and {kind_of(item)} is neither: launch raises TypeError"
                )
                yield misuse_at(item, at, message, quoted(item))
    elif isinstance(value, Constant) or is_condition(value) or (isinstance(value, Call) and class_of(value) in ACTIONS):
        message = f"{what} takes a text or a substitution, and {kind_of(value)} is neither: launch raises TypeError"
        yield misuse_at(value, place, message, quoted(value))
    elif is_path(value):
        yield Misuse(place, f"{what} takes a text, and a pathlib.Path is none: launch raises TypeError; use str()")


def not_words(given: Argument, what: str) -> Iterator[Misuse]:
    """Yield what is no list of texts, and the items that are none."""
    value = given.value
    if isinstance(value, Text):
        yield Misuse(place_of(given), f"{what} takes a list: of a text, each letter becomes an argument of its own")
    elif isinstance(value, Sequence):
        for item, place in zip(value.items, value.places, strict=True):
            if not isinstance(item, Unknown):
                yield from not_a_text(item, place, f"each item of {what}")
    elif isinstance(value, Constant) or is_substitution(value):
        yield Misuse(place_of(given), f"{what} takes a list, not {kind_of(value)}: Python raises TypeError")


def not_condition(given: Argument, what: str) -> Iterator[Misuse]:
    value = given.value
    if is_substitution(value) or isinstance(value, Text | Joined | Constant | Sequence | Dict):
        message = f"{what} takes IfCondition or UnlessCondition, not {kind_of(value)}: the launch stops with "
        yield Misuse(place_of(given), f"{message}\"object has no attribute 'evaluate'\"")


def not_actions(given: Argument, what: str) -> Iterator[Misuse]:
    """Yield what is no list of actions, and the items that launch can't visit."""
    value = given.value
    if isinstance(value, Call) and (class_of(value) in ACTIONS or is_late(value)):
        yield Misuse(place_of(given), f"{what} takes a list of actions, not {kind_of(value)}: write `[…]` around it")
    elif isinstance(value, Text | Constant):
        yield Misuse(place_of(given), f"{what} takes a list of actions, not {kind_of(value)}")
    elif isinstance(value, Sequence):
        yield from not_visited(value, what)


def not_visited(value: Sequence, what: str) -> Iterator[Misuse]:
    for item, place in zip(value.items, value.places, strict=True):
        late = is_late(item) or (isinstance(item, Call) and class_of(item) == "ComposableNode")
        if late or isinstance(item, Text | Joined | Constant | Sequence | Dict):
            found = kind_of(item)
            hint = "; put a `*` before it" if isinstance(item, Sequence) and item.kind != "set" else ""
            hint = hint or ("; a component needs a container" if found == "`ComposableNode`" else "")
            yield Misuse(place, f"{found} is no action, and {what} takes a list of actions: the launch stops{hint}")


def not_pairs(given: Argument, what: str) -> Iterator[Misuse]:
    """Yield what `launch_arguments` can't be taken apart into: names and their texts."""
    value = given.value
    if isinstance(value, Dict) and value.items:
        end = Span(value.span.end, value.span.end)
        mend = (end, ".items()") if value.display and value.span == place_of(given) else None
        yield Misuse(
            place_of(given), f"{what} takes pairs of name and value, and a dict gives keys: add `.items()`", mend
        )
    for item in value.items if isinstance(value, Sequence) else ():
        if isinstance(item, Dict | Text):
            message = f"{what} takes pairs of name and value, not {kind_of(item)}: the launch stops"
            yield Misuse(within(item, place_of(given)), message)
        elif isinstance(item, Sequence) and len(item.items) == 2 and item.complete:
            inner = item.items[1]
            yield from not_a_text(inner, within(inner, place_of(given)), f"a value of {what}")


def not_output(given: Argument, what: str) -> Iterator[Misuse]:
    value = given.value
    if isinstance(value, Text) and value.text not in OUTPUTS:
        some = ", ".join(f"`{name}`" for name in sorted(OUTPUTS))
        yield Misuse(place_of(given), f"{what} knows no `{value.text}`, only {some}: the node is not started")
    elif isinstance(value, Constant):
        yield Misuse(place_of(given), f"{what} takes a text, not {kind_of(value)}: launch raises TypeError")


def not_period(given: Argument, what: str) -> Iterator[Misuse]:
    value = given.value
    if isinstance(value, Constant) and type(value.value) is int:
        message = f"{what} takes a float, and launch raises TypeError for {kind_of(value)}"
        yield misuse_at(value, place_of(given), message, f"{value.value}.0")


CHECKS: Mapping[Kind, Check] = {
    "text": not_text,
    "words": not_words,
    "condition": not_condition,
    "actions": not_actions,
    "pairs": not_pairs,
    "output": not_output,
    "period": not_period,
    "parameters": not_parameters,
    "remappings": not_remappings,
}
