"""Generated nodes run: against stand-ins for rclpy and messages (see `standins/`), since no index has the real ones."""

from __future__ import annotations

import json
import os
import signal
import subprocess
import sys
import time
from pathlib import Path

import pytest
import yaml
from planned import plan

from rospkg_cli.scaffold.plan import Plan
from rospkg_cli.scaffold.write import write_folder

STANDINS = Path(__file__).parent / "standins"
START = "import sys; from my_robot_nav.{} import main; sys.exit(main())"
"""What the script of a console_scripts entry does."""


class Running:
    """A node as a process of its own."""

    def __init__(self, planned: Plan, folder: Path, params: str = "") -> None:
        self.log = folder / "log.jsonl"
        self.log.touch()
        write_folder(folder / "my_robot_nav", planned.files)
        env = {
            "PATH": os.environ["PATH"],
            "PYTHONPATH": os.pathsep.join((str(folder / "my_robot_nav"), str(STANDINS))),
            "STANDIN_LOG": str(self.log),
        }
        if params:
            env["STANDIN_PARAMS"] = str(folder / "my_robot_nav" / params)
        command = [sys.executable, "-c", START.format(planned.answers.nodes[0].name)]
        self.process = subprocess.Popen(command, env=env, stderr=subprocess.PIPE, text=True)

    def noted(self, what: str) -> list[dict]:
        notes = [json.loads(line) for line in self.log.read_text().splitlines()]
        return [note for note in notes if note["what"] == what]

    def until(self, what: str, count: int = 1) -> list[dict]:
        """Wait until something was noted as often as that."""
        for _ in range(3000):
            if len(found := self.noted(what)) >= count or self.process.poll() is not None:
                return found
            time.sleep(0.01)
        pytest.fail(f"the node never came to {what}")

    def stop(self, number: signal.Signals) -> str:
        """Send a signal, and return what the process said; it must leave with 0."""
        self.process.send_signal(number)
        _, said = self.process.communicate(timeout=30)
        assert self.process.returncode == 0, said
        assert "Traceback" not in said
        return said


@pytest.mark.parametrize("number", [signal.SIGINT, signal.SIGTERM], ids=["Ctrl-C", "SIGTERM"])
def test_a_node_publishes_until_it_is_stopped(tmp_path: Path, number: signal.Signals) -> None:
    node = Running(plan(nodes=("talker",)), tmp_path)
    published = node.until("publish", 2)
    assert [note["data"]["data"] for note in published[:2]] == ["Hello 1", "Hello 2"]
    assert node.noted("publisher") == [{"what": "publisher", "topic": "greeting", "type": "std_msgs.msg.String"}]
    assert [note["name"] for note in node.noted("node")] == ["talker"]
    assert "[INFO] Hello 1\n" in node.stop(number)
    assert node.noted("shutdown")


def test_the_parameters_of_the_file_are_those_that_a_node_declares(tmp_path: Path) -> None:
    node = Running(plan(), tmp_path, "config/params.yaml")
    node.until("spin")
    node.stop(signal.SIGTERM)
    written = yaml.safe_load((tmp_path / "my_robot_nav/config/params.yaml").read_text())
    declared = node.noted("declare")
    assert {note["name"]: note["value"] for note in declared} == written["/**"]["ros__parameters"]
    assert all(note["described"] for note in declared)


def test_a_node_reads_its_parameters(tmp_path: Path) -> None:
    planned = plan()
    write_folder(tmp_path / "other", planned.files)
    params = (tmp_path / "other/config/params.yaml").read_text()
    changed = params.replace("Hello", "Ciao").replace("1.0", "50.0")
    assert changed != params
    (tmp_path / "params.yaml").write_text(changed)
    node = Running(planned, tmp_path, "../params.yaml")
    assert node.until("publish")[0]["data"] == {"data": "Ciao 1"}
    node.stop(signal.SIGINT)
    assert [note["period"] for note in node.noted("timer")] == [0.02]
