"""Conditions of Python code on the operating system, as they are on Linux."""

from __future__ import annotations

import ast

SYSTEMS = {"system()": "linux", "sys.platform": "linux", "platform": "linux", "os.name": "posix"}
"""How code asks, by the end of what it says, and the answer in small letters."""

KNOWN = ("linux", "posix", "win32", "win64", "windows", "nt", "cygwin", "msys", "darwin", "macos", "java", "freebsd")
"""What may be the answer; a `platform` that is compared with another word is no operating system."""


def holds_on_linux(test: ast.expr) -> bool | None:
    """Return whether a condition on the system holds on Linux; None where it asks for something else."""
    match test:
        case ast.UnaryOp(op=ast.Not(), operand=operand):
            inside = holds_on_linux(operand)
            return None if inside is None else not inside
        case ast.Compare(left=ast.Constant(value=str(part)), ops=[ast.In()], comparators=[asked]):
            answer = answer_of(asked)
            is_known = any(part.lower() in each for each in KNOWN)
            return part.lower() in answer if answer and is_known else None
        case ast.Compare(left=asked, ops=[operator], comparators=[values]):
            answer, names = answer_of(asked), names_in(values)
            if not answer or not names or not set(names).issubset(KNOWN):
                return None
            if not isinstance(operator, ast.Eq | ast.NotEq | ast.In | ast.NotIn):
                return None
            return (answer in names) is isinstance(operator, ast.Eq | ast.In)
        case ast.Call(func=ast.Attribute(value=asked, attr="startswith"), args=[ast.Constant(value=str(start))]):
            answer = answer_of(asked)
            is_known = any(each.startswith(start.lower()) for each in KNOWN)
            return answer.startswith(start.lower()) if answer and is_known else None
    return None


def answer_of(asked: ast.expr) -> str:
    """Return what Linux answers to a question for the system; "" where it is none."""
    while isinstance(asked, ast.Call) and isinstance(asked.func, ast.Attribute) and asked.func.attr == "lower":
        asked = asked.func.value
    text = ast.unparse(asked) if isinstance(asked, ast.Name | ast.Attribute | ast.Call) else ""
    return next((answer for end, answer in SYSTEMS.items() if text == end or text.endswith(f".{end}")), "")


def names_in(values: ast.expr) -> list[str]:
    """Return the names of systems in a text or in a list of them, in small letters, `linux2` as the first."""
    each = values.elts if isinstance(values, ast.List | ast.Tuple | ast.Set) else [values]
    texts = [one.value for one in each if isinstance(one, ast.Constant) and isinstance(one.value, str)]
    return [text.lower().replace("linux2", "linux") for text in texts] if len(texts) == len(each) else []
