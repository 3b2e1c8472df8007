"""The laws of the house, by reading its imports and running its middle."""

from __future__ import annotations

import ast
import dataclasses
import os
import pickle
import re
import subprocess
import sys
from pathlib import Path

import pytest
from imports import SRC, imports, modules, outside

from rospkg_cli.example import Example, manifest
from rospkg_cli.finding import Edit, Fix
from rospkg_cli.package.package_facts import PackageFacts
from rospkg_cli.package.workspace import Workspace
from rospkg_cli.source import Span
from rospkg_cli.testing import lint_files

RULES = [name for name in modules() if name.startswith("rules.") and name.count(".") == 2]
FLOORS = (
    {
        "",
        "lazy_regex",
        "light_dataclasses",
        "user_error",
        "source",
        "encoding",
        "control_characters",
        "sentence",
        "suggest",
        "ros",
        "resources",
        "current_folder",
        "leftovers",
        "gitignore",
        "search_path",
        "disk_trace",
        "read_problem",
    },
    {"tree", "absent_paths", "file_text", "finding", "unreadable"},
    {"fence", "files"},
    {"disk", "cache"},
    {"languages"},
    {"package"},
    {"checks"},
    {"edits", "example"},
    {"rule"},
    {"rule_table", "rule_address"},
    {"rules"},
    {"config"},
    {"engine"},
    {"rule_docs"},
    {"report", "scaffold", "index"},
    {"change", "graph", "lookup"},
    {"addition", "renaming"},
    {"cli"},
    {"testing"},
    {"__main__"},
)


def floor(name: str) -> int:
    first = name.partition(".")[0]
    return next(number for number, names in enumerate(FLOORS) if first in names)


@pytest.mark.parametrize("name", RULES)
def test_a_rule_imports_only_what_it_may(name: str) -> None:
    """Law 1."""
    allowed = {
        "lazy_regex",
        "light_dataclasses",
        "rule",
        "example",
        "finding",
        "source",
        "suggest",
        "files",
        "unreadable",
    }
    rooms = {"languages", "package", "checks", "edits", "ros"}
    assert not {i for i in imports(name) if i not in allowed and i.partition(".")[0] not in rooms}


TEXTS = {"lazy_regex", "light_dataclasses", "read_problem", "source", "encoding", "tree", "files", "unreadable"}
ROOMS = {
    "languages": TEXTS,
    "package": {*TEXTS, "languages", "ros", "suggest", "resources"},
    "checks": {*TEXTS, "languages", "package", "ros", "suggest"},
}


@pytest.mark.parametrize("room", ROOMS)
def test_the_three_rooms_of_what_is_known(room: str) -> None:
    """Law 2: languages know no ROS, packages no judgement, and none of them a rule, a finding or an edit."""
    for name in modules():
        if name.partition(".")[0] == room:
            assert not {i for i in imports(name) if i.partition(".")[0] not in {room, *ROOMS[room]}}, name


def test_dataclasses_are_cheap_to_define() -> None:
    """A dataclass of the standard library takes 0.4 ms to define, at each start of the command."""
    dear = {name for name in modules() if "dataclasses" in outside(name)}
    assert dear == {"light_dataclasses"}


def test_findings_pickle() -> None:
    """Law 3."""
    findings = lint_files({"package.xml": manifest().replace("Drives my robot", "TODO")}).findings
    assert findings
    assert pickle.loads(pickle.dumps(findings)) == findings


def test_a_fix_may_not_overlap_itself() -> None:
    """Law 4."""
    with pytest.raises(ValueError, match="overlap"):
        Fix("twice", (Edit("a", Span(0, 4), ""), Edit("a", Span(3, 5), "")))


def test_ros_knowledge_is_spelled_once() -> None:
    """Law 5: no list of distributions, build types or dependency tags outside ros/."""
    from rospkg_cli.ros.distros import DISTROS
    from rospkg_cli.ros.manifest import BUILD_TYPES, DEPENDENCY_TAGS

    for known in ({d.name for d in DISTROS}, set(BUILD_TYPES), set(DEPENDENCY_TAGS)):
        for name, tree in modules().items():
            if name.startswith("ros."):
                continue
            for node in ast.walk(tree):
                if isinstance(node, ast.Tuple | ast.List | ast.Set):
                    values = [e.value for e in node.elts if isinstance(e, ast.Constant)]
                    assert len(known.intersection(v for v in values if isinstance(v, str))) < 4, (name, node.lineno)


WRITERS = {"engine.fixing.write", "engine.fixing.move", "engine.fixing.remove_leftovers"}
"""The cache writes, too: into its own folder alone."""
WRITING = {"write_text", "write_bytes", "mkdir", "unlink", "rename", "replace_file", "rmtree", "makedirs", "chmod"}


def test_few_modules_write_to_the_disk() -> None:
    """Law 6: what changes files goes through one door (templates have theirs)."""
    for name, tree in modules().items():
        called = {n.func.attr for n in ast.walk(tree) if isinstance(n, ast.Call) and isinstance(n.func, ast.Attribute)}
        if name not in WRITERS and not name.startswith(("scaffold", "index", "cache")):
            assert not called & WRITING, name


RUNNERS = {"exec", "eval", "compile", "__import__", "execfile"}


COMPILES = "languages.python.compile_errors"
"""Lets Python compile a text to see whether it does, and keeps nothing of it that could be run."""

INSTALLED = "engine.run.rule_plugins"
"""Loads rules that the user installed, by the names of their entry points: nothing of a linted package."""


