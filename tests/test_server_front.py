"""What stands between an editor and the server: what is not answered in time is refused, and answered once."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from collections.abc import Iterator
from threading import Thread
from typing import Any

import pytest

from rospkg_cli.cli.server.deadlines import MARGIN, Deadlines
from rospkg_cli.cli.server.framing import bodies, framed
from rospkg_cli.cli.server.front import Front, Streams
from rospkg_cli.cli.server.refusal import LIMIT, limit_in

HOVER = {"id": 7, "method": "textDocument/hover", "params": {}}
RESOLVE = {"id": 8, "method": "codeAction/resolve", "params": {"title": "fix all", "data": {"key": "3"}}}
NEVER, AT_ONCE = 600, -MARGIN


class End:
    """One end of two pipes, which sends and hears messages."""

    def __init__(self, heard: int, told: int) -> None:
        self.streams = Streams(os.fdopen(heard, "rb"), os.fdopen(told, "wb"))
        self.heard = bodies(self.streams.heard)

    def tell(self, message: dict[str, Any]) -> None:
        self.streams.sink.write(framed(json.dumps(message).encode()))
        self.streams.sink.flush()

    def hear(self) -> Any:
        return json.loads(next(self.heard))


class Played:
    """A front between an editor and a server that a test plays."""

    def __init__(self) -> None:
        (a, b), (c, d), (e, f), (g, h) = (os.pipe() for _ in range(4))
        self.editor, self.server = End(a, d), End(e, h)
        front = End(c, b), End(g, f)
        self.front = Front(*(each.streams for each in front))
        self.thread = Thread(target=self.front.run)
        self.thread.start()

    def give(self, seconds: float) -> None:
        """Have the editor say how long it waits."""
        options = {"initializationOptions": {"answerWithin": seconds}}
        self.editor.tell({"id": 1, "method": "initialize", "params": options})
        assert self.server.hear()["id"] == 1
        if seconds < LIMIT:
            self.front.deadlines.limit = AT_ONCE


@pytest.fixture
def played() -> Iterator[Played]:
    found = Played()
    yield found
    found.server.streams.sink.close()
    found.thread.join()
    found.editor.streams.sink.close()


def test_what_the_server_does_not_answer_is_refused_once(played: Played) -> None:
    played.give(0.01)
    played.editor.tell(HOVER)
    assert played.server.hear() == HOVER
    refused = played.editor.hear()
    assert (refused["id"], refused["error"]["code"]) == (7, -32801)
    played.server.tell({"id": 7, "result": "too late"})
    played.server.tell({"id": 7, "method": "client/registerCapability"})
    assert "method" in played.editor.hear()
    played.server.tell({"id": 7, "result": "another of that number"})
    assert played.editor.hear()["result"] == "another of that number"


def test_what_is_answered_in_time_is_not_refused(played: Played) -> None:
    played.give(NEVER)
    played.editor.tell(HOVER)
    played.editor.tell({**HOVER, "id": "other"})
    assert [played.server.hear()["id"] for _ in range(2)] == [7, "other"]
    played.server.tell({"id": 7, "result": None})
    assert played.editor.hear() == {"id": 7, "result": None}
    assert [*played.front.deadlines.waiting] == ["other"]


def test_what_is_no_question_about_a_file_waits_as_long_as_it_takes(played: Played) -> None:
    played.give(0.01)
    played.editor.tell({"id": 2, "method": "workspace/executeCommand", "params": {}})
    played.editor.tell({"method": "textDocument/hover"})
    assert not played.front.deadlines.waiting
    played.server.hear()
    played.server.tell({"id": 2, "result": None})
    assert played.editor.hear()["id"] == 2


def test_an_action_comes_without_its_edit_and_the_server_hears_of_it(played: Played) -> None:
    played.give(0.01)
    played.editor.tell(RESOLVE)
    assert played.editor.hear()["result"] == RESOLVE["params"]
    told = [played.server.hear() for _ in range(2)]
    assert {"jsonrpc": "2.0", "method": "rospkg/unanswered", "params": {"key": "3"}} in told


def test_what_is_no_message_is_passed_on(played: Played) -> None:
    for body in (b"[" * 10_000, b"no JSON", b'["list"]'):
        played.editor.streams.sink.write(b"Content-Type: text\r\n" + framed(body))
        played.editor.streams.sink.flush()
        assert next(played.server.heard) == body


def test_the_first_deadline_is_that_of_the_first_request() -> None:
    deadlines = Deadlines(AT_ONCE)
    deadlines.asked(HOVER)
    deadlines.asked(RESOLVE)
    assert deadlines.late() == HOVER
    assert deadlines.lets_through({"id": 8, "result": None})
    assert not deadlines.lets_through({"id": 7, "result": None})


@pytest.mark.parametrize(
    "options, limit",
    [
        (None, LIMIT),
        ({}, LIMIT),
        ({"answerWithin": 3}, 3),
        ({"answerWithin": 0}, LIMIT),
        ({"answerWithin": "1"}, LIMIT),
        ({"answerWithin": float("inf")}, 3600),
    ],
)
def test_an_editor_may_say_how_long_it_waits(options: object, limit: float) -> None:
    assert limit_in(options) == limit


@pytest.mark.skipif(not hasattr(os, "fork"), reason="the server is alone there")
@pytest.mark.parametrize("serve, status", [("lambda: 3", 3), ("lambda: os.kill(os.getpid(), 9)", 137)])
def test_the_status_is_that_of_the_server(serve: str, status: int) -> None:
    code = f"import os, sys; from rospkg_cli.cli.server.processes import behind_front; sys.exit(behind_front({serve}))"
    done = subprocess.run([sys.executable, "-c", code], input=b"", capture_output=True, check=False)
    assert (done.returncode, done.stdout, done.stderr) == (status, b"", b"")


@pytest.mark.skipif(not hasattr(os, "fork"), reason="the server is alone there")
def test_the_server_hears_all_that_the_editor_says_and_ends_with_it() -> None:
    code = """
import sys
from rospkg_cli.cli.server.framing import bodies, framed
from rospkg_cli.cli.server.processes import behind_front
def echo():
    for body in bodies(sys.stdin.buffer):
        sys.stdout.buffer.write(framed(body))
    return 0
sys.exit(behind_front(echo))
"""
    said = b"".join(framed(b'{"method": "%d"}' % number) for number in range(3))
    done = subprocess.run([sys.executable, "-c", code], input=said + b"Content-Length: 9\r\n\r\n{", capture_output=True)
    assert (done.returncode, done.stdout, done.stderr) == (0, said, b"")
