"""One package's trouble is that package's: what fails on one costs one RPK005, and all others are served."""

from __future__ import annotations

import os
import signal
from collections.abc import Iterator
from dataclasses import replace
from functools import partial
from pathlib import Path

import pytest

from rospkg_cli.cli.inspect import run as inspecting
from rospkg_cli.cli.inspect.run import inspect
from rospkg_cli.disk import DiskTree
from rospkg_cli.disk_trace import MAX_BYTES
from rospkg_cli.engine.fixing.fix import fix_all
from rospkg_cli.engine.run import worker
from rospkg_cli.engine.run.process_pool import ProcessPool
from rospkg_cli.engine.run.results import Results
from rospkg_cli.engine.run.run_rules import MAX_HITS
from rospkg_cli.engine.run.scope import Scope
from rospkg_cli.engine.run.session import Session
from rospkg_cli.finding import Delete, Edit, Fix, Hit, Safety
from rospkg_cli.package import readers
from rospkg_cli.package.manifest import Manifest
from rospkg_cli.package.setup.setup_py import SetupPy
from rospkg_cli.rule_table import rule_by_code
from rospkg_cli.source import Span
from rospkg_cli.testing import lint_files
from rospkg_cli.tree import LeadsOutError, MemoryTree, TreeEntry

CODES = frozenset({"RPK001", "RPK005", "XML104", "SET101", "DEP103"})


def session(clean, **more) -> Session:
    """Two packages without faults, `bad` and `good`."""
    files = {
        f"{name}/{path.replace('my_pkg', name)}": text.replace("my_pkg", name)
        for name in ("bad", "good")
        for path, text in clean.items()
    }
    return Session(MemoryTree.of(files), Scope(("bad", "good"), frozenset({"bad", "good"})), CODES, **more)


def told(results: Results) -> list[tuple[str, str, str]]:
    return [(f.code, f.package, f.message.partition(":")[0]) for f in results.findings]


def fails(reading) -> Iterator[object]:
    if reading.files.folder == "bad":
        raise KeyError("of ours")
    return iter(())


