"""What `languages/` and `package/` find is a code; its sentence is in `checks/`."""

from __future__ import annotations

import ast
import re

import pytest
from imports import SRC, modules

from rospkg_cli.checks.interfaces.grammar_sentences import SENTENCES as GRAMMAR
from rospkg_cli.checks.read_sentences import SENTENCES, syntax_sentence, what_is_wrong
from rospkg_cli.languages.syntax_problem import SyntaxProblem
from rospkg_cli.package.interfaces.grammar_problem import GrammarCode
from rospkg_cli.read_problem import ReadProblem
from rospkg_cli.source import Span
from rospkg_cli.unreadable import Unreadable

LONGEST = 9
"""Words of a reason why something is unknown, which is a part of a sentence."""

ENGLISH = re.compile(r"(?<![\w`$({<\\.-])(?:a|an|be|can't|is|it|may|not|of|than|that|the|to|what|which|who)(?![\w`-])")


def long_texts(tree: ast.Module) -> list[str]:
    """Return the texts of a module, docstrings excluded, that read like an English sentence; f-strings as a whole."""
    nodes = list(ast.walk(tree))
    docs = {id(node.value) for node in nodes if isinstance(node, ast.Expr)}
    texts = ["".join(map(piece, node.values)) for node in nodes if isinstance(node, ast.JoinedStr)]
    texts += [piece(node) for node in nodes if isinstance(node, ast.Constant) and id(node) not in docs]
    return [text for text in texts if len(text.split()) > LONGEST and len(ENGLISH.findall(text)) > 1]


def piece(node: ast.expr) -> str:
    return str(node.value) if isinstance(node, ast.Constant) else "_"


@pytest.mark.parametrize("room", ["languages", "package"])
def test_facts_hold_no_sentence_for_users(room: str) -> None:
    found = {name: long_texts(tree) for name, tree in modules().items() if name.partition(".")[0] == room}
    assert {name: texts for name, texts in found.items() if texts} == {}


@pytest.mark.parametrize(("codes", "sentences"), [(ReadProblem, SENTENCES), (GrammarCode, GRAMMAR)])
def test_each_code_has_a_sentence_and_is_found_by_a_reader(codes: type, sentences: dict[object, str]) -> None:
    assert set(sentences) == set(codes)
    text = "".join(path.read_text() for room in ("languages", "package") for path in (SRC / room).rglob("*.py"))
    text += (SRC / "file_text.py").read_text()
    used = set(re.findall(rf"{codes.__name__}\.([A-Z0-9_]+)", text))
    assert used == {code.name for code in codes}  # type: ignore[var-annotated]


def test_a_sentence_names_the_file_and_what_is_wrong_in_it() -> None:
    file = Unreadable("a.xml", Span(0, 0), ReadProblem.XML_MISMATCH, ("a", "b"))
    assert what_is_wrong(file) == "`a.xml` is not well-formed XML: `<a>` is closed by `</b>`"
    problem = SyntaxProblem(Span(0, 0), ReadProblem.SUBSTITUTION_CHARACTER, ("(", "find"))
    assert syntax_sentence(problem) == "`(` is not allowed inside of `$(find …)`: quote it"