def test_nothing_of_a_linted_package_is_executed() -> None:
    """Law 8."""
    for name, tree in modules().items():
        if name.partition(".")[0] not in {*ROOMS, "rules", "edits", "ros", "engine"} or name == INSTALLED:
            continue
        assert not outside(name) & {"subprocess", "runpy", "importlib", "imp", "pty"}, name
        called = {n.func.id for n in ast.walk(tree) if isinstance(n, ast.Call) and isinstance(n.func, ast.Name)}
        assert not called & (RUNNERS - {"compile"} if name == COMPILES else RUNNERS), name


def test_no_import_goes_up() -> None:
    """Law 9: no import from a lower floor to a higher one. (`rule` finds its rules by walking their folder.)"""
    for name in modules():
        for other in imports(name) - {"rules"}:
            assert floor(other) <= floor(name), f"{name} imports {other}"


def test_no_circles() -> None:
    """Law 9."""
    done: set[str] = set()

    def visit(name: str, path: tuple[str, ...]) -> None:
        assert name not in path, " → ".join([*path, name])
        if name not in done:
            for other in imports(name) - {"rules", ""}:
                if not (name.startswith(other + ".") or other.startswith(name + ".")):
                    visit(other, (*path, name))
            done.add(name)

    for name in modules():
        visit(name, ())


def test_no_circles_between_folders() -> None:
    """Law 9, one level up from files; a folder and those in it count as one with each other."""
    edges: dict[str, set[str]] = {}
    for name in modules():
        for other in imports(name) - {"rules", ""}:
            here, there = folder(name), folder(other)
            if here and there and not f"{here}.".startswith(f"{there}.") and not f"{there}.".startswith(f"{here}."):
                edges.setdefault(here, set()).add(there)
    for start in edges:
        reached, waiting = set[str](), list(edges[start])
        while waiting:
            if (each := waiting.pop()) not in reached:
                reached.add(each)
                waiting += edges.get(each, ())
        assert start not in reached, start


def folder(name: str) -> str:
    """Return the folder of a module; a package's own folder for the package itself."""
    return name if (SRC / Path(*name.split("."))).is_dir() else name.rpartition(".")[0]


def test_facts_are_frozen_and_pickle() -> None:
    """Law 10."""
    facts = PackageFacts("a", "a", unknown=frozenset({"executables"}))
    assert pickle.loads(pickle.dumps(facts)) == facts
    assert hash(facts) == hash(pickle.loads(pickle.dumps(facts)))  # only a frozen one has a hash
    known = {"packages", "selected", "is_complete", "prefix_names", "repositories", "index", "incomplete"}
    known |= {"missing_repositories", "cmake_projects", "nearest"}
    assert {f.name for f in dataclasses.fields(Workspace)} <= known


def test_what_rules_are_given_and_what_checks_find_is_frozen() -> None:
    """The dataclasses of rules, checks and edits: one input serves all rules that ask for it."""
    for name, tree in modules().items():
        if name.partition(".")[0] in ("rules", "checks", "edits"):
            made = [each for node in ast.walk(tree) if isinstance(node, ast.ClassDef) for each in node.decorator_list]
            for code in map(ast.unparse, made):
                assert not code.startswith("dataclass") or "frozen=True" in code, name


def imported(*arguments: str, cwd: Path) -> set[str]:
    """Return the modules that a run of the command has imported at its end."""
    code = (
        "import sys, atexit; sys.argv = ['rospkg', *sys.argv[1:]]\n"
        "atexit.register(lambda: print('\\n'.join(sys.modules), file=sys.stderr))\n"
        "from rospkg_cli.__main__ import main; sys.exit(main())"
    )
    command = [sys.executable, "-c", code, *arguments]
    done = subprocess.run(command, cwd=cwd, capture_output=True, text=True, env={**os.environ, "COLUMNS": "80"})
    assert done.returncode == 0, done.stdout + done.stderr
    return set(done.stderr.split())


def test_version_imports_next_to_nothing(tmp_path: Path) -> None:
    assert not imported("--version", cwd=tmp_path) & {"typer", "rich", "lxml", "yaml", "rospkg_cli.rule"}


def test_a_clean_lint_to_json_imports_no_heavy_library(tmp_path: Path) -> None:
    for path, text in Example(bad={}, good={}).bad_files().items():
        target = tmp_path / "my_pkg" / path
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_text(text)
    names = imported("lint", "--format", "json", cwd=tmp_path / "my_pkg")
    assert "rospkg_cli.report.json" in names
    assert not names & {"rich", "jinja2", "xmlschema", "rospkg_cli.scaffold", "rospkg_cli.report.text"}
    assert not names & {
        "urllib.request",
        "rospkg_cli.index.fetch",
        "rospkg_cli.index.file_url",
        "rospkg_cli.index.update",
    }


def test_every_module_is_python_3_10() -> None:
    for path in sorted(SRC.rglob("*.py")):
        ast.parse(path.read_text(), str(path), feature_version=(3, 10))


def test_strings_use_the_words_of_the_field() -> None:
    """Docstrings and messages say `reported`, `says`, `nothing`, `next to`, `intended`, as ROS's own pages do."""
    own = re.compile(r"\b(?:told|tells|nobody|mend(?:ed)?|meant|beside|hollow|astray|sought|lonely)\b", re.I)
    found = {
        (name, word)
        for name, tree in modules().items()
        for node in ast.walk(tree)
        if isinstance(node, ast.Constant) and isinstance(node.value, str)
        for word in own.findall(node.value)
    }
    assert found == {
        ("checks.unintended_starts", "meant"),
        ("ros.headers", "beside"),
    }  # what pages say; a key of a table
