"""Messages on parameters that code gets and nothing declares, that it gets twice, and on joint limits."""

from __future__ import annotations

from .joint_limits import MistypedLimit
from .repeated_reads import RepeatedRead
from .unknown_read import UnknownRead

SHOWN = 3


def undeclared(read: UnknownRead) -> str:
    """Return the message about a parameter that code gets and nothing declares."""
    are = "variables are" if read.more else "variable is"
    is_kept = read.is_python or read.has_other
    lost = "the value that is set for it is never seen" if is_kept else f"the {are} never set"
    ends = "the node stops with ParameterNotDeclaredException" if read.throws else lost
    known = f"this file declares `{read.suggestion}` and never gets it"
    hint = known if read.suggestion else "declare it, as the others here" if read.has_others else "declare it"
    names = [f"`{name}`" for name in (read.name, *(name for name, _ in read.more))]
    last = f"{len(names) - SHOWN} more" if len(names) > SHOWN else names.pop()
    named = f"{', '.join(names[:SHOWN])} and {last}" if names else last
    if read.more:
        ends, hint = ends.replace("for it is", "for them is"), "declare them"
    return f"nothing declares the parameter{'s' if read.more else ''} {named}: {ends}; {hint}"


def repeated(read: RepeatedRead) -> str:
    """Return the message about a parameter in whose place another one is got a second time."""
    what = f"`{read.unread}` is declared and never got, and `{read.name}` is got again in its place"
    return f"{what}: the value that is set for `{read.unread}` is dropped; get `{read.unread}` here"


def unread(limit: MistypedLimit) -> str:
    """Return the message about a misspelt limit of a joint."""
    intended = " or ".join(f"`{name}`" for name in limit.intended)
    when = "" if limit.is_met else ", where something opens the file and the value sets a limit"
    return f"no limit of a joint is called `{limit.name}`: the value is dropped{when}; did you mean {intended}?"
