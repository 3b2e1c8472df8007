"""Text that users give: whatever it is, every file stays what it was, and all files say the same."""

from __future__ import annotations

import ast
import re
import xml.etree.ElementTree as ElementTree
from xml.sax.saxutils import unescape

import pytest
import yaml
from catkin_pkg.package import parse_package_string
from hypothesis import example, given, settings
from hypothesis import strategies as st
from planned import plan, texts

from rospkg_cli.scaffold import ScaffoldError
from rospkg_cli.scaffold.answers import Request
from rospkg_cli.scaffold.extras import all_extras
from rospkg_cli.scaffold.launch_format import LAUNCH_FORMATS, NO_FILE
from rospkg_cli.scaffold.plan import Plan
from rospkg_cli.scaffold.template import load_template, template_names
from rospkg_cli.scaffold.user_text import UnescapedError, UserText, comment, markdown, pieces_of, user_text

NASTY = (
    "it's \"quoted\" & <b>bold</b>", "back\\slash \\n \\N{DASH}", "{{ name }} {% raw %} {# no #}", "${HOME} $(id) `id`",
    "<!-- --> ]]> -->", "--", "''' \"\"\"", "two\nlines\r\nand\ttab", "שלום \u202e right to left", "naïve 機器人 🤖",
    "# hash", "%s %(x)s {0}", "@", "a: b", "- x", "null", "0o17", "'", '"', "\\", "\u2028line\x85separators",
)  # fmt: skip
TEXT = st.one_of(
    st.sampled_from(NASTY),
    st.text(st.characters(exclude_categories=("Cc", "Cs"), exclude_characters="\ufffe\uffff"), max_size=300),
)


def call_of(setup: str) -> dict[str, object]:
    """Return the literal arguments of the call to setup()."""
    calls = [node for node in ast.walk(ast.parse(setup)) if isinstance(node, ast.Call)]
    keywords = next(c.keywords for c in calls if isinstance(c.func, ast.Name) and c.func.id == "setup")
    return {k.arg: k.value.value for k in keywords if k.arg and isinstance(k.value, ast.Constant)}


def check(planned: Plan, description: str | None, maintainer: str | None) -> None:
    files = texts(planned)
    package = parse_package_string(files["package.xml"])
    root = ElementTree.fromstring(files["package.xml"])
    arguments = call_of(files["setup.py"])
    if description is not None:
        assert root.findtext("description") == arguments["description"] == description
        assert unescape(package.description, {"&quot;": '"'}) == description  # catkin_pkg keeps it as XML
    if maintainer is not None:
        assert root.findtext("maintainer") == arguments["maintainer"] == package.maintainers[0].name == maintainer
    assert arguments["version"] == package.version
    for path, text in files.items():
        if path.endswith(".py"):
            ast.parse(text)
            shown = text.splitlines()
            assert not [line for line in shown if len(line) > 99], path
            assert all(character.isprintable() for line in shown for character in line), path
        if path.endswith(".yaml"):
            assert yaml.safe_load(text)


@settings(deadline=None, max_examples=30)
@given(TEXT)
@example("words " * 60 + "x" * 200)
@example("'\"" * 80)
def test_any_description_is_the_same_everywhere(text: str) -> None:
    line = " ".join(text.split())
    planned = plan(description=text)
    assert {finding.code for finding in planned.findings} <= {"XML104"}, "only a description that says nothing"
    check(planned, line or None, "Ada Lovelace")


@settings(deadline=None, max_examples=20)
@given(TEXT, st.sampled_from(template_names()))
def test_any_description_stands_in_every_type_of_package(text: str, template: str) -> None:
    planned = plan("my_robot", template=template, description=text)
    assert {finding.code for finding in planned.findings} <= {"XML104"}, "only a description that says nothing"
    shown = ElementTree.fromstring(texts(planned)["package.xml"]).findtext("description")
    assert shown == (" ".join(text.split()) or plan("my_robot", template=template).answers.description.text)


@settings(deadline=None, max_examples=30)
@given(TEXT)
def test_any_maintainer_is_the_same_everywhere(text: str) -> None:
    line = " ".join(text.split())
    try:
        planned = plan(maintainer=text)
    except ScaffoldError:
        assert not line or len(line) > 80 or re.search("coding[:=]", line)
        return
    if line:
        assert planned.findings == ()
        check(planned, None, line)
        assert UserText(line).text in texts(plan(maintainer=text, license="MIT"))["LICENSE"]


