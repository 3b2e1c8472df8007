"""Each edit on small texts: what is put in, what is taken out, and what stays around it."""

from __future__ import annotations

from collections.abc import Iterable
from types import SimpleNamespace
from typing import Any

import pytest
from cmaking import read

from rospkg_cli.edits import cmake_commands
from rospkg_cli.edits.cmake_export import export_dependencies
from rospkg_cli.edits.data_files import LAUNCH_GLOB, widen_glob
from rospkg_cli.edits.entry_points import strings
from rospkg_cli.edits.launch_file import import_name, pass_through
from rospkg_cli.edits.manifest_tags import remove_attribute, set_attribute
from rospkg_cli.edits.setup_py import move_tests_require
from rospkg_cli.edits.toml import find_entry
from rospkg_cli.example import manifest
from rospkg_cli.files import PackageFiles
from rospkg_cli.finding import Edit
from rospkg_cli.languages.python.file import parse_python
from rospkg_cli.package.manifest import manifest_of
from rospkg_cli.package.package import Package
from rospkg_cli.package.setup.setup_py import SetupPy
from rospkg_cli.source import Source, Span
from rospkg_cli.tree import MemoryTree


def applied(text: str, edits: Iterable[Edit]) -> str:
    for edit in sorted(edits, key=lambda each: each.span, reverse=True):
        text = text[: edit.span.start] + edit.text + text[edit.span.end :]
    return text


def edits(name: str, text: str) -> Iterable[Edit]:
    """Return what a function makes of the first command `a(…)` of a file."""
    file = read(text).root
    command = next(each for each in file.syntax.commands if each.name.lower() == "a")
    match name:
        case "add_at_end":
            return [cmake_commands.add_at_end(file, "new(x)")]
        case "add_before":
            return [cmake_commands.add_before(file, command, "new(x)")]
        case "add_after":
            return [cmake_commands.add_after(file, command, "new(x)")]
        case "add_argument":
            return [cmake_commands.add_argument(file, command, "new")]
        case "remove_argument":
            return [cmake_commands.remove_argument(file, command.arguments[-1].span)]
        case "guard":
            return {each for some in cmake_commands.guard(file, [command]).values() for each in some}
        case _:
            return [cmake_commands.remove(file, command)]


