"""Every template with every answer: it renders, parses, and our own linter has nothing to say, pedantic or not."""

from __future__ import annotations

import ast
import configparser
import itertools
import json
import re
import xml.etree.ElementTree as ElementTree
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest
import yaml
from pairwise import pairwise
from planned import ADA, around, plan, texts

from rospkg_cli.package.launch.launch_file import LaunchFile
from rospkg_cli.ros.distros import DISTROS
from rospkg_cli.ros.licenses import LICENSES
from rospkg_cli.scaffold import ScaffoldError
from rospkg_cli.scaffold.answers import Request
from rospkg_cli.scaffold.code_filters import in_order
from rospkg_cli.scaffold.extras import all_extras
from rospkg_cli.scaffold.launch_format import LAUNCH_FORMATS
from rospkg_cli.scaffold.node import known_kind
from rospkg_cli.scaffold.node_kinds import OF, all_kinds, offered_kinds
from rospkg_cli.scaffold.plan import Plan, make_plan
from rospkg_cli.scaffold.template import WORKSPACE, load_template, template_names
from rospkg_cli.scaffold.test_level import TEST_LEVELS
from rospkg_cli.scaffold.workspace import WorkspacePackages


def node_sets(template: str) -> dict[str, tuple[str, ...]]:
    kinds = load_template(template).kinds
    if template == "mixed":
        pairs = itertools.pairwise(kind for kind in (*kinds, kinds[0]) if kind != "component")
        return {
            "default": (),
            "bare": ("adder:service", "nothing:empty:python"),
            "silent": ("idle:empty", "nothing:python:empty"),
            **{kind: (f"a_node:{kind}", f"b_node:{other}:python") for kind, other in pairs},
            "component": ("a_node:component", "b_node:component:cpp", "c_node:lifecycle:python"),
            "all": all_in_both(),
        }
    return {
        "default": (),
        "several": ("talker", "listener_node:subscriber", "node:lifecycle", "a1:timer", "a2:lifecycle"),
        "bare": ("adder:service", "nothing:empty"),
        **{kind: (f"a_node:{kind}",) for kind in kinds},
        "all": tuple(f"n_{kind.replace('-', '_')}:{kind}" for kind in kinds),
    }


def all_in_both() -> tuple[str, ...]:
    """Return every kind in every language that it can be written in."""
    pairs = [
        (kind, language) for kind in all_kinds().values() if not kind.name.endswith(OF) for language in kind.languages
    ]
    return tuple(f"{language}_{kind.name.replace('-', '_')}:{kind.name}:{language}" for kind, language in pairs)


DEPENDS = {"nothing": (), "something": ("sensor_msgs", "python3-numpy", "launch_testing", "geometry_msgs")}
WITH_NODES = [name for name in template_names() if load_template(name).kinds]
FACTORS = {
    "distro": [distro.name for distro in DISTROS],
    "launch": tuple(LAUNCH_FORMATS),
    "params": (True, False),
    "parameters": ("file", "generate"),
    "minimal": (False, True),
    "tests": tuple(TEST_LEVELS),
    "depends": tuple(DEPENDS),
    "extras": ((), tuple(all_extras())),
}
COMBINATIONS = [
    {"template": template, **row}
    for template in WITH_NODES
    for row in pairwise({"nodes": tuple(node_sets(template)), **FACTORS})
]
"""Every two answers meet, in each template."""


@pytest.mark.parametrize("row", COMBINATIONS, ids=lambda row: "-".join(map(str, row.values())))
def test_every_combination_is_written_without_a_finding(row: dict[str, Any]) -> None:
    depends = DEPENDS[row["depends"]]
    if row["minimal"]:  # nothing tests with it there, as `new` says
        depends = tuple(name for name in depends if name != "launch_testing")
    faultless(plan(**{**row, "nodes": node_sets(row["template"])[row["nodes"]], "depends": depends}))


@pytest.mark.parametrize("license", [each.spdx for each in LICENSES])
@pytest.mark.parametrize("template", WITH_NODES)
def test_every_license_is_too(template: str, license: str) -> None:
    faultless(plan(template=template, license=license))


