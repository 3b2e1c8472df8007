"""What one run costs, counted and not timed: each text is parsed once, and only what a package needs is imported."""

from __future__ import annotations

import ast
import gc
import subprocess
import sys
from collections import Counter
from pathlib import Path
from typing import Any

import pytest

import rospkg_cli
from rospkg_cli.checks.urdf.named_with_folder import NamedWithFolder
from rospkg_cli.checks.urdf.opened_robots import OpenedRobots
from rospkg_cli.disk import DiskTree
from rospkg_cli.engine.run.scope import Scope
from rospkg_cli.engine.run.session import Session
from rospkg_cli.engine.selection import EVERYTHING
from rospkg_cli.example import CMAKE, manifest
from rospkg_cli.languages.cmake import file as cmake_file
from rospkg_cli.languages.cpp import file as cpp_file
from rospkg_cli.languages.python import syntax, unreached_places
from rospkg_cli.languages.python.file import parse_python
from rospkg_cli.languages.python.nodes import nodes_of_kind
from rospkg_cli.languages.xml import parser as xml_parser
from rospkg_cli.languages.yaml import nodes as yaml_nodes
from rospkg_cli.package.params import node_names
from rospkg_cli.source import Source
from rospkg_cli.testing import lint_files

CORPUS = Path(__file__).parent / "corpus"
PARSERS = (
    (syntax, "parsed_without_collector"), (cmake_file, "parse"), (cpp_file, "read_anew"), (xml_parser, "XmlParser"),
    (yaml_nodes, "events"),
)  # fmt: skip

HEAVY = (
    "concurrent", "multiprocessing", "importlib.metadata", "tomllib", "socket", "email", "xmlschema", "jinja2",
    "urllib.request", "watchfiles", "typer", "json", "string", "inspect", "dataclasses",
)  # fmt: skip
LATER = (
    "edits.toml", "engine.fixing.apply", "engine.fixing.fix", "engine.fixing.write", "engine.run.process_pool",
    "engine.run.rule_plugins", "cli.diff", "cli.lint.add_ignores", "languages.cmake.interpreter",
    "languages.cmake.commands", "package.cmake.cmake_install_table", "rules.cmake", "rules.urdf", "scaffold", "testing",
)  # fmt: skip


def test_code_that_never_runs_is_looked_for_once_a_file(monkeypatch: pytest.MonkeyPatch) -> None:
    file = parse_python(Source("a.py", "if False:\n    a()\n" + "b()\n" * 50))
    walks: list[object] = []
    real = unreached_places.unreached_statements
    monkeypatch.setattr(unreached_places, "unreached_statements", lambda *given: walks.append(given) or real(*given))
    reached = [not unreached_places.is_unreached(file, file.span(each)) for each in nodes_of_kind(file.tree, ast.Call)]
    assert sorted(reached) == [False] + [True] * 50
    assert len(walks) == 1


def test_who_names_a_robot_is_looked_for_once_a_robot(monkeypatch: pytest.MonkeyPatch) -> None:
    asked: Counter[str] = Counter()
    real = OpenedRobots.find_robots_naming

    def counted(self: OpenedRobots, path: str) -> list[str]:
        asked[path] += 1
        return real(self, path)

    monkeypatch.setattr(OpenedRobots, "find_robots_naming", counted)
    include = '<xacro:include filename="r{}.xacro"/>'
    robot = '<robot xmlns:xacro="http://www.ros.org/wiki/xacro" name="r">{}<link name="l{}"/></robot>\n'
    chain = {f"urdf/r{n}.xacro": robot.format(include.format(n + 1) if n < 9 else "<a/>", n) for n in range(10)}
    lint_files({"package.xml": manifest("", "ament_cmake"), "CMakeLists.txt": CMAKE, **chain}, ["URD001", "URD002"])
    assert asked
    assert max(asked.values()) == 1


