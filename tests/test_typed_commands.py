"""Each command line of README and of the pages is typed, section by section; or it says here why not."""

from __future__ import annotations

import io
import re
import shlex
import subprocess
import sys
from collections.abc import Mapping
from pathlib import Path

import pytest
from in_process import run_here
from small_rosdistro import FILES
from typed_pages import PAGES, ROOT, Typed, typed
from typer.main import get_command

from rospkg_cli.cli.app import app
from rospkg_cli.example import Example

NOT_TYPED = {
    r"(python3 -m venv|pipx|uvx|pip) ": "installs: tests/real/test_install.py does, from this folder",
    r"(colcon|source|ros2) ": "needs ROS; tests/real builds with the real colcon",
    r"\.venv/bin/(pytest|ruff|pre-commit|pip|mkdocs)|\.ci/run": "runs these tests, or the site around them",
    r"\.venv/bin/python (-m )?bench": "measures for minutes",
    r"rospkg index update --source https:": "needs the network; tests/test_index.py has a server of its own",
    r"rospkg server": "waits for an editor: tests/test_server.py is one",
    r"rospkg lint --watch": "waits for changes: tests/test_watch.py makes some",
    r"rospkg (rules OUR|explain OUR001|lint --select OUR)": "of a plugin: tests/test_site.py installs it",
    r"rospkg --install-completion": "writes into the shell's files; tests/real/test_completion.py asks the shells",
    r"git config --global": "writes into the user's own config",
    r"rospkg new \.$": "wants an empty folder: tests/test_new_existing.py has one",
    r"rospkg new --template$": "names an option; tests/test_own_templates.py uses it",
}
"""What is not typed here (the start of a line) and why."""
ELSEWHERE = {"docs/exercises.md": "tests/test_exercises.py", "docs/comparison.md": "tests/test_comparison.py"}
"""Pages whose commands have a test of their own."""
FORMS = {
    "rospkg new NAME": "rospkg new my_new",
    "rospkg add WHAT NAME": "rospkg add node hello --package my_new",
    "rospkg remove WHAT NAME": "rospkg remove node hello --package my_new --allow-dirty",
    "rospkg rename OLD NEW": "rospkg rename my_new my_newer --allow-dirty",
    "rospkg upgrade --to DISTRO": "rospkg upgrade --to kilted",
    "rospkg help VERB": "rospkg help lint",
    "rospkg rules [CODES…]": "rospkg rules SET",
    "rospkg explain CODE": "rospkg explain SET101",
    "rospkg add plugin NAME:KIND": "rospkg add plugin wall:costmap-layer --package my_wall",
    "rospkg lint --output junit:FILE": "rospkg lint --output junit:rospkg.xml",
    "rospkg lint --output junit:build/<package>/rospkg.xml": "rospkg lint --output junit:build/my_pkg/rospkg.xml",
}
"""Forms, which have words of capitals, as somebody would type them."""
SETUP = """\
from setuptools import setup

setup(
    name='my_pkg', version='0.1.0', packages=['my_pkg'], tests_require=['pytest'],
    data_files=[('share/ament_index/resource_index/packages', ['resource/my_pkg']), ('share/my_pkg', ['package.xml'])],
)
"""
FAULTLESS = Example(bad={}, good={}).bad_files()
OLD = {f"src/my_pkg/{path}": text for path, text in {**FAULTLESS, "setup.py": SETUP}.items()}
OTHERS = {"ours.toml": "", **{f"rosdistro/{path}": text for path, text in FILES.items()}}
FROM_SCRATCH = (
    "docs/first-package.md",
    "docs/index.md",
    "docs/new.md",
    "README.md: Writing",
    "docs/coming-from.md: ros2 pkg create",
)
"""Pages, or sections of them, that begin in an empty folder; the others have a workspace with an old package."""
IN_ONE_GO = ("docs/first-package.md", "docs/adopting.md")
"""Pages that are followed from the first line to the last."""
BEFORE = {
    "docs/change.md": (
        "new my_robot -t ament_cmake --node planner --minimal",
        "new my_arm -t ament_cmake --minimal",
        "new my_msgs -t interfaces --msg Other:'bool on' --minimal",
    ),
    "docs/change.md: Another name": ("new my_robot --node drive", "new my_arm --node talker"),
    "docs/editors.md: Without a server": ("new src/my_robot_nav",),
    "docs/new.md: Update": ("new my_robot_nav", "new my_ws --type workspace"),
    "docs/new.md: Where the folder exists": ("new my_robot_nav -t ament_cmake --node talker",),
    "docs/new.md: Nodes about an interface": ("new my_msgs -t interfaces --msg RobotStatus:'bool on' --srv SetGoal",),
}
"""What somebody has who reads a section, as commands."""
PLACES = {r"rospkg (add|remove) (msg|srv|action) ": "my_msgs", r"rospkg (add|remove) (?!.*--package)": "my_robot"}
"""Where a line of docs/change.md is typed, if not in the workspace."""
MAY_FIND = ("lint", "upgrade", "format", "rename", "add")
"""Verbs that end with 1 where something is left, or is only shown."""
KEEPING = ("docs/cache.md: What lint remembers", "docs/names.md: The index", "README.md: What you type")
"""Sections that speak of what is kept of a run."""
VERBS = get_command(app).commands
QUIET = {"GIT_CONFIG_NOSYSTEM": "1", "ROS_DISTRO": "jazzy"}


