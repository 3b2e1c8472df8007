"""`rospkg inspect`: the install table, printed for people and for programs."""

from __future__ import annotations

import io
import json
from pathlib import Path

import jsonschema
import pytest

from rospkg_cli.cli import UsageError
from rospkg_cli.cli.inspect.run import inspect
from rospkg_cli.example import BACKDROPS, SETUP_PY, manifest, scripts, setup_py
from rospkg_cli.resources import resources

FILES = {
    **{path: text for path, text in BACKDROPS["ament_python"].items() if text is not None},
    "setup.py": "import os\n\n" + setup_py(scripts("talker = my_pkg.talker:main")),
    "my_pkg/talker.py": "def main(): ...\n",
}
TEXT = """\
my_pkg (ament_python, ws/my_pkg)
  executables
    lib/my_pkg/talker  <- my_pkg.talker:main
  share files
    share/ament_index/resource_index/packages/my_pkg  <- resource/my_pkg
    share/my_pkg/package.xml                          <- package.xml
  Python modules
    lib/python3.*/site-packages/my_pkg/__init__.py  <- my_pkg/__init__.py
    lib/python3.*/site-packages/my_pkg/talker.py    <- my_pkg/talker.py
"""


@pytest.fixture
def workspace(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    write(tmp_path / "ws/my_pkg", FILES)
    monkeypatch.chdir(tmp_path)
    return tmp_path / "ws"


def write(folder: Path, files: dict[str, str]) -> None:
    for path, text in files.items():
        (folder / path).parent.mkdir(parents=True, exist_ok=True)
        (folder / path).write_text(text)


def printed(*paths: Path, format: str = "text") -> str:
    stream = io.StringIO()
    assert inspect(paths, format=format, stream=stream) == 0
    return stream.getvalue()


def test_text(workspace: Path) -> None:
    assert printed(workspace) == TEXT


def test_a_file_means_its_package(workspace: Path) -> None:
    assert printed(workspace / "my_pkg/setup.py") == TEXT


def test_json(workspace: Path) -> None:
    (package,) = json.loads(printed(workspace, format="json"))["packages"]
    assert (package["name"], package["path"], package["build_type"]) == ("my_pkg", "ws/my_pkg", "ament_python")
    assert package["unknown"] == []
    (talker,) = [row for row in package["installed"] if row["what"] == "executable"]
    said = talker.pop("said")
    assert talker == {
        "what": "executable",
        "destination": "lib/my_pkg/talker",
        "source": "",
        "entry": "my_pkg.talker:main",
        "certain": True,
        "testing": False,
    }
    line = FILES["setup.py"].splitlines()[said["line"] - 1]
    assert said["path"] == "ws/my_pkg/setup.py"
    assert line[said["column"] - 1 :].startswith("talker = ")


def test_what_is_not_known_is_said_with_its_place(workspace: Path) -> None:
    text = "import os\n\n" + SETUP_PY.replace("['package.xml']", "[os.environ['EXTRA']]")
    write(workspace / "my_pkg", {"setup.py": text})
    shown = printed(workspace)
    assert "  not known\n    share files, executables: `os.environ['EXTRA']` depends on the environment" in shown
    assert f"(setup.py:{text[: text.index('EXTRA')].count(chr(10)) + 1})" in shown


def test_a_broken_setup_py_is_said(workspace: Path) -> None:
    write(workspace / "my_pkg", {"setup.py": "setup(\n"})
    assert "`setup.py` is not valid Python" in printed(workspace)


def test_nothing_to_inspect(tmp_path: Path) -> None:
    with pytest.raises(UsageError, match="no package"):
        inspect([tmp_path])


def test_what_hangs_on_an_unknown_condition_is_there_perhaps(workspace: Path) -> None:
    install = "if(other_FOUND)\n  install(FILES a.yaml DESTINATION share/a_pkg)\nendif()\n"
    text = f"project(a_pkg)\n{install}ament_package()\n"
    files = {"package.xml": manifest(name="a_pkg", build_type="ament_cmake"), "a.yaml": "", "CMakeLists.txt": text}
    write(workspace / "a_pkg", files)
    assert "    share/a_pkg/a.yaml       <- a.yaml (perhaps)\n" in printed(workspace / "a_pkg")
    (package,) = json.loads(printed(workspace / "a_pkg", format="json"))["packages"]
    assert {row["source"]: row["certain"] for row in package["installed"]} == {"package.xml": True, "a.yaml": False}


def test_components_and_what_is_there_with_tests(workspace: Path) -> None:
    lines = [
        "project(a_pkg)",
        "add_library(parts SHARED a.cpp)",
        "rclcpp_components_register_node(parts PLUGIN a::Talker EXECUTABLE talker)",
        "rclcpp_components_register_nodes(parts a::Ear)",
        "if(BUILD_TESTING)",
        "  install(FILES a.yaml DESTINATION share/a_pkg)",
        "endif()",
    ]
    files = {"package.xml": manifest(name="a_pkg", build_type="ament_cmake"), "a.yaml": "", "a.cpp": ""}
    write(workspace / "a_pkg", {**files, "CMakeLists.txt": "\n".join(lines)})
    shown = printed(workspace / "a_pkg")
    assert "    share/a_pkg/a.yaml  <- a.yaml (with tests)\n" in shown
    assert "  components\n    a::Ear     <- parts\n    a::Talker  <- parts, run by talker\n" in shown
    (package,) = json.loads(printed(workspace / "a_pkg", format="json"))["packages"]
    assert package["components"][1] == {
        "name": "a::Talker",
        "target": "parts",
        "executable": "talker",
        "said": {"path": "ws/a_pkg/CMakeLists.txt", "line": 3, "column": lines[2].index("a::Talker") + 1},
    }


LAUNCH = """\
<launch>
  <arg name="rate" default="10"/>
  <arg name="mode"/>
  <node pkg="my_pkg" exec="talker" name="t" if="$(var mode)">
    <param from="$(find-pkg-share my_pkg)/config/talker.yaml"/>
    <param name="rate" value="$(var rate)"/>
    <remap from="chatter" to="/chat"/>
  </node>
  <node_container pkg="rclcpp_components" exec="component_container" name="c" namespace="">
    <composable_node pkg="other" plugin="other::Listener" name="l"/>
  </node_container>
  <include file="$(find-pkg-share other)/launch/other.launch.xml">
    <arg name="rate" value="$(var rate)"/>
  </include>
  <executable cmd="ros2 bag record -a"/>
</launch>
"""
LAUNCHED = """\
  launch files
    launch/a.launch.xml  (rate:=10, mode)
      starts my_pkg talker as t  <- $(find-pkg-share my_pkg)/config/talker.yaml  (perhaps)
      starts rclcpp_components component_container as c
      loads other other::Listener as l
      includes $(find-pkg-share other)/launch/other.launch.xml  (rate:=$(var rate))
      runs ros2 bag record -a
"""


def test_what_launch_files_start(workspace: Path) -> None:
    write(workspace / "my_pkg", {"launch/a.launch.xml": LAUNCH})
    assert LAUNCHED in printed(workspace)


def test_what_launch_files_start_for_programs(workspace: Path) -> None:
    write(workspace / "my_pkg", {"launch/a.launch.xml": LAUNCH, "test/b.launch.xml": LAUNCH})
    data = json.loads(printed(workspace, format="json"))
    schema = json.loads((resources("schemas") / "inspect.schema.json").read_text())
    jsonschema.validate(data, schema, jsonschema.Draft202012Validator)
    (file,) = data["packages"][0]["launch_files"]
    assert file["said"]["path"] == "ws/my_pkg/launch/a.launch.xml"
    talker = file["nodes"][0]
    assert LAUNCH.splitlines()[talker["said"]["line"] - 1][talker["said"]["column"] - 1 :].startswith("node ")
    assert talker["parameter_files"] == ["$(find-pkg-share my_pkg)/config/talker.yaml"]
    assert talker["parameters"] == {"rate": "$(var rate)"}
    assert (talker["remappings"], talker["certain"]) == ([["chatter", "/chat"]], False)
    assert [(each["name"], each["default"]) for each in file["arguments"]] == [("rate", "10"), ("mode", None)]
    assert file["includes"][0]["arguments"] == {"rate": "$(var rate)"}
