"""The sentences about what xacro refuses while it expands a robot."""

from __future__ import annotations

from collections.abc import Iterable

from ...lazy_regex import regex
from ...package.urdf.expansion.expansion import FoundProblem, XacroProblem
from ...suggest import is_slip, nearest
from ..enumeration import in_ticks
from ..fault import Fault, Level, joined, softer
from .similar_names import only_near
from .xacro_calls import XacroCalls

STOPS = "xacro stops here"
SENTENCES = {
    XacroProblem.MACRO: "no macro is called `{name}`{hint}: " + STOPS,
    XacroProblem.NAME: "no property or parameter is called `{name}`{hint}: " + STOPS,
    XacroProblem.ARGUMENT: "no `<xacro:arg>` declares `{name}`{hint}: unless it is given, " + STOPS,
    XacroProblem.PARAMETER: "the macro `{macro}` has no parameter `{name}`{hint}: " + STOPS,
    XacroProblem.MISSING: "the macro `{macro}` needs its parameter `{name}`: " + STOPS,
    XacroProblem.FEW_BLOCKS: "the macro `{macro}` needs an element for its block `{name}`: " + STOPS,
    XacroProblem.MANY_BLOCKS: "the macro `{macro}` has no block for the element `<{name}>`: " + STOPS,
    XacroProblem.BLOCK: "no block is called `{name}`{hint}: " + STOPS,
    XacroProblem.CONDITION: "this condition is `{name}`, which is neither true nor false: " + STOPS,
}
LACKING = regex(r"the macro `([^`]*)` needs its parameter (.*)")
UNPREFIXED = {XacroProblem.NAME: "property", XacroProblem.MACRO: "macro"}
"""Elements that old files write without the prefix `xacro:`; xacro 2.1.1 ignores those."""

WITHOUT_PREFIX = (
    "the `<{0}>` that defines this lacks its `xacro:`: xacro passes over it and stops here; write `<xacro:{0}>`"
)
BY_NAME = (XacroProblem.MACRO, XacroProblem.NAME, XacroProblem.BLOCK)
"""What may be defined by a file that is not here."""


def problem_fault(problem: FoundProblem, calls: XacroCalls, *, is_sure: bool) -> Fault | None:
    """Return the fault that a problem is; None where what is not known may make it none.

    It is sure in a robot of its own, of which all files are here; else a near name is needed that nothing defines.
    """
    is_sure = is_sure and problem.is_certain
    near = (
        nearest(problem.name, problem.known)
        if is_sure and problem.is_closed
        else only_near(problem.name, problem.known)
    )
    if problem.kind is XacroProblem.MACRO and not near and not (is_sure and problem.is_closed):
        near = only_near(problem.name, calls.macros)
    named = problem.kind in BY_NAME or problem.kind is XacroProblem.ARGUMENT
    may_be_elsewhere = problem.kind is XacroProblem.ARGUMENT or (
        problem.kind in BY_NAME and not (is_sure and problem.is_closed)
    )
    if may_be_elsewhere and (not near or not is_slip(problem.name, near) or calls.is_defined(problem.name)):
        return None
    if problem.kind in UNPREFIXED and calls.is_unprefixed(UNPREFIXED[problem.kind], problem.name):
        message = WITHOUT_PREFIX.format(UNPREFIXED[problem.kind])
        return Fault(problem.span, message, None if is_sure else "warning")
    hint = f" (did you mean `{near}`?)" if near and (named or problem.kind is XacroProblem.PARAMETER) else ""
    message = SENTENCES[problem.kind].format(name=problem.name, hint=hint, macro=problem.macro)
    if not problem.is_certain:
        return softer(Fault(problem.span, message), "warning", "where the condition around it holds")
    level: Level | None = "warning" if may_be_elsewhere or not is_sure else None
    return Fault(problem.span, message, level)


def of_one_parameter(faults: Iterable[Fault]) -> list[Fault]:
    """Return the faults with those as one that are calls of several macros without the same parameter."""
    groups: dict[object, list[Fault]] = {}
    for fault in faults:
        lacking = LACKING.fullmatch(fault.message)
        groups.setdefault((lacking.group(2), fault.level) if lacking else id(fault), []).append(fault)
    return [same[0] if len(same) == 1 else joined(same, of_macros(same), "") for same in groups.values()]


def of_macros(faults: Iterable[Fault]) -> str:
    found = [match for fault in faults if (match := LACKING.fullmatch(fault.message))]
    return f"the macros {in_ticks(match.group(1) for match in found)} need their parameter {found[0].group(2)}"
