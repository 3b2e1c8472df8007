"""Ignores: in comments and in the config, with reasons; needless and misspelt ones are findings."""

from __future__ import annotations

import pytest

from rospkg_cli.engine.suppression.comments import removal
from rospkg_cli.source import Source, Span
from rospkg_cli.testing import lint_files

BEFORE = "  <description>"
IGNORE = "<!-- rospkg: ignore[XML104] no -->"
WHOLE = "<!-- rospkg: ignore-file[XML104] draft -->"


def with_comment(clean: dict[str, str], comment: str, *, same_line: bool = False) -> dict[str, str]:
    text = clean["package.xml"].replace("Drives my robot", "TODO")
    new = f"{BEFORE}TODO</description> {comment}" if same_line else f"  {comment}\n{BEFORE}TODO</description>"
    return {**clean, "package.xml": text.replace(f"{BEFORE}TODO</description>", new)}


@pytest.mark.parametrize("name", ["XML104", "placeholder-metadata", "XML1", "SET101, XML104"])
@pytest.mark.parametrize("same_line", [True, False])
def test_a_comment_silences_its_line_and_the_next(clean, name, same_line) -> None:
    comment = f"<!-- rospkg: ignore[{name}] it will come -->"
    results = lint_files(with_comment(clean, comment, same_line=same_line), ["XML104"])
    assert results.findings == ()
    assert [f.suppressed for f in results.suppressed] == ["it will come"]


def test_elsewhere_it_silences_nothing(clean) -> None:
    files = with_comment(clean, "")
    files["package.xml"] = files["package.xml"].replace(
        "  <export>", "  <!-- rospkg: ignore[XML104] no -->\n  <export>"
    )
    codes = [f.code for f in lint_files(files, ["XML104", "RPK002"]).findings]
    assert sorted(codes) == ["RPK002", "XML104"]


def test_ignore_file_holds_for_the_file(clean) -> None:
    files = with_comment(clean, "")
    files["package.xml"] = files["package.xml"].replace(
        "<package", "<!-- rospkg: ignore-file[XML104] draft -->\n<package", 1
    )
    results = lint_files(files, ["XML104", "RPK002"])
    assert results.findings == ()
    assert len(results.suppressed) == 1


def test_rules_that_did_not_run_are_not_judged(clean) -> None:
    files = {**clean, "setup.py": "# rospkg: ignore[XML104] elsewhere\n" + clean["setup.py"]}
    assert lint_files(files, ["RPK002"]).findings == ()
    assert [f.code for f in lint_files(files, ["RPK002", "XML104"]).findings] == ["RPK002"]


def test_text_in_a_string_is_no_comment(clean) -> None:
    files = {**clean, "setup.py": clean["setup.py"] + '\nHELP = """\n# rospkg: ignore[XML104] shown to users\n"""\n'}
    assert lint_files(files, ["RPK002", "XML104"]).findings == ()


def test_one_code_of_several_is_taken_out(clean) -> None:
    comment = "<!-- rospkg: ignore[XML104, RPK003] it will come -->"
    (finding,) = lint_files(with_comment(clean, comment), ["XML104", "RPK002", "RPK003"]).findings
    assert finding.code == "RPK002"
    assert "`RPK003`" in finding.message
    (edit,) = finding.fix.operations
    text = with_comment(clean, comment)["package.xml"]
    assert "ignore[XML104]" in text[: edit.span.start] + text[edit.span.end :]


@pytest.mark.parametrize(
    "text, alone, left",
    [
        ("a\n  # c\nb\n", True, "a\nb\n"),
        ("a  # c\nb\n", False, "a\nb\n"),
        ("a\n  # c", True, "a\n"),
        ("a  # c", False, "a"),
    ],
)
def test_a_comment_that_is_removed_takes_its_blanks_along_and_its_line_where_it_is_alone(text, alone, left) -> None:
    at = text.index("#")
    span = removal(Source("a.py", text), Span(at, at + 3), alone)
    assert text[: span.start] + text[span.end :] == left


def test_a_comment_without_a_reason_silences_and_is_told(clean) -> None:
    comment = "<!-- rospkg: ignore[XML104, SET101] -->"
    results = lint_files(with_comment(clean, comment), ["XML104", "RPK009"])
    assert [(f.code, f.message) for f in results.findings] == [
        ("RPK009", "the ignore of `XML104, SET101` gives no reason; write one after the bracket")
    ]
    assert [f.code for f in results.suppressed] == ["XML104"]
    assert lint_files(with_comment(clean, comment.replace("]", "] soon")), ["XML104", "RPK009"]).findings == ()
    unused = {**clean, "setup.py": "# rospkg: ignore[XML104]\n" + clean["setup.py"]}
    assert [f.code for f in lint_files(unused, ["RPK002", "RPK009", "XML104"]).findings] == ["RPK002"]


@pytest.mark.parametrize(
    "comment",
    [
        "# rospkg: ignore",
        "# rospkg: ignore the line below",
        "# rospkg: ignore[] no code",
        "# rospkg: ignore-file",
        "#rospkg:ignore SET101 brackets are missing",
    ],
)
def test_a_comment_that_names_no_rule_is_told(clean, comment: str) -> None:
    (finding,) = lint_files({**clean, "setup.py": f"{comment}\n{clean['setup.py']}"}, ["RPK003"]).findings
    assert finding.message == "this comment names no rule, so it ignores nothing; write `rospkg: ignore[CODE] reason`"
    assert (finding.location.line, finding.location.column, finding.location.end_column) == (1, 1, len(comment) + 1)


@pytest.mark.parametrize(
    "text", ["# rospkg: ignored", "# rospkg: ignore-files", "# rospkg: ignore[SET", "# rospkg ignore"]
)
def test_what_is_no_ignore_comment_is_none(clean, text: str) -> None:
    assert lint_files({**clean, "setup.py": f"{text}\n{clean['setup.py']}"}, ["RPK003"]).findings == ()
