"""`new --family`: four packages that depend on each other, all of them or none."""

from __future__ import annotations

from pathlib import Path

import pytest
from planned import ADA, texts

from rospkg_cli.cli import UsageError
from rospkg_cli.cli.new.family import new_family
from rospkg_cli.ros.distros import DISTROS
from rospkg_cli.scaffold import ScaffoldError, family
from rospkg_cli.scaffold.answers import Request
from rospkg_cli.scaffold.family import plan_family
from rospkg_cli.scaffold.plan import Plan

MEMBERS = ["my_robot_interfaces", "my_robot_description", "my_robot", "my_robot_bringup"]


def plans(name: str = "my_robot", **asked: object) -> dict[str, Plan]:
    request = Request(name, **{**ADA, **asked})
    return {plan.answers.name: plan for plan in plan_family(request, Path("/nowhere"), {})}


def manifests(**asked: object) -> dict[str, str]:
    return {name: texts(plan)["package.xml"] for name, plan in plans(**asked).items()}


ASKED = [
    {"msgs": ("RobotStatus:float32 battery_level, string current_task",)},
    {"srvs": ("Go",), "nodes": ("planner:timer", "arm:lifecycle"), "launch": "xml"},
    {"actions": ("Fly",), "depends": ("sensor_msgs",), "launch": "none"},
    {"nodes": ("planner:timer",), "tests": "none", "params": False},
    {"msgs": ("A:int32 x", "B:A a"), "launch": "yaml", "tests": "minimal"},
]


@pytest.mark.parametrize("asked", ASKED)
@pytest.mark.parametrize("template", ["ament_python", "ament_cmake"])
def test_each_is_written_without_a_finding(template: str, asked: dict[str, object]) -> None:
    found = plans(template=template, **asked)
    assert list(found) == MEMBERS
    for plan in found.values():
        assert [(f.code, f.location.path, f.message) for f in plan.findings] == []


@pytest.mark.parametrize("distro", [each.name for each in DISTROS])
def test_so_it_is_with_both_languages_on_each_distribution(distro: str) -> None:
    assert [plan.findings for plan in plans(template="mixed", distro=distro).values()] == [()] * 4


def test_they_depend_on_each_other() -> None:
    found = manifests()
    of = {name: {each for each in MEMBERS if f"depend>{each}<" in text} for name, text in found.items()}
    assert of == {
        "my_robot_interfaces": set(),
        "my_robot_description": set(),
        "my_robot": {"my_robot_interfaces"},
        "my_robot_bringup": {"my_robot", "my_robot_description"},
    }


@pytest.mark.parametrize("template, tag", [("ament_python", "exec_depend"), ("ament_cmake", "depend")])
def test_the_interfaces_are_in_the_tag_of_the_build_type(template: str, tag: str) -> None:
    for nodes in ((), ("planner:timer",)):
        manifest = manifests(template=template, nodes=nodes)["my_robot"]
        assert manifest.count(f"<{tag}>my_robot_interfaces</{tag}>") == manifest.count(">my_robot_interfaces<") == 1


def test_the_node_publishes_the_first_message() -> None:
    found = plans(msgs=("RobotStatus:float32 battery_level", "Other:"))
    source = texts(found["my_robot"])["my_robot/my_robot_node.py"]
    assert "from my_robot_interfaces.msg import RobotStatus\n" in source
    assert "        message.battery_level = 0.0\n" in source
    both = texts(plans(template="mixed")["my_robot"])
    assert "from my_robot_interfaces.msg import Status\n" in both["my_robot/listener.py"]


def test_bringup_starts_the_nodes_with_parameters_of_its_own() -> None:
    files = texts(plans()["my_robot_bringup"])
    assert "rate: 1.0" in files["config/my_robot.yaml"]
    assert "'my_robot.launch.py'" in files["launch/my_robot_bringup.launch.py"]
    without = texts(plans(launch="none")["my_robot_bringup"])
    assert "executable='my_robot_node'" in without["launch/my_robot_bringup.launch.py"]


def test_what_was_said_of_the_robot_is_said_of_its_nodes() -> None:
    found = manifests(description="Brings the coffee", license="MIT")
    assert [name for name, text in found.items() if "Brings the coffee" in text] == ["my_robot"]
    assert all("<license>MIT</license>" in text for text in found.values())


REFUSED = {
    ("my_robot_bringup", "ament_python"): "rospkg new my_robot --family",
    ("my_robot", "interfaces"): "not interfaces",
    ("my_robot", "bringup"): "ament_python, ament_cmake or mixed",
    ("x" * 55, "ament_python"): "too long for a family",
    ("Robot", "ament_python"): "try `robot`",
}


@pytest.mark.parametrize("name, template", REFUSED)
def test_what_can_be_no_family_is_refused(name: str, template: str) -> None:
    with pytest.raises(ScaffoldError, match=REFUSED[name, template]):
        plans(name, template=template)


def test_it_is_written_side_by_side(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert new_family(Request("my_robot", **ADA), tmp_path / "src") == 0
    assert {path.name for path in (tmp_path / "src").iterdir()} == set(MEMBERS)
    said = capsys.readouterr()
    assert said.err == ""
    assert said.out.endswith("  ros2 launch my_robot_bringup my_robot_bringup.launch.py\n")


def test_where_one_stands_already_none_is_written(tmp_path: Path) -> None:
    (tmp_path / "my_robot").mkdir()
    with pytest.raises(UsageError, match="my_robot` exists already"):
        new_family(Request("my_robot", **ADA), tmp_path)
    assert [path.name for path in tmp_path.iterdir()] == ["my_robot"]


@pytest.mark.parametrize("fault", [KeyboardInterrupt, OSError])
def test_an_interruption_leaves_none(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, fault: type[BaseException]
) -> None:
    real = family.write_folder

    def sometimes(target: Path, files: object) -> None:
        if target.name == "my_robot":
            raise fault
        real(target, files)

    monkeypatch.setattr(family, "write_folder", sometimes)
    with pytest.raises(fault):
        new_family(Request("my_robot", **ADA), tmp_path / "ws" / "src")
    assert list(tmp_path.iterdir()) == []


def test_a_dry_run_shows_all_and_writes_none(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert new_family(Request("my_robot", **ADA), tmp_path, dry_run=True) == 0
    said = capsys.readouterr().out
    assert all(f"── {name}/package.xml\n" in said for name in MEMBERS)
    assert said.count("Nothing was written.") == 1
    assert list(tmp_path.iterdir()) == []


def test_nobodys_address_is_mentioned_once(tmp_path: Path, monkeypatch: pytest.MonkeyPatch, capsys) -> None:
    monkeypatch.setenv("HOME", str(tmp_path))
    monkeypatch.setenv("GIT_CONFIG_NOSYSTEM", "1")
    monkeypatch.setenv("PATH", "/nowhere")
    monkeypatch.delenv("XDG_CONFIG_HOME", raising=False)
    assert new_family(Request("my_robot", distro="lyrical"), tmp_path / "src") == 0
    assert len(capsys.readouterr().err.splitlines()) == 1
