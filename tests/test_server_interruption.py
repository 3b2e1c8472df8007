"""`rospkg server` while a run goes on: what is asked is answered or refused, and what is typed ends the run."""

from __future__ import annotations

import asyncio
import threading
from collections.abc import Callable, Coroutine, Iterator
from functools import cached_property
from pathlib import Path
from typing import Any

import pytest
from editor import PATIENCE
from server_in_process import ServerInProcess, until

from rospkg_cli.cli.server import fixing_all, language_server, offered_actions
from rospkg_cli.cli.server.live_lint import LintOrder, LiveLint
from rospkg_cli.cli.server.shared_properties import get
from rospkg_cli.engine.live.safe_point import RightOfWay, RunInterrupted, SafePoint
from rospkg_cli.engine.run import fitting_rules, worker
from rospkg_cli.example import Example
from rospkg_cli.light_dataclasses import replace
from rospkg_cli.rule_table import rule_by_code

MANIFEST = Example(bad={}, good={}).bad_files()["package.xml"]
TODO = MANIFEST.replace("Apache-2.0", "TODO")
TWICE = MANIFEST.replace("  <export>", "  <depend>rclpy</depend>\n" * 2 + "  <export>")
MODIFIED = -32801


class Hold:
    """Holds up one thread at a time, from `begun` until `go_on`."""

    def __init__(self) -> None:
        self.begun, self.go_on = threading.Event(), threading.Event()

    def __call__(self) -> None:
        self.begun.set()
        self.go_on.wait()


@pytest.fixture
def hold() -> Iterator[Hold]:
    found = Hold()
    yield found
    found.go_on.set()


@pytest.fixture
def held_rule(hold: Hold, monkeypatch: pytest.MonkeyPatch) -> Hold:
    """Hold up the rule about descriptions where one says TODO."""

    def rule(code: str) -> Any:
        real = rule_by_code(code)

        def check(given: Any) -> Any:
            if "TODO" in given.manifest.source.text:
                hold()
            return real.check(given)

        return replace(real, check=check) if code == "XML104" else real

    monkeypatch.setattr(worker, "rule_by_code", rule)
    return hold


@pytest.fixture
def held_end(hold: Hold, monkeypatch: pytest.MonkeyPatch) -> Hold:
    """Hold up a run over a text with TODO behind its last safe point."""
    real = language_server.lint

    def lint(live: LiveLint, order: LintOrder, *rest: Any) -> Any:
        found = real(live, order, *rest)
        if any(b"TODO" in each.data for each in order.texts.values()):
            hold()
        return found

    monkeypatch.setattr(language_server, "lint", lint)
    return hold


@pytest.fixture
def manifest(tmp_path: Path) -> Path:
    path = tmp_path / "my_pkg/package.xml"
    path.parent.mkdir()
    path.write_text(MANIFEST)
    (path.parent / "setup.py").write_text("")
    return path


def play(manifest: Path, scene: Callable[[ServerInProcess], Coroutine[Any, Any, None]]) -> None:
    async def go() -> None:
        server = ServerInProcess(manifest.parents[1])
        server.open(manifest, MANIFEST)
        await server.settle()
        await scene(server)

    asyncio.run(go())


def at(manifest: Path, word: str) -> dict[str, Any]:
    line = next(number for number, each in enumerate(MANIFEST.split("\n")) if word in each)
    where = {"line": line, "character": MANIFEST.split("\n")[line].index(word) + 1}
    return {"textDocument": {"uri": manifest.as_uri()}, "position": where}


@pytest.fixture
def impatient(monkeypatch: pytest.MonkeyPatch) -> None:
    """Let actions wait for no run."""
    monkeypatch.setattr(offered_actions, "LISTING", 2 * PATIENCE)


