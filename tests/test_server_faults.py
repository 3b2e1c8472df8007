"""`rospkg server` where something of ours fails or is slow: it tells, goes on, and answers no earlier text."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest
from editor import Editor
from lsprotocol import types
from writing import Write

DEPENDENCY = "  <exec_depend>rclpy</exec_depend>\n"
TODO = ("Apache-2.0", "TODO")


def message(**parts: object) -> bytes:
    body = json.dumps({"jsonrpc": "2.0", **parts}).encode()
    return b"Content-Length: %d\r\n\r\n" % len(body) + body


def test_an_editor_that_takes_leave_gets_no_fault() -> None:
    initialize = message(id=1, method="initialize", params={"processId": None, "rootUri": None, "capabilities": {}})
    leave = message(id=2, method="shutdown") + message(method="exit")
    command = [sys.executable, "-m", "rospkg_cli", "server"]
    done = subprocess.run(command, input=initialize + leave, capture_output=True, check=False)
    assert (done.returncode, done.stderr) == (0, b"")
    assert b'"id": 2, "jsonrpc": "2.0", "result": null' in done.stdout


class FailingEditor(Editor):
    program = (str(Path(__file__).with_name("failing_server.py")),)


@pytest.fixture(scope="module")
def editor(tmp_path_factory: pytest.TempPathFactory) -> Iterator[Editor]:
    kept = {name: os.environ[name] for name in ("PATH", "HOME", "LANG") if name in os.environ}
    folder = tmp_path_factory.mktemp("faults")
    (folder / "src").mkdir()
    found = FailingEditor(folder, **kept, XDG_CACHE_HOME=os.devnull, XDG_CONFIG_HOME=os.devnull)
    found.folder = folder
    yield found
    found.quit()


@pytest.fixture
def manifest(editor: Editor, write: Write, clean: dict[str, str], request: pytest.FixtureRequest) -> Path:
    """The open package.xml of a faultless package with the name of the test."""
    name = request.node.name.removeprefix("test_")[:40].rstrip("_")
    files = {path.replace("my_pkg", name): text.replace("my_pkg", name) for path, text in clean.items()}
    path = write(editor.folder / "src" / name, files) / "package.xml"
    editor.open(path)
    return path


def test_a_rule_that_fails_is_a_finding(editor: Editor, manifest: Path) -> None:
    text = editor.texts[manifest]
    editor.type(manifest, text.replace("Drives my robot", "broken rule").replace("ada@example.org", "ada"))
    editor.until(lambda: editor.codes(manifest) == ["RPK005", "XML105"])
    found = next(each for each in editor.diagnostics[manifest] if each.code == "RPK005")
    assert found.message == f"rule XML104 failed on `{manifest.parent.name}`: KeyError: 'of ours'; please report this"
    assert found.severity == types.DiagnosticSeverity.Error
    editor.type(manifest, text.replace(*TODO))
    editor.until(lambda: editor.codes(manifest) == ["XML104"])


def test_a_lookup_that_fails_is_a_finding(editor: Editor, manifest: Path) -> None:
    text = editor.texts[manifest]
    editor.type(manifest, text.replace("  <export>", "  <depend>broken_lookup</depend>\n  <export>"))
    editor.settle()
    assert editor.definition(manifest, "broken|_lookup</depend>") == []
    editor.until(lambda: "RPK005" in editor.codes(manifest))
    found = next(each for each in editor.diagnostics[manifest] if each.code == "RPK005")
    name = manifest.parent.name
    assert found.message == f"answer to definition failed on `{name}`: KeyError: 'broken_lookup'; please report this"
    assert editor.hover(manifest, "broken|_lookup</depend>")
    editor.type(manifest, text)
    editor.until(lambda: editor.codes(manifest) == [])


def test_actions_that_fail_are_a_finding(editor: Editor, manifest: Path) -> None:
    assert editor.actions(manifest) == []
    editor.until(lambda: editor.codes(manifest) == ["RPK005"])
    [found] = editor.diagnostics[manifest]
    name = manifest.parent.name
    assert found.message == f"answer to actions failed on `{name}`: KeyError: 'actions'; please report this"


def test_a_run_that_fails_is_told_once(editor: Editor, manifest: Path, write: Write) -> None:
    broken = write(editor.folder / "src/broken_run", {"package.xml": editor.texts[manifest]})
    editor.type(manifest, editor.texts[manifest].replace(*TODO))
    editor.until(lambda: any("internal error, please report it: KeyError('broken_run')" in m for m in editor.messages))
    assert editor.actions(manifest) == []
    (broken / "package.xml").unlink()
    editor.wrote(broken / "package.xml")
    editor.until(lambda: editor.codes(manifest) == ["XML104"])


def test_actions_wait_for_the_run(editor: Editor, manifest: Path) -> None:
    """Asked right behind what was typed, while a run over the text before may go on."""
    text = editor.texts[manifest]
    for slow in (text.replace("Drives my robot", "TODO slowly"), text.replace("Drives my robot", "Goes slowly")):
        editor.type(manifest, slow)
        editor.actions(manifest)
        editor.type(manifest, slow.replace("  <export>", f"{DEPENDENCY}{DEPENDENCY}  <export>"))
        [fix] = [each for each in editor.actions(manifest) if each.is_preferred]
        [change] = fix.edit.document_changes
        assert change.text_document.version == editor.versions[manifest]


def test_a_request_that_is_cancelled_is_answered_at_once(editor: Editor, manifest: Path) -> None:
    editor.type(manifest, editor.texts[manifest].replace("Drives my robot", "TODO slowly"))
    whole = types.Range(types.Position(0, 0), types.Position(99, 0))
    asked = types.CodeActionParams(types.TextDocumentIdentifier(manifest.as_uri()), whole, types.CodeActionContext([]))
    waiting = editor.client.protocol.send_request("textDocument/codeAction", asked, msg_id="waiting")
    editor.client.cancel_request(types.CancelParams("waiting"))
    editor.until(waiting.done)
    assert "canceled" in str(waiting.exception())
    editor.until(lambda: editor.codes(manifest) == ["XML104"])