@pytest.mark.parametrize(
    "name, before, after",
    [
        ("add_before", "a(1)\nb(2)\n", "new(x)\na(1)\nb(2)\n"),
        ("add_after", "a(1)\nb(2)\n", "a(1)\nnew(x)\nb(2)\n"),
        ("add_at_end", "a(1)\nb(2)\n", "a(1)\nb(2)\n\nnew(x)\n"),
        ("remove", "a(1)\nb(2)\n", "b(2)\n"),
        ("add_argument", "a(1)\nb(2)\n", "a(1 new)\nb(2)\n"),
        ("remove_argument", "a(1)\nb(2)\n", "a()\nb(2)\n"),
        ("guard", "a(1)\nb(2)\n", "if(BUILD_TESTING)\n  a(1)\nendif()\nb(2)\n"),
        ("add_before", "  a(1) # why\nb(2)", "new(x)\n  a(1) # why\nb(2)"),
        ("add_after", "  a(1) # why\nb(2)", "  a(1) # why\nnew(x)\nb(2)"),
        ("add_at_end", "  a(1) # why\nb(2)", "  a(1) # why\nb(2)\n\nnew(x)\n"),
        ("remove", "  a(1) # why\nb(2)", "   # why\nb(2)"),
        ("add_argument", "  a(1) # why\nb(2)", "  a(1 new) # why\nb(2)"),
        ("remove_argument", "  a(1) # why\nb(2)", "  a() # why\nb(2)"),
        ("guard", "  a(1) # why\nb(2)", "if(BUILD_TESTING)\n    a(1) # why\nendif()\nb(2)"),
        ("add_before", "# above\n  # more\na(1)\nb(2)\n", "new(x)\n# above\n  # more\na(1)\nb(2)\n"),
        ("add_after", "# above\n  # more\na(1)\nb(2)\n", "# above\n  # more\na(1)\nnew(x)\nb(2)\n"),
        ("add_at_end", "# above\n  # more\na(1)\nb(2)\n", "# above\n  # more\na(1)\nb(2)\n\nnew(x)\n"),
        ("remove", "# above\n  # more\na(1)\nb(2)\n", "# above\n  # more\nb(2)\n"),
        ("add_argument", "# above\n  # more\na(1)\nb(2)\n", "# above\n  # more\na(1 new)\nb(2)\n"),
        ("remove_argument", "# above\n  # more\na(1)\nb(2)\n", "# above\n  # more\na()\nb(2)\n"),
        ("guard", "# above\n  # more\na(1)\nb(2)\n", "# above\n  # more\nif(BUILD_TESTING)\n  a(1)\nendif()\nb(2)\n"),
        ("add_before", "A(1)\nB(2)\n\n\n", "NEW(x)\nA(1)\nB(2)\n\n\n"),
        ("add_after", "A(1)\nB(2)\n\n\n", "A(1)\nNEW(x)\nB(2)\n\n\n"),
        ("add_at_end", "A(1)\nB(2)\n\n\n", "A(1)\nB(2)\n\nNEW(x)\n"),
        ("remove", "A(1)\nB(2)\n\n\n", "B(2)\n\n\n"),
        ("add_argument", "A(1)\nB(2)\n\n\n", "A(1 new)\nB(2)\n\n\n"),
        ("remove_argument", "A(1)\nB(2)\n\n\n", "A()\nB(2)\n\n\n"),
        ("guard", "A(1)\nB(2)\n\n\n", "IF(BUILD_TESTING)\n  A(1)\nENDIF()\nB(2)\n\n\n"),
        ("add_before", "a(1\n  2)\nb(2)\n", "new(x)\na(1\n  2)\nb(2)\n"),
        ("add_after", "a(1\n  2)\nb(2)\n", "a(1\n  2)\nnew(x)\nb(2)\n"),
        ("add_at_end", "a(1\n  2)\nb(2)\n", "a(1\n  2)\nb(2)\n\nnew(x)\n"),
        ("remove", "a(1\n  2)\nb(2)\n", "b(2)\n"),
        ("add_argument", "a(1\n  2)\nb(2)\n", "a(1\n  2\n  new)\nb(2)\n"),
        ("guard", "a(1\n  2)\nb(2)\n", "if(BUILD_TESTING)\n  a(1\n    2)\nendif()\nb(2)\n"),
        ("add_before", "\n\na(1)  #[[x]]\nb(2)\n", "\n\nnew(x)\na(1)  #[[x]]\nb(2)\n"),
        ("add_after", "\n\na(1)  #[[x]]\nb(2)\n", "\n\na(1)  #[[x]]\nnew(x)\nb(2)\n"),
        ("add_at_end", "\n\na(1)  #[[x]]\nb(2)\n", "\n\na(1)  #[[x]]\nb(2)\n\nnew(x)\n"),
        ("remove", "\n\na(1)  #[[x]]\nb(2)\n", "\n\n  #[[x]]\nb(2)\n"),
        ("add_argument", "\n\na(1)  #[[x]]\nb(2)\n", "\n\na(1 new)  #[[x]]\nb(2)\n"),
        ("remove_argument", "\n\na(1)  #[[x]]\nb(2)\n", "\n\na()  #[[x]]\nb(2)\n"),
        ("guard", "\n\na(1)  #[[x]]\nb(2)\n", "\n\nif(BUILD_TESTING)\n  a(1)  #[[x]]\nendif()\nb(2)\n"),
        ("add_argument", "a()\n", "a(new)\n"),
        ("add_argument", "a( )\n", "a(new )\n"),
        ("add_argument", "a(\n  1\n  2\n)\n", "a(\n  1\n  2\n  new\n)\n"),
        ("remove_argument", "a(\n  1\n  2\n)\n", "a(\n  1\n)\n"),
        ("add_argument", "a(1\n  2\n)\n", "a(1\n  2\n  new\n)\n"),
        ("remove_argument", "a(1\n  2\n)\n", "a(1\n)\n"),
        ("add_argument", "a(\n  1 2)\n", "a(\n  1 2 new)\n"),
        ("remove_argument", "a(\n  1 2)\n", "a(\n  1)\n"),
        ("add_argument", "a(1 2)\n", "a(1 2 new)\n"),
        ("remove_argument", "a(1 2)\n", "a(1)\n"),
    ],
)
def test_commands_of_cmake(name: str, before: str, after: str) -> None:
    assert applied(before, edits(name, before)) == after


@pytest.mark.parametrize("text", ["", "\n\n"])
def test_an_empty_file_of_cmake_begins_with_what_is_added(text: str) -> None:
    assert applied(text, [cmake_commands.add_at_end(read(text).root, "new()")]) == "new()\n"


