"""What is kept of one package, and after which changes its facts and its findings still hold."""

from __future__ import annotations

import os
from collections.abc import Callable, Iterator
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest

from rospkg_cli import disk_trace
from rospkg_cli.cache.kept_file import load, save
from rospkg_cli.disk import DiskTree
from rospkg_cli.engine.reuse.kept_packages import KeptPackages, Observed
from rospkg_cli.engine.reuse.recorded_tree import RecordedTree, found_again, listing
from rospkg_cli.engine.run.worker import observed_in
from rospkg_cli.files import PackageFiles
from rospkg_cli.package.package import Package
from rospkg_cli.package.package_facts import PackageFacts
from rospkg_cli.package.workspace import Workspace

FACTS = PackageFacts("arm", "src/arm", version="1.0.0")
WORKSPACE = Workspace((FACTS,), frozenset({"src/arm"}))
FOUND = ("one finding", ("another",), 3)


@pytest.fixture(autouse=True)
def traced(monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    """Trace each test, with files that are old enough to be known by their look."""
    monkeypatch.setattr(disk_trace, "YOUNG", -(10**15))
    disk_trace.start_trace()
    yield
    disk_trace.stop_trace()


@pytest.fixture
def root(tmp_path: Path) -> Path:
    """A workspace of one package, of which a.txt and no.txt were asked for, and LICENSE and NOTICE above it."""
    (tmp_path / "ws/src/arm").mkdir(parents=True)
    for path in ("src/arm/a.txt", "src/arm/b.txt", "LICENSE"):
        (tmp_path / "ws" / path).write_text("one")
    return tmp_path / "ws"


def packages(root: Path, facts_key: str = "facts", rules_key: str = "rules") -> KeptPackages:
    disk_trace.start_trace()
    return KeptPackages(str(root.parent / "kept"), DiskTree(root), facts_key, rules_key)


def observed(root: Path) -> Observed:
    own, whole = RecordedTree(DiskTree(root / "src/arm")), RecordedTree(DiskTree(root))
    for tree, path in ((own, "a.txt"), (own, "no.txt"), (whole, "LICENSE"), (whole, "NOTICE")):
        try:
            tree.entry(path)
        except OSError:
            assert path in ("no.txt", "NOTICE")
    return Observed(listing(own), own.reads, whole.reads, frozenset({("names",), ("package_at", "src/arm/a.txt")}))


@pytest.fixture
def kept(root: Path) -> Path:
    kept = packages(root)
    kept.keep(WORKSPACE, {"src/arm": observed(root)}, {"src/arm": FOUND}, frozenset())
    return root


def known(kept: KeptPackages, workspace: Workspace = WORKSPACE) -> tuple[bool, bool]:
    """Return whether facts and findings are known; they are what was kept."""
    facts = kept.known_facts(["src/arm", "src/new"])
    results = kept.known_results(workspace, ["src/arm", "src/new"])
    assert facts in ({}, {"src/arm": FACTS})
    assert results in ({}, {"src/arm": FOUND})
    assert kept.unchecked() == (frozenset(facts) if kept.rules_key != "rules" else frozenset())
    return bool(facts), bool(results)


def write(path: str, text: str = "three") -> Callable[[Path], object]:
    return lambda root: (root / path).write_text(text)


@pytest.mark.parametrize(
    "change, holds",
    [
        (lambda root: None, True),
        (write("src/arm/a.txt"), False),
        (write("src/arm/b.txt"), True),
        (write("src/arm/no.txt"), False),
        (write("src/arm/c.txt"), False),
        (write("LICENSE"), False),
        (write("NOTICE"), False),
        (write("README"), True),
        (lambda root: (root / "src/arm/a.txt").unlink(), False),
        (lambda root: os.utime(root / "src/arm/a.txt", (1, 1)), True),
        (lambda root: os.utime(root / "LICENSE", (1, 1)), True),
    ],
)
def test_what_was_asked_for_must_be_as_it_was(kept: Path, change: Callable[[Path], object], holds: bool) -> None:
    change(kept)
    assert known(packages(kept)) == (holds, holds)


def test_facts_and_findings_have_their_keys(kept: Path) -> None:
    assert known(packages(kept)) == (True, True)
    assert known(packages(kept, rules_key="others")) == (True, False)
    assert known(packages(kept, facts_key="others")) == (False, False)
    (kept.parent / "kept").unlink()
    assert known(packages(kept)) == (False, False)


@pytest.mark.parametrize("others", [(), (PackageFacts("arm", "src/arm"), PackageFacts("leg", "src/leg"))])
def test_findings_need_the_same_answers(kept: Path, others: tuple[PackageFacts, ...]) -> None:
    assert known(packages(kept), Workspace(others)) == (True, False)
    assert known(packages(kept), Workspace((PackageFacts("arm", "src/arm", version="2.0.0"),))) == (True, True)


@pytest.mark.parametrize(
    "damage", [["facts"], ["facts", "rules"], ["facts", "rules", "{"], ["facts", "rules", "{}", ""]]
)
def test_a_file_of_another_form_is_of_no_use(kept: Path, damage: list[str]) -> None:
    save(str(kept.parent / "kept"), damage)
    assert packages(kept).load() == {}
    assert known(packages(kept)) == (False, False)


def content(root: Path) -> list[str] | None:
    return load(str(root.parent / "kept"))


def test_it_is_written_where_something_is_new(kept: Path) -> None:
    before = content(kept)
    again = packages(kept)
    assert known(again) == (True, True)
    again.keep(WORKSPACE, {}, {}, frozenset())
    assert content(kept) == before
    os.utime(kept / "src/arm/a.txt", (1, 1))
    again = packages(kept)
    assert not again.is_refreshed
    assert known(again) == (True, True)
    assert again.is_refreshed
    again.keep(WORKSPACE, {}, {}, frozenset())
    assert content(kept) != before
    last = packages(kept)
    assert known(last) == (True, True)
    assert not last.is_refreshed


def test_what_failed_or_is_collected_on_demand_is_not_kept(root: Path) -> None:
    class OnDemand(PackageFacts):
        pass

    for facts, failed in ((FACTS, frozenset({"src/arm"})), (OnDemand("arm", "src/arm"), frozenset[str]())):
        packages(root).keep(Workspace((facts,)), {"src/arm": observed(root)}, {"src/arm": FOUND}, failed)
        assert known(packages(root)) == (False, False)


def test_facts_alone(root: Path) -> None:
    packages(root).keep(WORKSPACE, {"src/arm": observed(root)}, {}, frozenset())
    again = packages(root)
    assert again.known_facts(["src/arm"]) == {"src/arm": FACTS}
    assert again.known_results(WORKSPACE, ["src/arm"]) == {}
    assert again.unchecked() == {"src/arm"}


def test_what_the_facts_needed_counts_where_only_the_rules_run_again(kept: Path) -> None:
    again = packages(kept, rules_key="others")
    assert known(again) == (True, False)
    rules = Observed(observed(kept).files, {"b.txt": ("b.txt", "file x", "")}, {"README": ("README", "absent", "")})
    again.keep(WORKSPACE, {"src/arm": rules}, {"src/arm": FOUND}, frozenset())
    package = again.kept["src/arm"]
    assert [read[0] for read in package.reads] == ["a.txt", "b.txt", "no.txt"]
    assert [read[0] for read in package.above] == ["LICENSE", "NOTICE", "README"]
    assert package.asked == []


def test_a_file_above_is_looked_up_once(kept: Path) -> None:
    found = packages(kept)
    first = found.above("LICENSE")
    assert first[1].startswith("file ")
    (kept / "LICENSE").write_text("changed meanwhile")
    assert found.above("LICENSE") is first


def test_a_file_that_looks_as_it_did_is_not_read(kept: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    tree = DiskTree(kept / "src/arm")
    own = RecordedTree(tree)
    own.entry("a.txt")
    read = own.reads["a.txt"]
    assert read[2]
    monkeypatch.setattr(DiskTree, "entry", lambda *_: 1 / 0)
    disk_trace.start_trace()
    assert found_again(tree, read) is read
    for other in ((read[0], read[1], ""), (read[0], "file x", read[2] + "x"), ("no.txt", read[1], read[2])):
        with pytest.raises(ZeroDivisionError):
            found_again(tree, other)


def test_only_what_was_read_without_a_crash_is_observed(root: Path) -> None:
    def package(recorded: bool, paths: tuple[str, ...], above: bool = True) -> Package:
        own: Any = RecordedTree(DiskTree(root / "src/arm")) if recorded else DiskTree(root / "src/arm")
        for path in paths:
            own.entry(path)
        return Package(PackageFiles(own, "src/arm", RecordedTree(DiskTree(root)) if above else DiskTree(root)))

    whole = package(True, ("a.txt",))
    assert list(observed_in("src/arm", whole)["src/arm"].reads) == ["a.txt"]
    whole.crashes["Manifest"] = "Traceback"
    assert observed_in("src/arm", whole) == {}
    assert observed_in("src/arm", package(True, ())) == {}
    assert observed_in("src/arm", package(True, ("a.txt",), above=False)) == {}
    assert observed_in("src/arm", package(False, ("a.txt",))) == {}


def test_a_recorded_tree_is_the_tree(root: Path) -> None:
    (root / "src/arm/link.txt").symlink_to("a.txt")
    (root / "src/arm/d").mkdir()
    (root / "src/arm/d/c.txt").write_text("deep")
    tree = DiskTree(root / "src/arm")
    own = RecordedTree(tree)
    assert own.files() == tree.files()
    assert own.entry("a.txt") is own.entry("a.txt") is tree.entry("a.txt")
    assert own.sub("d").entry("c.txt").data == b"deep"
    assert own.reads.keys() == {"a.txt"}
    with pytest.raises(FileNotFoundError):
        own.entry("no.txt")
    assert own.entry("link.txt").kind == "link"
    kinds = {path: (answer.partition(" ")[0], bool(signature)) for path, answer, signature in own.reads.values()}
    assert kinds == {"a.txt": ("file", True), "no.txt": ("FileNotFoundError", False), "link.txt": ("link", False)}


def test_without_a_trace_every_file_is_read_again(root: Path) -> None:
    disk_trace.stop_trace()
    own = RecordedTree(DiskTree(root / "src/arm"))
    own.entry("a.txt")
    assert own.reads == {"a.txt": ("a.txt", "file ", "")}


def test_a_listing_tells_paths_and_kinds_apart(tmp_path: Path) -> None:
    def of(**kinds: Any) -> str:
        return listing(SimpleNamespace(files=lambda: {path.replace("__", " "): kind for path, kind in kinds.items()}))

    every = [of(), of(a="file"), of(a="link"), of(b="file"), of(a="file", b="file"), of(afile__b="file")]
    assert len(set(every)) == len(every)
    assert of(a="file") == of(a="file")
    assert listing(SimpleNamespace(files=lambda: {"\udc80": "file"})) != of()
