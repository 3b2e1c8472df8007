"""Comments that ignore findings: what one is, which lines it holds for, and how one is written."""

from __future__ import annotations

import pytest

from rospkg_cli.engine.config_filter import matches_path
from rospkg_cli.engine.fixing.apply import touch
from rospkg_cli.engine.run.crashes import place_of
from rospkg_cli.engine.selection import Selection, named_by
from rospkg_cli.engine.suppression.comments import Suppression, in_source
from rospkg_cli.engine.suppression.file_head import FileHead
from rospkg_cli.engine.suppression.insert_ignores import comment_text
from rospkg_cli.engine.suppression.suppression_index import SuppressionIndex
from rospkg_cli.rule import Profile
from rospkg_cli.rule_table import rule_entries
from rospkg_cli.source import Source, Span


@pytest.mark.parametrize(
    "path, text, found",
    [
        ("a.xml", "<?x?>\n<!-- @-file[A1] why -->\n<a/>\n", [((), "A1", "why", "<?x?>\n<a/>\n")]),
        ("a.xml", "<a>\n<!-- @-file[A1] why -->\n</a>\n", [((2, 3), "A1", "why", "<a>\n</a>\n")]),
        ("a.xml", "<a> <!-- @[A1,B2 C3] why\n not --> </a>\n", [((1,), "A1 B2 C3", "why\n not", "<a> </a>\n")]),
        ("a.xml", "  <!--@[A1]-->\n<a/>\n", [((1, 2), "A1", "", "<a/>\n")]),
        ("a.xml", "<!-- @[A1] open\n<a/>\n", [((1, 2), "A1", "open", "<a/>\n")]),
        ("a.xml", "<!-- one --><!-- @-file[A1] x -->\n", [((), "A1", "x", "<!-- one -->\n")]),
        (
            "a.xml",
            "<!-- @-file[A1] x -->\n<!-- @-file[B1] y -->\n<a/>\n",
            [((), "A1", "x", "<!-- @-file[B1] y -->\n<a/>\n"), ((), "B1", "y", "<!-- @-file[A1] x -->\n<a/>\n")],
        ),
        (
            "a.xml",
            "<!-- @-file[A1] x -->\n<a/>\n<!-- @-file[B1] y -->\n",
            [((), "A1", "x", "<a/>\n<!-- @-file[B1] y -->\n"), ((3, 4), "B1", "y", "<!-- @-file[A1] x -->\n<a/>\n")],
        ),
        ("a.py", "# @-file[A1] why\nx = 1\n", [((), "A1", "why", "x = 1\n")]),
        ("a.py", "#!/x\n\n# @-file[A1] why\nx = 1\n", [((), "A1", "why", "#!/x\n\nx = 1\n")]),
        ("a.py", "x = 1  # @[B1]\n", [((1,), "B1", "", "x = 1\n")]),
        ("a.py", "x = '# @[A1] x'\n", []),
        ("a.py", "x = (\n# @[A1] not tokens\n", [((2, 3), "A1", "not tokens", "x = (\n")]),
        ("a.yaml", "a: 1 # @[A1] why\n", [((1,), "A1", "why", "a: 1\n")]),
        ("a.cpp", "// @-file[A1] why\nint x;\n", [((), "A1", "why", "int x;\n")]),
        ("a.cpp", "int x; // @[B1]\n", [((1,), "B1", "", "int x;\n")]),
        ("a.cpp", "int x;\n// @-file[A1] why\n", [((2, 3), "A1", "why", "int x;\n")]),
        ("a.txt", "\ufeff# @-file[A1]\na()\n", [((), "A1", "", "\ufeff\na()\n")]),
        ("a.txt", "# @[A1] \n", [((1, 2), "A1", "", "")]),
        ("a.txt", "# @[]  x\n# @d[A]\n# @[A\n", [((1, 2), "", "x", "# @d[A]\n# @[A\n")]),
        ("a.txt", "a() # one # @[A1] two\n", [((1,), "A1", "two", "a() # one\n")]),
        ("a.xml", "<!-- open\n @[A1] # @-file[B1] x\n-->\n<a/>", [((2,), "B1", "x", "<!-- open\n @[A1]\n-->\n<a/>")]),
    ],
)
def test_lines_codes_reason_and_the_text_without_it(path: str, text: str, found: list) -> None:
    text = text.replace("@", "rospkg: ignore")

    def shown(each: Suppression) -> tuple:
        left = text[: each.line_span.start] + text[each.line_span.end :]
        return each.lines, " ".join(each.codes), each.reason, left.replace("rospkg: ignore", "@")

    assert [shown(each) for each in in_source(Source(path, text), path)] == found


@pytest.mark.parametrize(
    "path, comment",
    [
        ("a.xml", "<!-- rospkg: ignore[A1] why – not at all -->"),
        ("a.urdf", "<!-- rospkg: ignore[A1] why – not at all -->"),
        ("a.py", "# rospkg: ignore[A1] why -- not at all"),
        ("a.cpp", "// rospkg: ignore[A1] why -- not at all"),
        ("CMakeLists.txt", "# rospkg: ignore[A1] why -- not at all"),
        ("a.launch", "<!-- rospkg: ignore[A1] why – not at all -->"),
    ],
)
def test_a_comment_in_the_language_of_the_file(path: str, comment: str) -> None:
    assert comment_text(path, "rospkg: ignore[A1]", "why -- not\n at all") == comment