@pytest.mark.parametrize(
    "text, keys, found",
    [
        ('[ignore]\nA = "x"\n', ("ignore", "A"), ("A", "[ignore]\n")),
        ('[ignore]\nA = "x" # why\nB = "y"\n', ("ignore", "A"), ("A", '[ignore]\nB = "y"\n')),
        ('ignore = {A = "x", B = "y"}\n', ("ignore", "A"), ("A", 'ignore = {B = "y"}\n')),
        ('ignore = {A = "x", B = "y"}\n', ("ignore", "B"), ("B", 'ignore = {A = "x"}\n')),
        ('ignore.A = "x"\n', ("ignore", "A"), ("A", "")),
        ("ignore.\"A\" = 'x'\nb = 1", ("ignore", "A"), ('"A"', "b = 1")),
        ('[a.ignore]\n"A"="x"', ("a", "ignore", "A"), ('"A"', "[a.ignore]\n")),
        ("[ignore]\nA = 1\n", ("ignore", "A"), None),
        ('[ignore]\nA = """x"""\n', ("ignore", "A"), None),
        ('[other]\nA = "x"\n[ignore]\nA = "x"\n', ("ignore", "A"), ("A", '[other]\nA = "x"\n[ignore]\n')),
        ('[ignore]\nBA = "x"\n', ("ignore", "A"), None),
        ('ignore = { A = "x" }\n', ("ignore", "A"), ("A", "ignore = {  }\n")),
        ('[[a]]\nA = "x"\n', ("a", "A"), None),
        ('ignore = {B = "y" , A = "x\\"y"}\n', ("ignore", "A"), ("A", 'ignore = {B = "y"}\n')),
        ("x\ry", ("x",), None),
        ("", ("A",), None),
    ],
)
def test_a_key_of_toml_and_the_rest_without_it(text: str, keys: tuple[str, ...], found: tuple[str, str] | None) -> None:
    spans = find_entry(text, keys)
    shown = (text[spans[0].start : spans[0].end], text[: spans[1].start] + text[spans[1].end :]) if spans else None
    assert shown == found


@pytest.mark.parametrize(
    "code, found",
    [
        ("'a' 'b'", ["'a'", "'b'"]),
        ("'a'\n 'b'", ["'a'", "'b'"]),
        ("'a' + b", []),
        ("b", []),
        ("'a' % 'b'", ["'a'", "'b'"]),
        ("('a'", []),
        ("f'x' 'y'", ["f'x'", "'y'"]),
        ("f'{x:{y}} = {f(1)}'\n f'y' 'z'", ["f'{x:{y}} = {f(1)}'", "f'y'", "'z'"]),
        ("f'{x}' 'y' % z", []),
        ("'a' 'b' # c\n 'd'", ["'a'", "'b'", "'d'"]),
        ("'''a\nb''' 'c'", ["'''a\nb'''", "'c'"]),
        ("", []),
        ("'a'", ["'a'"]),
    ],
)
def test_strings_that_python_joins(code: str, found: list[str]) -> None:
    assert [code[start:end] for start, end in strings(code)] == found


@pytest.mark.parametrize(
    "before, after",
    [
        ("x = 1\n", "from b import c\nx = 1\n"),
        ("", "from b import c\n"),
        ("import a\nimport d\n", "import a\nfrom b import c\nimport d\n"),
        ('"""Docs."""\nimport d\n', '"""Docs."""\nfrom b import c\nimport d\n'),
        ("from __future__ import x\nfrom b import d\n", "from __future__ import x\nfrom b import c\nfrom b import d\n"),
        ("import a", "import a\nfrom b import c"),
        ("import a\r\n", "import a\r\nfrom b import c\r\n"),
        ("from b import c\n", "from b import c\n"),
        ("from . import a\n", "from . import a\nfrom b import c\n"),
    ],
)
def test_an_import_is_put_in_order(before: str, after: str) -> None:
    assert applied(before, import_name(parse_python(Source("a.py", before)), "b", "c")) == after


@pytest.mark.parametrize("end", ["\n", "\r\n"])
@pytest.mark.parametrize(
    "width, after",
    [
        (40, "    x = call(value, more)\n"),
        (24, "    x = call(\n        value,\n        more)\n"),
        (12, "    x = value\n"),
    ],
)
def test_a_call_around_an_expression_keeps_to_the_width(width: int, after: str, end: str) -> None:
    text = f"def f():{end}    x = value{end}"
    at = text.index("value")
    edits = pass_through(parse_python(Source("a.py", text)), Span(at, at + 5), "call", "more", width)
    assert applied(text, edits) == f"def f():{end}" + after.replace("\n", end)


