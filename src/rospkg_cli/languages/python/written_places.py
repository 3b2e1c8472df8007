"""The arguments by which Python code names the files that it writes: `open(path, "w")`, `shutil.move(other, path)`."""

from __future__ import annotations

import ast
from collections.abc import Callable, Iterator

from ...lazy_regex import regex
from .nodes import last_name

MODE = regex(r"[bt+]{0,2}[wxa][bt+]{0,2}")
METHODS = frozenset({"write_text", "write_bytes", "touch"})
TO_SECOND = frozenset({"copy", "copy2", "copyfile", "move", "rename", "replace"})
FIRST = frozenset(
    {"imwrite", "imsave", "savefig", "savez", "to_csv", "to_json", "to_excel", "write_point_cloud", "write"}
)
EITHER = frozenset({"save"})
"""`np.save(path, values)`, `torch.save(model, path)`."""
TO = frozenset({"dst", "path", "fname", "filename"})
RUNNERS = frozenset({"system", "popen", "run", "call", "check_call", "check_output", "Popen"})
PROCESSES = frozenset({"ExecuteProcess", "ExecuteLocal"})


def written_by(call: ast.Call) -> Iterator[ast.expr]:
    """Yield the expressions that may be the path which a call writes to."""
    name, method = last_name(call.func), call.func.value if isinstance(call.func, ast.Attribute) else None
    if name == "open":
        first = call.args[0] if call.args else None
        modes = [*call.args[1:2], *(each.value for each in call.keywords if each.arg == "mode")]
        if is_mode(first) and method is not None:
            yield method
        elif (opened := first or method) is not None and any(map(is_mode, modes)):
            yield opened
    elif name in METHODS and method is not None:
        yield method
    elif name in TO_SECOND:
        yield from (*call.args[1:2], *named(call))
    elif name in FIRST or name in EITHER:
        yield from (*call.args[: 2 if name in EITHER else 1], *named(call))


def named(call: ast.Call) -> Iterator[ast.expr]:
    yield from (each.value for each in call.keywords if each.arg in TO)


def commands(call: ast.Call, held: Callable[[ast.expr], ast.expr]) -> list[ast.expr]:
    """Return the words of the command that a call runs; none where it runs none. `held` is what a variable holds."""
    name = last_name(call.func)
    given = call.args[:1] if name in RUNNERS else []
    given = [each.value for each in call.keywords if each.arg == "cmd"] if name in PROCESSES else given
    lines = map(held, given)
    return [word for line in lines for word in (line.elts if isinstance(line, ast.List) else [line])]


def is_mode(node: ast.expr | None) -> bool:
    """Return whether a literal is a mode in which open() makes a file that is not there."""
    return isinstance(node, ast.Constant) and isinstance(node.value, str) and MODE.fullmatch(node.value) is not None
