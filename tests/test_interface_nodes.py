"""Nodes about services and actions of one's own, or of others; topics, their names and their quality of service."""

from __future__ import annotations

import itertools
import signal
from pathlib import Path

import pytest
from planned import around, plan, texts
from test_generated_nodes import Running

from rospkg_cli.ros.distros import DISTROS
from rospkg_cli.scaffold.qos import QOS

GO = "Go:geometry_msgs/Pose goal, string why --- bool ok, builtin_interfaces/Time at"
FLY = "Fly:int32 height --- bool ok --- float32 rest"
THERE = around(plan("my_ifs", template="interfaces", srvs=(GO, "Bare: --- "), actions=(FLY, "Still: --- --- ")))
KINDS = {"service": "Go", "client": "Go", "action-server": "Fly", "action-client": "Fly"}
LANGUAGES = {"ament_python": ("python",), "ament_cmake": ("cpp",), "mixed": ("cpp", "python")}


@pytest.mark.parametrize("distro", [each.name for each in DISTROS])
@pytest.mark.parametrize("template", LANGUAGES)
def test_they_are_written_without_a_finding(template: str, distro: str) -> None:
    pairs = itertools.product(KINDS, LANGUAGES[template])
    nodes = tuple(
        f"n{n}_{name.lower()}:{kind}:{language}:{name}{'@/a/b' if n % 2 else ''}"
        for n, (kind, language) in enumerate(pairs)
        for name in (KINDS[kind], {"Go": "Bare", "Fly": "Still"}[KINDS[kind]])
    )
    planned = plan(there=THERE, template=template, nodes=nodes, distro=distro)
    assert planned.findings == ()
    assert f"{'exec_' if template == 'ament_python' else ''}depend>my_ifs<" in texts(planned)["package.xml"]


@pytest.mark.parametrize("kind", KINDS)
def test_fields_with_a_plain_value_are_set(kind: str) -> None:
    node = f"a_node:{kind}:{KINDS[kind]}"
    python = texts(plan(there=THERE, nodes=(node,)))["my_robot_nav/a_node.py"]
    cpp = texts(plan(there=THERE, template="ament_cmake", nodes=(node,)))["src/a_node.cpp"]
    expected = {
        "service": ("response.ok = False", "response.ok = false;"),
        "client": ("request.why = ''", 'request->why = "";'),
        "action-server": ("feedback.rest = 0.0", "feedback->rest = 0.0;"),
        "action-client": ("goal.height = 0", "goal.height = 0;"),
    }
    assert expected[kind][0] in python
    assert expected[kind][1] in cpp
    assert f'"{KINDS[kind].lower()}"' in cpp
    assert f'#include "my_ifs/{"srv" if "Go" in node else "action"}/{KINDS[kind].lower()}.hpp"' in cpp


@pytest.mark.parametrize("name", QOS)
def test_a_topic_has_the_quality_of_service_that_is_named(name: str) -> None:
    nodes = (f"scan:subscriber:sensor_msgs/LaserScan@/scan:{name}", f"far:publisher:{name}:sensor_msgs/LaserScan")
    planned = plan(nodes=nodes)
    assert planned.findings == ()
    for node in ("scan", "far"):
        source = texts(planned)[f"my_robot_nav/{node}.py"]
        assert f"            {QOS[name].python},\n" in source
        assert f"from rclpy.qos import {', '.join(QOS[name].imports)}\n" in source
    cpp = texts(plan(template="ament_cmake", nodes=nodes))
    assert f'"/scan", {QOS[name].cpp},\n' in cpp["src/scan.cpp"]
    assert f'"laser_scan", {QOS[name].cpp});\n' in cpp["src/far.cpp"]


def test_any_kind_takes_the_name_of_its_topic_service_or_action() -> None:
    kinds = ("publisher", "subscriber", "service", "client", "action-server", "action-client", "lifecycle")
    nodes = tuple(f"n_{kind.replace('-', '_')}:{kind}@/{'x' * 27}" for kind in kinds)
    for template in ("ament_python", "ament_cmake"):
        planned = plan(template=template, nodes=nodes)
        assert planned.findings == ()
        files = texts(planned)
        for path in [path for path in files if path.rpartition("/")[2].startswith("n_")]:
            assert f"/{'x' * 27}" in files[path], path
            assert max(map(len, files[path].splitlines())) <= 99, path
        assert files["README.md"].count(f"`/{'x' * 27}`") == len(kinds)


def test_the_chapters_topics() -> None:
    files = texts(plan(nodes=("talker@/chatter", "scan:subscriber:sensor_msgs/LaserScan@/scan")))
    assert "create_publisher(String, '/chatter', 10)" in files["my_robot_nav/talker.py"]
    assert "            '/scan',\n" in files["my_robot_nav/scan.py"]


def test_long_names_keep_the_line_length() -> None:
    name = "A" + "bcdefghijkl" * 3 + "bcdef"
    nodes = tuple(f"n{n}_{language}:{kind}:{language}:a_robot_interfaces_pkg_of_mi/{name}"
                  for n, kind in enumerate(KINDS) for language in ("cpp", "python"))  # fmt: skip
    for path, text in texts(plan(template="mixed", nodes=nodes)).items():
        if path.endswith((".py", ".cpp")):
            assert [line for line in text.splitlines() if len(line) > 99 and line[0] != "#"] == [], path


def test_a_service_answers(tmp_path: Path) -> None:
    node = Running(plan(nodes=("adder:service:example_interfaces/AddTwoInts@/sum",)), tmp_path)
    assert node.until("response")[0]["data"] == {"sum": 0}
    assert "AddTwoInts.Request(a=2, b=3)" in node.stop(signal.SIGTERM)
    assert [note["service"] for note in node.noted("service")] == ["/sum"]


def test_a_client_asks(tmp_path: Path) -> None:
    node = Running(plan(nodes=("asker:client:example_interfaces/AddTwoInts",)), tmp_path, {"rate": 50.0})
    heard = node.heard(3)
    assert heard.startswith("[INFO] ready\n[INFO] waiting for the service\n")
    assert "AddTwoInts.Response(sum=0)" in heard
    assert node.noted("call")[0]["service"] == "add_two_ints"


def test_an_action_server_works(tmp_path: Path) -> None:
    planned = plan(nodes=("worker:action-server:example_interfaces/Fibonacci",))
    node = Running(planned, tmp_path, {"pause": 0.01, "steps": 3})
    states = {note["order"]: note["state"] for note in node.until("result", 4)}
    node.stop(signal.SIGINT)
    assert states == {0: "succeeded", 47: "succeeded", 5: "succeeded", 40: "canceled"}
    assert len(node.noted("feedback")) == 9


def test_an_action_client_asks(tmp_path: Path) -> None:
    node = Running(plan(nodes=("asker:action-client:example_interfaces/Fibonacci",)), tmp_path)
    assert "[INFO] result: Fibonacci.Result(sequence=[])\n" in node.heard(3)
    assert [note["order"] for note in node.noted("goal")] == [0]
