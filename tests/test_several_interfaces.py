"""Nodes with several interfaces: `NAME:subscriber:…+publisher:…`."""

from __future__ import annotations

import signal
from pathlib import Path

import pytest
from adding import added, cmake_package, new_findings, text
from planned import plan, texts
from test_add_to_cmake import LOWER
from test_generated_nodes import Running

from rospkg_cli.scaffold import ScaffoldError

IMU, TWIST = "subscriber:sensor_msgs/Imu@/imu", "publisher:geometry_msgs/Twist@/cmd_vel"
BOTH = f"drive:{IMU}:sensor_data+{TWIST}"
FOUR = f"{BOTH}+service:std_srvs/SetBool@go+client:std_srvs/Trigger"


@pytest.mark.parametrize("template, language", [("ament_python", "python"), ("ament_cmake", "cpp"), ("mixed", "")])
def test_they_are_written_without_a_finding(template: str, language: str) -> None:
    nodes = (FOUR, f"other:{IMU}:python+subscriber:sensor_msgs/Imu@/imu2") if template == "mixed" else (FOUR,)
    planned = plan(template=template, nodes=nodes, distro="humble")
    assert planned.findings == ()
    manifest = texts(planned)["package.xml"]
    assert [name for name in ("geometry_msgs", "sensor_msgs", "std_srvs") if f"depend>{name}<" not in manifest] == []
    assert [line for path, each in texts(planned).items() if path.endswith((".py", ".cpp"))
            for line in each.splitlines() if len(line) > 99] == []  # fmt: skip
    assert "It listens to `/imu` (`sensor_msgs/msg/Imu`).\nIt publishes `/cmd_vel`" in texts(planned)["README.md"]
    drive = planned.answers.nodes[0]
    assert drive.language == (language or "cpp")
    assert [part.topic for part in drive.parts] == ["/imu", "/cmd_vel", "go", "trigger"]
    assert (drive.kind.does, planned.answers.sections.keys()) == ("uses several topics and services", {"/**"})


def test_two_parts_are_told_in_a_sentence_and_without_a_sender_there_is_no_timer() -> None:
    python = texts(plan(nodes=(BOTH,)))["my_robot_nav/drive.py"]
    assert '"""A node that listens to Imu and logs it and publishes Twist."""' in python
    assert "            self.hear_imu,\n            qos_profile_sensor_data,\n" in python
    assert "self.timer" in python
    hears = f"ears:{IMU}+subscriber:std_msgs/String+publisher:std_msgs/String"
    assert "from std_msgs.msg import String\n" in texts(plan(nodes=(hears,)))["my_robot_nav/ears.py"]
    deaf = texts(plan(template="ament_cmake", nodes=(hears.rpartition("+")[0],)))
    assert "timer_" not in deaf["src/ears.cpp"]
    assert "config/params.yaml" not in deaf


def test_it_runs(tmp_path: Path) -> None:
    asked = "sum:service:example_interfaces/AddTwoInts@/sum+publisher:std_msgs/String@/said"
    node = Running(plan(nodes=(asked,)), tmp_path, {"rate": 50.0})
    assert node.until("response")[0]["data"] == {"sum": 0}
    assert node.until("publish", 2)[0]["topic"] == "/said"
    node.stop(signal.SIGTERM)


def test_it_can_be_added() -> None:
    files = cmake_package(LOWER)
    for language in ("cpp", "python"):
        draft = added(files, "node", f"{BOTH}:{language}")
        assert new_findings(files, draft) == []
    assert "self.cmd_vel_publisher" in text(draft, "my_pkg/drive.py")


@pytest.mark.parametrize(
    "asked, said",
    [
        ("x1:timer+publisher:std_msgs/String", "each part is a publisher, subscriber, service or client and names"),
        ("x1:action-server:nav2_msgs/Spin+publisher:std_msgs/String", "each part is a publisher"),
        (f"x1:{IMU}+{IMU}", "would have one name in code; name them by @NAME"),
        (f"x1:{IMU}+subscriber:std_msgs/String@imu", "would have one name in code"),
        (f"x1:{IMU}+subscriber:sensor_msgs/Imu@imu", "would have one name in code"),
        (f"x1:{IMU}+subscriber:sensor_msgs/Imu@{'a' * 25}", "has more than 24 characters; shorten it by @NAME"),
        ("x1:publisher:one_msgs/Aa@a1+publisher:two_msgs/Aa@a2", "Python could import only one of them"),
        (f"x1:cpp:{IMU}+python:{TWIST}", "a node has one language"),
        (f"x1:{IMU}+nothing:std_msgs/String", "there is no kind of node `nothing`"),
    ],
)
def test_what_can_not_be_is_refused(asked: str, said: str) -> None:
    with pytest.raises(ScaffoldError, match=said):
        plan(template="mixed", nodes=(asked, "b1:empty:python"))
