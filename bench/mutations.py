"""Small breaks of Python sources: what a careless edit does to conditions, constants, levels, texts and results."""

from __future__ import annotations

import ast
import random
from collections.abc import Iterator, Sequence
from dataclasses import dataclass
from pathlib import Path

LEVELS = {"ERROR": "WARNING", "WARNING": "INFO", "INFO": "ERROR", "SAFE": "UNSAFE", "UNSAFE": "SAFE"}
FLIPPED: dict[type[ast.cmpop], str] = {
    ast.Eq: "!=", ast.NotEq: "==", ast.Lt: "<=", ast.LtE: "<", ast.Gt: ">=", ast.GtE: ">",
    ast.In: "not in", ast.NotIn: "in", ast.Is: "is not", ast.IsNot: "is",
}  # fmt: skip
NOT_RUN = {"annotation", "returns", "type_params", "bases", "msg"}
"""Fields of syntax nodes that hold types, or what only a failed assertion shows."""

UNTOUCHED = {"examples", "since", "slots", "strict"}
"""Keywords whose values are documents, change nothing that a program can see of itself, or assert (of `zip`)."""


@dataclass(frozen=True)
class Mutant:
    path: Path
    kind: str
    start: int
    """Offsets in UTF-8 bytes, as `ast` counts columns."""
    end: int
    text: str
    lines: range
    """Those that run when the broken code runs."""

    def of(self, source: str) -> str:
        data = source.encode()
        return (data[: self.start] + self.text.encode() + data[self.end :]).decode()


def draw(files: Sequence[Path], count: int, seed: int) -> list[Mutant]:
    """Return so many mutants of the files, of each kind about as many; the same for the same seed and sources."""
    chance, by_kind = random.Random(seed), dict[str, list[Mutant]]()
    for path in files:
        for each in mutants(path):
            by_kind.setdefault(each.kind, []).append(each)
    drawn: list[Mutant] = []
    while len(drawn) < count and by_kind:
        kind = chance.choice(sorted(by_kind))
        mutant = by_kind[kind].pop(chance.randrange(len(by_kind[kind])))
        if not by_kind[kind]:
            del by_kind[kind]
        if changes_something(mutant):
            drawn.append(mutant)
    return drawn


def changes_something(mutant: Mutant) -> bool:
    """Return whether a mutant is Python, and another program than before."""
    source = mutant.path.read_text("utf-8")
    try:
        return ast.dump(ast.parse(mutant.of(source))) != ast.dump(ast.parse(source))
    except SyntaxError:
        return False


def mutants(path: Path) -> Iterator[Mutant]:
    """Yield every mutant of a file. Examples and docs of rules, annotations and assertions are left alone."""
    source = path.read_text("utf-8")
    starts = [0]
    for line in source.encode().split(b"\n"):
        starts.append(starts[-1] + len(line) + 1)

    def at(line: int | None, column: int | None) -> int:
        return starts[(line or 1) - 1] + (column or 0)

    for node, inside in visited(ast.parse(source), False):
        for kind, target, text in breaks(node, inside, source):
            span = at(target.lineno, target.col_offset), at(target.end_lineno, target.end_col_offset)
            yield Mutant(path, kind, *span, text, range(node.lineno, (node.end_lineno or node.lineno) + 1))


def visited(node: ast.AST, inside: bool) -> Iterator[tuple[ast.expr | ast.stmt, bool]]:
    """Yield the nodes of a file that run, each with whether it lies in a function."""
    for name, value in ast.iter_fields(node):
        for child in value if isinstance(value, list) else [value]:
            if name in NOT_RUN or not isinstance(child, ast.AST) or is_text_of_nobody(child):
                continue
            if isinstance(child, ast.keyword) and child.arg in UNTOUCHED:
                continue
            if isinstance(child, ast.expr | ast.stmt):
                yield child, inside
            if isinstance(child, ast.JoinedStr):
                continue  # before Python 3.12 what is in an f-string does not know where it is
            yield from visited(child, inside or (isinstance(node, ast.FunctionDef) and name == "body"))


def is_text_of_nobody(node: ast.AST) -> bool:
    is_docstring = isinstance(node, ast.Expr) and isinstance(node.value, ast.Constant)
    return is_docstring or isinstance(node, ast.Assert | ast.Import | ast.ImportFrom)


def breaks(node: ast.expr | ast.stmt, inside: bool, source: str) -> Iterator[tuple[str, ast.expr | ast.stmt, str]]:
    """Yield what may be broken at a node: the kind, the node to replace, and by what."""

    def code(each: ast.AST) -> str:
        return ast.get_source_segment(source, each) or ""

    match node:
        case ast.If(test=test) | ast.While(test=test) | ast.IfExp(test=test) if code(test) != "TYPE_CHECKING":
            yield "condition", test, f"(not ({code(test)}))"
        case ast.ListComp() | ast.SetComp() | ast.GeneratorExp() | ast.DictComp():
            for test in (each for generator in node.generators for each in generator.ifs):
                yield "condition", test, f"(not ({code(test)}))"
        case ast.Compare(left=left, ops=[op], comparators=[right]):
            yield "comparison", node, f"({code(left)} {FLIPPED[type(op)]} {code(right)})"
        case ast.BoolOp(op=op, values=values):
            word = " or " if isinstance(op, ast.And) else " and "
            yield "junction", node, f"({word.join(f'({code(each)})' for each in values)})"
        case ast.Attribute(value=ast.Name(id="Severity" | "Safety" as enum), attr=attr) if attr in LEVELS:
            yield "level", node, f"{enum}.{LEVELS[attr]}"
        case ast.Constant(value=bool(value)):
            yield "constant", node, str(not value)
        case ast.Constant(value=int(value)):
            yield "constant", node, str(value + 1)
        case ast.Constant(value=str(value)) if inside and value:
            yield "text", node, '""'
        case ast.JoinedStr() if inside:
            yield "text", node, '""'
        case ast.Return(value=value) if value is not None and code(value) != "False":  # None is as false
            yield "result", node, "return None"
        case ast.Expr(value=ast.Yield() | ast.YieldFrom()):
            yield "result", node, "yield from ()"
