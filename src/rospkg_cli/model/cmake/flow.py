"""What blocks do: conditions, loops, functions and macros."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace

from .blocks import Block, Branch
from .call import Call
from .condition import Truth, both, evaluate, negated
from .machine import ExhaustedError, Frame, Function, LeaveError, Machine
from .scope import Scope, Snapshot
from .words import HOLE, Value, Word, as_value
from .world import World

MAX_ROUNDS = 500

Reached = tuple[Truth, Truth]
"""Whether a place is reached with BUILD_TESTING on, and off."""


def run_if(machine: Machine, block: Block) -> None:
    """Run the branches that may be taken, each on its own, and unite what they leave behind."""
    live: Reached = (True, not machine.frame.testing)
    before = machine.scope.save()
    ends: list[Snapshot] = []
    left: list[Reached] = []
    for branch in block.branches:
        reached, live = split(live, verdict(machine, branch, live))
        if reached == (False, False):
            machine.try_out(branch.body)
            continue
        machine.scope.restore(before)
        how = run_branch(machine, branch, reached)
        if is_sure(machine, reached) and how:
            raise LeaveError(how)
        if how == "return":
            left.append(reached)
        elif how != "fatal":
            ends.append(machine.scope.save())
    if live != (False, False):
        ends.append(before)
    machine.scope.restore(before)
    if not ends:
        raise LeaveError("return" if left else "fatal")
    machine.scope.unite(ends)
    for reached in left:
        machine.frame = after_leaving(machine.frame, reached)


def verdict(machine: Machine, branch: Branch, live: Reached) -> Reached:
    """Return whether a branch's condition holds with BUILD_TESTING on, and off."""
    if branch.command.name == "else":
        return True, True
    found: list[Truth] = []
    for assumed, alive in zip(("ON", "OFF"), live, strict=True):
        machine.assume = assumed
        found.append(evaluate(machine.words(branch.command), World(machine)) if alive is not False else False)
    machine.assume = None
    return found[0], found[1]


def split(live: Reached, verdict: Reached) -> tuple[Reached, Reached]:
    """Return when a branch is reached, and when what follows it is."""
    reached = both(live[0], verdict[0]), both(live[1], verdict[1])
    return reached, (both(live[0], negated(verdict[0])), both(live[1], negated(verdict[1])))


def is_sure(machine: Machine, reached: Reached) -> bool:
    """Return whether a branch is always taken where its block is."""
    return reached[0] is True and (machine.frame.testing or reached[1] is True)


def run_branch(machine: Machine, branch: Branch, reached: Reached) -> str:
    """Run a branch; return how it left its file or loop, or "".

    colcon builds with BUILD_TESTING on: what runs only without it is a `maybe`.
    """
    testing = reached[1] is False
    sure = reached[0] is True and (testing or reached[1] is True)
    frame = machine.frame
    inner = replace(frame, testing=frame.testing or testing, maybe=frame.maybe or not sure)
    try:
        with machine.framed(inner):
            machine.body(branch.body)
    except LeaveError as leave:
        return leave.how
    return ""


def after_leaving(frame: Frame, reached: Reached) -> Frame:
    """Return the frame behind a block of which a branch ended in `return`: what follows runs only without it."""
    if reached[0] is False:
        return replace(frame, testing=True, maybe=frame.maybe or reached[1] is None)
    if reached[1] is False:
        return frame
    return replace(frame, maybe=True)


def run_foreach(machine: Machine, block: Block) -> None:
    words = machine.words(block.command)
    if not words:
        return
    name, rest = words[0].text, words[1:]
    values = loop_values(machine, rest)
    before = machine.scope.get(name)
    if values is None:
        run_maybe(machine, block, {name: machine.hole()})
    elif not values:
        machine.scope.set(name, machine.hole())
        machine.try_out(block.branches[0].body)
    else:
        run_rounds(machine, block, name, values)
    if before is None:
        machine.scope.variables.pop(name, None)
    else:
        machine.scope.set(name, before)


def run_rounds(machine: Machine, block: Block, name: str, values: Sequence[Word]) -> None:
    for word in values[:MAX_ROUNDS]:
        if word.maybe or word.text == HOLE:
            run_maybe(machine, block, {name: (replace(word, maybe=False),)})
            continue
        machine.scope.set(name, (word,))
        try:
            machine.body(block.branches[0].body)
        except LeaveError as leave:
            if leave.how == "break":
                return
            if leave.how != "continue":
                raise


