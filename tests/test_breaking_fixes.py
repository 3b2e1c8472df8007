"""Which fixes are refused where a round would make a file unreadable: those that break it, and no bystander."""

from __future__ import annotations

import pytest

from rospkg_cli.engine.fixing import round as fixing_round
from rospkg_cli.engine.fixing.overlay import Overlay
from rospkg_cli.engine.fixing.round import breaking_fixes, newly_unreadable, one_round
from rospkg_cli.example import manifest
from rospkg_cli.finding import Edit, Finding, Fix, Location, Move, Operation, Severity
from rospkg_cli.source import Span
from rospkg_cli.tree import MemoryTree

TEXT = manifest("  <depend>rclcpp</depend>\n")
AT = TEXT.index("<depend") + len("<depend")
TREE = Overlay(
    MemoryTree.of({"a/package.xml": TEXT, "b/package.xml": TEXT, "a/launch/x.txt": "<launch>", "a/setup.cfg": ""}), {}
)


def finding(*operations: Operation) -> Finding:
    place = Location("a/package.xml", Span(0, 1), 1, 1, 1, 2)
    return Finding("XML104", "x", Severity.WARNING, "why", place, "a", fix=Fix("Do it", operations))


def put(text: str, path: str = "a/package.xml", at: int = AT) -> Finding:
    return finding(Edit(path, Span(at, at), text))


BREAKS, HARMLESS, ELSEWHERE = put("<"), put(' version_gte="1"'), put(' version_gte="1"', "b/package.xml")
MOVES = finding(Move("a/launch/x.txt", "a/launch/x.launch.xml"))


def breaking(*left: Finding, path: str = "a/package.xml") -> list[Finding]:
    return breaking_fixes(TREE, ["a", "b"], left, {path: "why"})


def test_one_that_breaks_it_by_itself() -> None:
    assert breaking(HARMLESS, BREAKS, ELSEWHERE) == [BREAKS]


def test_several_that_break_it_together_and_no_bystander() -> None:
    same = put(' version_gte="2"')
    assert breaking(HARMLESS, ELSEWHERE, same) == [HARMLESS, same]
    changes, done, refused = one_round(TREE, ["a", "b"], [HARMLESS, ELSEWHERE, same], {})
    assert (list(changes), done) == (["b/package.xml"], [ELSEWHERE])
    assert [each.finding for each in refused] == [HARMLESS, same]
    assert {each.why.partition(":")[0] for each in refused} == {"it would break `a/package.xml`"}


def test_a_file_that_is_moved_is_touched_under_both_names() -> None:
    assert breaking(MOVES, ELSEWHERE, path="a/launch/x.launch.xml") == [MOVES]
    assert breaking(MOVES, ELSEWHERE, path="a/launch/x.txt") == [MOVES]


@pytest.mark.parametrize("most, expected", [(2, [BREAKS]), (1, [HARMLESS, BREAKS])])
def test_none_of_many_is_tried_alone(monkeypatch: pytest.MonkeyPatch, most: int, expected: list[Finding]) -> None:
    monkeypatch.setattr(fixing_round, "MAX_TRIED", most)
    assert breaking(HARMLESS, ELSEWHERE, BREAKS) == expected


def test_a_file_counts_where_it_could_be_read_before() -> None:
    broken = Overlay(MemoryTree.of({"a/package.xml": TEXT + "<"}), {})
    changes, _ = fixing_round.apply_fixes(broken, [each.fix for each in (HARMLESS,) if each.fix])
    assert newly_unreadable(broken, changes, ["a"]) == {}
    changes, _ = fixing_round.apply_fixes(TREE, [each.fix for each in (BREAKS,) if each.fix])
    assert newly_unreadable(TREE, changes, ["a", "b"]).keys() == {"a/package.xml"}
    assert newly_unreadable(TREE, changes, ["b"]) == {}
