"""What the documents promise holds: README's commands, the problem matcher, the verbs."""

from __future__ import annotations

import html
import json
import re
import sys
from pathlib import Path

from in_process import run_here as rospkg
from typer.main import get_command

from rospkg_cli.cli.app import app
from rospkg_cli.scaffold.template import read_template

ROOT = Path(__file__).parents[1]
NEW = (
    "python3 -m venv .venv && .venv/bin/pip install . && .venv/bin/rospkg new my_robot_nav"
    " && .venv/bin/rospkg lint my_robot_nav"
)
TEST = "python3 -m venv .venv && .venv/bin/pip install -e '.[test]' && .venv/bin/pytest"


def test_readme_has_the_two_commands_each_in_a_line() -> None:
    lines = [line.strip() for line in (ROOT / "README.md").read_text().splitlines()]
    assert NEW in lines
    assert TEST in lines


def test_readme_names_every_verb() -> None:
    text = (ROOT / "README.md").read_text()
    for command in app.registered_commands:
        assert f"`rospkg {command.name or command.callback.__name__}" in text
    change = (ROOT / "docs/change.md").read_text()
    for group in app.registered_groups:
        assert f"`rospkg {group.name}" in text
        for command in group.typer_instance.registered_commands:
            name = f"rospkg {group.name} {command.name or command.callback.__name__}"
            assert f"`{name}`" in text or f"    {name} " in change


def test_the_problem_matcher_reads_concise(tmp_path, write, clean) -> None:
    blocks = re.findall(r"```json\n(.*?)```", (ROOT / "docs/in-the-flow.md").read_text(), re.DOTALL)
    pattern = json.loads(blocks[0])["problemMatcher"]["pattern"]
    manifest = clean["package.xml"].replace("Apache-2.0", "TODO")
    package = write(tmp_path / "a folder" / "my_pkg", {**clean, "package.xml": manifest})
    (line,) = rospkg("lint", "--format", "concise", cwd=package.parent).stdout.splitlines()
    found = re.fullmatch(pattern["regexp"], line)
    assert found
    assert found.group(pattern["file"]) == "my_pkg/package.xml"
    assert found.group(pattern["severity"]) == "warning"
    assert found.group(pattern["code"]) == "XML104"


def test_the_page_on_new_names_its_options_and_a_template_that_can_be_read(tmp_path) -> None:
    text = (ROOT / "docs/new.md").read_text()
    [command] = [command for command in get_command(app).commands.values() if command.name == "new"]
    options = {name for parameter in command.params for name in (*parameter.opts, *parameter.secondary_opts)}
    named = set(re.findall(r"(?<![\w-])--[a-z][a-z-]*", text)) - {"--packages-select"}
    assert named <= options
    told_by_help = {"--build-type", "--description", "--maintainer", "--email", "--license", "--version", "--year"}
    assert {name for name in options if name.startswith("--")} - named <= told_by_help | {"--into", "--color", "--help"}
    [block] = [block for block in re.findall(r"```toml\n(.*?)```", text, re.DOTALL) if "build-type" in block]
    (tmp_path / "template.toml").write_text(block)
    assert len(read_template(tmp_path).files) == 4


def test_the_picture_shows_what_lint_says_today(tmp_path, write) -> None:
    """docs/lint.svg, which docs/picture.py draws."""
    sys.path.insert(0, str(ROOT / "docs"))
    from picture import COMMAND, package

    files = {path.replace("my_pkg", "my_robot_nav"): text for path, text in package().items()}
    write(tmp_path / "my_robot_nav", {path: text.replace("my_pkg", "my_robot_nav") for path, text in files.items()})
    said = rospkg(*COMMAND.split()[1:], cwd=tmp_path).stdout
    drawn = html.unescape(re.sub(r"<[^>]+>", "", (ROOT / "docs/lint.svg").read_text("utf-8").partition("</style>")[2]))
    words = re.findall(r"[\w./]{3,}", re.sub(r"in [\d.]+ ?m?s", "", said))
    assert len(words) > 60
    assert [word for word in words if word not in drawn] == []


def test_hooks_run_verbs_that_exist() -> None:
    verbs = {command.name or command.callback.__name__ for command in app.registered_commands}
    for entry in re.findall(r"entry: rospkg (\w+)", (ROOT / ".pre-commit-hooks.yaml").read_text()):
        assert entry in verbs