@pytest.mark.usefixtures("impatient")
def test_what_is_asked_while_a_rule_goes_on_is_answered(manifest: Path, held_rule: Hold) -> None:
    async def scene(server: ServerInProcess) -> None:
        server.type(manifest, TODO)
        await until(held_rule.begun.is_set)
        for asked in ("hover", "definition", "completion"):
            assert "result" in await server.answer(f"textDocument/{asked}", at(manifest, "my_pkg"))
        options = {"textDocument": {"uri": manifest.as_uri()}, "options": {"tabSize": 2, "insertSpaces": True}}
        assert "result" in await server.answer("textDocument/formatting", options)
        assert "result" in await server.actions(manifest)
        assert not held_rule.go_on.is_set()
        assert not any("XML104" in each for each in server.published(manifest))
        held_rule.go_on.set()
        await server.settle()
        assert "XML104" in server.published(manifest)[-1]
        assert "result" in await server.actions(manifest)

    play(manifest, scene)


def edits_of(action: dict[str, Any]) -> list[tuple[int, str]]:
    """Return the lines (from 0) and the texts of the edits of an action, for the version that is open."""
    [change] = action["edit"]["documentChanges"]
    assert change["textDocument"]["version"] == 3
    return [(each["range"]["start"]["line"], each["newText"]) for each in change["edits"]]


@pytest.mark.usefixtures("impatient")
@pytest.mark.parametrize(
    "edited, moved",
    [
        (TWICE.replace("Apache-2.0", "TODO\n"), 1),
        (TWICE.replace("Apache-2.0", "TODO"), 0),
        (TWICE.replace("\n  <description>Drives my robot", "<description>TODO"), -1),
        (TWICE.replace("  <depend>rclpy</depend>\n", "  <depend>rclpy</depend>TODO\n", 1), None),
        (TWICE.replace("  <depend>rclpy</depend>\n", "", 1).replace("Apache-2.0", "TODO"), None),
    ],
    ids=["a line more above", "a line changed", "a line less", "a line of it changed", "a line of it gone"],
)
def test_actions_right_behind_a_key_are_those_that_still_hold(
    manifest: Path, held_rule: Hold, edited: str, moved: int | None
) -> None:
    """They are for the text as it is, and asked for again when the run has ended."""

    async def scene(server: ServerInProcess) -> None:
        server.type(manifest, TWICE)
        await server.settle()
        before = len(server.published(manifest))
        server.type(manifest, edited)
        if "TODO" in edited.partition("</description>")[0]:
            await until(held_rule.begun.is_set)
        found = (await server.actions(manifest))["result"]
        fixes = [each for each in found if "XML201" in each["title"] and each.get("isPreferred")]
        line = TWICE.split("\n").index("  <depend>rclpy</depend>")
        assert [edits_of(each) for each in fixes] == ([] if moved is None else [[(line + 1 + moved, "")]])
        held_rule.go_on.set()
        await server.settle()
        assert len(server.published(manifest)) > before

    play(manifest, scene)


def test_actions_before_the_first_run_has_ended_are_refused(manifest: Path, held_rule: Hold) -> None:
    async def go() -> None:
        server = ServerInProcess(manifest.parents[1])
        server.open(manifest, TODO)
        await until(held_rule.begun.is_set)
        server.server.limit = 0.01
        assert (await server.actions(manifest))["error"]["code"] == MODIFIED
        held_rule.go_on.set()
        await server.settle()

    asyncio.run(go())


def test_what_cannot_be_looked_up_in_time_is_refused(manifest: Path, held_rule: Hold) -> None:
    async def scene(server: ServerInProcess) -> None:
        server.server.looking_up.submit(held_rule)
        server.server.limit = 0.01
        answer = await server.answer("textDocument/hover", at(manifest, "my_pkg"))
        assert answer["error"] == {
            "code": MODIFIED,
            "message": "rospkg is still reading what has changed: ask again",
        }
        assert server.server.way.is_free.is_set()
        held_rule.go_on.set()

    play(manifest, scene)


def test_actions_asked_in_vain_are_asked_for_again_when_the_run_has_ended(manifest: Path, held_rule: Hold) -> None:
    """An editor asks when diagnostics come: they come although they are the last ones."""

    async def scene(server: ServerInProcess) -> None:
        server.type(manifest, TODO)
        held_rule.go_on.set()
        await server.settle()
        before = len(server.published(manifest))
        held_rule.begun.clear()
        held_rule.go_on.clear()
        server.type(manifest, TODO + "\n")
        await until(held_rule.begun.is_set)
        server.server.limit = 0.01
        await server.actions(manifest)
        held_rule.go_on.set()
        await server.settle()
        assert len(server.published(manifest)) == before + 1
        server.type(manifest, TODO)
        await server.settle()
        assert len(server.published(manifest)) == before + 1

    play(manifest, scene)