def why_not(page: str, line: str) -> str | None:
    """Return why a line is not typed; a name of a verb that wants more words is only a mention."""
    return ELSEWHERE.get(page) or next((why for start, why in NOT_TYPED.items() if re.match(start, line)), None)


def in_sections(page: str) -> Mapping[str, list[Typed]]:
    """Return the lines to type of a page, by section; a span that repeats a line, or names a verb alone, is none."""
    found: dict[str, list[Typed]] = {}
    seen: set[str] = set()
    for each in typed(page):
        if why_not(page, each.line) or (each.is_span and (each.line in seen or is_mention(each.line))):
            continue
        seen.add(each.line)
        found.setdefault("" if page in IN_ONE_GO else each.section, []).append(each)
    return found


def is_mention(line: str) -> bool:
    """Return whether a span only names a verb, which has to be there."""
    verb, *rest = line.split()[1:]
    group = getattr(VERBS.get(verb), "commands", {})
    return verb in VERBS and (not rest or (rest[0] in group and len(rest) == 1))


SECTIONS = [(page, section) for page in PAGES for section in in_sections(page)]


@pytest.fixture(scope="module")
def home(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp("home")
    (folder / ".gitconfig").write_text("[user]\n\tname = Ada Lovelace\n\temail = ada@example.org\n")
    return folder


@pytest.mark.parametrize("page, section", SECTIONS, ids=lambda word: word.removeprefix("docs/"))
def test_the_commands_of_a_section_do_what_they_say(
    page: str, section: str, tmp_path: Path, home: Path, write, monkeypatch: pytest.MonkeyPatch
) -> None:
    for name, value in {**QUIET, "HOME": str(home), "GIT_CONFIG_GLOBAL": str(home / ".gitconfig")}.items():
        monkeypatch.setenv(name, value)
    monkeypatch.setenv("ROSDISTRO_INDEX_URL", (tmp_path / "rosdistro/index-v4.yaml").as_uri())
    if f"{page}: {section}" in KEEPING:
        monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
    begin(page, section, tmp_path, write)
    place = tmp_path
    for each in in_sections(page)[section]:
        if each.line.startswith("cd "):
            place /= each.line[3:]
        else:
            type_it(each, place_of(page, each.line, place), monkeypatch)


def begin(page: str, section: str, folder: Path, write) -> None:
    """Write what somebody has who reads a section."""
    title = f"{page}: {section}"
    before = BEFORE.get(title) or (() if title.startswith("docs/change.md: M") else BEFORE.get(page, ()))
    if page not in FROM_SCRATCH and title not in FROM_SCRATCH:
        write(folder, {**({} if before else OLD), **OTHERS})
    for command in before:
        done = run_here(*shlex.split(command), cwd=folder)
        assert done.returncode == 0, done.stderr
    for command in ("init -q", "add .", "commit -q --allow-empty -m old", "update-ref refs/remotes/origin/main HEAD"):
        subprocess.run(["git", *command.split()], cwd=folder, check=True, timeout=60)


def place_of(page: str, line: str, folder: Path) -> Path:
    places = PLACES.items() if page == "docs/change.md" else ()
    return folder / next((place for start, place in places if re.match(start, line)), "")


def type_it(each: Typed, place: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    line = FORMS.get(each.line, re.sub(r" \[.*?\]", "", each.line))
    command, _, target = line.partition(" > ")
    command, _, source = command.partition(" < ")
    if command.startswith("--"):
        command = f"rospkg new my_example --dry-run {command}"
    if source:
        monkeypatch.setattr(sys, "stdin", io.TextIOWrapper(io.BytesIO(FAULTLESS["package.xml"].encode())))
    words = shlex.split(command.replace("~", str(place)))[1:]
    done = run_here(*words, cwd=place)
    said = f"{line}\n{done.stdout}{done.stderr}"
    may_find = words[0] in MAY_FIND and not re.search("--exit-zero|baseline", line)
    assert done.returncode in ((0, 1) if may_find else (0,)), said
    for part in (*re.findall(r'^# "([^"]+)"', each.beside), *each.prints):
        assert part in " ".join(said.split()), said
    assert not target or "<!doctype html>" in done.stdout


def test_a_block_can_be_copied_into_a_shell() -> None:
    beside = [(page, each.beside) for page in PAGES for each in typed(page) if each.beside]
    assert [words for words in beside if not words[1].startswith("# ")] == []
    assert len(beside) > 60


def test_what_is_not_typed_is_somewhere() -> None:
    lines = [(page, each.line) for page in PAGES for each in typed(page)]
    assert [start for start in NOT_TYPED if not any(re.match(start, line) for _, line in lines)] == []
    assert [form for form in FORMS if form not in {line for _, line in lines}] == []
    named = re.findall(r"(?<![\w/])(?:tests|bench)/[\w/]+\.py", " ".join([*NOT_TYPED.values(), *ELSEWHERE.values()]))
    benches = [match[0].replace(".", "/") + ".py" for _, line in lines if (match := re.search(r"bench\.\w+", line))]
    files = [word for _, line in lines for word in re.findall(r"(?:tests|bench)/[\w/]+\.py", line)]
    missing = {path for path in (*named, *benches, *files) if not (ROOT / path).is_file()}
    assert {path for path in missing if not (ROOT / path.removesuffix(".py")).is_dir()} == set()
    assert set(ELSEWHERE) <= set(PAGES)
