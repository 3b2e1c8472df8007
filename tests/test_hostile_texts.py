"""What `new` makes of odd and hostile texts: one line that says why not, or files that are right."""

from __future__ import annotations

import re

import pytest
from planned import plan, texts

from rospkg_cli.scaffold import ScaffoldError
from rospkg_cli.scaffold.template import template_names
from rospkg_cli.sentence import LONGEST, single_line

HOSTILE = ("\r\n::error::x", "\x1b[31m", "a\tb", "\u202e", "\udcff", "\u2028", "x" * 100_000, "\t" * 100_000)
FIELDS = ("template", "license", "version", "distro", "launch", "tests", "email", "nodes", "depends", "msgs", "extras")


@pytest.mark.parametrize("field", FIELDS)
@pytest.mark.parametrize("text", HOSTILE, ids=lambda text: ascii(text[:9]))
def test_a_refusal_is_one_line_whatever_it_quotes(field: str, text: str) -> None:
    lists = ("nodes", "depends", "msgs", "extras")
    asked = {"template": "interfaces"} if field == "msgs" else {}
    with pytest.raises(ScaffoldError) as refused:
        plan(**{**asked, field: (text,) if field in lists else text})
    said = str(refused.value)
    assert said.isprintable()
    assert len(said) <= LONGEST + 3


def test_a_name_of_a_package_is_quoted_on_one_line() -> None:
    with pytest.raises(ScaffoldError, match=r"^`a\\nb` can't be the name"):
        plan("a\nb")


def test_sentences_lose_their_middle_alone() -> None:
    assert single_line("Ünïcode, 机器人 and all") == "Ünïcode, 机器人 and all"
    said = single_line("begin" + "\0" * 10**6 + "end")
    assert said.startswith("begin\\x00")
    assert said.endswith("\\x00end")
    assert len(said) <= LONGEST + 3


@pytest.mark.parametrize("text", ["S:string a, # é\0é", "S:string a '\x1b[2J'", "S:# \udcff"], ids=ascii)
def test_fields_hold_no_control_characters(text: str) -> None:
    with pytest.raises(ScaffoldError, match=r"--msg S: a field or a comment holds '\\\S+'; leave it out"):
        plan(template="interfaces", msgs=(text,))


def test_no_node_is_taken_for_what_pytest_sets_up() -> None:
    with pytest.raises(ScaffoldError, match="pytest takes a module `conftest` for its own setup"):
        plan(nodes=("conftest",))


@pytest.mark.parametrize("message", ["signed_msgs/None", "class/Talk", "int/Talk"])
@pytest.mark.parametrize("template", ["ament_python", "ament_cmake"])
def test_a_message_has_no_name_that_a_language_keeps(template: str, message: str) -> None:
    with pytest.raises(ScaffoldError, match=r"` is a keyword of (Python|C\+\+), and no code could use the message"):
        plan(template=template, nodes=(f"listener:subscriber:{message}",))


@pytest.mark.parametrize("form", ["msgs", "srvs", "actions"])
def test_an_interface_neither(form: str) -> None:
    with pytest.raises(ScaffoldError, match="`None` is a keyword of Python: nothing could import a"):
        plan(template="interfaces", **{form: ("None",)})


@pytest.mark.parametrize("template", template_names())
def test_what_a_template_needs_may_be_asked_for_too(template: str) -> None:
    manifest = texts(plan(template=template))["package.xml"]
    for key in sorted(set(re.findall(r"depend>([\w-]+)</", manifest)) - {"ament_python"}):
        planned = plan(template=template, depends=(key,))
        assert [(each.code, each.message) for each in planned.findings] == []


def test_no_component_is_called_like_the_library_of_its_package() -> None:
    with pytest.raises(ScaffoldError, match="the library of `os` would have the name of its package"):
        plan("os_component", template="ament_cmake", nodes=("os:component",))


def test_a_bringup_starts_no_executable_of_its_own() -> None:
    with pytest.raises(ScaffoldError, match="`data` has no executables: it starts those of others"):
        plan("data", template="bringup", nodes=("data/component",))
