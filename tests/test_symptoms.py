"""docs/symptoms.md leads from what was printed to rules that are there, and says rightly how each is repaired."""

from __future__ import annotations

import re
from pathlib import Path

import pytest

from rospkg_cli.finding import Safety
from rospkg_cli.rule import all_rules

PAGE = Path(__file__).parents[1] / "docs/symptoms.md"
BY = {Safety.SAFE: "`--fix`", Safety.UNSAFE: "`--unsafe-fixes`", None: "hand"}
RULES = {rule.code: rule for rule in all_rules()}
SECTIONS = re.findall(r"^### `(.*)`\n\n((?:\|.*\n)+)", PAGE.read_text(encoding="utf-8"), re.MULTILINE)
SEARCHED = {
    "package 'robot_state_publisher' not found, searching": "DEP103",
    "error while loading shared libraries": "CMK103",
    "ModuleNotFoundError: No module named 'cv2'": "DEP101",
    "Unknown distribution option: 'tests_require'": "SET304",
    "NO TESTS RAN": "SET304",
    "Compatibility with CMake < 3.10": "CMK002",
    'Unknown CMake command "ament_target_dependencies"': "CMK005",
    "Could not find a package configuration file provided by": "DEP104",
    "Cannot locate rosdep definition for [ament_python]": "XML207",
    "Cannot locate rosdep definition for [rospy]": "DEP203",
    "libexec directory": "SET001",
    "No executable found": "SET106",
    "can't copy 'resource/": "SET202",
    "was not found in the share directory of package": "SET204",
    "ament_xmllint": "XML002",
    "Packages installing interfaces must include": "XML305",
    "must not contain the following tags: member_of_group": "XML004",
    "is an invalid message name. It should have the pattern": "IDL002",
    "Could not find separator '---'": "IDL001",
    "silently ignored": "PRM003",
    "has invalid type": "PRM006",
    "because another target with the same name already exists": "CMK006",
    "TODO: Package description": "XML104",
    "Usage of dash-separated 'script-dir'": "SET003",
    "is redundant with: build_depend": "XML202",
    "Duplicate package names not supported": "WSP001",
    "Unable to parse the value of parameter robot_description as yaml": "LCH009",
    "missing 1 required keyword-only argument: 'executable'": "LCH005",
    "pkg_resources.DistributionNotFound": "SET306",
    "does not match current PROJECT_NAME": "CMK001",
    "License classifiers are deprecated": "SET305",
    "No task extension to 'build'": "XML302",
    "'distutils.core.setup()' was never called": "SET103",
}
"""Parts of messages that people search for, and a rule that each has to lead to."""


def rows(table: str) -> list[list[str]]:
    return [line.strip("|\n ").split(" | ") for line in table.splitlines()[2:]]


@pytest.mark.parametrize("part", SEARCHED)
def test_a_message_leads_to_its_rule(part: str) -> None:
    found = [codes for message, codes in SECTIONS if part in message]
    assert any(f"[{SEARCHED[part]}]" in codes for codes in found)


@pytest.mark.parametrize("message, table", SECTIONS, ids=[message for message, _ in SECTIONS])
def test_its_rules_are_there_and_repaired_as_it_says(message: str, table: str) -> None:
    for cause, rule, repair, by in rows(table):
        code = rule[1:7]
        assert rule == f"[{code}](rules/{code}.md)"
        assert by == BY[RULES[code].fix], f"{message}: {code}"
        assert cause
        assert repair


def test_each_heading_has_its_table() -> None:
    text = PAGE.read_text(encoding="utf-8")
    assert len(SECTIONS) == text.count("\n### ")
    assert len({message for message, _ in SECTIONS}) == len(SECTIONS)