def test_every_two_answers_meet() -> None:
    for template in WITH_NODES:
        rows = [row for row in COMBINATIONS if row["template"] == template]
        kinds = {f"a_node:{kind}" for kind in load_template(template).kinds}
        assert {asked for row in rows for asked in node_sets(template)[row["nodes"]]} >= kinds
        for one, other in itertools.combinations(FACTORS, 2):
            met = {(row[one], row[other]) for row in rows}
            assert met == set(itertools.product(FACTORS[one], FACTORS[other]))


DISTROS_AND_LICENSES = [*((d.name, "MIT-0") for d in DISTROS), *(("jazzy", each.spdx) for each in LICENSES)]
INTERFACES = {
    "default": {},
    "msg": {"msgs": ("RobotStatus:float32 battery_level, string current_task", "Other")},
    "srv": {"srvs": ("Go:geometry_msgs/Pose goal --- bool ok", "Other")},
    "action": {"actions": ("Fly",)},
    "all": {"msgs": ("A:B[] b", "B:std_msgs/Header h"), "srvs": ("A",), "actions": ("A:B goal --- ---",)},
}


@pytest.mark.parametrize("depends", [(), ("nav_msgs", "ament_cmake_pytest")])
@pytest.mark.parametrize("asked", INTERFACES)
@pytest.mark.parametrize("distro, license", DISTROS_AND_LICENSES)
def test_every_package_of_interfaces_is_too(distro: str, license: str, asked: str, depends: tuple[str, ...]) -> None:
    options = {"distro": distro, "license": license, "depends": depends, **INTERFACES[asked]}
    faultless(plan("my_interfaces", template="interfaces", **options))


@pytest.mark.parametrize("depends", DEPENDS.values())
@pytest.mark.parametrize("distro, license", DISTROS_AND_LICENSES)
@pytest.mark.parametrize("name, launch", [("my_robot_description", "py"), ("robot", "xml"), ("my_arm", "yaml")])
def test_every_description_is_too(name: str, launch: str, distro: str, license: str, depends: tuple[str, ...]) -> None:
    options = {"distro": distro, "license": license, "depends": depends, "launch": launch}
    faultless(plan(name, template="description", **options))


@pytest.mark.parametrize(
    "distro, license, tests, depends",
    [
        ("humble", "MIT", "ament", "something"),
        ("jazzy", "LGPL-3.0-only", "ament", "nothing"),
        ("lyrical", "Apache-2.0", "minimal", "something"),
        ("rolling", "Apache-2.0", "none", "nothing"),
    ],
)
def test_every_library_is_too(distro: str, license: str, tests: str, depends: str) -> None:
    asked = {"distro": distro, "license": license, "tests": tests, "depends": DEPENDS[depends]}
    faultless(plan("a" * 60, template="library", **asked))


@pytest.mark.parametrize("form", ["py", "xml", "yaml"])
def test_a_description_shows_the_robot_in_every_form(form: str) -> None:
    planned = plan("my_robot_description", template="description", launch=form)
    read = around(planned).package("my_robot_description").parts(LaunchFile).good
    own, view = sorted(read, key=lambda file: file.path)
    assert [finding.code for finding in planned.findings] == []
    assert [node.package.literal for node in own.nodes] == ["robot_state_publisher"]
    assert [node.package.literal for node in view.nodes] == [
        "joint_state_publisher_gui", "joint_state_publisher", "rviz2",
    ]  # fmt: skip
    assert [each.file.in_share()[1] for each in view.includes] == [f"launch/my_robot_description.launch.{form}"]
    assert (f"<exec_depend>launch_{form}<" in texts(planned)["package.xml"]) == (form != "py")


@pytest.mark.parametrize("template", ["description", "bringup"])
def test_what_is_there_for_its_launch_files_has_some(template: str) -> None:
    with pytest.raises(ScaffoldError, match="py, xml or yaml"):
        plan("my_robot", template=template, launch="none")
    with_config = make_plan(
        Request("my_robot", template=template, **ADA), Path(), {"launch": "none"}, WorkspacePackages()
    )
    assert "launch/my_robot.launch.py" in texts(with_config)
    with pytest.raises(ScaffoldError, match="no launch file; leave --launch out"):
        plan("my_robot", template="interfaces", launch="xml")
    with pytest.raises(ScaffoldError, match=r"no launch files in `xlm` \(did you mean `xml`\?\)"):
        plan(launch="xlm")
    assert make_plan(
        Request("my_robot", template="interfaces", **ADA), Path(), {"launch": "xml"}, WorkspacePackages()
    ).files


