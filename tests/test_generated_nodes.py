"""Generated nodes run: against stand-ins for rclpy and messages (see `standins/`), since no index has the real ones."""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
import time
from collections.abc import Callable, Mapping
from itertools import groupby
from pathlib import Path
from types import MappingProxyType

import pytest
import yaml
from planned import plan

from rospkg_cli.scaffold.node_kinds import all_kinds
from rospkg_cli.scaffold.plan import Plan
from rospkg_cli.scaffold.template import load_template
from rospkg_cli.scaffold.write import write_folder

STANDINS = Path(__file__).parent / "standins"
START = "import sys; from my_robot_nav.{} import main; sys.exit(main())"
"""What the script of a console_scripts entry does."""


class Running:
    """A node as a process of its own; `params` is a file of the package, or values to write into one;
    `modules` are more stand-ins."""

    def __init__(
        self,
        planned: Plan,
        folder: Path,
        params: str | dict[str, object] = "",
        block: str = "/**",
        modules: Mapping[str, str] = MappingProxyType({}),
    ) -> None:
        self.log, self.said = folder / "log.jsonl", folder / "stderr.txt"
        self.log.touch()
        package = folder / "my_robot_nav"
        write_folder(package, planned.files)
        for path, text in modules.items():
            (package / path).parent.mkdir()
            (package / path).write_text(text)
        if isinstance(params, dict):
            (package / "own.yaml").write_text(yaml.safe_dump({block: {"ros__parameters": params}}))
            params = "own.yaml"
        env = {
            "PATH": os.environ["PATH"],
            "PYTHONPATH": os.pathsep.join((str(package), str(STANDINS))),
            "STANDIN_LOG": str(self.log),
            **({"STANDIN_PARAMS": str(package / params)} if params else {}),
        }
        [node, *_] = planned.answers.nodes_in("python")
        script = package / "scripts" / node.name
        command = [sys.executable, str(script)] if script.exists() else [sys.executable, "-c", START.format(node.name)]
        with self.said.open("w") as stderr:
            self.process = subprocess.Popen(command, env=env, stderr=stderr)

    @property
    def notes(self) -> list[dict]:
        return [json.loads(line) for line in self.log.read_text().splitlines()]

    def noted(self, what: str) -> list[dict]:
        return [note for note in self.notes if note["what"] == what]

    def until(self, what: str, count: int = 1) -> list[dict]:
        """Wait until something was noted as often as that."""
        self.wait(lambda: len(self.noted(what)) >= count)
        found = self.noted(what)
        assert len(found) >= count, self.said.read_text()
        return found

    def heard(self, count: int) -> str:
        """Wait until that many lines were logged, stop the node, and return them."""
        self.wait(lambda: len(self.said.read_text().splitlines()) >= count)
        return "".join(self.stop(signal.SIGTERM).splitlines(keepends=True)[:count])

    def wait(self, enough: Callable[[], bool]) -> None:
        for _ in range(3000):
            if enough() or self.process.poll() is not None:
                return
            time.sleep(0.01)
        self.process.kill()
        pytest.fail(f"the node never came so far: {self.said.read_text()}")

    def stop(self, number: signal.Signals) -> str:
        """Send a signal, and return what the process said; it must leave with 0."""
        self.process.send_signal(number)
        status = self.process.wait(timeout=30)
        said = self.said.read_text()
        assert status == 0, said
        assert "Traceback" not in said
        return said


STOPS = [pytest.param(signal.SIGINT, id="Ctrl-C"), pytest.param(signal.SIGTERM, id="SIGTERM")]
DOES: dict[str, tuple[str, int]] = {
    "publisher": ("publish", 2), "subscriber": ("subscription", 1), "timer": ("timer", 1), "service": ("response", 2),
    "client": ("call", 2), "action-server": ("result", 2), "action-client": ("goal", 1), "lifecycle": ("transition", 7),
}  # fmt: skip
"""What a kind comes to, and how often at least; any other spins."""


@pytest.mark.parametrize("number", STOPS)
@pytest.mark.parametrize("kind", load_template("ament_python").kinds)
def test_every_kind_runs_until_it_is_stopped(tmp_path: Path, kind: str, number: signal.Signals) -> None:
    planned = plan(nodes=(f"a_node:{kind}",))
    node = Running(planned, tmp_path, "config/params.yaml" if planned.answers.sections else "")
    node.until(*DOES.get(kind, ("spin", 1)))
    said = node.stop(number)
    assert [note["name"] for note in node.noted("node")] == ["a_node"]
    assert node.noted("shutdown")
    declared = {note["name"]: note["value"] for note in node.noted("declare")}
    assert declared == {each.name: each.default for each in all_kinds()[kind].parameters}
    assert all(note["described"] for note in node.noted("declare"))
    assert not node.noted("publish while inactive")
    assert "Error" not in said
    assert not said or said.startswith(f"[INFO] {all_kinds()[kind].says}\n")


def test_publisher(tmp_path: Path) -> None:
    node = Running(plan(nodes=("talker",)), tmp_path)
    assert [note["data"]["data"] for note in node.until("publish", 2)[:2]] == ["Hello 1", "Hello 2"]
    assert node.noted("publisher") == [{"what": "publisher", "topic": "greeting", "type": "std_msgs.msg.String"}]
    assert "[INFO] Hello 1\n" in node.stop(signal.SIGTERM)


def test_subscriber(tmp_path: Path) -> None:
    node = Running(plan(nodes=("listener:subscriber",)), tmp_path)
    assert '[INFO] I heard "Hello" (number 1)\n[INFO] I heard "Hello" (number 2)\n' in node.heard(3)
    assert [note["topic"] for note in node.noted("subscription")] == ["greeting"]


