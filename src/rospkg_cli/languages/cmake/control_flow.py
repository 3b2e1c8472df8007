"""Run `if`; the table of functions that run blocks."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from ...light_dataclasses import replace
from .call_stack import Frame, LeaveError
from .command_blocks import Block, Branch
from .condition import evaluate
from .condition_context import InterpreterContext
from .functions import define_function, run_block
from .interpreter import Interpreter
from .loops import run_foreach, run_while
from .truth import Truth, and_, not_
from .variable_scope import Snapshot

Reached = tuple[Truth, Truth]
"""Whether a place is reached with BUILD_TESTING on, and off."""


def run_if(interpreter: Interpreter, block: Block) -> None:
    """Run the branches that may be taken, each from the same state, and merge their results."""
    live: Reached = (True, not interpreter.frame.testing)
    before = interpreter.save()
    ends: list[Snapshot] = []
    left: list[Reached] = []
    for branch in block.branches:
        reached, live = split_reached(live, evaluate_branch(interpreter, branch, live))
        if reached == (False, False):
            interpreter.run_unreachable(branch.body)
            continue
        interpreter.scope.restore(before)
        how = run_branch(interpreter, branch, reached)
        if is_certain(interpreter, reached) and how:
            raise LeaveError(how)
        if how == "return":
            left.append(reached)
        elif how != "fatal":
            ends.append(interpreter.save())
    if live != (False, False):
        ends.append(with_defined(before, asked_name(interpreter, block)))
    interpreter.scope.restore(before)
    if not ends:
        raise LeaveError("return" if left else "fatal")
    interpreter.unite(ends)
    for reached in left:
        interpreter.frame = frame_after_return(interpreter.frame, reached)


def asked_name(interpreter: Interpreter, block: Block) -> str:
    """Return the variable that has a value where a block's one branch is not taken: `if(NOT DEFINED name)`."""
    first, *others = block.branches
    words = [] if others else interpreter.words(first.command)
    texts = [word.text for word in words]
    start = next((n for n in (2, 1) if texts[:n] == ["NOT", "DEFINED"][:n]), 0)
    name, rest = "".join(texts[start : start + 1]), words[start + 1 :]
    is_alone = not rest or (texts[start + 1] == "AND" and evaluate(rest[1:], InterpreterContext(interpreter)) is True)
    return name if start and is_alone else ""


def with_defined(state: Snapshot, name: str) -> Snapshot:
    """Return variables of which one certainly has the value that it may have."""
    found = next((level[name] for level in state if name in level), ())
    if len(found) != 1 or not found[0].maybe:
        return state
    place = next(at for at, level in enumerate(state) if name in level)
    changed = {**state[place], name: (replace(found[0], maybe=False),)}
    return tuple(changed if at == place else level for at, level in enumerate(state))


def evaluate_branch(interpreter: Interpreter, branch: Branch, live: Reached) -> Reached:
    """Return whether a branch's condition holds with BUILD_TESTING on, and off."""
    if branch.command.name == "else":
        return True, True
    found: list[Truth] = []
    for assumed, alive in zip(("ON", "OFF"), live, strict=True):
        interpreter.assume = assumed
        found.append(
            evaluate(interpreter.words(branch.command), InterpreterContext(interpreter))
            if alive is not False
            else False
        )
    interpreter.assume = None
    return found[0], found[1]


def split_reached(live: Reached, evaluate_branch: Reached) -> tuple[Reached, Reached]:
    """Return when a branch is reached, and when what follows it is."""
    reached = and_(live[0], evaluate_branch[0]), and_(live[1], evaluate_branch[1])
    return reached, (and_(live[0], not_(evaluate_branch[0])), and_(live[1], not_(evaluate_branch[1])))


def is_certain(interpreter: Interpreter, reached: Reached) -> bool:
    """Return whether a branch is always taken where its block is."""
    return reached[0] is True and (interpreter.frame.testing or reached[1] is True)


def run_branch(interpreter: Interpreter, branch: Branch, reached: Reached) -> str:
    """Run a branch; return how it left its file or loop, or "".

    colcon builds with BUILD_TESTING on: what runs only without it is a `maybe`.
    """
    testing = reached[1] is False
    sure = reached[0] is True and (testing or reached[1] is True)
    frame = interpreter.frame
    inner = replace(frame, testing=frame.testing or testing, maybe=frame.maybe or not sure)
    try:
        with interpreter.enter_frame(inner):
            interpreter.body(branch.body)
    except LeaveError as leave:
        return leave.how
    return ""


def frame_after_return(frame: Frame, reached: Reached) -> Frame:
    """Return the frame behind a block of which a branch ended in `return`: what follows runs only without it."""
    if reached[0] is False:
        return replace(frame, testing=True, maybe=frame.maybe or reached[1] is None)
    if reached[1] is False:
        return frame
    return replace(frame, maybe=True)


BLOCKS: Mapping[str, Callable[[Interpreter, Block], None]] = {
    "if": run_if,
    "foreach": run_foreach,
    "while": run_while,
    "function": define_function,
    "macro": define_function,
    "block": run_block,
}