@settings(deadline=None, max_examples=20)
@given(TEXT, st.sampled_from(template_names()))
def test_any_maintainer_stands_in_every_type_of_package(text: str, template: str) -> None:
    try:
        planned = plan("my_robot", template=template, maintainer=text, license="MIT", extras=tuple(all_extras()))
    except ScaffoldError:
        return
    assert planned.findings == ()
    check_parses(planned)
    [package] = [parse_package_string(texts(planned)["package.xml"])]
    assert package.maintainers[0].name == planned.answers.maintainer.text


NAMES = st.from_regex(r"[a-z][a-z0-9]*(_[a-z0-9]+)*", fullmatch=True).filter(lambda name: 2 <= len(name) <= 60)


@settings(deadline=None, max_examples=20)
@given(NAMES, st.sampled_from(template_names()), st.sampled_from(sorted({*LAUNCH_FORMATS} - {NO_FILE})))
def test_any_name_fits_every_type_of_package(name: str, template: str, launch: str) -> None:
    try:
        planned = plan(name, template=template, launch=launch if load_template(template).launches else "")
    except ScaffoldError:
        return
    assert {finding.code for finding in planned.findings} == set()
    check_parses(planned)


def check_parses(planned: Plan) -> None:
    for path, text in texts(planned).items():
        if path.endswith(".py"):
            ast.parse(text)
        if path.endswith((".xml", ".xacro")):
            ElementTree.fromstring(text)
        if path.endswith((".yaml", ".json")):
            assert yaml.safe_load(text)


@pytest.mark.parametrize("template", template_names())
def test_what_a_user_says_is_no_template(template: str) -> None:
    text = "{{ name }} {% raw %} {# no #} [[ name ]] [% raw %] [# no #]"
    files = texts(plan("my_robot", template=template, description=text, extras=("docs",)))
    assert text in files["package.xml"]
    for page in ("README.md", "doc/index.md"):
        assert text in files[page].replace("\\", "")


@pytest.mark.parametrize(
    "text, code", [("bell \a", "U+0007"), ("escape \x1b[0m", "U+001B"), ("\udcff", "UTF-8"), ("\uffff", "U+FFFF")]
)
def test_what_no_file_can_hold_is_refused(text: str, code: str) -> None:
    with pytest.raises(ScaffoldError, match=re.escape(code)):
        plan(description=text)


def test_a_maintainer_who_would_set_the_encoding_is_refused() -> None:
    with pytest.raises(ScaffoldError, match="coding:"):
        plan(maintainer="Ada -*- coding: latin-1 -*-")


@pytest.mark.parametrize("name", ['Ada "the first"', "Ada \\ Co", "${ADA}"])
@pytest.mark.parametrize("template", ["ament_cmake", "interfaces"])
def test_a_maintainer_whom_ament_cmake_would_stumble_over_is_refused(name: str, template: str) -> None:
    with pytest.raises(ScaffoldError, match="unescaped"):
        plan(template=template, maintainer=name)
    assert plan(maintainer=name).files


def test_a_template_must_name_the_language_of_a_users_text() -> None:
    with pytest.raises(UnescapedError):
        f"{UserText('text')}"


@given(st.text(max_size=300), st.integers(20, 100))
def test_pieces_make_the_text(text: str, width: int) -> None:
    pieces = pieces_of(text, width)
    assert "".join(pieces) == text
    assert all(len(repr(piece)) <= width for piece in pieces)


@pytest.mark.parametrize(
    "text, shown",
    [
        ("snake_case stays", "snake_case stays"),
        ("*bold* _it_ `code` [link](x) <b>", "\\*bold\\* \\_it\\_ \\`code\\` \\[link\\](x) \\<b>"),
        ("# no heading", "\\# no heading"),
        ("1. no list", "1\\. no list"),
        ("&amp; & more", "\\&amp; & more"),
    ],
)
def test_markdown_has_no_markup_of_users(text: str, shown: str) -> None:
    assert markdown(user_text("it", text)) == shown


def test_a_comment_shows_every_character() -> None:
    assert comment(UserText("abc\u202edef\u200b")) == "# abcdef"
    assert comment("a\n\nb\n", "//") == "// a\n//\n// b\n"


def test_defaults_give_way_to_what_was_typed() -> None:
    asked = Request("my_pkg", license="MIT").with_defaults({"license": "BSL-1.0", "maintainer": "Ada"})
    assert (asked.license, asked.maintainer) == ("MIT", "Ada")
