"""The packages of an editor's workspace between the first run and the one that has judged them all."""

from __future__ import annotations

from concurrent.futures import Future
from pathlib import Path

import pytest
from looked_up import FILES

from rospkg_cli.cli.server import live_lint
from rospkg_cli.cli.server.language_server import PackageServer
from rospkg_cli.cli.server.live_lint import LintOrder, LiveLint
from rospkg_cli.cli.server.live_workspace import LiveWorkspace
from rospkg_cli.cli.server.live_world import LiveWorld
from rospkg_cli.cli.server.open_text import OpenText
from rospkg_cli.engine.run import worker
from rospkg_cli.example import Example
from rospkg_cli.finding import Finding
from rospkg_cli.light_dataclasses import replace
from rospkg_cli.lookup.definition import definitions
from rospkg_cli.lookup.mention import mention_at
from rospkg_cli.package.run_events import RuleCrash

MANIFEST = Example(bad={}, good={}).bad_files()["package.xml"]


def test_a_neighbour_is_found_before_it_is_linted(tmp_path: Path) -> None:
    using = MANIFEST.replace("<export>", "<depend>my_other</depend><export>")
    for name, text in (("my_pkg", using), ("my_other", MANIFEST.replace("my_pkg", "my_other"))):
        (tmp_path / name).mkdir()
        (tmp_path / name / "package.xml").write_text(text)
    texts = {tmp_path / "my_pkg/package.xml": OpenText("", 1, using.encode())}
    run = LiveLint(tmp_path).run(LintOrder(texts, frozenset(texts), frozenset({tmp_path / "my_pkg"})))
    assert not run.is_finished
    world = LiveWorld().at(run.scene, texts)
    mention = mention_at(world.package("my_pkg"), "package.xml", using.index("my_other"))
    assert mention
    assert [each.path for each in definitions(world, "my_pkg", mention)] == ["my_other/package.xml"]


def test_a_package_on_which_a_rule_fails_keeps_none_from_being_judged(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    for name in ("broken", "good", "other"):
        (tmp_path / name).mkdir()
        (tmp_path / name / "package.xml").write_text(MANIFEST.replace("my_pkg", name))
    real = worker.run_rules
    monkeypatch.setattr(live_lint, "CHUNK", 1)
    monkeypatch.setattr(
        worker,
        "run_rules",
        lambda inputs, rules, builder: (
            [RuleCrash("XML104", "broken", "package.xml", "KeyError")]
            if builder.package == "broken"
            else real(inputs, rules, builder)
        ),
    )
    live = LiveLint(tmp_path)
    runs = [live.run(LintOrder({}, frozenset(), frozenset({tmp_path / "broken"}))) for _ in range(4)]
    assert [run.results.packages for run in runs] == [1, 2, 3, 3]
    assert [run.is_finished for run in runs] == [False, False, True, True]
    assert "RPK005" in [each.code for each in runs[-1].results.findings]


def test_neighbours_know_a_manifest_as_it_was_while_it_is_typed(tmp_path: Path) -> None:
    """Broken between two keys, it says nothing of its package; broken and saved, it is what lint reads."""
    for path, text in FILES.items():
        (tmp_path / path).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / path).write_text(text.replace("executable='driver'", "executable='drivr'"))
    manifest, live = tmp_path / "my_cpp/package.xml", LiveLint(tmp_path)
    before = live.run(LintOrder({}, frozenset(), frozenset())).results.findings
    assert "LCH002" in [each.code for each in before]

    def found(text: str) -> tuple[Finding, ...]:
        texts = {manifest: OpenText("", 1, text.encode())}
        results = live.run(LintOrder(texts, frozenset(texts), frozenset())).results
        assert not results.crashes
        return results.findings

    own = [each for each in before if each.package != "my_cpp"]
    whole = manifest.read_text()
    for broken in (whole.replace("</package>", "<dep"), whole.replace("</package>", "<depend>"), "<", ""):
        after = found(broken)
        assert [each for each in after if each.package != "my_cpp"] == own
        assert "RPK001" in [each.code for each in after]
    assert found(whole) == before
    manifest.write_text(broken)
    saved = found(broken)
    assert "LCH002" not in [each.code for each in saved]
    assert saved == LiveLint(tmp_path).run(LintOrder({}, frozenset(), frozenset())).results.findings


def packages(tmp_path: Path, *names: str) -> LiveLint:
    """Return the lint of some packages that have been judged."""
    for name in names:
        (tmp_path / name).mkdir()
        (tmp_path / name / "package.xml").write_text(MANIFEST.replace("my_pkg", name))
    return LiveLint(tmp_path)


def test_what_nobody_tells_of_is_seen_on_disk(tmp_path: Path) -> None:
    """Neovim and Emacs do not watch files: a branch may have been changed under the editor."""
    live, told = packages(tmp_path, "a", "b", "c"), list[Path]()
    order = LintOrder({}, frozenset(), frozenset(), on_disk=told.append)
    live.run(order)
    first = dict(live.memory.facts)
    assert not told
    (tmp_path / "b/package.xml").write_text(MANIFEST.replace("my_pkg", "b").replace("Apache-2.0", "TODO"))
    (tmp_path / "c/setup.py").touch()
    assert "XML104" in [each.code for each in live.run(order).results.findings]
    assert set(told) == {tmp_path / "b/package.xml", tmp_path / "c/setup.py"}
    assert [folder for folder in "abc" if live.memory.facts[folder] is first[folder]] == ["a"]
    (tmp_path / "b/package.xml").write_text(MANIFEST.replace("my_pkg", "b"))
    assert "XML104" in [each.code for each in live.run(replace(order, on_disk=None)).results.findings]
    assert "XML104" not in [each.code for each in live.run(order).results.findings]


@pytest.mark.parametrize("path, is_kept", [(".github/workflows/ci.yml", True), ("tools/ci.yml", False)])
def test_what_only_other_tools_read_has_nothing_linted_again(tmp_path: Path, path: str, is_kept: bool) -> None:
    live = packages(tmp_path, "a", "b")
    live.run(LintOrder({}, frozenset(), frozenset()))
    first = live.memory.facts["a"]
    live.run(LintOrder({}, frozenset({tmp_path / path}), frozenset()))
    assert (live.memory.facts["a"] is first) is is_kept


def test_only_other_content_is_a_change(tmp_path: Path) -> None:
    path, live = tmp_path / "CMakeLists.txt", LiveWorkspace(tmp_path)
    path.write_text("# one")

    def changes(content: str | None, version: int = 1) -> bool:
        live.changed.clear()
        live.put(path, None if content is None else OpenText("", version, content.encode()))
        return bool(live.changed)

    assert not changes("# one")
    assert changes("# two")
    path.write_text("# two")
    assert not changes("# two")
    assert changes("# two", version=2)
    assert not changes(None)
    assert changes("# three")
    assert changes(None)
    path.unlink()
    assert changes("# two")


def test_a_manifest_that_is_saved_is_no_longer_typed(tmp_path: Path) -> None:
    live = LiveWorkspace(tmp_path)
    (tmp_path / "package.xml").write_text("<")
    live.put(tmp_path / "package.xml", OpenText("", 1, b"<"))
    assert live.changed


def test_what_pygls_keeps_of_notifications_is_let_go() -> None:
    server = PackageServer()
    kept = server.protocol._request_futures
    kept |= {"handled": Future(), "waiting": Future()}
    kept["handled"].set_result(None)
    server.forget_answered()
    assert list(kept) == ["waiting"]
