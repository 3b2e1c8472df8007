"""Packages inside of a package: colcon never builds them, and they hide no module of the outer one."""

from __future__ import annotations

import pytest

from rospkg_cli.example import manifest, scripts, setup_py
from rospkg_cli.finding import Finding
from rospkg_cli.testing import lint_files

FILES = {
    "package.xml": manifest(),
    "setup.py": setup_py(scripts("talker = my_pkg.talker:mian")),
    "resource/my_pkg": "",
    "my_pkg/__init__.py": "",
    "my_pkg/talker.py": "import sensor_msgs\n\n\ndef main():\n    pass\n",
}
INNER = manifest("", "ament_python", "inner")


def lint(codes: list[str], **more: str) -> tuple[Finding, ...]:
    files = {name.replace("__", "/").replace("_DOT_", "."): text for name, text in more.items()}
    return lint_files({**FILES, **files}, codes).findings


def test_a_stray_manifest_hides_no_module() -> None:
    assert {each.code for each in lint(["SET102", "DEP101"])} == {"SET102", "DEP101"}
    assert {each.code for each in lint(["SET102", "DEP101"], my_pkg__package_DOT_xml=INNER)} == {"SET102", "DEP101"}


def test_the_files_of_an_inner_package_are_its_own() -> None:
    files = {"inner__package_DOT_xml": INNER, "inner__a_DOT_py": "import std_msgs\n"}
    assert all("std_msgs" not in each.message for each in lint(["DEP101"], **files))


def test_several_are_one_finding() -> None:
    files = {f"{name}__package_DOT_xml": INNER for name in ("a", "a__b", "c")}
    (finding,) = lint(["WSP005"], **files)
    assert finding.location.path == "a/package.xml"
    assert finding.message.startswith("`a` (and 1 more) is a package inside of `my_pkg`: colcon does not look there")
    (other,) = (where for where, _ in finding.related)
    assert other.path == "c/package.xml"
    assert [(where.line, where.column, where.end_column) for where in (finding.location, other)] == [(1, 1, 1)] * 2


def test_a_manifest_that_can_not_be_read_is_none() -> None:
    unreadable = INNER.encode().replace(b"my", b"\xff") + b"\xff"
    assert lint_files({**FILES, "a/package.xml": unreadable}, ["WSP005"]).findings == ()


@pytest.mark.parametrize(
    "more",
    [
        {"a__COLCON_IGNORE": ""},
        {"a__b__AMENT_IGNORE": ""},
        {"a__CATKIN_IGNORE": ""},
        {"_DOT_gitignore": "a/\n"},
        {"a__b__package_DOT_xml": "<model/>\n"},
        {"package_DOT_xml": manifest("", "catkin")},
        {"setup_DOT_py": setup_py().replace("['package.xml']),", "['package.xml', 'a/b/package.xml']),")},
    ],
)
def test_what_is_not_meant_to_be_built_is_left_alone(more: dict[str, str]) -> None:
    assert lint(["WSP005"], **{"a__b__package_DOT_xml": INNER, **more}) == ()
    assert len(lint(["WSP005"], a__b__package_DOT_xml=INNER)) == 1


@pytest.mark.parametrize("folder", ["test", "templates", "vendor", "fixtures", "resource", "examples/a", "legacy/a"])
def test_folders_of_copies_are_left_alone(folder: str) -> None:
    assert lint_files({**FILES, f"{folder}/package.xml": INNER}, ["WSP005"]).findings == ()


WANTED = {**FILES, "package.xml": manifest("  <depend>inner</depend>\n")}
"""A package that needs the one inside of it."""
ENTRY = "#!/bin/bash\n. /opt/ros/humble/setup.sh && cd ~/workspace/inner && colcon build\n"


@pytest.mark.parametrize(
    ("path", "text", "level"),
    [
        (".devcontainer/entrypoint", ENTRY, "info"),
        (".devcontainer/entrypoint", ENTRY.replace("#!/bin/bash", "#!/usr/bin/python3"), "warning"),
        (".devcontainer/entrypoint", ENTRY.replace("/inner", ""), "warning"),
        ("setup.bash", ENTRY, "info"),
        ("scripts/build.bash", "cd ws\ncd inner\ncolcon --log-base log build\n", "info"),
        ("docker/Dockerfile.humble", "WORKDIR /ws/inner\nRUN colcon build\n", "info"),
        ("build.sh", 'cd "$(dirname $0)"/inner && colcon build\n', "info"),
        ("build.sh", "cd $(git rev-parse --show-toplevel)/inner && colcon build\n", "info"),
        ("build.sh", "cd inner\ncd ..\ncolcon build\n", "warning"),
        ("build.sh", "source ~/ws/inner/install/setup.bash\n", "info"),
        ("build.sh", ". ./inner/install/local_setup.sh\n", "info"),
        ("build.sh", "source ~/ws/install/setup.bash\n", "warning"),
        ("build.sh", "source ~/ws/my-inner/install/setup.bash\n", "warning"),
        ("Dockerfile", "COPY ./inner/install/inner/lib/* /opt/ros/humble/lib/\n", "info"),
        (".github/workflows/ci.yml", "path: |\n  install/my_pkg\n  inner/install/inner\n", "info"),
        (".vscode/tasks.json", '{"options": {"cwd": "${workspaceFolder}/inner"}, "command": "colcon build"}\n', "info"),
    ],
)
def test_a_package_that_is_built_on_its_own_is_an_info(path: str, text: str, level: str) -> None:
    found = lint_files({**WANTED, "inner/package.xml": INNER, path: text}, ["WSP005"]).findings
    assert [each.severity.value for each in found] == [level]