def faultless(planned: Plan) -> None:
    assert [(f.code, f.location.path, f.message) for f in planned.findings] == []
    for path, text in texts(planned).items():
        assert text == "" or (text.endswith("\n") and not text.endswith("\n\n")), path
        assert not [line for line in text.splitlines() if line != line.rstrip()], path
        if path.endswith(".py"):
            ast.parse(text, feature_version=(3, 10))
            assert not [line for line in text.splitlines() if len(line) > 99 and "# noqa: E501" not in line], path
        if path.endswith(".yaml"):
            assert yaml.safe_load(text)
        if path.endswith(".json"):
            assert json.loads(text)


@pytest.mark.parametrize("template", template_names())
def test_the_same_answers_give_the_same_bytes(template: str) -> None:
    asked = {"ament_python": {"nodes": ("a1", "b2")}, "mixed": {"nodes": ("a1", "b2:python")}}.get(template, {})
    assert plan(template=template, **asked).files == plan(template=template, **asked).files


def test_the_year_is_the_one_that_was_asked_for() -> None:
    assert "# Copyright 1999 Ada Lovelace\n" in texts(plan(year=1999))["setup.py"]


@pytest.mark.parametrize("name", [*template_names(), WORKSPACE])
def test_every_file_of_a_template_is_written_by_it(name: str) -> None:
    template = load_template(name)
    own = template.folders[0]
    sources = [file.source for file in template.files if not file.source.startswith("_shared/")]
    listed = {source.replace("{{ launch }}", form) + ".j2" for source in sources for form in ("py", "xml", "yaml")}
    assert {path.relative_to(own).as_posix() for path in own.rglob("*") if path.is_file()} == listed


def test_every_file_of_the_templates_ends_in_j2() -> None:
    """Otherwise pip compiles it, git obeys it, or colcon takes it for a package."""
    for name in (*template_names(), WORKSPACE, "_shared"):
        folder = load_template("ament_python").folders[1] / name
        names = {path.name for path in folder.rglob("*") if path.is_file()}
        others = {"kinds.toml", "extras.toml", "plugins.toml"} if name == "_shared" else {"template.toml"}
        assert {n for n in names if not n.endswith(".j2")} == others


def test_dependencies_stand_in_their_tags() -> None:
    manifest = texts(plan(depends=("sensor_msgs", "python3-numpy", "launch_testing_ros", "rclpy")))["package.xml"]
    for key in ("sensor_msgs", "python3-numpy", "rclpy", "launch", "std_msgs"):
        assert manifest.count(f"<exec_depend>{key}</exec_depend>") == 1
    assert manifest.count(">launch_testing_ros<") == manifest.count("<test_depend>launch_testing_ros<") == 1


def test_each_python_node_is_an_executable() -> None:
    files = texts(plan(nodes=("talker", "listener")))
    assert "'talker = my_robot_nav.talker:main',\n" in files["setup.py"]
    assert "'listener = my_robot_nav.listener:main',\n" in files["setup.py"]
    assert "class TalkerNode(Node):" in files["my_robot_nav/talker.py"]
    assert files["launch/my_robot_nav.launch.py"].count("executable=") == 2


def test_executables_go_where_ros2_run_looks() -> None:
    config = configparser.ConfigParser()
    config.read_string(texts(plan())["setup.cfg"])
    assert config["develop"]["script_dir"] == config["install"]["install_scripts"] == "$base/lib/my_robot_nav"


def test_python_has_one_form_for_every_distribution() -> None:
    """`with rclpy.init()` is no form for Humble and Jazzy: there it returns None."""
    written = [texts(plan(distro=distro.name)) for distro in DISTROS]
    assert all(files == written[0] for files in written)


