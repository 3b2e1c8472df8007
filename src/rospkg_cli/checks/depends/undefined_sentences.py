"""What is said of names that nothing binds (DEP117)."""

from __future__ import annotations

from ...suggest import nearest
from .own_members import is_own_member
from .undefined_uses import UndefinedUse
from .unset_members import UnsetMember
from .unwritten_parts import UNWRITTEN

ENDS = {
    "certainly": "the start ends here with NameError",
    "maybe": "the line raises NameError when it runs",
    "branch": "the line raises NameError where its condition holds",
    "late": "the line raises NameError where `spin` returns, which Ctrl-C leaves by an exception of its own",
    "ended": "the line raises NameError once the loop has ended in which the program stays",
    "unspun": "the line raises NameError when its callback runs, and nothing spins the node",
    "seldom": "the line raises NameError where several conditions hold at once",
    "unshown": "the line raises NameError once a program reaches it, which nothing here shows",
    "aside": "the line raises NameError when somebody runs this file, which nothing installs",
    "never": "the line raises NameError once something calls it, which nothing here does",
}
OF_TYPE = "before Python 3.14, which Lyrical has, importing the module raises NameError"
CAUGHT = "NameError is raised each time, which the `except` around it takes for another failure"


def advice(use: UndefinedUse, line: str) -> str:
    """Return the advice on a name; `line` imports it from the standard library, "" where none does."""
    name = use.found.name
    if line or use.home:
        return f"; add `{line or use.home}`"
    if is_own_member(use.file, name, use.found.span):
        return f"; did you mean `self.{name}`?"
    near = nearest(name, use.found.known)
    return f"; did you mean `{near}`?" if near else ""


def of_member(member: UnsetMember) -> str:
    owner, better = member.owner, member.better
    ends = ENDS[member.when].replace("NameError", "AttributeError")
    if better == "Node":
        return f"`{owner}` is no node and has no `{member.name}`: {ends}; write `class {owner}(Node)`"
    if member.is_unwritten:
        return f"`{owner}` has no `{member.name}`, and nothing gives it one: {ends}{UNWRITTEN}"
    near = f"; did you mean `self.{better}`?" if better else ""
    return f"`{owner}` has no `{member.name}`, and nothing gives it one: {ends}{near}"