@pytest.mark.parametrize(
    "text, is_head",
    [
        ("|x", True),
        ("# a\n|x", True),
        ("# a|", True),
        ("a|", False),
        ("  \n|", True),
        ("a # b|", False),
        ("<!-- a -->|", True),
        ("<!-- a|", False),
        ("<? a ?>|", True),
        ("<? a|", False),
        ("x <!-- a -->|", False),
        ("// a\n|", True),
        ("// a\n // b|", True),
        ("a\n# b|", False),
        ("<!-- a --> b|", False),
        ("<!-- a -->\n<? b ?>\n# c\n|", True),
    ],
)
def test_the_head_of_a_file_ends_at_its_first_content(text: str, is_head: bool) -> None:
    assert FileHead(Source("a", text.replace("|", ""))).holds(text.index("|")) is is_head


def comment(codes: str, *lines: int, path: str = "a.xml", reason: str = "") -> Suppression:
    names = tuple(codes.split())
    spans = tuple(Span(10 * number, 10 * number + 6) for number in range(len(names)))
    return Suppression(path, lines, names, spans, reason, Span(0, 90), Span(0, 99))


def test_what_ignored_nothing_is_taken_out_alone_or_with_its_comment() -> None:
    codes = frozenset(code for code in rule_entries() if code.startswith("XML1"))

    def ran(path: str) -> frozenset[str]:
        return codes

    index = SuppressionIndex(
        [comment("XML104 XML101", 1), comment("XML101 SET101"), comment("XML1 NONE")], lambda _: codes
    )
    assert [(each.code, each.delete) for each in index.unused()] == [
        ("XML104", Span(0, 99)),
        ("XML101", Span(0, 99)),
        ("XML101", Span(0, 10)),
        ("XML1", Span(0, 10)),
    ]
    index.used |= {(0, 0)}
    assert next(each.delete for each in index.unused()) == Span(6, 16)
    assert [(each.name, each.span) for each in index.unknown()] == [("NONE", Span(10, 16))]


@pytest.mark.parametrize(
    "path, pattern, fits",
    [
        ("a/b.xml", "a", True),
        ("a/b.xml", "a/", True),
        ("a/b.xml", "a/b.xml", True),
        ("a/b.xml", "*.xml", True),
        ("a/b.xml", "b.xml", False),
        ("a/b.xml", "a/c", False),
        ("a/b/c", "a/b", True),
        ("a/b/c", "b", False),
        ("ab/c", "a", False),
        ("a", "a", True),
    ],
)
def test_a_pattern_fits_a_path_or_a_folder_above_it(path: str, pattern: str, fits: bool) -> None:
    assert matches_path(path, pattern) is fits


@pytest.mark.parametrize(
    "name, named",
    [
        ("XML104", True),
        ("xml1", True),
        ("placeholder-metadata", True),
        ("placeholder", False),
        ("", False),
        ("SET", False),
    ],
)
def test_names_codes_and_prefixes_name_a_rule(name: str, named: bool) -> None:
    assert bool(named_by(rule_entries()["XML104"], [name])) is named


def test_profiles_and_previews_run_where_they_are_asked_for_or_named() -> None:
    every = Selection(profiles=frozenset(Profile), preview=True).codes()
    assert every == rule_entries().keys()
    usual = Selection().codes()
    assert usual == {c for c, rule in rule_entries().items() if rule.profile is Profile.DEFAULT and not rule.preview}
    pedantic = next(c for c, rule in rule_entries().items() if rule.profile is Profile.PEDANTIC)
    assert pedantic in Selection(extend=(pedantic,)).codes()
    assert usual < Selection(extend=(pedantic,)).codes()
    assert Selection(select=(pedantic,)).codes() == {pedantic}
    assert pedantic not in Selection(select=(pedantic[:4],)).codes()
    assert Selection(select=("XML1",), extend=("SET1",)).codes() == {c for c in usual if c[:4] in ("XML1", "SET1")}


@pytest.mark.parametrize(
    "error, place",
    [
        ("", " "),
        ("ValueError: x", " ValueError: x"),
        (
            'Traceback\n  File "a", line 1, in f\n    x\n  File "b", line 2\nValueError: x\n',
            'File "b", line 2 ValueError: x',
        ),
    ],
)
def test_the_place_of_a_crash_is_the_last_one_with_the_error(error: str, place: str) -> None:
    assert place_of(error) == place


@pytest.mark.parametrize(
    "one, other, touches",
    [
        ((0, 0), (0, 0), False),
        ((0, 0), (1, 1), False),
        ((0, 0), (0, 1), True),
        ((1, 1), (0, 1), True),
        ((0, 1), (1, 2), True),
        ((0, 1), (2, 3), False),
        ((0, 0), (1, 2), False),
        ((0, 3), (1, 2), True),
        ((0, 2), (1, 3), True),
        ((3, 3), (0, 2), False),
    ],
)
def test_two_edits_touch_unless_both_insert(one: tuple[int, int], other: tuple[int, int], touches: bool) -> None:
    assert touch(Span(*one), Span(*other)) is touch(Span(*other), Span(*one)) is touches
