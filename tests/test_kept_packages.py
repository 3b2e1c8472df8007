"""Facts and findings of single packages are kept: a change costs its package, and those that see another answer."""

from __future__ import annotations

import json
import typing
from enum import Enum
from pathlib import Path

import pytest
from keeping import Run, run_kept
from test_cache_truth import add, edit

from rospkg_cli import disk_trace
from rospkg_cli.cache.kept_file import load, save
from rospkg_cli.engine.reuse.answer_digests import METHODS, AnswerDigests
from rospkg_cli.engine.reuse.plain import ENUMS, KINDS, digest_of, from_plain, to_plain
from rospkg_cli.engine.reuse.recorded_facts import RecordedFacts
from rospkg_cli.engine.reuse.recorded_workspace import GIVEN, RecordedWorkspace
from rospkg_cli.engine.run.package_results import PackageResults
from rospkg_cli.engine.run.worker import Worker
from rospkg_cli.example import manifest
from rospkg_cli.finding import Finding
from rospkg_cli.light_dataclasses import field_names
from rospkg_cli.package.package_facts import ActiveDependency, PackageFacts
from rospkg_cli.package.workspace import Workspace
from rospkg_cli.rule import all_rules
from rospkg_cli.testing import lint_files

ALL = ["src/my_pkg", "src/other", "src/user"]
JSON = ("--format", "json", "--pedantic", "--release", "--preview")


@pytest.fixture
def checked(monkeypatch: pytest.MonkeyPatch) -> list[str]:
    """The folders of the packages whose rules ran; to be cleared between runs."""
    found: list[str] = []
    check = Worker.check

    def counted(self: Worker, folder: str, *others: object) -> PackageResults:
        found.append(folder)
        return check(self, folder, *others)  # type: ignore[arg-type]

    monkeypatch.setattr(Worker, "check", counted)
    return found


@pytest.fixture
def workspace(tmp_path: Path, write, clean, monkeypatch: pytest.MonkeyPatch, checked: list[str]) -> Path:
    """Three packages; `user` depends on `my_pkg`, `other` on neither. Linted once."""
    monkeypatch.setattr(disk_trace, "YOUNG", -(10**15))
    monkeypatch.setenv("XDG_CACHE_HOME", str(tmp_path / "cache"))
    folder = tmp_path / "ws"
    (folder / ".git").mkdir(parents=True)
    for name in ("my_pkg", "other", "user"):
        write(folder / "src" / name, {path: text.replace("my_pkg", name) for path, text in clean.items()})
    edit("src/user/package.xml", "</package>", "  <depend>my_pkg</depend>\n</package>")(folder)
    add("src/user/user/node.py", "import my_pkg.helper\n")(folder)
    lint(folder)
    assert sorted(checked) == ["src/my_pkg", "src/other", "src/user"]
    checked.clear()
    return folder


def lint(workspace: Path, *options: str) -> Run:
    return run_kept("src", *JSON, *options, cwd=workspace)


def test_another_report_of_the_same_checks_nothing(workspace: Path, checked: list[str]) -> None:
    for options in (("--color", "always"), ("--format", "concise"), ("--output", "text:/dev/null")):
        told = lint(workspace, *options)
        assert (told.is_served, checked) == (False, [])
        assert told.out == lint(workspace, *options, "--no-cache").out
        checked.clear()


@pytest.mark.parametrize(
    "change, expected",
    [
        (add("src/other/other/more.py", "import unheard_of\n"), ["src/other"]),
        (edit("src/my_pkg/package.xml", "Drives", "Steers"), ["src/my_pkg"]),
        (edit("src/my_pkg/package.xml", "<name>my_pkg<", "<name>your_pkg<"), ALL),
        (
            edit("src/my_pkg/package.xml", "</package>", "<depend>other</depend>\n</package>"),
            ALL,  # other asks who needs it
        ),
        (add("src/LICENSE", "Apache License\nVersion 2.0, January 2004\n"), None),
        (add("src/fourth/package.xml", manifest().replace("my_pkg", "fourth")), None),
    ],
)
def test_a_change_costs_those_that_see_it(workspace: Path, checked: list[str], change, expected) -> None:
    change(workspace)
    told = lint(workspace)
    if expected is not None:
        assert sorted(checked) == expected
    truth = lint(workspace, "--no-cache")
    assert told[:3] == truth[:3]
    checked.clear()
    assert lint(workspace).is_served


