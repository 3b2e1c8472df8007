"""What help texts and documents list is what there is: formats, verbs, options, families, kinds, types, laws."""

from __future__ import annotations

import re
import textwrap
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
from imports import SRC
from typer.main import get_command
from typer.testing import CliRunner

from rospkg_cli.cli.app import app
from rospkg_cli.report import FORMATS
from rospkg_cli.ros.distros import DISTROS
from rospkg_cli.rule import all_rules
from rospkg_cli.scaffold.extras import all_extras
from rospkg_cli.scaffold.launch_format import LAUNCH_FORMATS
from rospkg_cli.scaffold.node_kinds import listed_kinds, offered_kinds
from rospkg_cli.scaffold.template import WORKSPACE, template_names
from rospkg_cli.scaffold.test_level import TEST_LEVELS

ROOT = Path(__file__).parents[1]
PAGES = {path.relative_to(ROOT).as_posix(): path for path in [*ROOT.glob("*.md"), *(ROOT / "docs").glob("*.md")]}
HELD = {name: PAGES[name] for name in PAGES if name != "CHANGELOG.md"}
"""All but the history, which names what once was."""
COMMANDS: dict[str, Any] = get_command(app).commands  # type: ignore[attr-defined]
KINDS = set(offered_kinds())
ARCHITECTURE = "docs/architecture.md"
LISTS = {"README.md": "Kinds of nodes: ", "docs/new.md": r"\| `--node [^|]*\| "}
"""How the lists of kinds begin on pages; `--update-golden` writes them."""


def text(page: str) -> str:
    return PAGES[page].read_text(encoding="utf-8")


def words(page: str, pattern: str) -> list[str]:
    """Return the names in what follows a phrase of a page, up to where the list ends."""
    found = re.search(pattern, text(page), re.DOTALL)
    assert found, f"{page} has no list that begins like {pattern!r}"
    return names(found[1])


def names(listed: str) -> list[str]:
    """Return the names of a list as people write it: `a, b and c (of one sort) or d.`"""
    plain = re.sub(r"\([^)]*\)|C\+\+|[`.]|\b(and|or|in)\b", " ", listed)
    return re.findall(r"[a-z_][\w-]*", plain)


def help_of(verb: str, option: str) -> str:
    [found] = [each.help for each in COMMANDS[verb].params if option in each.opts]
    return str(found)


def rows(page: str, heading: str) -> list[list[str]]:
    """Return the cells of the table below a heading."""
    section = re.search(rf"^## {heading}\n(.*?)(?=^## |\Z)", text(page), re.DOTALL | re.MULTILINE)
    assert section, f"{page} has no heading {heading!r}"
    lines = re.findall(r"^\| (.*) \|$", section[1], re.MULTILINE)
    return [re.split(r" (?<!\\)\| ", line) for line in lines[1:]]


def test_formats_of_reports() -> None:
    files = {
        path.stem for path in (SRC / "report").glob("*.py") if re.search(r"^def render\(report", path.read_text(), re.M)
    }
    assert files == set(FORMATS)
    assert names(help_of("lint", "--format")) == list(FORMATS), "FORMAT_HELP in cli/lint/options.py"
    assert sorted(words("README.md", r"--format (sarif +# and [^\n]*)")) == sorted(FORMATS), (
        "README.md, --format sarif and …"
    )
    assert words(ARCHITECTURE, r"one file a format: ([^|]*)") == list(FORMATS), ARCHITECTURE


def test_kinds_of_nodes(pytestconfig: pytest.Config, monkeypatch: pytest.MonkeyPatch) -> None:
    if pytestconfig.getoption("--update-golden"):
        for page, begins in LISTS.items():
            rewritten = re.sub(rf"({begins})[^|.]*[^|. ]", lambda found: found[1] + listed_kinds(), text(page), count=1)
            paragraphs = rewritten.split("\n\n")
            PAGES[page].write_text("\n\n".join(map(refilled, paragraphs)), encoding="utf-8")
    for page, begins in LISTS.items():
        assert set(words(page, rf"{begins}([^|.]*)")) == KINDS, f"write it with: pytest {__file__} --update-golden"
    monkeypatch.setenv("COLUMNS", "500")
    shown = CliRunner().invoke(app, ["new", "--help"]).output
    assert f"Kinds: {listed_kinds()}." in shown


def refilled(paragraph: str) -> str:
    """Return the paragraph of the kinds with lines as long as they may be, any other as it is."""
    if not paragraph.startswith("Kinds of nodes: "):
        return paragraph
    return textwrap.fill(" ".join(paragraph.split()), 120, break_long_words=False, break_on_hyphens=False)


