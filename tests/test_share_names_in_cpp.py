"""DEP112: C++ that catches, branches before, or never calls what looks for a misspelt package."""

from __future__ import annotations

import pytest

from rospkg_cli.example import CMAKE, manifest
from rospkg_cli.testing import lint_files

LINES = """\
find_package(ament_index_cpp REQUIRED)
add_executable(talker src/talker.cpp)
target_link_libraries(talker ament_index_cpp::ament_index_cpp)
install(TARGETS talker DESTINATION lib/${PROJECT_NAME})
"""
LOOK = 'get_package_share_directory("my_pgk")'
NODE = """\
class Talker : public rclcpp::Node
{
  Talker() { CALL }
  void look() { %s; }
};
int main() { Talker talker; }
"""


def levels(source: str) -> list[str]:
    files = {
        "CMakeLists.txt": CMAKE.replace("ament_package", LINES + "ament_package"),
        "package.xml": manifest("  <depend>ament_index_cpp</depend>\n", "ament_cmake"),
        "src/talker.cpp": f"{source}\n",
    }
    return [each.severity.value for each in lint_files(files, ["DEP112"]).findings]


@pytest.mark.parametrize(
    ("source", "expected"),
    [
        (f"int main() {{ {LOOK}; }}", ["error"]),
        (f"auto share = {LOOK};\nint main() {{}}", ["error"]),
        (f"int main(int n, char **) {{ if (n > 1) {{ {LOOK}; }} }}", ["warning"]),
        (f"int main() {{ try {{ {LOOK}; }} catch (const std::exception & e) {{}} }}", []),
        (f"int main() {{ try {{ if (true) {{ {LOOK}; }} }} catch (...) {{}} }}", []),
        (f"int main() {{ try {{ {LOOK}; }} catch (const std::bad_alloc & e) {{}} }}", ["error"]),
        (f"int main() {{ try {{}} catch (...) {{}} {LOOK}; }}", ["error"]),
        (NODE.replace("CALL", "look();") % LOOK, ["error"]),
        (NODE.replace("CALL", "") % LOOK, ["info"]),
    ],
)
def test_who_meets_a_look_up(source: str, expected: list[str]) -> None:
    assert levels(source) == expected