def test_a_reader_that_fails(clean, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(readers.READERS, SetupPy, fails)
    results = session(clean).run()
    assert told(results) == [("RPK005", "bad", "reader of SetupPy failed on `bad`")]
    assert len(results.crashes) == 1


def test_facts_that_can_t_be_gathered(clean, monkeypatch: pytest.MonkeyPatch) -> None:
    real = worker.collect_facts
    monkeypatch.setattr(
        worker, "collect_facts", lambda p, t, folder, name: 1 / 0 if folder == "bad" else real(p, t, folder, name)
    )
    assert told(session(clean).run()) == [("RPK005", "bad", "reader of PackageFacts failed on `bad`")]


def put_rules(monkeypatch: pytest.MonkeyPatch, **checks) -> None:
    real = rule_by_code
    monkeypatch.setattr(
        worker,
        "rule_by_code",
        lambda code: replace(real(code), over=Manifest, check=checks[code]) if code in checks else real(code),
    )


def test_rules_that_fail_at_one_place_are_told_once(clean, monkeypatch: pytest.MonkeyPatch) -> None:
    def check(manifest: Manifest) -> Iterator[Hit]:
        if manifest.name == "bad":
            raise RecursionError("too deep")
        yield from ()

    real = rule_by_code
    ours = {code: replace(real(code), over=Manifest, check=check) for code in ("XML104", "SET101")}
    monkeypatch.setattr(worker, "rule_by_code", lambda code: ours.get(code) or real(code))
    assert told(session(clean).run()) == [("RPK005", "bad", "rule SET101, XML104 failed on `bad`")]


def test_a_fix_that_fails(clean, monkeypatch: pytest.MonkeyPatch) -> None:
    seen = "<!-- seen -->"

    def check(manifest: Manifest) -> Iterator[Hit]:
        end = Span(manifest.root.open.end, manifest.root.open.end)
        operation = Delete("x") if manifest.name == "bad" else Edit(manifest.path, end, seen)
        if seen not in manifest.source.text:
            yield Hit(manifest.path, end, "x", fix=Fix("Do it", (operation,)))

    put_rules(monkeypatch, XML104=check)
    monkeypatch.setattr("rospkg_cli.engine.fixing.apply.outcome", lambda tree, operation: 1 / 0)
    outcome = fix_all(session(clean), (Safety.SAFE,))
    assert [(f.code, f.package) for f in outcome.applied] == [("XML104", "good")]
    assert [(f.package, why) for f, why in outcome.refused] == [("bad", "ZeroDivisionError: division by zero")]
    assert ("RPK005", "bad", "fix of XML104 failed on `bad`") in told(outcome.results)
    assert len(outcome.results.crashes) == 1


def test_an_inspection_that_fails(tmp_path: Path, write, clean, monkeypatch, capsys) -> None:
    for name in ("bad", "good"):
        write(tmp_path / "ws" / name, {p.replace("my_pkg", name): t.replace("my_pkg", name) for p, t in clean.items()})
    real = inspecting.inspect_package

    def odd(package, *more):
        return 1 / 0 if package.folder == "bad" else real(package, *more)

    monkeypatch.setattr(inspecting, "inspect_package", odd)
    assert inspect([tmp_path / "ws"]) == 3
    out, err = capsys.readouterr()
    assert "good" in out
    assert "`bad` can't be inspected" in err


@pytest.mark.parametrize("step", ["collect_facts", "run_rules"])
def test_a_process_that_dies(clean, monkeypatch: pytest.MonkeyPatch, step: str) -> None:
    real = getattr(worker.Worker, step)

    def killed(self, *given):
        if self.folders == ("bad",):
            os.kill(os.getpid(), signal.SIGKILL)
        return real(self, *given)

    monkeypatch.setattr(worker.Worker, step, killed)
    results = session(clean, make_pool=partial(ProcessPool, jobs=2)).run()
    assert told(results) == [("RPK005", "bad", "check of the whole package failed on `bad`")]


def test_more_findings_than_anybody_reads_are_cut_off_and_said(clean) -> None:
    wrong = "".join(f"  <dependz>a{n}</dependz>\n" for n in range(MAX_HITS + 500))
    files = {**clean, "package.xml": clean["package.xml"].replace("  <export>", wrong + "  <export>")}
    results = lint_files(files, ["XML001", "XML002", "XML003", "XML004"])
    assert not results.crashes
    assert len(results.findings) == MAX_HITS + 1
    last = results.findings[-1]
    assert (
        last.message == f"more than {MAX_HITS:,} findings of {last.code} in `my_pkg`: from here on they are not shown"
    )


def test_a_file_too_large_is_skipped_and_said(tmp_path: Path, write, clean) -> None:
    package = write(tmp_path / "pkg", clean)
    (package / "setup.py").write_text(clean["setup.py"] + "#" * MAX_BYTES)
    found = Session(DiskTree(package), Scope(("",), frozenset({""})), CODES | {"RPK007"}).run().findings
    assert [(f.code, f.severity.value, f.location.path) for f in found] == [("RPK007", "info", "setup.py")]
    assert found[0].message == "`setup.py` is not read: it has 4.0 MB, more than the limit of 4 MB"


def test_a_link_that_leads_out_is_told_mildly() -> None:
    why = "`setup.py` is a link to `/etc/passwd`, out of the package and its repository: it is not read"

    class Outside(MemoryTree):
        def entry(self, path: str) -> TreeEntry:
            if path.endswith("setup.py"):
                raise LeadsOutError(why)
            return super().entry(path)

    tree = Outside.of({"package.xml": "<package/>", "setup.py": TreeEntry("outside", b"")})
    found = Session(tree, Scope(("",), frozenset({""})), frozenset({"RPK001", "RPK007"})).run().findings
    assert [(f.code, f.severity.value, f.message) for f in found] == [("RPK007", "info", why)]
