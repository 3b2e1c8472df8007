"""Run loops: `foreach` over known and unknown values, `while` as long as its condition is known."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from ...light_dataclasses import replace
from .call_stack import ExhaustedError, LeaveError
from .command_blocks import Block
from .condition import evaluate
from .condition_context import InterpreterContext
from .interpreter import Interpreter
from .list_text import as_value
from .values import UNKNOWN, Value, Word

MAX_ROUNDS = 500


def run_foreach(interpreter: Interpreter, block: Block) -> None:
    words = interpreter.words(block.command)
    if not words:
        return
    name, rest = words[0].text, words[1:]
    values = loop_values(interpreter, rest)
    before = interpreter.scope.get(name)
    if values is None:
        run_maybe(interpreter, block, {name: interpreter.unknown()})
    elif not values:
        interpreter.scope.set(name, interpreter.unknown())
        interpreter.run_unreachable(block.branches[0].body)
    else:
        run_rounds(interpreter, block, name, values)
    if before is None:
        interpreter.scope.variables.pop(name, None)
    else:
        interpreter.scope.set(name, before)


def run_rounds(interpreter: Interpreter, block: Block, name: str, values: Sequence[Word]) -> None:
    for word in values[:MAX_ROUNDS]:
        if word.maybe or word.text == UNKNOWN:
            run_maybe(interpreter, block, {name: (replace(word, maybe=False),)})
            continue
        interpreter.scope.set(name, as_value([word]))
        try:
            interpreter.body(block.branches[0].body)
        except LeaveError as leave:
            if leave.how == "break":
                return
            if leave.how != "continue":
                raise


def run_maybe(interpreter: Interpreter, block: Block, variables: Mapping[str, Value]) -> None:
    """Run a body that may run any number of times, and merge the result with the state before."""
    before = interpreter.save()
    for name, value in variables.items():
        interpreter.scope.set(name, value)
    try:
        with interpreter.enter_frame(replace(interpreter.frame, maybe=True)):
            interpreter.body(block.branches[0].body)
    except LeaveError as leave:
        if leave.how == "fatal":
            interpreter.scope.restore(before)
            return
    interpreter.unite([before, interpreter.save()])


def loop_values(interpreter: Interpreter, words: Sequence[Word]) -> list[Word] | None:
    """Return the values of a foreach; None where they are unknown as a whole."""
    if words and words[0].text == "RANGE" and not words[0].quoted:
        return range_values([word.text for word in words[1:]], interpreter)
    if not (words and words[0].text == "IN" and not words[0].quoted):
        return list(words)
    found: list[Word] = []
    mode = ""
    for word in words[1:]:
        if word.text in ("LISTS", "ITEMS", "ZIP_LISTS") and not word.quoted:
            mode = word.text
        elif mode == "ZIP_LISTS":
            return None
        else:
            found += interpreter.value(word.text) if mode == "LISTS" else [word]
    return found


def range_values(texts: list[str], interpreter: Interpreter) -> list[Word] | None:
    if not all(text.isdecimal() and len(text) < 6 for text in texts) or not 1 <= len(texts) <= 3:
        return None
    numbers = [int(text) for text in texts]
    start, stop = (0, numbers[0]) if len(numbers) == 1 else (numbers[0], numbers[1])
    step = numbers[2] if len(numbers) == 3 else 1
    return [interpreter.word(str(n)) for n in range(start, stop + 1, step)[:MAX_ROUNDS]] if step else None


def run_while(interpreter: Interpreter, block: Block) -> None:
    for _ in range(MAX_ROUNDS):
        truth = evaluate(interpreter.words(block.command), InterpreterContext(interpreter))
        if truth is False:
            return
        if truth is None:
            run_maybe(interpreter, block, {})
            return
        try:
            interpreter.body(block.branches[0].body)
        except LeaveError as leave:
            if leave.how == "break":
                return
            if leave.how != "continue":
                raise
    raise ExhaustedError