@pytest.mark.parametrize("where", ["held_rule", "held_end"])
def test_an_edit_ends_the_run_and_nothing_of_it_is_shown(
    manifest: Path, where: str, request: pytest.FixtureRequest
) -> None:
    hold = request.getfixturevalue(where)

    async def scene(server: ServerInProcess) -> None:
        before = server.published(manifest)
        server.type(manifest, TODO)
        await until(hold.begun.is_set)
        server.type(manifest, TWICE)
        hold.go_on.set()
        await server.settle()
        after = server.published(manifest)[len(before) :]
        assert [("XML104" in each, "XML201" in each) for each in after] == [(False, True)]

    play(manifest, scene)


def test_a_run_that_was_interrupted_gives_its_changes_to_the_next(manifest: Path, held_rule: Hold) -> None:
    """A file that changed before the interrupted run, and not since."""
    other = manifest.parents[1] / "my_other/package.xml"
    other.parent.mkdir()
    (other.parent / "setup.py").write_text("")
    other.write_text(MANIFEST.replace("my_pkg", "my_other"))

    async def scene(server: ServerInProcess) -> None:
        other.write_text(TWICE.replace("my_pkg", "my_other"))
        server.tell("workspace/didChangeWatchedFiles", {"changes": [{"uri": other.as_uri(), "type": 2}]})
        server.type(manifest, TODO)
        await until(held_rule.begun.is_set)
        server.type(manifest, MANIFEST)
        held_rule.go_on.set()
        await server.settle()
        assert "XML201" in server.published(other)[-1]
        assert not any("XML104" in each for each in server.published(manifest))

    play(manifest, scene)


