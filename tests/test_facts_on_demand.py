"""Facts on demand are those that are collected at once, and only what is asked for is read."""

from __future__ import annotations

import pickle
from pathlib import Path

import pytest

from rospkg_cli.disk import DiskTree
from rospkg_cli.disk_trace import start_trace, stop_trace
from rospkg_cli.engine.run import worker
from rospkg_cli.engine.run.worker import Worker
from rospkg_cli.example import Example
from rospkg_cli.files import PackageFiles
from rospkg_cli.light_dataclasses import field_names
from rospkg_cli.package import facts_on_demand
from rospkg_cli.package.collect_facts import DOUBTS, PARTS, collect_facts
from rospkg_cli.package.facts_on_demand import FactsOnDemand
from rospkg_cli.package.package import Package
from rospkg_cli.package.package_facts import PackageFacts
from rospkg_cli.package.rule_settings import RuleSettings
from rospkg_cli.package.workspace import Workspace
from rospkg_cli.ros.distros import Targets
from rospkg_cli.tree import MemoryTree, Tree

CORPUS = Path(__file__).parent / "corpus"
TREES: list[Tree] = [
    *(DiskTree(CORPUS / name) for name in ("my_robot_examples", "my_robot_nav")),
    *(MemoryTree.of(Example(bad={}, good={}, on=on).bad_files()) for on in ("ament_python", "ament_cmake")),
]


def package_in(tree: Tree) -> Package:
    return Package(PackageFiles(tree))


def on_demand(package: Package) -> PackageFacts:
    return facts_on_demand.facts_on_demand(package, Targets(), "here", "fallback")


@pytest.mark.parametrize("tree", TREES)
def test_they_are_the_same(tree: Tree) -> None:
    wanted = collect_facts(package_in(tree), Targets(), "here", "fallback")
    for name in field_names(PackageFacts):  # each asked for first, of facts of its own
        assert getattr(on_demand(package_in(tree)), name) == getattr(wanted, name), name
    for field in (
        "name",
        "dependencies",
        "executables",
        "interfaces",
        "share_files",
        "components",
        "modules",
        "loaders",
        "header_files",
    ):
        assert on_demand(package_in(tree)).knows(field) is wanted.knows(field)
    sent = pickle.loads(pickle.dumps(on_demand(package_in(tree))))
    assert type(sent) is PackageFacts
    assert sent == wanted


def test_every_field_is_in_one_part() -> None:
    names = [name for part in PARTS for name in part]
    assert sorted([*names, "name", "folder", "unknown"]) == sorted(field_names(PackageFacts))


def test_a_name_reads_the_manifest_alone() -> None:
    package = package_in(TREES[1])
    facts = on_demand(package)
    assert isinstance(facts, FactsOnDemand)
    assert (facts.name, facts.folder, facts.build_type) == ("my_robot_nav", "here", "ament_python")
    assert [kind.__name__ for kind in package._parts] == ["Manifest"]
    with pytest.raises(AttributeError):
        facts.nothing  # type: ignore[attr-defined]  # noqa: B018


@pytest.mark.parametrize(
    "line, is_evaluated",
    [("", False), ("generate_parameter_library(p p.yaml)", True), ("cmake_language(CALL ${NAME} p p.yaml)", True)],
)
def test_cmake_is_evaluated_where_it_may_define_parameters(line: str, is_evaluated: bool) -> None:
    files = Example(bad={}, good={}, on="ament_cmake").bad_files()
    package = package_in(MemoryTree.of(files | {"CMakeLists.txt": f"{files['CMakeLists.txt']}\n{line}\n"}))
    assert on_demand(package).parameters == ()
    assert ("CMake" in [kind.__name__ for kind in package._parts]) == is_evaluated


@pytest.mark.parametrize("line, is_known", [("", True), ("generate_parameter_library(p p.yaml)", False)])
def test_headers_are_listed_without_their_build(line: str, is_known: bool) -> None:
    files = Example(bad={}, good={}, on="ament_cmake").bad_files() | {"include/my_pkg/a.hpp": ""}
    package = package_in(MemoryTree.of(files | {"CMakeLists.txt": f"{files['CMakeLists.txt']}\n{line}\n"}))
    facts = on_demand(package)
    assert facts.header_files == frozenset({"my_pkg/a.hpp"})
    assert "CMake" not in [kind.__name__ for kind in package._parts]
    assert facts.knows("header_files") is is_known
    assert on_demand(package).unknown == facts.unknown == collect_facts(package, Targets(), "", "").unknown


def test_a_doubt_that_raises_holds(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(DOUBTS, "header_files", lambda _: bool(1 // 0))
    facts = on_demand(package_in(TREES[1]))
    assert not facts.knows("header_files")
    assert "header_files" in facts.unknown


def test_what_raises_is_unknown(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(PARTS, ("interfaces",), lambda *_: 1 / 0)
    facts = on_demand(package_in(TREES[1]))
    assert facts.interfaces == frozenset()
    assert not facts.knows("interfaces")
    assert facts.knows("executables")
    assert facts.unknown == {"interfaces"}


def test_a_broken_manifest_leaves_the_folder() -> None:
    facts = on_demand(package_in(MemoryTree.of({"package.xml": "<package"})))
    assert (facts.name, facts.knows("name")) == ("here", False)


def test_only_the_neighbours_of_what_is_checked_wait() -> None:
    tree = MemoryTree.of(
        {f"{name}/{path}": text for name in ("a", "b") for path, text in Example(bad={}, good={}).bad_files().items()}
    )
    worker = Worker(tree, ("a", "b"), Targets(), RuleSettings(), selected=frozenset({"a"}))
    assert [type(facts) for facts in worker.collect_facts(("a", "b"))] == [PackageFacts, FactsOnDemand]
    worker = Worker(tree, ("a", "b"), Targets(), RuleSettings())
    assert [type(facts) for facts in worker.collect_facts(("a", "b"))] == [PackageFacts, PackageFacts]


def run_of(folders: tuple[str, ...]) -> tuple[list[bool], object]:
    """Return of which packages something is kept after reading, and all that a traced run over the corpus gives."""
    start_trace()
    try:
        worker = Worker(DiskTree(CORPUS), folders, Targets())
        facts = worker.collect_facts(folders)
        kept = [bool(package._parts) for package in worker.packages.values()]
        results = worker.run_rules(Workspace(tuple(facts)), ["DEP101", "SET205", "LCH001", "XML101"], folders)
        return kept, (facts, results, worker.observed())
    finally:
        stop_trace()


def test_of_many_packages_little_is_kept(monkeypatch: pytest.MonkeyPatch) -> None:
    folders = ("my_robot_examples", "my_robot_nav")
    kept, expected = run_of(folders)
    assert kept == [True, True]
    monkeypatch.setattr(worker, "MAX_KEPT", 1)
    assert run_of(folders) == ([True, False], expected)


def test_a_crash_while_reading_is_remembered(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(worker, "MAX_KEPT", 0)
    monkeypatch.setattr(worker, "collect_facts", lambda *_: 1 // 0)
    reading = Worker(TREES[1], ("",), Targets())
    workspace = Workspace(tuple(reading.collect_facts([""])))
    (results,) = reading.run_rules(workspace, [], [""])
    assert ["ZeroDivisionError" in each.error for each in results.crashes] == [True]