def test_long_names_keep_the_line_length() -> None:
    name = "a_rather_long_name_for_a_package_that_somebody_chose_so_long"
    planned = plan(name, nodes=(name[:-1], "talker"), description="words " * 60)
    assert planned.findings == ()
    for path, text in texts(planned).items():
        if path.endswith(".py"):
            assert not [n for n in text.splitlines() if len(n) > 99 and not n.endswith("  # noqa: E501")], path


def test_a_node_is_named_after_its_package() -> None:
    assert plan("drive").answers.nodes[0].name == "drive_node"
    assert plan("drive_node").answers.nodes[0].name == "drive"
    assert plan("t" * 60).answers.nodes[0].name == "main_node"


def test_parameters_stand_in_one_block_where_all_nodes_have_the_same() -> None:
    same = yaml.safe_load(texts(plan(nodes=("a1", "b1:lifecycle", "c1:empty")))["config/params.yaml"])
    assert same == {"/**": {"ros__parameters": {"text": "Hello", "rate": 1.0}}}
    other = yaml.safe_load(texts(plan(nodes=("a1", "b1:subscriber", "c1:empty")))["config/params.yaml"])
    assert set(other) == {"/**/a1", "/**/b1"}
    assert other["/**/b1"] == {"ros__parameters": {"prefix": "I heard"}}


def test_without_parameters_there_is_no_file_of_them() -> None:
    files = texts(plan(nodes=("adder:service",)))
    assert not [path for path in files if "params" in path or path.startswith("config/")]
    assert "params_file" not in files["launch/my_robot_nav.launch.py"]
    assert "config" not in files["setup.py"]
    assert "yaml" not in files["package.xml"]


def test_parameters_that_nobody_wants_in_a_file_are_still_declared() -> None:
    files = texts(plan(params=False))
    assert "declare_parameter(" in files["my_robot_nav/my_robot_nav_node.py"]
    assert not [path for path in files if "params" in path]
    assert "params_file" not in files["launch/my_robot_nav.launch.py"]
    assert "<exec_depend>rcl_interfaces</exec_depend>" in files["package.xml"]
    assert "src/describe.hpp" in cmake(params=False)


@pytest.mark.parametrize("template", WITH_NODES)
@pytest.mark.parametrize("format, needs", [("xml", {"launch_xml"}), ("yaml", {"launch_yaml"}), ("py", {"launch"})])
def test_a_launch_file_declares_the_frontend_that_reads_it(template: str, format: str, needs: set[str]) -> None:
    files = texts(plan(template=template, launch=format))
    assert f"launch/my_robot_nav.launch.{format}" in files
    declared = set(re.findall(r"<exec_depend>(launch\w*)</exec_depend>", files["package.xml"]))
    assert declared == {"launch_ros", *needs}


@pytest.mark.parametrize("template", WITH_NODES)
def test_without_a_launch_file_nothing_speaks_of_one(template: str) -> None:
    also = ("idle:empty:python",) if template == "mixed" else ()
    planned = plan(template=template, launch="none", nodes=("talker", "lc:lifecycle", *also))
    files = texts(planned)
    assert not [path for path, text in files.items() if "launch" in path or "launch" in text]
    assert planned.commands[-1] == "ros2 run my_robot_nav talker"
    assert "--params-file" in files["README.md"]


def entity(format: str, **asked: Any) -> dict[str, Any]:
    """Return the first node of a launch file as the attributes that its frontend sees."""
    text = texts(plan(launch=format, **asked))[f"launch/my_robot_nav.launch.{format}"]
    if format == "xml":
        found = next(each for each in ElementTree.fromstring(text) if each.tag != "arg")
        return {"action": found.tag, **found.attrib, "param": [dict(each.attrib) for each in found]}
    [(action, attributes)] = next(each for each in yaml.safe_load(text)["launch"] if "arg" not in each).items()
    return {"action": action, **attributes, **({"autostart": "true"} if attributes.get("autostart") else {})}


@pytest.mark.parametrize("asked", ["talker", "adder:service", "lc:lifecycle"])
@pytest.mark.parametrize("distro", ["humble", "lyrical"])
def test_launch_files_in_xml_and_yaml_say_the_same(asked: str, distro: str) -> None:
    assert entity("xml", nodes=(asked,), distro=distro) == entity("yaml", nodes=(asked,), distro=distro)