def test_other_rules_use_facts_alone(workspace: Path, checked: list[str]) -> None:
    assert lint(workspace, "--select", "XML").out == lint(workspace, "--select", "XML", "--no-cache").out
    assert len(checked) == 6


def test_one_package_of_many(workspace: Path, checked: list[str]) -> None:
    """What was checked before is known where one package is asked for; what is selected is a question, too."""
    told = run_kept("src/user", *JSON, cwd=workspace)
    assert told.out == run_kept("src/user", *JSON, "--no-cache", cwd=workspace).out
    assert set(checked) <= {"src/user"}


@pytest.mark.parametrize(
    "damage",
    ["[]", "{", '{"src/user": []}', '{"src/user": [1, 2, 3, 4, 5, 6]}', '{"src/user": ["", [], [], ["Path"]]}'],
)
def test_a_damaged_file_is_not_believed(workspace: Path, tmp_path: Path, checked: list[str], damage: str) -> None:
    (path,) = (tmp_path / "cache/rospkg/lint").glob("packages-*")
    fields = load(str(path))
    assert fields is not None
    save(str(path), [*fields[:2], damage])
    told = lint(workspace, "--color", "always")
    assert len(checked) == 3
    assert told.out == lint(workspace, "--no-cache").out


def test_values_of_other_fields_are_not_believed(workspace: Path, tmp_path: Path) -> None:
    (path,) = (tmp_path / "cache/rospkg/lint").glob("packages-*")
    fields = load(str(path))
    assert fields is not None
    data = json.loads(fields[2])
    for package in data.values():
        package[3] = ["Span", 0, 1]
        package[5] = None
    save(str(path), [*fields[:2], json.dumps(data)])
    assert lint(workspace, "--color", "always").out == lint(workspace, "--no-cache").out


def test_files_that_were_touched_are_read_once(workspace: Path, tmp_path: Path, checked: list[str]) -> None:
    (path,) = (tmp_path / "cache/rospkg/lint").glob("packages-*")
    before = path.read_bytes()
    (workspace / "src/other/setup.py").touch()
    lint(workspace, "--color", "always")
    assert checked == []
    after = path.read_bytes()
    assert after != before
    lint(workspace, "--color", "never")
    assert path.read_bytes() == after


def test_a_crash_is_not_kept(workspace: Path, checked: list[str], monkeypatch: pytest.MonkeyPatch) -> None:
    from rospkg_cli.engine.run import worker

    def fails(*_: object) -> None:
        raise RuntimeError("once")

    add("src/other/other/more.py", "")(workspace)
    monkeypatch.setattr(worker, "suppressions_in", lambda files: ())
    monkeypatch.setattr(worker, "run_rules", lambda inputs, rules, builder: iter([crash(builder)]))
    assert lint(workspace).status == 3
    monkeypatch.undo()
    monkeypatch.setenv("XDG_CACHE_HOME", str(workspace.parent / "cache"))
    assert lint(workspace).status != 3


def crash(builder):
    from rospkg_cli.package.run_events import RuleCrash

    return RuleCrash("XML001", builder.package, builder.crash_path, "RuntimeError: once")


def test_all_that_facts_and_findings_hold_can_be_kept() -> None:
    waiting, seen = [PackageFacts, Finding, KINDS["Suppression"]], set()
    while waiting:
        kind = waiting.pop()
        if kind in seen:
            continue
        seen.add(kind)
        if isinstance(kind, type) and hasattr(kind, "__light_fields__"):
            waiting += [hint for name, hint in typing.get_type_hints(kind).items() if name in field_names(kind)]
        waiting += [each for each in typing.get_args(kind) if not isinstance(each, str)]
    classes = {kind for kind in seen if isinstance(kind, type) and not typing.get_args(kind)}
    assert classes - {str, int, bool, type(None)} == {*KINDS.values(), *ENUMS.values()}


