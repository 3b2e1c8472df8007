"""What is added to a manifest of format 1 is of that format: catkin_pkg refuses one with tags of others."""

from __future__ import annotations

import pytest

from rospkg_cli.example import CMAKE, SETUP_PY_FOR_ALL, manifest
from rospkg_cli.testing import lint_files

LAUNCH = "<launch>\n  <node pkg='rviz2' exec='rviz2'/>\n</launch>\n"


@pytest.mark.parametrize(
    "code, files, build_type, expected",
    [
        ("DEP103", {"launch/a.launch.xml": LAUNCH, "setup.py": SETUP_PY_FOR_ALL}, "ament_python",
         "<run_depend>rviz2</run_depend>"),
        ("DEP104", {"CMakeLists.txt": CMAKE.replace("ament_package", "find_package(tf2 REQUIRED)\nament_package")},
         "ament_cmake", "<build_depend>tf2</build_depend> and <run_depend>tf2</run_depend>"),
    ],
)  # fmt: skip
def test_a_dependency_is_declared_in_the_tags_of_the_format(
    code: str, files: dict[str, str], build_type: str, expected: str
) -> None:
    text = manifest(build_type=build_type).replace('<package format="3">', "<package>")
    (finding,) = lint_files({"package.xml": text, **files}, [code]).findings
    assert finding.message.endswith(f"; add {expected}")
    assert finding.fix is not None
    assert finding.fix.title == f"add {expected}"
    added = "".join(getattr(each, "text", "") for each in finding.fix.operations)
    assert all(line in added for line in expected.split(" and "))