def test_a_file_is_looked_for_with_its_folder_once(monkeypatch: pytest.MonkeyPatch) -> None:
    asked: Counter[str] = Counter()
    real = NamedWithFolder.look_for

    def counted(self: NamedWithFolder, path: str) -> bool:
        asked[path] += 1
        return real(self, path)

    monkeypatch.setattr(NamedWithFolder, "look_for", counted)
    mesh = '<mesh filename="package://my_pkg/none.stl"/>'
    robot = f'<robot name="r"><link name="l"><visual><geometry>{mesh}</geometry></visual></link></robot>\n'
    copies = {f"models/m{n}/model.urdf": robot for n in range(9)}
    lint_files({"package.xml": manifest("", "ament_cmake"), "CMakeLists.txt": CMAKE, **copies}, ["URD001", "URD002"])
    assert len(asked) == len(copies)
    assert max(asked.values()) == 1


def test_what_many_programs_share_is_read_for_nodes_once(monkeypatch: pytest.MonkeyPatch) -> None:
    read: Counter[str] = Counter()
    real = node_names.of_cpp
    monkeypatch.setattr(node_names, "of_cpp", lambda text: read.update([text]) or real(text))
    lines = "".join(f"add_executable(p{n} src/p{n}.cpp)\n" for n in range(9))
    programs = {f"src/p{n}.cpp": f'#include "my_pkg/base.hpp"\nint main() {{}} // {n}\n' for n in range(9)}
    files = {
        "package.xml": manifest("", "ament_cmake"),
        "CMakeLists.txt": CMAKE.replace("ament_package", f"{lines}ament_package"),
        "include/my_pkg/base.hpp": "class Base;\n",
        "src/base.cpp": '#include "my_pkg/base.hpp"\n',
    }
    lint_files({**files, **programs}, ["PRM003"])
    assert len(read) == len(programs) + 2
    assert max(read.values()) == 1


@pytest.mark.parametrize("name", ["my_robot_examples", "my_robot_nav"])
def test_each_text_is_parsed_once(name: str, monkeypatch: pytest.MonkeyPatch) -> None:
    parsed: Counter[tuple[str, str]] = Counter()

    def counted(kind: str, real: Any) -> Any:
        def parse(source: Any, *more: Any) -> Any:
            parsed[kind, source.path] += 1
            return real(source, *more)

        return parse

    for module, parser in PARSERS:
        monkeypatch.setattr(module, parser, counted(parser, getattr(module, parser)))
    Session(DiskTree(CORPUS / name), Scope(("",), frozenset({""}), name), EVERYTHING.codes()).run()
    assert {kind for kind, _ in parsed} >= {"parsed_without_collector", "XmlParser"}
    assert {each: count for each, count in parsed.items() if count > 1} == {}


@pytest.mark.parametrize("name", ["my_robot_examples", "my_robot_nav"])
def test_texts_are_freed_without_the_collector(name: str) -> None:
    gc.collect()
    gc.disable()
    try:
        before = {id(each) for each in gc.get_objects() if isinstance(each, Source)}
        Session(DiskTree(CORPUS / name), Scope(("",), frozenset({""}), name), EVERYTHING.codes()).run()
        left = [each.path for each in gc.get_objects() if isinstance(each, Source) and id(each) not in before]
    finally:
        gc.enable()
    assert left == []


@pytest.fixture(scope="module")
def imported() -> set[str]:
    """What a lint of one Python package without a fault imports."""
    code = (
        "import sys; before = set(sys.modules); sys.argv = ['rospkg', 'lint', '--no-cache', '.']\n"
        "from rospkg_cli.__main__ import main; main(); print(*(set(sys.modules) - before), sep='\\n', file=sys.stderr)"
    )
    folder = CORPUS / "my_robot_nav"
    done = subprocess.run([sys.executable, "-c", code], cwd=folder, capture_output=True, text=True)
    return set(done.stderr.split())


def test_a_lint_imports_what_its_package_needs(imported: set[str]) -> None:
    ours = {name.removeprefix("rospkg_cli.") for name in imported if name.startswith("rospkg_cli.")}
    assert "rules.manifest.xml104_placeholder_metadata" in ours
    assert {name for name in ours if name.startswith(tuple(f"{each}." for each in LATER)) or name in LATER} == set()
    assert {name for name in imported if name in HEAVY or name.startswith(tuple(f"{each}." for each in HEAVY))} == set()
    assert len(ours) < 0.6 * len(list(Path(rospkg_cli.__file__).parent.rglob("*.py")))