@pytest.mark.parametrize(
    "before, value, after",
    [
        ('<a b="x"/>', "y", '<a b="y"/>'),
        ("<a b='x'/>", "y", "<a b='y'/>"),
        ('<a b="x"/>', "\"'<&", '<a b="&quot;\'&lt;&amp;"/>'),
        ("<a b='x'/>", "\"'", "<a b='\"&apos;'/>"),
        ("<a c='x'/>", "y", "<a b=\"y\" c='x'/>"),
        ("<a/>", 'y"', "<a b='y\"'/>"),
        ("<a/>", "\"'", '<a b="&quot;\'"/>'),
    ],
)
def test_an_attribute_keeps_its_quotes(before: str, value: str, after: str) -> None:
    manifest = manifest_of(Source("package.xml", f"<package>{before}</package>"))
    assert (
        applied(manifest.source.text, [set_attribute(manifest, manifest.root.children[0], "b", value)])[9:-10] == after
    )


def test_an_attribute_is_removed_with_the_blanks_before_it() -> None:
    manifest = manifest_of(Source("package.xml", "<package><a  b='x'\n c='y'/></package>"))
    edits = [remove_attribute(manifest, manifest.root.children[0], name) for name in "bc"]
    assert applied(manifest.source.text, edits) == "<package><a/></package>"


def setup_of(arguments: str) -> SetupPy:
    text = f"from setuptools import setup\nimport given\nsetup({arguments})\n"
    package = Package(
        PackageFiles(MemoryTree.of({"package.xml": manifest(build_type="ament_python"), "setup.py": text}))
    )
    (found,) = package.parts(SetupPy).good
    return found


@pytest.mark.parametrize(
    "before, after",
    [
        ("tests_require=['pytest']", "extras_require={'test': ['pytest']}"),
        ("tests_require=['pytest'], extras_require={}", "extras_require={'test': ['pytest']}"),
        (
            "tests_require=['pytest'], extras_require={'doc': ['sphinx']}",
            "extras_require={'doc': ['sphinx'], 'test': ['pytest']}",
        ),
        ("tests_require=['pytest'], extras_require=given.extras()", None),
        ("tests_require=['pytest'], extras_require=dict(doc=['sphinx'])", None),
    ],
)
def test_what_tests_require_is_an_extra(before: str, after: str | None) -> None:
    setup = setup_of(before)
    edited = applied(setup.source.text, move_tests_require(setup))
    assert edited == setup.source.text.replace(before, before if after is None else after)


@pytest.mark.parametrize(
    "code, pattern, path, matches, is_widened",
    [
        ("glob('launch/*.py')", "launch/*.py", "launch/a.launch.xml", ["launch/b.launch.py"], True),
        ("glob('launch/*.py')", "launch/*.py", "launch/a.txt", [], False),
        ("glob('launch/*.py')", "launch/*.py", "launch/deep/a.launch.xml", [], False),
        ("glob('launch/*' + '.py')", "launch/*.py", "launch/a.launch.xml", [], False),
        ("glob('*', '*')", "*", "launch/a.launch.xml", [], False),
        ("glob('launch/*.py')", "launch/*.py", "launch/a.launch.xml", ["launch/tool.py"], False),
    ],
)
def test_a_glob_is_widened_where_it_is_a_plain_text(
    code: str, pattern: str, path: str, matches: list[str], is_widened: bool
) -> None:
    setup = setup_of(f"data_files=[('x', {code})]")
    start = setup.source.text.index(code)
    glob: Any = SimpleNamespace(span=Span(start, start + len(code)), pattern=pattern, matches=matches)
    edited = applied(setup.source.text, widen_glob(setup, glob, path))
    assert edited == setup.source.text.replace(pattern, LAUNCH_GLOB if is_widened else pattern)


@pytest.mark.parametrize("width, is_one_line", [(23, True), (22, False)])
def test_the_width_counts_to_the_end_of_a_file_without_a_line_break(width: int, is_one_line: bool) -> None:
    text = "x = (value)"
    edited = applied(text, pass_through(parse_python(Source("a.py", text)), Span(5, 10), "call", "more", width))
    assert edited == ("x = (call(value, more))" if is_one_line else "x = (call(\n    value,\n    more))")


def test_a_long_list_of_exports_has_a_line_for_each() -> None:
    names = [f"a_longer_message_package_{number}" for number in range(3)]
    text = "project(a)\nfoo(\n    b)\nament_package()\n"
    short, long = (applied(text, [export_dependencies(read(text), names[:count])]) for count in (2, 3))
    assert f"\nament_export_dependencies({names[0]} {names[1]})\n" in short
    assert "\nament_export_dependencies(\n    " + "\n    ".join(names) + "\n)\n" in long
