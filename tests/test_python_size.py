"""Python files that are too large, or nested too deeply, for what reads them are skipped, and said to be."""

from __future__ import annotations

import ast

import pytest

from rospkg_cli.checks.read_sentences import what_is_wrong
from rospkg_cli.languages.python import syntax
from rospkg_cli.languages.python.file import parse_python
from rospkg_cli.languages.python.size_limits import MAX_DEPTH, MAX_TOKENS
from rospkg_cli.source import Source
from rospkg_cli.unreadable import Unreadable, UnreadableError


def refused(text: str) -> Unreadable:
    with pytest.raises(UnreadableError) as caught:
        parse_python(Source("a.py", text))
    return caught.value.unreadable


@pytest.mark.parametrize("line", ["a;", "a,", "é;", "f(1)\n"])
def test_too_many_tokens(line: str) -> None:
    found = refused(line * MAX_TOKENS)
    assert found.skipped
    assert what_is_wrong(found).startswith("`a.py` is skipped: it has more than 200,000 tokens")


def test_long_texts_and_comments_are_few_tokens() -> None:
    text = "# a b c d\n" * 50_000 + "x = '" + "a " * MAX_TOKENS + '\'\ny = """' + 'b " ' * MAX_TOKENS + '"""\n'
    assert len(parse_python(Source("a.py", text)).tree.body) == 2


DEEP = [
    lambda n: "x = " + "-" * n + "1\n",
    lambda n: "x = " + "not " * n + "y\n",
    lambda n: "x = 1" + " + 1" * n + "\n",
    lambda n: "x = a" + ".b" * n + "\n",
    lambda n: "x = a" + "()" * n + "\n",
    lambda n: "x = a" + "[0]" * n + "\n",
    lambda n: "x = " + "lambda: " * n + "1\n",
    lambda n: "x = " + "1 if a else " * n + "2\n",
    lambda n: "if a: pass\n" + "elif a: pass\n" * n,
]


@pytest.mark.parametrize("make", DEEP)
@pytest.mark.parametrize("depth", [MAX_DEPTH, 900, 2_500, 30_000])
def test_too_deep(make, depth: int) -> None:  # type: ignore[no-untyped-def]
    found = refused(make(depth))
    assert "nested" in what_is_wrong(found)
    assert not found.grammar


def test_what_is_just_not_too_deep_can_be_visited() -> None:
    for make in DEEP:
        file = parse_python(Source("a.py", make(MAX_DEPTH - 10)))
        assert file.imports == ()
        assert file.definitions.keys() <= {"x"}
        assert not file.has_dynamic_names


def test_a_line_is_decoded_once(monkeypatch: pytest.MonkeyPatch) -> None:
    made: list[str] = []
    table = syntax.CharTable
    monkeypatch.setattr(syntax, "CharTable", lambda text: made.append(text) or table(text))
    file = parse_python(Source("a.py", "x = 'é'; " + "y = 1; " * 50 + "z = 'ü'\n"))
    shown = [file.text(node.targets[0]) for node in file.tree.body if isinstance(node, ast.Assign)]
    assert shown == ["x", *["y"] * 50, "z"]
    assert len(made) == 1
