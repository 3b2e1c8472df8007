"""Items put into lists and taken out of them: the code still means the same plus or minus one, and looks as it did."""

from __future__ import annotations

import ast

import pytest
from hypothesis import given
from hypothesis import strategies as st

from rospkg_cli.edits.python_list import append, remove
from rospkg_cli.finding import Edit
from rospkg_cli.languages.python.file import parse_python
from rospkg_cli.source import Source, Span


def parts(text: str) -> tuple[Source, Span, list[Span]]:
    file = parse_python(Source("a.py", text))
    (statement,) = file.tree.body
    assert isinstance(statement, ast.Assign)
    shown = statement.value
    assert isinstance(shown, ast.List)
    return file.source, file.span(shown), [file.span(item) for item in shown.elts]


def applied(text: str, edits: tuple[Edit, ...]) -> str:
    for edit in sorted(edits, key=lambda e: e.span, reverse=True):
        text = text[: edit.span.start] + edit.text + text[edit.span.end :]
    return text


def appended(text: str) -> str:
    source, brackets, items = parts(text)
    return applied(text, append(source, brackets, items, "'new'"))


@pytest.mark.parametrize(
    "before, after",
    [
        ("x = []", "x = ['new']"),
        ("x = ['a']", "x = ['a', 'new']"),
        ("x = ['a', ]", "x = ['a', 'new', ]"),
        ("x = [\n]", "x = [\n'new']"),
        ("x = [\n    'a',\n]", "x = [\n    'a',\n    'new',\n]"),
        ("x = [\n    'a'\n]", "x = [\n    'a',\n    'new',\n]"),
        ("x = [\n    'a',  # why\n]", "x = [\n    'a',  # why\n    'new',\n]"),
        ("x = [\n    'a'  # why\n]", "x = [\n    'a',  # why\n    'new',\n]"),
        ("x = [\n    'a', 'b',\n]", "x = [\n    'a', 'b', 'new',\n]"),
        ("x = [\n    'a',\n    'b']", "x = [\n    'a',\n    'b',\n    'new']"),
        ("x = ['a',\n     'b']", "x = ['a',\n     'b',\n     'new']"),
    ],
)
def test_append(before: str, after: str) -> None:
    assert appended(before) == after


@pytest.mark.parametrize(
    "before, index, after",
    [
        ("x = ['a']", 0, "x = []"),
        ("x = ['a', 'b']", 0, "x = ['b']"),
        ("x = ['a', 'b']", 1, "x = ['a']"),
        ("x = [\n    'a',  # why\n    'b',\n]", 0, "x = [\n    'b',\n]"),
        ("x = [\n    'a',\n    'b'\n]", 1, "x = [\n    'a',\n]"),
        ("x = [\n    'a', 'b',\n]", 0, "x = [\n    'b',\n]"),
        ("x = [\n    'a',\n    'b']", 1, "x = [\n    'a']"),
    ],
)
def test_remove(before: str, index: int, after: str) -> None:
    source, _, items = parts(before)
    assert applied(before, (remove(source, items[index]),)) == after


SEPARATORS = st.sampled_from([", ", ",", ",\n    ", "  ,\n", ",  # c\n    ", "\n    , ", "  # c\n    ,\n"])
ENDS = st.sampled_from(["", ",", ",\n", "\n", "  # c\n", ",  # c\n", "  # c\n,"])


@given(st.lists(SEPARATORS, max_size=4), st.sampled_from(["", "\n    "]), ENDS)
def test_the_code_means_what_it_should(separators: list[str], start: str, end: str) -> None:
    text = "x = [" + start + "".join(f"'{i}'{s}" for i, s in enumerate(separators)) + f"'last'{end}]"
    values = [*map(str, range(len(separators))), "last"]
    assert ast.literal_eval(appended(text)[4:]) == [*values, "new"]
    source, _, items = parts(text)
    for index, item in enumerate(items):
        left = applied(text, (remove(source, item),))
        assert ast.literal_eval(left[4:]) == values[:index] + values[index + 1 :]