def test_what_else_new_lets_one_choose() -> None:
    types, forms = {*template_names(), WORKSPACE}, set(LAUNCH_FORMATS)
    assert set(names(help_of("new", "--type"))) == types
    assert set(words("docs/new.md", r"\| `--type`, `-t` \| ([^|]*)")) == types
    assert set(names(help_of("new", "--with").partition("(")[0])) == set(all_extras())
    assert set(words("docs/new.md", r"\| `--with` \| ([^|]*) .comma-separated")) == set(all_extras())
    assert set(words("README.md", r"`--with ([^`]*)`")) == set(all_extras())
    assert set(names(help_of("new", "--launch").partition(":")[2].partition(".")[0])) == forms
    assert set(words("docs/new.md", r"\| `--launch` \| [^:|]*: ([^|]*)")) == forms
    assert set(names(help_of("new", "--tests").partition(".")[0])) == set(TEST_LEVELS)
    assert set(re.findall(r"`(\w+)`", re.search(r"\| `--tests` \| ([^|]*)", text("docs/new.md"))[1])) == set(
        TEST_LEVELS
    )
    assert set(words("docs/new.md", r"\| `--distro` \| ([^;|]*)")) == {each.name for each in DISTROS}


def test_verbs() -> None:
    table = re.findall(r"^\| `rospkg (\w+)", text("README.md"), re.MULTILINE)
    assert sorted(table) == sorted(COMMANDS)
    assert words(ARCHITECTURE, r"the verbs: ([^;]*);") == list(COMMANDS)


def test_hidden_commands_are_named_nowhere() -> None:
    assert not [name for name, command in COMMANDS.items() if command.hidden]


@pytest.mark.parametrize("page", HELD)
def test_commands_that_a_page_shows_can_be_typed(page: str) -> None:
    for verb, options in typed(text(page)):
        assert verb in COMMANDS, f"{page}: rospkg {verb}"
        command = COMMANDS[verb]
        every = [command, *getattr(command, "commands", {}).values()]
        known = {
            name for each in every for parameter in each.params for name in parameter.opts + parameter.secondary_opts
        }
        assert set(options) <= {*known, "--help", "-h"}, f"{page}: rospkg {verb}"


def typed(page: str) -> Iterator[tuple[str, list[str]]]:
    """Yield the verb and the options of commands in code: up to two blanks, where the explanation begins."""
    code = [line for line in page.splitlines() if line.startswith("    ")] + re.findall(r"`([^`\n]+)`", page)
    for line in code:
        for verb, rest in re.findall(r"(?<![\w/.-])rospkg ([a-z]+)\b((?: (?! )[^&]*?)?)(?=  | &&|$)", line):
            yield verb, re.findall(r"(?<!\S)(--[a-z][a-z-]*|-[a-z])\b", rest)


def test_families_of_rules() -> None:
    listed = {code: folder.strip("`") for code, folder, _ in rows(ARCHITECTURE, "The families of rules")}
    there = {rule.family: rule.check.__module__.split(".")[-2] for rule in all_rules()}
    assert listed == there


@pytest.mark.parametrize("page", HELD)
def test_rules_that_a_page_names_are_there_and_counted_rightly(page: str) -> None:
    known = {rule.code for rule in all_rules()}
    assert {int(number) for number in re.findall(r"\b(\d+) rules\b", text(page))} <= {len(known)}
    families = "|".join({code[:3] for code in known})
    assert set(re.findall(rf"\b(?:{families})\d{{3}}\b", text(page))) <= known


def test_every_folder_is_in_the_drawing_and_every_file_that_is_in_it_is_there() -> None:
    """`test_house.FLOORS` says where each file stands; the page may leave small ones out."""
    listed = {name for first, _ in rows(ARCHITECTURE, "The rooms") for name in re.findall(r"`([^`]+)`", first)}
    assert {name for name in listed if name.endswith("/")} == {
        f"{path.parent.name}/" for path in SRC.glob("*/__init__.py")
    }
    assert all((SRC / name).exists() for name in listed)


def test_laws_name_tests_that_are_there() -> None:
    laws = rows(ARCHITECTURE, "The laws")
    assert [number for number, _, _ in laws] == [str(number) for number in range(1, len(laws) + 1)]
    for _, _, held in laws:
        for file, _, name in (each.partition("::") for each in re.findall(r"`([^`]+)`", held)):
            assert (
                f"def {name}(" in (ROOT / "tests" / file).read_text(encoding="utf-8")
                if name
                else (ROOT / "tests" / file).exists()
            ), name


def test_words_name_classes_that_are_there() -> None:
    there = {name for path in SRC.rglob("*.py") for name in re.findall(r"^class (\w+)", path.read_text("utf-8"), re.M)}
    named = {name for row in rows(ARCHITECTURE, "Words") for name in re.findall(r"`([A-Z][a-z]\w+)`", " ".join(row))}
    assert named
    assert named <= there


@pytest.mark.parametrize("page", ["CONTRIBUTING.md", ARCHITECTURE])
def test_paths_that_a_page_names_are_there(page: str) -> None:
    folders = "src|tests|bench|docs|templates|schemas|languages|package|checks|report|engine|\\.ci"
    named = re.findall(rf"(?<![\w/.-])((?:{folders})/[\w./]*\w)", text(page))
    assert named
    for path in named:
        assert (ROOT / path).exists() or (SRC / path).exists(), f"{page}: {path}"
