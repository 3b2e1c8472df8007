"""Repositories that jobs and pages fetch may have a package that nobody else knows: by its name it is no slip."""

from __future__ import annotations

import pytest

from rospkg_cli.example import manifest
from rospkg_cli.testing import lint_files

LAUNCH = '<launch>\n  <node pkg="acme_lidar_driver" exec="node"/>\n</launch>\n'
CI = ".github/workflows/ci.yml"


def levels(code: str, files: dict[str, str]) -> list[str]:
    return [each.severity.value for each in lint_files(files, [code]).findings]


@pytest.mark.parametrize(
    ("path", "text", "expected"),
    [
        (CI, "env:\n  UPSTREAM_WORKSPACE: github:acme/acme_lidar_driver#main\n", "info"),
        (CI, "env:\n  UPSTREAM_WORKSPACE: 'github:acme/a#main github:acme/acme_lidar_driver#main'\n", "info"),
        (CI, "env:\n  TARGET_WORKSPACE: . git+https://acme.org/acme_lidar_driver.git#main\n", "info"),
        (CI, "env:\n  UPSTREAM_WORKSPACE: github:acme/something#main\n", "warning"),
        ("setup.sh", "wget https://github.com/acme/acme_lidar_driver/archive/refs/heads/main.zip\n", "info"),
        ("setup.sh", "wget https://github.com/acme/something/archive/refs/heads/main.zip\n", "warning"),
    ],
)
def test_jobs_and_archives(path: str, text: str, expected: str) -> None:
    files = {"my_pkg/package.xml": manifest(""), "my_pkg/launch/a.launch.xml": LAUNCH, path: text}
    assert levels("DEP103", files) == [expected]


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        ("git clone https://github.com/acme/sensor_msg.git\n", "info"),
        ("git clone https://github.com/acme/sensors.git\n", "warning"),
        ("Uses sensor_msg.\n", "warning"),
    ],
)
def test_a_dependency_that_resembles_another_name(text: str, expected: str) -> None:
    needs = manifest("  <exec_depend>sensor_msg</exec_depend>\n")
    assert levels("DEP001", {"my_pkg/package.xml": needs, "README.md": text}) == [expected]


def test_a_launch_file_is_no_slip_of_a_neighbour() -> None:
    files = {"my_pkg/package.xml": manifest(""), "my_pkg/launch/a.launch.xml": LAUNCH}
    files |= {"other/package.xml": manifest("").replace("my_pkg", "acme_lidar_drivers")}
    assert levels("DEP103", files) == ["warning"]
    assert levels("DEP103", {**files, "README.md": "git clone https://x.org/acme/acme_lidar_driver\n"}) == ["info"]
