"""CMake's grammar, as CMake itself reads it: spans, verdicts, and the place of the one complaint."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from rospkg_cli.checks.read_sentences import syntax_sentence
from rospkg_cli.example import BACKDROPS
from rospkg_cli.languages.cmake.command_blocks import Block, nest
from rospkg_cli.languages.cmake.lexer import tokens
from rospkg_cli.languages.cmake.parser import parse
from rospkg_cli.source import Source
from rospkg_cli.testing import lint_files

PIECES = [
    "set", "if", "endif", "(", ")", '"', "\\", "\\\n", "#", "#[[", "[[", "]]", "[=[", "]=]", "${x}", "$<1:a>", ";",
    "\n", " ", "\t", "\r", "=", "-Da=\"b c\"", "$(MAKE)", "\0", "\u00a0", "é", "find_package(", "foo)\n",
]  # fmt: skip
TEXTS = st.one_of(st.text(max_size=60), st.lists(st.sampled_from(PIECES), max_size=40).map("".join))


def commands(text: str) -> list[tuple[str, list[tuple[str, str]]]]:
    found = parse(Source("CMakeLists.txt", text))
    assert not found.problems
    return [(c.name, [(a.kind, a.text) for a in c.arguments]) for c in found.commands]


@given(TEXTS)
def test_tokens_tile_the_text(text: str) -> None:
    at = 0
    for token in tokens(text):
        assert token.start == at
        assert token.text
        at = token.end
    assert at == len(text)


@given(TEXTS)
def test_any_text_can_be_parsed(text: str) -> None:
    found = parse(Source("CMakeLists.txt", text))
    nest(found.commands)
    at = 0
    for command in found.commands:
        assert at <= command.span.start
        at = command.span.end
        assert text[command.name_span.start : command.name_span.end].lower() == command.name
        assert (text[command.inner.start - 1], text[command.inner.end]) == ("(", ")")
        for argument in command.arguments:
            assert command.inner.start <= argument.span.start < argument.span.end <= command.inner.end
            if argument.kind != "bracket":
                assert text[argument.inner.start : argument.inner.end] == argument.text
    assert all(0 <= f.span.start < f.span.end <= len(text) for f in found.problems)


def test_arguments_keep_their_kind() -> None:
    text = 'Set(a "b ${c}\\"" [==[\nd ]] e]==] -Df="g h" $(MAKE) i[0]=1 # j\n  (k) #[[ l ]] m\\ n)\n'
    assert commands(text) == [
        (
            "set",
            [
                ("unquoted", "a"), ("quoted", 'b ${c}\\"'), ("bracket", "d ]] e"), ("unquoted", '-Df="g h"'),
                ("unquoted", "$(MAKE)"), ("unquoted", "i[0]=1"), ("paren", "("), ("unquoted", "k"), ("paren", ")"),
                ("unquoted", "m\\ n"),
            ],
        )
    ]  # fmt: skip


@pytest.mark.parametrize(
    "text",
    [
        "",
        "\n# nothing\n#[[ at\nall ]]\n",
        "a()\n  b (c)",
        'a("b\nc" "d\\\ne")\n',
        "a(\n  b# c )\n)\n",
        "if(A AND\n  NOT(B))\nendif()\n",
        "a([=[b]=] [[c]] ([[d]]))\n",
        "a(b[[c]])\n",
    ],
)
def test_what_cmake_accepts(text: str) -> None:
    assert parse(Source("CMakeLists.txt", text)).problems == ()


@pytest.mark.parametrize(
    "text, said",
    [
        ("a(b)\n«set(»C d\nfind_package(e)\n", "`set(` is never closed"),
        ("a(b)«)»\n", "`)` follows a command"),
        ("a(b)\n«)»\n", "`)` closes nothing"),
        ("a(b) «c»(d)\n", "`c` follows a command in the same line"),
        ("«a»\n(b)\n", "`a` is followed by no `(`"),
        ('a(«"»b)\nc("d")\n', '`"` is never closed'),
        ('a(b)\nc(d «"e)»\n', '`"` is never closed'),
        ("a(b)\nc(d «[=[e ]])»\n", "`[=[` is never closed"),
        ("«#[[ a»\nb()\n", "`#[[` is never closed"),
        ("a([[b]]«c»)\n", "a blank is missing"),
        ("a(#[[b]]«c»)\n", "a blank is missing"),
        ("a()\n«<<<<<<<» HEAD\nb()\n", "merge conflict"),
        ("a(b\n«<<<<<<<» HEAD\n  c\n=======\n)\n", "merge conflict"),
        ("«\u00a0a»()\n", "is where a command should begin"),
    ],
)
def test_the_place_of_a_fault(text: str, said: str) -> None:
    start, end = text.index("«"), text.index("»") - 1
    found = parse(Source("CMakeLists.txt", text.replace("«", "").replace("»", "")))
    first = found.problems[0]
    assert said in syntax_sentence(first)
    assert (first.span.start, first.span.end) == (start, end)


def test_what_follows_a_fault_is_still_read() -> None:
    found = parse(Source("CMakeLists.txt", "project(a)\nset(B c\n\nfind_package(d)\ne(\n)\n"))
    assert [c.name for c in found.commands] == ["project", "find_package", "e"]
    assert len(found.problems) == 1


def test_recovery_comes_to_an_end() -> None:
    """A quote inside a string that was found unclosed must not be found again and again."""
    found = parse(Source("CMakeLists.txt", 'a("b\nc(d)\ne("f)\ng(h"\ni(\n' * 30))
    assert 1 <= len(found.problems) <= 20


def test_blocks() -> None:
    text = "if(a)\n b()\nelseif(c)\nelse()\n foreach(x y)\n  d()\n endforeach()\nendif()\ne()\n"
    body, faults = nest(parse(Source("CMakeLists.txt", text)).commands)
    assert not faults
    block, last = body
    assert isinstance(block, Block)
    assert [branch.command.name for branch in block.branches] == ["if", "elseif", "else"]
    inner = block.branches[2].body[0]
    assert isinstance(inner, Block)
    assert [c.name for c in inner.branches[0].body if not isinstance(c, Block)] == ["d"]
    assert not isinstance(last, Block)


@pytest.mark.parametrize(
    "text, at, said",
    [
        ("a()\nif(b)\nc()\n", 4, "`endif()` is missing"),
        ("endif()\n", 0, "outside of any `if`"),
        ("if(a)\nendforeach()\nendif()\n", 6, "where `endif` should close `if`"),
        ("if(a)\nelse()\nelse()\nendif()\n", 13, "`else`"),
    ],
)
def test_bad_nesting(text: str, at: int, said: str) -> None:
    _, faults = nest(parse(Source("CMakeLists.txt", text)).commands)
    assert faults[0].span.start == at
    assert said in syntax_sentence(faults[0])


def findings(files: dict[str, str]) -> list[tuple[str, int, int]]:
    found = lint_files({**BACKDROPS["ament_cmake"], **files}, ["RPK001"]).findings
    return [(f.location.path, f.location.line, f.location.column) for f in found]


def test_one_finding_a_file_where_the_fault_begins() -> None:
    broken = "cmake_minimum_required(VERSION 3.20)\nproject(my_pkg\nfind_package(a)\n\nif(b)\nc(d)\n"
    assert findings({"CMakeLists.txt": broken}) == [("CMakeLists.txt", 2, 1)]


def test_only_files_that_the_build_reads() -> None:
    root = "project(my_pkg)\nadd_subdirectory(src)\ninclude(cmake/flags.cmake)\n"
    files = {"src/CMakeLists.txt": "a(", "cmake/flags.cmake": "b", "cmake/idle.cmake": "c", "x/CMakeLists.txt": "d"}
    assert findings({"CMakeLists.txt": root, **files}) == [("cmake/flags.cmake", 1, 1), ("src/CMakeLists.txt", 1, 1)]


def test_nobody_reads_it_in_a_python_package() -> None:
    files = {**BACKDROPS["ament_python"], "CMakeLists.txt": "a("}
    assert lint_files(files, ["RPK001"]).findings == ()


def test_bytes_that_are_no_text() -> None:
    files = {**BACKDROPS["ament_cmake"], "CMakeLists.txt": b"project(my_pkg)\n# \xff\n"}
    found = lint_files(files, ["RPK001"]).findings
    assert [f.location.path for f in found] == ["CMakeLists.txt"]