def test_findings_come_back_as_they_were() -> None:
    examples = [rule.examples[0] for rule in all_rules() if rule.family in ("SET", "XML") and rule.examples]
    found = [finding for example in examples for finding in lint_files(example.bad_files()).findings]
    operations = {type(each).__name__ for finding in found if finding.fix for each in finding.fix.operations}
    assert operations >= {"Edit", "Create"}
    for finding in found:
        assert from_plain(json.loads(json.dumps(to_plain(finding)))) == finding


def test_plain_data_makes_no_other_objects() -> None:
    for value in (Path("x"), {"a": 1}, 1.5, [1], KINDS):
        with pytest.raises(TypeError, match=f"{type(value).__name__} can't be kept"):
            to_plain(value)
    with pytest.raises(ValueError, match="Span has other fields"):
        from_plain(["Span", 1])
    for data in (["Path", "x"], ["Span", 1], ["Severity", "none"], [], ["Workspace"]):
        with pytest.raises((LookupError, TypeError, ValueError)):
            from_plain(data)
    assert digest_of(frozenset("abc")) == digest_of(frozenset("cba")) != digest_of(("a", "b", "c"))
    assert not any(issubclass(kind, Enum) for kind in KINDS.values())


def test_every_field_of_the_workspace_is_recorded_or_in_the_key() -> None:
    assert set(field_names(Workspace)) == {"packages", "selected", "nearest", *GIVEN}
    own = {"packages", "selected", "names"}
    assert all(name in vars(RecordedWorkspace) for name in {*own, *METHODS, "named", "at", "kind_of", "is_available"})
    assert all(isinstance(vars(RecordedFacts)[name], property) for name in field_names(PackageFacts))


def test_questions_and_their_answers() -> None:
    one = PackageFacts("one", "a", version="1", dependencies=(ActiveDependency("depend", "two"),))
    two = PackageFacts("two", "b", headers=frozenset({"two"}), modules=frozenset({"mod"}))
    real = Workspace((one, two), frozenset({"a"}))
    seen = RecordedWorkspace(real, "a")
    assert seen.at("a") is one is seen.named("one")
    facts = seen.named("two")
    assert facts is seen.at("b") is seen.packages[1]
    assert facts.name == "two"
    assert facts.knows("name")
    assert seen.providers_of("mod.x") == ("two",)
    assert seen.with_header("two/x.hpp") == {"two"}
    assert (seen.selected, seen.names) == ({"a"}, {"one", "two"})
    asked = dict(AnswerDigests(real).of(seen.noted))
    assert ("field", "b", "name") in asked
    assert ("field", "b", "unknown") in asked
    assert ("field", "b", "version") not in asked
    changed = Workspace((one, PackageFacts("two", "b", "cmake", modules=frozenset({"mod"}))), frozenset({"a", "b"}))
    again = AnswerDigests(changed)
    differing = {question for question, digest in asked.items() if again.digest(question) != digest}
    assert differing == {("selected",), ("with_header", "two/x.hpp")}
    assert AnswerDigests(real).digest(("no_such", "thing")) == AnswerDigests(real).digest(("field", "z", "name")) == ""
    assert seen != RecordedWorkspace(real, "a")


def test_a_field_that_is_asked_of_most_is_asked_of_all() -> None:
    packages = tuple(PackageFacts(f"p{n}", f"p{n}") for n in range(20))
    seen = RecordedWorkspace(Workspace(packages), "p0")
    assert [facts.parameters for facts in seen.packages] == [()] * 20
    questions = [question for question, _ in AnswerDigests(seen.real).of(seen.noted)]
    assert questions == [("all", "parameters"), ("folders",)]


def test_a_package_that_is_linted_alone_beside_others_is_no_fault(workspace: Path) -> None:
    """Of the others facts are collected as they are asked for, and can't be kept."""
    for name in ("cache", "elsewhere"):
        for _ in range(2):
            run = run_kept("src/user", *JSON, cwd=workspace, XDG_CACHE_HOME=str(workspace.parent / name))
            assert (run.status in (0, 1), run.err) == (True, "")
            add("src/other/notes.md", f"{name}\n")(workspace)
