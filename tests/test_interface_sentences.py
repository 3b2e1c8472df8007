"""The sentences on what rosidl refuses, one text for each."""

from __future__ import annotations

import pytest

from rospkg_cli.checks.interfaces.grammar_sentences import SENTENCES, sentence_of, title_of
from rospkg_cli.package.interfaces.grammar_problem import GrammarCode, GrammarProblem
from rospkg_cli.package.interfaces.text import parse_interface
from rospkg_cli.source import Source, Span

SAID = (
    (
        "srv",
        "int32 a\n --- \nint32 b\n",
        (
            "rosidl takes only a line that is exactly `---` for a separator, without spaces around it: the build "
            "stops here"
        ),
        "write `---`",
    ),
    (
        "msg",
        "int32 a\n---\nint32 b\n",
        "a .msg file has no line `---`; this one is too many, and the build stops here",
        "",
    ),
    ("srv", "int32 a", "a .srv file has exactly one line `---` between request and response; here is none", ""),
    (
        "action",
        "int32 a\n---\nint32 b\n",
        "a .action file has exactly two lines `---` between goal, result and feedback; here is 1",
        "",
    ),
    (
        "msg",
        " int32 a",
        "rosidl can't read a line that begins with a blank: the build stops with an IndexError",
        "remove the blanks",
    ),
    ("msg", "int32", "`int32` lacks a blank between a type and a name", ""),
    ("msg", "string a 'x=y'", "rosidl reads a line with `=` as a constant; a default value can't hold one", ""),
    ("msg", "int32 a b=1", "rosidl reads a line with `=` as a constant; a default has none", ""),
    ("msg", "int32[] A=1", "a constant has a primitive type without bounds or brackets, not `int32[]`", ""),
    ("msg", "int32 [] a", "the brackets belong to the type, without a blank: `int32[] …`", ""),
    ("msg", "int32 a;", "a line ends without `;`: one field a line", "remove the `;`"),
    ("msg", "int32 a.b", "`a.b` is no name of a field: lowercase letters, digits and single `_`", ""),
    ("msg", "string a 'x#y'", "rosidl cuts the line at the `#`, even inside quotes: the value becomes `'x`", ""),
    ("msg", "string[] a ['ä']", "rosidl can't write default values of string arrays that are not ASCII", ""),
    (
        "msg",
        "string a '\\x'",
        "rosidl decodes the backslashes in `'\\x'` as escapes and then can't read what it wrote; double them",
        "",
    ),
    ("msg", "int32] a", "`int32]` has a `]` without a `[`; an array is `int32[]`", ""),
    ("msg", "int32[0] a", "`0` is no size of an array: write `int32[]`, `int32[3]` or `int32[<=3]`", ""),
    ("msg", "string<=0 a", "`string<=0` needs a whole number above 0 behind `<=`: `string<=10`", ""),
    ("msg", "long a", "`long` is no type of rosidl; the build stops here: write `int64`", "write `int64`"),
    (
        "msg",
        "time a",
        "`time` is a type of ROS 1; rosidl can't generate it: write `builtin_interfaces/Time`",
        "write `builtin_interfaces/Time`",
    ),
    (
        "msg",
        "std_msgs/msg/String a",
        "rosidl refuses `std_msgs/msg/String`: in an interface file it is written `std_msgs/String`",
        "write `std_msgs/String`",
    ),
    ("msg", "a/b/c/D a", "`a/b/c/D` is no type: write `package/Name`", ""),
    (
        "msg",
        "My-Pkg/Name a",
        "`My-Pkg` in `My-Pkg/Name` can't be the name of a package: lowercase, digits and single `_`",
        "",
    ),
    (
        "msg",
        "int32[][] a",
        "`int32[]` is no type: an array has one pair of brackets, without spaces: `int32[]`, `int32[3]`",
        "",
    ),
    (
        "msg",
        "point a",
        "`point` is no type: primitive types are `bool`, `int32`, `float64`, `string` …; others are CamelCase",
        "",
    ),
    (
        "msg",
        "geometry_msgs/Point a 1",
        "`geometry_msgs/Point` can't have a default value: only primitive types can",
        "",
    ),
    ("msg", "int32[] a 1", "the value of an array stands in brackets: `[1]`", ""),
    ("msg", "string[] a [,'x']", "`[,'x']` can't be split into its elements; quote each string: `['a', 'b']`", ""),
    ("msg", "int32[<=2] a [1,2,3]", "`int32[<=2]` takes at most 2 elements, not 3", ""),
    ("msg", "int32[2] a [1]", "`int32[2]` takes exactly 2 elements, not 1", ""),
    ("msg", "bool a yes", "`yes` is no `bool`: write `true` or `false`", ""),
    ("msg", "uint8 a 300", "`300` is no `uint8`: 0 to 255", ""),
    ("msg", "float32 a x", "`x` is no `float32`: write it like `1.5` or `1e-3`", ""),
    (
        "msg",
        "string a 'it's'",
        "write a quote inside the string as `\\'`, or use the other kind of quotes around it",
        "",
    ),
    ("msg", "string<=2 a 'xyz'", "the string has 3 characters; `string<=2` takes 2", ""),
    (
        "msg",
        "int32 a # [m\n  # s]\n",
        (
            "rosidl takes `[m` and the next line for a unit, and generates an .idl file with a broken string "
            "from it; keep what stands in brackets on one line, or use parentheses"
        ),
        "",
    ),
    (
        "msg",
        "int32 a # \\x",
        (
            "rosidl decodes `\\x` in a comment as an escape: the build stops with a UnicodeDecodeError or a syntax "
            "error; double the backslash, or do without it"
        ),
        "double the backslash",
    ),
)
"""Kind, text, the sentence on its first problem, and the title of the repair."""


def first_problem(kind: str, text: str) -> GrammarProblem:
    return parse_interface(Source(f"{kind}/Foo.{kind}", text), kind).problems[0]


@pytest.mark.parametrize(("kind", "text", "sentence", "title"), SAID)
def test_what_is_said(kind: str, text: str, sentence: str, title: str) -> None:
    problem = first_problem(kind, text)
    assert sentence_of(problem) == sentence
    assert (title_of(problem) if problem.repair is not None else "") == title


def test_every_problem_has_a_sentence_that_a_text_shows() -> None:
    mark = GrammarProblem(Span(0, 0), GrammarCode.BYTE_ORDER_MARK)
    shown = {mark.code, *(first_problem(kind, text).code for kind, text, _, _ in SAID)}
    assert shown == set(GrammarCode) == set(SENTENCES)
    assert sentence_of(mark).startswith("the file begins with a byte order mark")