def test_packages_checked_before_an_interruption_are_not_checked_again(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    for name in ("a", "b", "c"):
        (tmp_path / name).mkdir()
        (tmp_path / name / "package.xml").write_text(TWICE.replace("my_pkg", name))
    checked: list[str] = []
    order = LintOrder({}, frozenset(), frozenset())
    real = fitting_rules.has_inputs

    def noting(code: str, package: Any) -> bool:
        if code == "XML104":
            checked.append(package.folder)
            if checked == ["a", "b"]:
                order.look.end()
        return real(code, package)

    monkeypatch.setattr(fitting_rules, "has_inputs", noting)
    live = LiveLint(tmp_path)
    with pytest.raises(RunInterrupted):
        live.run(order)
    assert set(live.memory.results) == set(live.memory.facts) == {"a"}
    found = live.run(LintOrder({}, frozenset(), frozenset())).results
    assert checked == ["a", "b", "b", "c"]
    assert found == LiveLint(tmp_path).run(LintOrder({}, frozenset(), frozenset())).results
    assert {each.package for each in found.findings if each.code == "XML201"} == {"a", "b", "c"}


def test_a_run_waits_where_something_shorter_has_the_right_of_way() -> None:
    way, order = RightOfWay(), []
    look = SafePoint(way)

    def run() -> None:
        look()
        order.append("run")

    thread = threading.Thread(target=run)
    with way.taken(), way.taken():
        thread.start()
        thread.join(0.02)
        order.append("answer")
    thread.join()
    assert order == ["answer", "run"]


@pytest.fixture
def held_fixes(hold: Hold, monkeypatch: pytest.MonkeyPatch) -> Hold:
    real = fixing_all.all_fixes

    def fixes(*given: Any) -> Any:
        hold()
        return real(*given)

    monkeypatch.setattr(fixing_all, "all_fixes", fixes)
    return hold


async def fix_all_action(server: ServerInProcess, manifest: Path) -> dict[str, Any]:
    server.type(manifest, TWICE)
    await server.settle()
    found = (await server.actions(manifest))["result"]
    return next(each for each in found if each["kind"] == "source.fixAll.rospkg")


def applied(server: ServerInProcess) -> list[dict[str, Any]]:
    return [each["params"] for each in server.sent if each.get("method") == "workspace/applyEdit"]


def test_fixes_of_a_package_that_take_long_come_by_themselves(manifest: Path, held_fixes: Hold) -> None:
    async def scene(server: ServerInProcess) -> None:
        action = await fix_all_action(server, manifest)
        server.server.limit = 0.01
        assert "edit" not in (await server.answer("codeAction/resolve", action))["result"]
        assert not held_fixes.go_on.is_set()
        assert (await server.answer("workspace/executeCommand", action["command"]))["result"] is None
        assert not held_fixes.go_on.is_set()
        held_fixes.go_on.set()
        await until(lambda: bool(applied(server)))
        [edit] = applied(server)
        assert edit["edit"]["documentChanges"][0]["textDocument"] == {"uri": manifest.as_uri(), "version": 2}

    play(manifest, scene)


def test_fixes_of_a_package_that_came_in_time_do_not_come_twice(manifest: Path, held_fixes: Hold) -> None:
    async def scene(server: ServerInProcess) -> None:
        held_fixes.go_on.set()
        action = await fix_all_action(server, manifest)
        assert "edit" in (await server.answer("codeAction/resolve", action))["result"]
        held_fixes.begun.clear()
        await server.answer("workspace/executeCommand", action["command"])
        assert not held_fixes.begun.is_set()
        assert not applied(server)

    play(manifest, scene)


def test_fixes_that_came_too_late_for_the_front_come_by_the_command(manifest: Path, held_fixes: Hold) -> None:
    async def scene(server: ServerInProcess) -> None:
        held_fixes.go_on.set()
        for tells_first in (True, False):
            action = await fix_all_action(server, manifest)
            unanswered = {"key": action["data"]["key"]}
            if tells_first:
                server.tell("rospkg/unanswered", unanswered)
            assert "edit" in (await server.answer("codeAction/resolve", action))["result"]
            if not tells_first:
                server.tell("rospkg/unanswered", unanswered)
            before = len(applied(server))
            await server.answer("workspace/executeCommand", action["command"])
            await until(lambda before=before: len(applied(server)) == before + 1)

    play(manifest, scene)


def test_fixes_of_a_text_that_changed_meanwhile_are_not_made(manifest: Path, held_fixes: Hold) -> None:
    async def scene(server: ServerInProcess) -> None:
        action = await fix_all_action(server, manifest)
        await server.answer("workspace/executeCommand", action["command"])
        await until(held_fixes.begun.is_set)
        server.type(manifest, TODO)
        held_fixes.go_on.set()
        said = "rospkg: the text has changed meanwhile, nothing was fixed"
        await until(lambda: any(each.get("params", {}).get("message") == said for each in server.sent))
        assert not applied(server)

    play(manifest, scene)


def test_fixes_that_fail_are_a_finding(manifest: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def failing(*_: object) -> None:
        raise KeyError("fixes")

    monkeypatch.setattr(fixing_all, "all_fixes", failing)

    async def scene(server: ServerInProcess) -> None:
        action = await fix_all_action(server, manifest)
        assert (await server.answer("codeAction/resolve", action))["result"]["edit"] == {}
        await until(lambda: "RPK005" in server.published(manifest)[-1])

    play(manifest, scene)


def test_threads_compute_properties_of_two_instances_at_once(hold: Hold) -> None:
    """Before Python 3.12, one that takes long holds up that of all other instances."""

    class Slow:
        def __init__(self, wait: Callable[[], object]) -> None:
            self.wait = wait
            self.calls = 0

        def value(self) -> int:
            self.wait()
            self.calls += 1
            return self.calls

    prop = cached_property(Slow.value)
    prop.__set_name__(Slow, "prop")
    slow, quick = Slow(hold), Slow(lambda: None)
    thread = threading.Thread(target=get, args=(prop, slow))
    thread.start()
    hold.begun.wait()
    assert [get(prop, quick), get(prop, quick)] == [1, 1]
    assert get(prop, None) is prop
    assert not hold.go_on.is_set()
    hold.go_on.set()
    thread.join()
    assert slow.calls == 1
