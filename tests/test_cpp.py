"""C++ as far as it is read: includes and registrations at their exact place, nothing from comments and strings."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from rospkg_cli.files import PackageFiles
from rospkg_cli.languages.cpp.file import CppFile, read_cpp
from rospkg_cli.package.package import Package
from rospkg_cli.source import Source
from rospkg_cli.tree import MemoryTree

PIECES = [
    "//", "/*", "*/", '"', "'", "\\", "\\\n", "\n", "#include ", "<", ">", "#if 0\n", "#else\n", "#endif\n",
    "#ifndef A\n", "#define A", "PLUGINLIB_EXPORT_CLASS", "(", ")", ",", "{", "}", " ", "a::B", 'R"x(', ')x"',
    "pluginlib::ClassLoader<", "1'000", "é", '"p", "n::C"', "loader_",
]  # fmt: skip
TEXTS = st.one_of(st.text(max_size=60), st.lists(st.sampled_from(PIECES), max_size=40).map("".join))


def read(text: str) -> CppFile:
    return read_cpp(Source("a.cpp", text))


def said(text: str) -> list[tuple[str, str, list[str], str]]:
    return [(c.name, c.template, [a.text for a in c.arguments or ()], c.variable) for c in read(text).calls]


@given(TEXTS)
def test_any_text_can_be_read_and_spans_lie_where_they_say(text: str) -> None:
    file = read(text)
    for include in file.includes:
        assert text[include.span.start : include.span.end].strip() == include.path
    for call in file.calls:
        assert text[call.span.start :].startswith(call.name)
        for argument in call.arguments or ():
            assert call.span.start < argument.span.start <= argument.span.end < call.span.end


def test_includes() -> None:
    text = '#include <a/b.hpp>  // why\n  #  include "c.h"\n// #include <no>\n/*\n#include <no>\n*/\n#include MACRO\n'
    found = read(text).includes
    assert [(i.path, i.is_angled) for i in found] == [("a/b.hpp", True), ("c.h", False)]
    assert [text[i.span.start : i.span.end] for i in found] == ["a/b.hpp", "c.h"]


def test_a_guard_is_no_condition() -> None:
    text = "#ifndef A_HPP\n#define A_HPP\n#include <a>\n#ifdef WIN32\n#include <b>\n#else\n#include <c>\n#endif\n"
    text += "#include <d>\n#endif\n"
    assert {i.path: i.is_conditional for i in read(text).includes} == {"a": False, "b": True, "c": True, "d": False}


def test_another_ifndef_is_one() -> None:
    assert [i.is_conditional for i in read("#ifndef FAST\n#include <a>\n#endif\n").includes] == [True]


def test_what_is_never_compiled_is_not_there() -> None:
    text = "#if 0\n#include <a>\n#ifdef X\nPLUGINLIB_EXPORT_CLASS(A, B)\n#endif\n#else\n#include <b>\n#endif\n"
    file = read(text)
    assert [i.path for i in file.includes] == ["b"]
    assert not file.calls


@pytest.mark.parametrize(
    "text",
    [
        "// PLUGINLIB_EXPORT_CLASS(a::A, b::B)\n",
        "// goes on \\\nPLUGINLIB_EXPORT_CLASS(a::A, b::B)\n",
        "/* PLUGINLIB_EXPORT_CLASS(a::A, b::B) */",
        'auto s = "PLUGINLIB_EXPORT_CLASS(a::A, b::B)";',
        'auto s = R"(\n"PLUGINLIB_EXPORT_CLASS(a::A, b::B))";',
        "#define MINE(x) \\\n  PLUGINLIB_EXPORT_CLASS(x, b::B)\n",
        "PLUGINLIB_EXPORT_CLASS(a::A, b::B",
    ],
)
def test_no_call(text: str) -> None:
    assert said(text) == []


@pytest.mark.parametrize(
    "text, arguments",
    [
        ("PLUGINLIB_EXPORT_CLASS(a::A, b::B)", ["a::A", "b::B"]),
        ("PLUGINLIB_EXPORT_CLASS(\n  a::A,  // mine\n  b::B /* theirs */);", ["a::A", "b::B"]),
        ("PLUGINLIB_EXPORT_CLASS (a::A<b::C>, b::B)", ["a::A<b::C>", "b::B"]),
        ("char c = '\"'; int i = 1'000'000; PLUGINLIB_EXPORT_CLASS(a::A, b::B)", ["a::A", "b::B"]),
    ],
)
def test_macros(text: str, arguments: list[str]) -> None:
    (call,) = read(text).calls
    assert [a.text for a in call.arguments or ()] == arguments
    assert text[call.arguments[0].span.start : call.arguments[0].span.end] == arguments[0]  # type: ignore[index]


def test_a_macro_of_ones_own_is_known_to_be_one() -> None:
    (define,) = read("#define MINE(x) \\\n  PLUGINLIB_EXPORT_CLASS(x, b::B)\n").defines
    assert define.name == "MINE"
    assert "PLUGINLIB_EXPORT_CLASS" in define.body


@pytest.mark.parametrize(
    "text, expected",
    [
        (
            'x = std::make_unique<pluginlib::ClassLoader<b::B>>(\n  "p", "b::B");',
            ("ClassLoader", "b::B", ['"p"', '"b::B"'], ""),
        ),
        ('pluginlib::ClassLoader<b::B> l("p", "b::B");', ("ClassLoader", "b::B", ['"p"', '"b::B"'], "l")),
        ('pluginlib::ClassLoader<b::B<c::C>> l{"p", name};', ("ClassLoader", "b::B<c::C>", ['"p"', "name"], "l")),
        ("std::shared_ptr<pluginlib::ClassLoader<B>>\n  loader_;", ("ClassLoader", "B", [], "loader_")),
        (': loader_("p", "b::B"), x_(1)', ("loader_", "", ['"p"', '"b::B"'], "")),
        ('declare_parameter<double>("a.b", 1.0)', ("declare_parameter", "double", ['"a.b"', "1.0"], "")),
    ],
)
def test_calls(text: str, expected: tuple[str, str, list[str], str]) -> None:
    assert said(text)[0] == expected


def test_literals() -> None:
    (call,) = read('pluginlib::ClassLoader<B> l("p" , "b::" "B");').calls
    assert [a.literal for a in call.arguments or ()] == ["p", "b::B"]
    (call,) = read('pluginlib::ClassLoader<B> l(package, "p\\n");').calls
    assert [a.literal for a in call.arguments or ()] == [None, None]


def test_a_file_in_an_old_encoding_is_no_fault() -> None:
    files = {"src/a.cpp": b'#include "b.hpp"\n', "src/b.cpp": b"// \xe9\n", "include/c.HPP": b""}
    package = Package(PackageFiles(MemoryTree.of(files)))
    assert [file.path for file in package.parts(CppFile).good] == ["src/a.cpp"]
    assert not package.unreadable()