def test_a_frontend_that_knows_no_lifecycle_leaves_the_node_unconfigured_and_says_so() -> None:
    nodes = ("lc:lifecycle",)
    for distro, action in (("humble", "node"), ("kilted", "node"), ("lyrical", "lifecycle_node")):
        assert entity("xml", nodes=nodes, distro=distro)["action"] == action
        planned = plan(launch="xml", nodes=nodes, distro=distro)
        said = "ros2 lifecycle set /lc configure"
        assert any(said in note for note in planned.notes) == (action == "node")
        assert (said in texts(planned)["README.md"]) == (action == "node")
    assert plan(nodes=nodes, distro="humble").notes == ()


@pytest.mark.parametrize("template", template_names())
def test_linters_come_with_ament_alone(template: str) -> None:
    for tests in TEST_LEVELS:
        planned = plan(template=template, tests=tests)
        tested = re.findall("<test_depend>(.*)</test_depend>", texts(planned)["package.xml"])
        assert any(key.startswith(("ament_copyright", "ament_cmake_copyright")) for key in tested) == (tests == "ament")
        assert tests != "none" or not tested
        assert tests != "none" or not [path for path in texts(planned) if "test" in path]
        assert tests != "none" or "BUILD_TESTING" not in texts(planned).get("CMakeLists.txt", "")
        assert tests != "none" or "colcon test" not in texts(planned)["README.md"]


def test_minimal_tests_need_neither_ros_nor_ament() -> None:
    files = texts(plan(tests="minimal"))
    assert {path for path in files if path.startswith("test/")} == {"test/test_greeting.py", "test/test_params.py"}
    assert "<test_depend>python3-pytest</test_depend>" in files["package.xml"]
    assert "extras_require" in files["setup.py"]
    assert "extras_require" not in texts(plan(tests="none"))["setup.py"]
    lists = cmake(tests="minimal")["CMakeLists.txt"]
    assert "ament_add_gtest(" in lists
    assert "ament_lint_auto" not in lists


@pytest.mark.parametrize("template", WITH_NODES)
@pytest.mark.parametrize("format", ["py", "xml", "yaml"])
def test_a_launch_test_waits_for_every_node_of_the_launch_file(template: str, format: str) -> None:
    also = ("other:empty:python",) if template == "mixed" else ()
    files = texts(plan(template=template, launch=format, nodes=("talker", "lc:lifecycle", *also), distro="jazzy"))
    test = files["test/test_launch.py"]
    assert f"'my_robot_nav.launch.{format}'" in test
    assert "'[talker]: Hello 1'" in test
    assert ("'[lc]: Hello 1'" if format == "py" else "'[lc]: ready to be configured'") in test
    assert "<test_depend>launch_testing</test_depend>" in files["package.xml"]
    assert ("mark.launch_test" in test) == (template == "ament_python")
    assert ("add_launch_test(test/test_launch.py)\n" in files.get("CMakeLists.txt", "")) == (template != "ament_python")


@pytest.mark.parametrize("template", template_names())
def test_extras_come_with_every_type(template: str) -> None:
    planned = plan(template=template, extras=tuple(all_extras()), distro="jazzy")
    faultless(planned)
    files = texts(planned)
    plain = set(texts(plan(template=template)))
    assert set(files) - plain == {
        ".devcontainer/devcontainer.json", ".github/workflows/ci.yaml", ".pre-commit-config.yaml", "doc/index.md",
    }  # fmt: skip
    workflow = yaml.safe_load(files[".github/workflows/ci.yaml"])
    assert workflow["jobs"]["test"]["strategy"]["matrix"] == {"distro": ["jazzy"]}
    assert workflow["jobs"]["test"]["container"] == "ros:${{ matrix.distro }}-ros-base"
    assert "ros:jazzy-ros-base" in files[".devcontainer/devcontainer.json"]
    hooks = yaml.safe_load(files[".pre-commit-config.yaml"])["repos"][-1]["hooks"]
    assert [hook["id"] for hook in hooks] == ["rospkg-fix"]