def run_maybe(machine: Machine, block: Block, variables: Mapping[str, Value]) -> None:
    """Run a body that may run any number of times, and unite what it leaves behind with what was."""
    before = machine.scope.save()
    for name, value in variables.items():
        machine.scope.set(name, value)
    try:
        with machine.framed(replace(machine.frame, maybe=True)):
            machine.body(block.branches[0].body)
    except LeaveError as leave:
        if leave.how == "fatal":
            machine.scope.restore(before)
            return
    machine.scope.unite([before, machine.scope.save()])


def loop_values(machine: Machine, words: Sequence[Word]) -> list[Word] | None:
    """Return what a foreach goes over, None where that is unknown as a whole."""
    if words and words[0].text == "RANGE" and not words[0].quoted:
        return number_range([word.text for word in words[1:]], machine)
    if not (words and words[0].text == "IN" and not words[0].quoted):
        return list(as_value(words))
    found: list[Word] = []
    mode = ""
    for word in words[1:]:
        if word.text in ("LISTS", "ITEMS", "ZIP_LISTS") and not word.quoted:
            mode = word.text
        elif mode == "ZIP_LISTS":
            return None
        else:
            found += machine.value(word.text) if mode == "LISTS" else as_value([word])
    return found


def number_range(texts: list[str], machine: Machine) -> list[Word] | None:
    if not all(text.isdecimal() and len(text) < 6 for text in texts) or not 1 <= len(texts) <= 3:
        return None
    numbers = [int(text) for text in texts]
    start, stop = (0, numbers[0]) if len(numbers) == 1 else (numbers[0], numbers[1])
    step = numbers[2] if len(numbers) == 3 else 1
    return [machine.word(str(n)) for n in range(start, stop + 1, step)][:MAX_ROUNDS] if step else None


def run_while(machine: Machine, block: Block) -> None:
    for _ in range(MAX_ROUNDS):
        truth = evaluate(machine.words(block.command), World(machine))
        if truth is False:
            return
        if truth is None:
            run_maybe(machine, block, {})
            return
        try:
            machine.body(block.branches[0].body)
        except LeaveError as leave:
            if leave.how == "break":
                return
            if leave.how != "continue":
                raise
    raise ExhaustedError


def run_block(machine: Machine, block: Block) -> None:
    """Run `block()` in a scope of its own; with PROPAGATE the named variables go out of it."""
    words = [word.text for word in machine.words(block.command)]
    names = words[words.index("PROPAGATE") + 1 :] if "PROPAGATE" in words else []
    inner = machine.scope = Scope(machine.scope)
    try:
        machine.body(block.branches[0].body)
    finally:
        machine.scope = inner.around or inner
    for name in names:
        machine.scope.set(name, inner.variables.get(name, ()))


def define(machine: Machine, block: Block) -> None:
    """Remember a function or a macro."""
    words = [word.text for word in machine.words(block.command)]
    if words and HOLE not in words[0]:
        macro = block.command.name == "macro"
        function = Function(block.command, block.branches[0].body, machine.frame.path, words[1:], macro)
        machine.functions[words[0].lower()] = function


def invoke(machine: Machine, function: Function, call: Call) -> None:
    """Run a function in a scope of its own, or a macro in that of its caller."""
    bound = arguments(machine, function, call)
    frame = machine.frame
    name = function.command.arguments[0].text
    inner = replace(frame, path=function.path, depth=frame.depth + 1, inside=name)
    inner = replace(inner, bindings=bound if function.macro else {})
    scope = machine.scope
    if not function.macro:
        machine.scope = Scope(scope, dict(bound))
    try:
        with machine.framed(inner):
            machine.body(function.body)
    except LeaveError as leave:
        if leave.how != "return" or function.macro:
            raise
    finally:
        machine.scope = scope


def arguments(machine: Machine, function: Function, call: Call) -> dict[str, Value]:
    """Return the parameters of a function, ARGN, ARGV, ARGC, and ARGV0 and so on, as a call sets them."""
    words, count = call.words, len(function.parameters)
    whole = any(word.text == HOLE or word.maybe for word in words[:count])
    bound: dict[str, Value] = {"ARGV": as_value(words)}
    bound["ARGN"] = machine.hole() if whole else as_value(words[count:])
    for index, name in enumerate(function.parameters):
        bound[name] = machine.hole() if whole else as_value(words[index : index + 1])
    for index, word in enumerate(words[:20]):
        bound[f"ARGV{index}"] = machine.hole() if whole else as_value([word])
    bound["ARGC"] = machine.hole() if whole or call.open_ended else (machine.word(str(len(words))),)
    return bound


BLOCKS: Mapping[str, Callable[[Machine, Block], None]] = {
    "if": run_if,
    "foreach": run_foreach,
    "while": run_while,
    "function": define,
    "macro": define,
    "block": run_block,
}
