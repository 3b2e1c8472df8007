"""Commands nested in their blocks: `if` to `endif`, `foreach` to `endforeach`, and so on."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Sequence

from ...light_dataclasses import dataclass, field
from ...read_problem import ReadProblem
from ..syntax_problem import SyntaxProblem
from .syntax import CommandInvocation

CLOSED_BY = {
    "if": "endif",
    "foreach": "endforeach",
    "while": "endwhile",
    "function": "endfunction",
    "macro": "endmacro",
    "block": "endblock",
}
OPENED_BY = {end: begin for begin, end in CLOSED_BY.items()}
BETWEEN = ("elseif", "else")


@dataclass(slots=True)
class Branch:
    """A command that opens a block or continues it (`elseif`, `else`), and the commands below it."""

    command: CommandInvocation
    body: list[CommandInvocation | Block] = field(default_factory=list)


@dataclass(slots=True)
class Block:
    """`if` has a branch for each alternative, all others have one."""

    branches: list[Branch]
    end: CommandInvocation | None = None

    @property
    def command(self) -> CommandInvocation:
        return self.branches[0].command


def commands_in(body: Iterable[CommandInvocation | Block]) -> Iterator[CommandInvocation]:
    """Yield, in no order, the commands of a body, those of inner blocks too."""
    waiting = [*body]
    while waiting:
        each = waiting.pop()
        if isinstance(each, Block):
            waiting += [below for branch in each.branches for below in branch.body]
        else:
            yield each


def nest(commands: Sequence[CommandInvocation]) -> tuple[list[CommandInvocation | Block], list[SyntaxProblem]]:
    """Return the commands of a file nested in their blocks, and the problems of nesting."""
    top: list[CommandInvocation | Block] = []
    stack: list[Block] = []
    problems: list[SyntaxProblem] = []
    for command in commands:
        body = stack[-1].branches[-1].body if stack else top
        if command.name in CLOSED_BY:
            block = Block([Branch(command)])
            body.append(block)
            stack.append(block)
        elif command.name in BETWEEN:
            if not stack or not may_have_alternative(stack[-1]):
                problems.append(misplaced(command, stack))
            else:
                stack[-1].branches.append(Branch(command))
        elif command.name in OPENED_BY:
            if not stack or CLOSED_BY[stack[-1].command.name] != command.name:
                problems.append(misplaced(command, stack))
            else:
                stack.pop().end = command
        else:
            body.append(command)
    problems += [unclosed(block.command) for block in stack]
    return top, problems


def may_have_alternative(block: Block) -> bool:
    """Return whether an `elseif` or `else` may follow."""
    return block.command.name == "if" and block.branches[-1].command.name != "else"


def misplaced(command: CommandInvocation, stack: Sequence[Block]) -> SyntaxProblem:
    if not stack:
        wanted = OPENED_BY.get(command.name, "if")
        return SyntaxProblem(command.name_span, ReadProblem.CMAKE_OUTSIDE, (command.name, wanted))
    opened = stack[-1].command.name
    return SyntaxProblem(command.name_span, ReadProblem.CMAKE_WRONG_END, (command.name, CLOSED_BY[opened], opened))


def unclosed(command: CommandInvocation) -> SyntaxProblem:
    return SyntaxProblem(command.name_span, ReadProblem.CMAKE_OPEN_BLOCK, (command.name, CLOSED_BY[command.name]))