def test_a_workflow_below_the_root_of_a_repository_is_mentioned(tmp_path: Path) -> None:
    asked = Request("my_pkg", extras=("ci",), maintainer="Ada", email="ada@example.org")
    assert make_plan(asked, tmp_path / "src", {}).notes == ()
    (tmp_path / ".git").mkdir()
    assert f"move `.github` to `{tmp_path}`" in make_plan(asked, tmp_path / "src", {}).notes[0]


def test_unknown_extras_are_refused() -> None:
    with pytest.raises(ScaffoldError, match=r"knows no `precommit` \(did you mean `pre-commit`\?\); known: ci, "):
        plan(extras=("precommit",))


def test_unknown_tests_are_refused() -> None:
    with pytest.raises(ScaffoldError, match=r"no tests `amment` \(did you mean `ament`\?\)"):
        plan(tests="amment")


def test_a_kind_brings_its_dependencies() -> None:
    manifest = texts(plan(nodes=("a1:action-client", "b1:lifecycle")))["package.xml"]
    for key in ("example_interfaces", "lifecycle_msgs", "rcl_interfaces", "std_msgs"):
        assert manifest.count(f"<exec_depend>{key}</exec_depend>") == 1
    assert "std_msgs" not in texts(plan(nodes=("a1:service",)))["package.xml"]


def cmake(**asked: object) -> dict[str, str]:
    return texts(plan(template="ament_cmake", **asked))


def test_each_cpp_node_is_built_and_installed() -> None:
    files = cmake(nodes=("talker", "listener:subscriber", "loaded:component"))
    lists = files["CMakeLists.txt"]
    for name in ("talker", "listener"):
        assert f"add_executable({name} src/{name}.cpp)\n" in lists
    assert "install(TARGETS\n  talker\n  listener\n  DESTINATION lib/${PROJECT_NAME})\n" in lists
    assert "add_library(loaded_component SHARED src/loaded.cpp)\n" in lists
    assert "loaded_component PROPERTIES OUTPUT_NAME ${PROJECT_NAME}_loaded)\n" in lists  # lib/ is everybody's
    assert 'PLUGIN "my_robot_nav::LoadedNode"\n  EXECUTABLE loaded)\n' in lists
    assert "ament_target_dependencies" not in lists


def test_an_action_server_survives_a_stop_with_a_goal_at_work() -> None:
    files = cmake(nodes=("worker:action-server", "talker"))
    guard = "} catch (const rclcpp::exceptions::RCLError &) {\n    if (rclcpp::ok()) {\n      throw;"
    assert guard in files["src/worker.cpp"]
    assert "catch" not in files["src/talker.cpp"]


def test_a_launch_file_in_python_hands_the_log_level_to_ros() -> None:
    assert "ros_arguments=['--log-level', " in texts(plan())["launch/my_robot_nav.launch.py"]


def test_cpp_is_of_its_distributions_standard() -> None:
    for distro, standard in (("humble", 17), ("jazzy", 17), ("kilted", 17), ("lyrical", 20), ("rolling", 20)):
        assert f"INTERFACE cxx_std_{standard})" in cmake(distro=distro)["CMakeLists.txt"]
        assert f"PRIVATE cxx_std_{standard})" in cmake(distro=distro, nodes=("idle:empty",))["CMakeLists.txt"]


def test_what_cpp_nodes_use_is_declared_found_and_linked() -> None:
    files = cmake(nodes=("a1:action-client", "b1:lifecycle"))
    for package in ("example_interfaces", "rcl_interfaces", "rclcpp", "rclcpp_action", "rclcpp_lifecycle", "std_msgs"):
        assert files["package.xml"].count(f"<depend>{package}</depend>") == 1
        assert files["CMakeLists.txt"].count(f"find_package({package} REQUIRED)\n") == 1
    assert "  rclcpp_lifecycle::rclcpp_lifecycle\n" in files["CMakeLists.txt"]
    assert "  ${example_interfaces_TARGETS}\n" in files["CMakeLists.txt"]
    assert "<exec_depend>lifecycle_msgs</exec_depend>" in files["package.xml"]


def test_a_rosdep_key_is_declared_and_not_looked_for() -> None:
    """What CMake calls it, nobody can tell from the key."""
    files = cmake(depends=("eigen", "nav_msgs"))
    assert "<depend>eigen</depend>" in files["package.xml"]
    assert "eigen" not in files["CMakeLists.txt"]
    assert "find_package(nav_msgs REQUIRED)\n" in files["CMakeLists.txt"]


