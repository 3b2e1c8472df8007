"""What `if` does, and which function runs which block."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace

from .call_stack import Frame, LeaveError
from .command_blocks import Block, Branch
from .condition import Truth, both, evaluate, negated
from .condition_context import InterpreterContext
from .functions import define, run_block
from .interpreter import Interpreter
from .loops import run_foreach, run_while
from .variable_scope import Snapshot

Reached = tuple[Truth, Truth]
"""Whether a place is reached with BUILD_TESTING on, and off."""


def run_if(machine: Interpreter, block: Block) -> None:
    """Run the branches that may be taken, each on its own, and unite what they leave behind."""
    live: Reached = (True, not machine.frame.testing)
    before = machine.save()
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
            ends.append(machine.save())
    if live != (False, False):
        ends.append(before)
    machine.scope.restore(before)
    if not ends:
        raise LeaveError("return" if left else "fatal")
    machine.unite(ends)
    for reached in left:
        machine.frame = after_leaving(machine.frame, reached)


def verdict(machine: Interpreter, branch: Branch, live: Reached) -> Reached:
    """Return whether a branch's condition holds with BUILD_TESTING on, and off."""
    if branch.command.name == "else":
        return True, True
    found: list[Truth] = []
    for assumed, alive in zip(("ON", "OFF"), live, strict=True):
        machine.assume = assumed
        found.append(
            evaluate(machine.words(branch.command), InterpreterContext(machine)) if alive is not False else False
        )
    machine.assume = None
    return found[0], found[1]


def split(live: Reached, verdict: Reached) -> tuple[Reached, Reached]:
    """Return when a branch is reached, and when what follows it is."""
    reached = both(live[0], verdict[0]), both(live[1], verdict[1])
    return reached, (both(live[0], negated(verdict[0])), both(live[1], negated(verdict[1])))


def is_sure(machine: Interpreter, reached: Reached) -> bool:
    """Return whether a branch is always taken where its block is."""
    return reached[0] is True and (machine.frame.testing or reached[1] is True)


def run_branch(machine: Interpreter, branch: Branch, reached: Reached) -> str:
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


BLOCKS: Mapping[str, Callable[[Interpreter, Block], None]] = {
    "if": run_if,
    "foreach": run_foreach,
    "while": run_while,
    "function": define,
    "macro": define,
    "block": run_block,
}
