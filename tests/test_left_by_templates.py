"""XML104: what a template left in one package.xml is one finding, as grave as its gravest line."""

from __future__ import annotations

import pytest

from rospkg_cli.example import manifest
from rospkg_cli.finding import Finding
from rospkg_cli.testing import lint_files

TODO = "TODO: Package description"
IGNORE = "<!-- rospkg: ignore[XML104] it will come -->\n  "


def found(text: str, *codes: str) -> list[Finding]:
    return list(lint_files({"package.xml": text}, ["XML104", *codes]).findings)


def left(**more: str) -> str:
    """Return a manifest with the description, the address and the license of a template."""
    text = manifest().replace("Drives my robot", TODO).replace("ada@example.org", "ada@todo.todo")
    text = text.replace("Apache-2.0", "TODO: License declaration")
    for tag, above in more.items():
        text = text.replace(f"<{tag}", f"{above}<{tag}", 1)
    return text


@pytest.mark.parametrize(
    ("old", "new", "level"),
    [
        ("Drives my robot", TODO, "info"),
        ("Drives my robot", "my_pkg", "info"),
        ("ada@example.org", "ada@todo.todo", "info"),
        (">Ada<", ">TODO<", "info"),
        ("Apache-2.0", "TODO", "warning"),
        ("Drives my robot", "", "error"),
    ],
)
def test_only_a_license_that_is_left_harms(old: str, new: str, level: str) -> None:
    assert [each.severity.value for each in found(manifest().replace(old, new))] == [level]


def test_several_lines_are_one_finding_at_the_license() -> None:
    (finding,) = found(left())
    assert finding.severity.value == "warning"
    assert finding.message == (
        "the license is `TODO: License declaration`: it does not say who may use the package; name a license by its "
        "SPDX id; the description and the address `ada@todo.todo` are a template's too"
    )
    lines = left().splitlines()
    assert "<license>" in lines[finding.location.line - 1]
    assert [lines[place.line - 1].split()[0] for place, _ in finding.related] == [
        "<description>TODO:", "<maintainer"
    ]  # fmt: skip


def test_without_a_license_the_first_line_has_it() -> None:
    (finding,) = found(left().replace("TODO: License declaration", "MIT"))
    assert finding.severity.value == "info"
    assert finding.message.startswith(f"the description says `{TODO}`; ")
    assert finding.message.endswith("; the address `ada@todo.todo` is a template's too")


def test_more_lines_than_a_message_holds() -> None:
    people = "".join(f'<author email="a{number}@todo.todo">A</author>\n  ' for number in range(9))
    (finding,) = found(left(license=people))
    assert finding.message.endswith(" `a3@todo.todo`, `a4@todo.todo` and 6 more are a template's too".replace(
        "`a3@todo.todo`, `a4@todo.todo`", "the address `a1@todo.todo`, the address `a2@todo.todo`"
    ))  # fmt: skip
    assert len(finding.related) == 5


@pytest.mark.parametrize("tag", ["description", "maintainer"])
def test_a_comment_silences_its_line_alone(tag: str) -> None:
    (finding,) = found(left(**{tag: IGNORE}), "RPK002")
    assert finding.code == "XML104"
    assert len(finding.related) == 1
    assert ("the description" in finding.message) is (tag != "description")


def test_a_comment_where_the_finding_lies_silences_it() -> None:
    assert found(left(license=IGNORE), "RPK002") == []
    assert found(left(license=IGNORE, maintainer=IGNORE), "RPK002") == []