@pytest.mark.parametrize("template", WITH_NODES)
def test_the_parameters_of_the_file_are_those_of_the_sources(template: str) -> None:
    for kind in load_template(template).kinds:
        other = ("idle:empty:python",) if template == "mixed" else ()
        files = texts(plan(template=template, nodes=(f"a_node:{kind}", *other)))
        source = files.get("src/a_node.cpp") or files["my_robot_nav/a_node.py"]
        declared = re.findall(r"""declare_parameter(?:<[\w:]+>)?\(\s*["'](\w+)["']""", source)
        written = yaml.safe_load(files.get("config/params.yaml", "{}"))
        assert set(declared) == set(written.get("/**", {}).get("ros__parameters", {}))


def test_every_kind_is_one_of_a_template() -> None:
    offered = {kind for name in template_names() for kind in load_template(name).kinds}
    assert {kind for kind in all_kinds() if not kind.endswith(OF)} == offered


def mixed(**asked: object) -> dict[str, str]:
    return texts(plan(template="mixed", **asked))


def test_a_mixed_package_installs_what_is_in_python() -> None:
    planned = plan(template="mixed", nodes=("talker", "planner:timer:python"))
    files = texts(planned)
    lists = files["CMakeLists.txt"]
    assert "ament_python_install_package(${PROJECT_NAME})\n" in lists
    assert "install(PROGRAMS\n  scripts/planner\n  DESTINATION lib/${PROJECT_NAME})\n" in lists
    assert files["scripts/planner"].startswith("#!/usr/bin/env python3\n")
    assert [file.path for file in planned.files if file.entry.is_executable] == ["scripts/planner"]
    assert "ament_add_gtest(test_greeting " in lists
    assert "ament_add_pytest_test(test_countdown_py test/test_countdown.py)\n" in lists


def test_what_only_python_uses_is_for_when_a_mixed_package_runs() -> None:
    files = mixed(nodes=("talker", "adder:service:python", "listener:subscriber:python"))
    assert "<exec_depend>example_interfaces</exec_depend>" in files["package.xml"]
    assert "example_interfaces" not in files["CMakeLists.txt"]
    assert files["package.xml"].count(">std_msgs<") == files["package.xml"].count("<depend>std_msgs</depend>") == 1
    assert "<buildtool_depend>ament_cmake_python</buildtool_depend>" in files["package.xml"]


@pytest.mark.parametrize(
    "template, kind, why",
    [
        (
            "ament_python",
            "component",
            "a component can be written only in C++, and `ament_python` has nodes in Python",
        ),
        ("ament_cmake", "tmer", "there is no kind of node `tmer` (did you mean `timer`?); known: publisher, "),
        ("ament_python", "sub", "there is no kind of node `sub` (did you mean `subscriber`?)"),
        ("ament_python", "action", "there is no kind of node `action`; known"),
        ("mixed", "publisher-of", "there is no kind of node `publisher-of`"),
    ],
)
def test_a_kind_is_refused_as_unknown_or_as_not_offered(template: str, kind: str, why: str) -> None:
    with pytest.raises(ScaffoldError) as refused:
        plan(template=template, nodes=(f"a_node:{kind}",))
    assert why in str(refused.value)


def test_a_template_of_ones_own_may_offer_some_kinds() -> None:
    template = replace(load_template("ament_python"), kinds=("timer",))
    with pytest.raises(ScaffoldError, match="`ament_python` offers no publisher; it offers: timer"):
        known_kind("publisher", template)


def test_all_kinds_of_the_languages_are_offered() -> None:
    assert "component" not in load_template("ament_python").kinds
    assert load_template("ament_cmake").kinds == load_template("mixed").kinds == offered_kinds()
    assert load_template("interfaces").kinds == ()


def test_imports_of_one_module_are_put_together() -> None:
    lines = "from b import d\nimport rclpy\nfrom a import z, Y\n\nfrom b import C, d\n"
    assert in_order(lines) == "from a import z, Y\nfrom b import C, d\nimport rclpy\n"
