"""Rule input: programs that are not intended to be started: a text says so, or others import their module."""

from __future__ import annotations

import ast
from collections.abc import Iterator

from ..languages.python.certain_nodes import is_guard
from ..languages.python.file import PythonFile
from ..languages.python.nodes import FunctionNode, functions_of, nodes_of_kind
from ..lazy_regex import regex
from ..light_dataclasses import dataclass
from ..source import Span
from .unstarted_programs import UnstartedPrograms

START = r"(?:run|start(?:ed)?|launch(?:ed)?|execut(?:ed?|ion)|instantiat(?:ed?|ion)|running|starting|launching)"
WHAT = r"(?:this|me|it|directly|alone|the (?:node|script|file|module|class|program))"
FORBIDS = regex(
    r"(?:\bDO(?: NOT|N'?T) (?:RUN|START|LAUNCH|EXECUTE)\b|(?i:"
    rf"\b(?:do(?: not|n'?t)|never) (?:directly )?{START} {WHAT}(?: (?:node|script|file|module|class|program))?\b"
    rf"|\bnot (?:meant|intended|supposed|designed) (?:to be|for) (?:directly )?{START}\b"
    rf"|\b(?:should|must|can) ?not be (?:directly )?{START}\b))"
    r"(?i:(?! (?:before|after|until|unless|while|when|if|in|on|as|at|with|without|from|more|twice|in)\b))"
)
"""How a text says that what it is about is not to be started at all."""
UNFINISHED = regex(
    r"(?im)^\W*(?:(?:note|warning|status|todo)\W+)?(?:(?:this|the) (?:\w+ ){1,3}(?:is|does) (?:still |currently )?)?"
    r"(?:wip|work in progress|unfinished|deprecated|obsolete|broken|no longer used|unused"
    r"|not (?:yet )?(?:finished|complete|working|work(?: yet)?|used|in use|maintained))(?=\W*$|[.:,;!])"
)
"""How a line begins that says that a program is not finished, or no longer used."""
STALE = "a page says that this program is no longer used, or not finished yet"
UNDONE = "its own text says that it is not finished, or no longer used"
TOLD = "its own text says that it is not to be started"
SPARE = "nothing here starts this program, whose module is there for others"


@dataclass(frozen=True)
class UnintendedStarts:
    programs: UnstartedPrograms

    def why(self, path: str, span: Span) -> str:
        """Return why a place of Python code is not intended to run; "" where it may be."""
        file = self.programs.reached.run.modules.at(path) if path.endswith(".py") else None
        if file is None:
            return ""
        around = [each for each in functions_of(file.tree) if file.span(each).holds(span)]
        entries = self.entries(file, around)
        if any(map(self.programs.is_started, entries)):
            return ""
        texts = [*self.texts(file, around, span)]
        if any(map(FORBIDS.search, texts)):
            return TOLD
        if stale := self.why_stale(file):
            return stale
        return SPARE if self.is_spare(file, around) else ""

    def why_stale(self, file: PythonFile) -> str:
        """Return why a file is unused, by texts on its programs, none of which is started; "" where it may be used."""
        own = [name for name, paths in self.programs.of_programs.items() if file.path in paths]
        if not own or any(map(self.programs.is_started, own)):
            return ""
        if UNFINISHED.search(f"{ast.get_docstring(file.tree) or ''}\n{comments_at_top(file.source.text)}"):
            return UNDONE
        return STALE if all(map(self.programs.is_called_stale, own)) else ""

    def texts(self, file: PythonFile, around: list[FunctionNode], span: Span) -> Iterator[str]:
        """Yield the docstrings and comments of the functions around a place, and of the file where it is started."""
        for each in around:
            yield f"{ast.get_docstring(each) or ''}\n{comment_above(file, file.span(each).start)}"
        guards = (each for each in file.tree.body if isinstance(each, ast.If) and is_guard(each))
        if any(file.span(each).holds(span) for each in guards) or self.entries(file, around):
            yield f"{ast.get_docstring(file.tree) or ''}\n{comments_at_top(file.source.text)}"

    def is_spare(self, file: PythonFile, around: list[FunctionNode]) -> bool:
        """Return whether nothing starts the programs that begin at a place, but programs that import the module."""
        programs, own = self.programs, self.entries(file, around)
        if not own or programs.has(file.path):
            return False
        of_others = (name for name, paths in programs.of_programs.items() if file.path in paths and name not in own)
        return any(map(programs.is_started, of_others))

    def entries(self, file: PythonFile, around: list[FunctionNode]) -> list[str]:
        """Return the programs that begin in functions around a place which no other file uses."""
        module = self.programs.reached.installed.names.get(file.path, "")
        names = {each.name for each in around if each in file.tree.body and not self.is_taken(file, module, each.name)}
        entries = {f"{module}:{name}" for name in names}
        rows = (row for row in self.programs.table.of("executable") if row.entry in entries)
        return [row.destination.rpartition("/")[2] for row in rows]

    def is_taken(self, file: PythonFile, module: str, name: str) -> bool:
        """Return whether another file imports a function of a module, or reads it of the module."""
        last = module.rpartition(".")[2]
        for other, each in self.programs.reached.imports.uses.get(module, []):
            if other is not file and (name in each.names or "*" in each.names or reads(other, last, name)):
                return True
        return False


def reads(file: PythonFile, module: str, name: str) -> bool:
    reading = (each for each in nodes_of_kind(file.tree, ast.Attribute) if each.attr == name)
    return any(ast.unparse(each.value).rpartition(".")[2] == module for each in reading)


def comment_above(file: PythonFile, start: int) -> str:
    """Return the comments directly above a place."""
    lines = file.source.text[:start].split("\n")[:-1]
    found: list[str] = []
    while lines and lines[-1].strip().startswith(("#", "@")):
        found.insert(0, lines.pop())
    return "\n".join(found)


def comments_at_top(text: str) -> str:
    lines = text.split("\n")
    end = next((number for number, line in enumerate(lines) if line.strip() and not line.startswith("#")), len(lines))
    return "\n".join(lines[:end])
