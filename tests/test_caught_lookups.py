"""Look-ups of a package that nobody has, where code catches that it is not there (DEP112)."""

from __future__ import annotations

import pytest

from rospkg_cli.example import CMAKE, manifest
from rospkg_cli.testing import lint_files

PYTHON = """\
from ament_index_python.packages import get_package_share_directory


def main():
    try:
        print(get_package_share_directory('{}'))
    except Exception:
        print('none')
"""
CPP = """\
int main()
{{
  try {{
    read(ament_index_cpp::get_package_share_directory("{}"));
  }} catch (const std::exception & error) {{
    log(error.what());
  }}
}}
"""


@pytest.mark.parametrize(
    "name, levels",
    [("robot_brignup", ["info"]), ("robot_bringup", []), ("robot_bringup_2", []), ("robot_bringups", [])],
)
@pytest.mark.parametrize("path, code", [("src/talker.cpp", CPP), ("scripts/talker.py", PYTHON)])
def test_a_slip_of_a_package_that_is_here(path: str, code: str, name: str, levels: list[str]) -> None:
    """Another name may be one of several that are tried; a slip is none, and nothing tells of it at run time."""
    build = f"add_executable(talker {path})" if path.endswith("cpp") else f"install(PROGRAMS {path} DESTINATION lib/a)"
    files = {
        "robot_bringup/package.xml": manifest("", "ament_cmake").replace("my_pkg", "robot_bringup"),
        "robot_bringup/CMakeLists.txt": CMAKE.replace("my_pkg", "robot_bringup"),
        "my_pkg/package.xml": manifest("", "ament_cmake"),
        "my_pkg/CMakeLists.txt": CMAKE.replace("ament_package", f"{build}\nament_package"),
        f"my_pkg/{path}": "#!/usr/bin/env python3\n" * path.endswith("py") + code.format(name),
    }
    found = lint_files(files, ["DEP112"]).findings
    assert [each.severity.value for each in found] == levels
    assert all("the code goes on without it" in each.message for each in found)
