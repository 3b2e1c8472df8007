"""The lexer of C++ finds what one simple pattern finds, which reads every character."""

from __future__ import annotations

import random
import re
from collections.abc import Iterator

import pytest

from rospkg_cli.languages.cpp import file
from rospkg_cli.languages.cpp.lexer import DIRECTIVE, REST, ConditionalStack, CppToken, tokens
from rospkg_cli.source import Source

SIMPLE = re.compile(
    r"""(?P<comment>//[^\n\\]*(?:\\[\s\S][^\n\\]*)*|/\*[\s\S]*?(?:\*/|\Z))"""
    r"""|(?P<raw>R"(?P<tag>[^()\\\s"]{0,16})\([\s\S]*?\)(?P=tag)")"""
    r"""|(?P<string>"(?:[^"\\\n]|\\[\s\S])*")"""
    r"""|(?P<char>(?<![0-9A-Za-z_])'(?:[^'\\\n]|\\.)+')"""
    rf"""|(?P<directive>\#[ \t]*(?:include|if|ifdef|ifndef|elif|else|endif|define)\b{REST})"""
    r"""|(?P<name>\b(?:\w*(?:REGISTER|EXPORT)\w*|ClassLoader|\w*declare_parameter\w*|declare_or_get_parameter"""
    r"""|get_parameter(?:_or)?)(?=\s*(?P<opening>[<(])))"""
)
PIECES = (
    '#include "a.hpp"', "#include <b/c.h>", "  #  include <d>", "#ifndef GUARD", "#define GUARD", "#define TWO(x) \\",
    "#if 0", "#if X", "#else", "#elif Y", "#endif", "// #include <commented>", "// a /* b", "/* open", "close */",
    " * #include <in_comment>", "/* one */ #include <behind>", "int x;  // #define no", "x = '\"';", 'say("// no");',
    'say("/*");', 'say("a \\', '#include <in_string>");', "\\", "//*", "*/ // #include <late>", 'say("a", "b::c");',
    "// go on \\", "#define A /* x", "#undef X", "don't", "f('a');", "", "#define S \"a /* b\"", "// #define M \\",
    "PLUGINLIB_EXPORT_CLASS(a, b)", "MY_REGISTER_IT (c)", "REGISTER", "x->declare_parameter<int>(1)", "ClassLoader<B>",
    "auto_declare_parameter_now(1)", "get_parameter_or(a)", "get_parameters(a)", "declare_or_get_parameter(x)", "1'000",
    'R"(raw " #include)"', 'R"tag(ClassLoader<A>', ')tag"', 'STDERR"x::y"', "/**/", "u8'a'", "f('\\'', \"::\")",
)  # fmt: skip


def simple_tokens(text: str) -> Iterator[CppToken]:
    conditions = ConditionalStack()
    for match in SIMPLE.finditer(text):
        kind, start, end = match.lastgroup, match.start(), match.end()
        if kind == "directive":
            found = DIRECTIVE.match(text, start)
            assert found is not None
            if not conditions.dead and found[1] in ("include", "define"):
                yield CppToken("directive", start, end, conditions.conditional, found[1], found.end())
            conditions.step(found[1], text, found.end(), end)
        elif kind == "string" and not conditions.dead and "::" in match[0]:
            yield CppToken("string", start, end, conditions.conditional)
        elif kind == "name" and not conditions.dead:
            yield CppToken("name", start, end, conditions.conditional, at=match.start("opening"))


@pytest.mark.parametrize("seed", range(40))
def test_it_finds_what_the_simple_pattern_finds(seed: int) -> None:
    chosen = random.Random(seed)
    for _ in range(100):
        between = chosen.choice(("\n", "\n", " ", "\r\n"))
        text = between.join(chosen.choices(PIECES, k=chosen.randrange(1, 9)))
        wanted = [each for each in simple_tokens(text) if each.kind != "name" or is_wanted(text, each)]
        found = [each for each in tokens(text) if each.kind != "name" or is_wanted(text, each)]
        assert found == wanted, text


def is_wanted(text: str, token: CppToken) -> bool:
    """Return whether the reader looks at a name; what else the lexer finds does not matter."""
    name = text[token.start : token.end]
    return bool(re.fullmatch(r"[A-Z][A-Z0-9]*_[A-Z0-9_]+", name)) or ("EXPORT" not in name and "REGISTER" not in name)


@pytest.mark.parametrize(
    ("text", "conditional"),
    [
        ("#ifndef A_H\n#define A_H\n#include <x>\n#endif", False),
        ("#ifndef A_H\n#define A_H_\n#include <x>\n#endif", True),
        ("#ifndef A_H\n\n # define A_H 1\n#include <x>\n#endif", False),
        ("#ifndef A_H\nint x;\n#define A_H\n#include <x>\n#endif", True),
        ("#if X\n#include <x>\n#endif", True),
    ],
)
def test_an_include_guard_is_no_condition(text: str, conditional: bool) -> None:
    (include,) = [token for token in tokens(text) if token.word == "include"]
    assert include.is_conditional is conditional


def test_a_source_is_read_once(monkeypatch: pytest.MonkeyPatch) -> None:
    asked: list[str] = []
    real = file.read_anew
    monkeypatch.setattr(file, "read_anew", lambda source: asked.append(source.path) or real(source))
    source = Source("a.cpp", "#include <a>\n")
    assert file.read_cpp(source).includes is file.read_cpp(source).includes
    assert asked == ["a.cpp"]
