"""Trees as they lie on disks: what lints clean stays clean whatever a tool, an editor or a lost file leaves in it."""

from __future__ import annotations

import shutil
from pathlib import Path

import pytest
from in_process import run_here as rospkg
from planned import plan
from working_trees import PUT, folders_of

from rospkg_cli.disk import DiskTree
from rospkg_cli.engine.run.scope import Scope
from rospkg_cli.engine.run.session import Session
from rospkg_cli.engine.selection import EVERYTHING
from rospkg_cli.example import BACKDROPS, existing_files
from rospkg_cli.rule import Rule, all_rules
from rospkg_cli.scaffold.template import template_names

CORPUS = Path(__file__).parent / "corpus"

BACKDROP = [name for name in BACKDROPS if name]
HELD = {"config": {"config/notes.txt": "What is installed must be there\n"}}


MAY_NOT_BE_KNOWN = "RPK004"
"""Where links to folders lie about, it can't be told what find_namespace_packages() finds, and that may be said."""


def findings(package: Path) -> list[tuple[str, str]]:
    session = Session(DiskTree(package), Scope(("",), frozenset({""}), "my_pkg"), EVERYTHING.codes())
    found = session.run().findings
    return [(each.code, each.message) for each in found if each.code != MAY_NOT_BE_KNOWN]


@pytest.mark.parametrize("put", PUT)
@pytest.mark.parametrize("backdrop", BACKDROP)
def test_a_clean_package_stays_clean(tmp_path: Path, write, backdrop: str, put: str) -> None:
    package = write(tmp_path / "my_pkg", {**existing_files(BACKDROPS[backdrop]), **HELD.get(backdrop, {})})
    assert findings(package) == []
    for folder in folders_of(package):
        PUT[put](folder)
    assert findings(package) == []


@pytest.mark.parametrize("rule", [pytest.param(rule, id=rule.code) for rule in all_rules() if rule.examples])
def test_every_good_example_stays_good(tmp_path: Path, write, rule: Rule) -> None:
    """The same findings (of all rules) as without what lies about, for each good example of each rule."""
    for number, example in enumerate(rule.examples):
        package = write(tmp_path / f"{number}" / "my_pkg", example.good_files())
        if not (package / "package.xml").is_file():
            continue
        before = findings(package)
        put_everything(package)
        assert findings(package) == before


@pytest.mark.parametrize("name", sorted(path.name for path in CORPUS.iterdir() if path.is_dir()))
def test_the_corpus_says_what_it_said(tmp_path: Path, name: str) -> None:
    package = tmp_path / "my_pkg"
    shutil.copytree(CORPUS / name, package)
    before = findings(package)
    put_everything(package)
    assert findings(package) == before


@pytest.mark.parametrize("template", template_names())
def test_what_new_writes_stays_clean(tmp_path: Path, template: str) -> None:
    package = tmp_path / "my_robot"
    for file in plan("my_robot", template=template, tests="ament", distro="jazzy").files:
        target = package / file.path
        target.parent.mkdir(parents=True, exist_ok=True)
        target.write_bytes(file.entry.data)
        target.chmod(file.entry.mode)
    assert findings(package) == []
    put_everything(package)
    assert findings(package) == []


def put_everything(package: Path) -> None:
    for folder in folders_of(package):
        for put in PUT.values():
            put(folder)


@pytest.mark.parametrize("layout", ["ros2 pkg create", "ros2 pkg create --node-name"])
def test_what_ros2_pkg_create_leaves(tmp_path: Path, write, layout: str) -> None:
    """Its folders are empty until somebody fills them: nothing breaks, whatever is said of its TODOs."""
    package = write(tmp_path / "foo_pkg", {"package.xml": CREATED, "CMakeLists.txt": CREATED_CMAKE})
    (package / "src").mkdir()
    (package / "include/foo_pkg").mkdir(parents=True)
    if "node" in layout:
        (package / "src/talker.cpp").write_text("int main() { return 0; }\n")
    for command in (("lint",), ("lint", "--fix"), ("inspect",)):
        done = rospkg(*command, cwd=package)
        assert done.returncode in (0, 1), done.stderr
        assert "RPK005" not in done.stdout


CREATED = """\
<?xml version="1.0"?>
<package format="3">
  <name>foo_pkg</name>
  <version>0.0.0</version>
  <description>TODO: Package description</description>
  <maintainer email="ada@example.org">ada</maintainer>
  <license>TODO: License declaration</license>
  <buildtool_depend>ament_cmake</buildtool_depend>
  <export>
    <build_type>ament_cmake</build_type>
  </export>
</package>
"""
CREATED_CMAKE = """\
cmake_minimum_required(VERSION 3.8)
project(foo_pkg)
find_package(ament_cmake REQUIRED)
ament_package()
"""