def test_timer(tmp_path: Path) -> None:
    node = Running(plan(nodes=("counter:timer",)), tmp_path, {"start": 3, "period": 0.02})
    assert node.heard(4) == "".join(f"[INFO] {number}\n" for number in (3, 2, 1, 0))


def test_a_parameter_is_changed_and_not_emptied(tmp_path: Path) -> None:
    node = Running(plan(nodes=("keeper:parameter",)), tmp_path)
    changes = {note["value"]: (note["successful"], note["reason"]) for note in node.until("change", 2)}
    assert changes == {"other": (True, ""), "": (False, "text must not be empty")}
    assert "[INFO] ready\n[INFO] text is other\n" in node.stop(signal.SIGTERM)


def test_frames_are_broadcast_and_looked_up(tmp_path: Path) -> None:
    node = Running(plan(nodes=("there:tf-broadcaster",)), tmp_path, {"x": 2.5, "rate": 50.0})
    assert node.until("transform")[0] == {"what": "transform", "parent": "world", "child": "robot", "x": 2.5}
    node.stop(signal.SIGTERM)


def test_a_frame_is_waited_for(tmp_path: Path) -> None:
    node = Running(plan(nodes=("where:tf-listener",)), tmp_path, {"rate": 50.0})
    assert node.heard(3) == "[INFO] ready\n[INFO] waiting: no such frame\n[INFO] robot is at 0.00 0.00 0.00\n"


def test_service(tmp_path: Path) -> None:
    node = Running(plan(nodes=("adder:service",)), tmp_path)
    assert node.until("response")[0]["data"] == {"sum": 5}
    assert "[INFO] 2 + 3 = 5\n" in node.stop(signal.SIGTERM)
    assert [note["service"] for note in node.noted("service")] == ["add"]


def test_client(tmp_path: Path) -> None:
    node = Running(plan(nodes=("asker:client",)), tmp_path, {"rate": 50.0})
    heard = node.heard(4)
    assert heard.startswith("[INFO] ready\n[INFO] waiting for the service\n[INFO] 1 + 2 = 3\n[INFO] 2 + 3 = 5\n")
    assert node.noted("call")[0]["request"] == {"a": 1, "b": 2}


def test_action_server(tmp_path: Path) -> None:
    node = Running(plan(nodes=("worker:action-server",)), tmp_path, {"pause": 0.01})
    results = {note["order"]: note for note in node.until("result", 2)}
    node.stop(signal.SIGTERM)
    assert [(note["order"], note["accepted"]) for note in node.noted("goal")] == [
        (0, False), (47, False), (5, True), (40, True),
    ]  # fmt: skip
    assert (results[5]["state"], results[5]["sequence"]) == ("succeeded", [1, 1, 2, 3, 5])
    assert results[40]["state"] == "canceled"
    assert [len(note["sequence"]) for note in node.noted("feedback") if note["order"] == 5] == [1, 2, 3, 4, 5]
    assert node.noted("spin")[0]["executor"] == "MultiThreadedExecutor"
    assert node.noted("action server")[0]["group"] == "ReentrantCallbackGroup"


def test_action_server_leaves_while_it_works(tmp_path: Path) -> None:
    node = Running(plan(nodes=("worker:action-server",)), tmp_path, {"pause": 0.2})
    node.until("feedback")
    node.stop(signal.SIGINT)


def test_action_client(tmp_path: Path) -> None:
    node = Running(plan(nodes=("asker:action-client",)), tmp_path, {"order": 4})
    heard = node.heard(7)
    assert heard.startswith("[INFO] ready\n[INFO] waiting for the action server\n[INFO] 1 of 4: 1\n")
    assert heard.endswith("[INFO] result: 4 of 4: ... 1 1 1\n")
    assert [note["order"] for note in node.noted("goal")] == [4]


def test_lifecycle(tmp_path: Path) -> None:
    """It publishes between activate and deactivate, and between activate and shutdown; nowhere else."""
    node = Running(plan(nodes=("talker:lifecycle",)), tmp_path, {"text": "Ciao", "rate": 50.0})
    node.until("transition", 7)
    node.stop(signal.SIGTERM)
    steps = [note.get("name") for note in node.notes if note["what"] in ("transition", "publish")]
    assert [step for step, _ in groupby(step or "publish" for step in steps)] == [
        "configure", "activate", "publish", "deactivate", "cleanup", "configure", "activate", "publish", "shutdown",
    ]  # fmt: skip
    assert not node.noted("publish while inactive")


def test_a_node_reads_the_file_of_parameters(tmp_path: Path) -> None:
    node = Running(
        plan(nodes=("talker", "listener:subscriber")), tmp_path, {"text": "Ciao", "rate": 50.0}, "/**/talker"
    )
    assert node.until("publish")[0]["data"] == {"data": "Ciao 1"}
    node.stop(signal.SIGINT)
    assert [note["period"] for note in node.noted("timer")] == [0.02]


@pytest.mark.parametrize("number", STOPS)
def test_the_script_of_a_mixed_package_runs_its_node(tmp_path: Path, number: signal.Signals) -> None:
    nodes = ("talker", "counter:timer:python", "listener:subscriber:python")
    node = Running(plan(template="mixed", nodes=nodes), tmp_path, "config/params.yaml")
    node.until("timer")
    assert [note["name"] for note in node.noted("node")] == ["counter"]
    assert {note["name"]: note["value"] for note in node.noted("declare")} == {"start": 10, "period": 1.0}
    assert "Error" not in node.stop(number)
