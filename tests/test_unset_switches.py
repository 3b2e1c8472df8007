"""A look-up behind a parameter or a constant that is off by default, and that nothing sets, is an info (DEP116)."""

from __future__ import annotations

import pytest

from rospkg_cli.example import CMAKE, manifest, scripts, setup_py
from rospkg_cli.testing import lint_files

NODE = "add_executable(node src/node.cpp)\ninstall(TARGETS node DESTINATION lib/${PROJECT_NAME})\nament_package"
CPP = """\
#include <rclcpp/rclcpp.hpp>
#include <ament_index_cpp/get_package_share_directory.hpp>
{top}
int main(int argc, char ** argv)
{{
  rclcpp::init(argc, argv);
  auto node = std::make_shared<rclcpp::Node>("node");
  {given}
  {condition} {{
    load(ament_index_cpp::get_package_share_directory("nav2_bringup"));
  }}
}}
"""
GIVEN = 'bool extra = node->declare_parameter<bool>("use_extra", false);'
IF = "if (extra)"
OFF = "; it runs only where the parameter `use_extra` is on, which it is not by default, and nothing here sets it"


def told(files: dict[str, str]) -> tuple[str, str]:
    (only,) = lint_files(files, ["DEP116"]).findings
    return only.severity.value, only.message.partition("; ")[2].partition("; ")[2]


def in_cpp(given: str, condition: str, top: str = "", **others: str) -> str:
    files = {
        "package.xml": manifest("  <depend>rclcpp</depend>\n  <depend>ament_index_cpp</depend>\n", "ament_cmake"),
        "CMakeLists.txt": CMAKE.replace("ament_package", NODE),
        "src/node.cpp": CPP.format(given=given, condition=condition, top=top),
        **{name.replace("__", "/"): text for name, text in others.items()},
    }
    return told(files)[0]


@pytest.mark.parametrize(
    "given, condition, level",
    [
        (GIVEN, IF, "info"),
        (GIVEN, "if (argc > 2 && extra)", "info"),
        (GIVEN, "if (extra == true)", "info"),
        (GIVEN, "if (argc > 2)", "warning"),
        (GIVEN, "if (argc > 2 || extra)", "warning"),
        (GIVEN, "if (!extra)", "warning"),
        (GIVEN, "if (extra == false)", "warning"),
        (GIVEN, "if (extra) {} else", "warning"),
        (GIVEN.replace("false", "true"), IF, "warning"),
        (GIVEN.replace("false", "true"), "if (!extra)", "info"),
        (f"{GIVEN} extra = argc > 2;", IF, "warning"),
        (f"{GIVEN} ask(&extra);", IF, "warning"),
        ('bool extra = true; node->declare_parameter("use_extra", false); node->get_parameter("use_extra", extra);', IF,
         "info"),
        ('bool extra; extra = get_param("use_extra", 0);', "if (extra)", "info"),
        ('bool extra; node->get_parameter_or("use_extra", extra, false);', IF, "info"),
        ('node->declare_parameter("use_extra", rclcpp::ParameterValue(false));'
         ' bool extra = node->get_parameter("use_extra").as_bool();', IF, "info"),
        ('bool extra = node->get_parameter("use_extra").as_bool();', IF, "warning"),
        ('std::string extra = node->declare_parameter("use_extra", "");', "if (!extra.empty())", "warning"),
        ("const bool extra = false;", IF, "info"),
        (GIVEN.replace("bool extra", "bool use_extra"), "if (use_extra)", "info"),
        ('node->declare_parameter("extra", false); bool extra; node->get_parameter("extra", extra);', IF, "info"),
        ("bool extra = false; for (int i = 0; i < argc; ++i) extra |= argv[i][0] == 'e';", IF, "warning"),
        ("bool extra = argc > 2;", IF, "warning"),
    ],
)  # fmt: skip
def test_a_condition_of_cpp(given: str, condition: str, level: str) -> None:
    assert in_cpp(given, condition) == level


@pytest.mark.parametrize(
    "others, level",
    [
        ({"config__a.yaml": "node:\n  ros__parameters:\n    use_extra: true\n"}, "warning"),
        ({"config__a.yaml": "node:\n  ros__parameters:\n    use_extra: false\n"}, "info"),
        ({"config__a.yaml": "node:\n  ros__parameters:\n    use_extra_map: true\n"}, "info"),
        ({"README.md": "Set `use_extra` to show more.\n"}, "warning"),
        ({"start.sh": "ros2 run my_pkg node --ros-args -p use_extra:=true\n"}, "warning"),
        ({"launch__a.launch.py": "PARAMETERS = [{'use_extra': True}]\n"}, "warning"),
        ({"launch__a.launch.py": "PARAMETERS = [{'use_extra': False}]\n"}, "info"),
        ({"launch__a.launch.xml": '<launch><param name="use_extra" value="true"/></launch>'}, "warning"),
        ({"launch__a.launch.xml": '<launch><param name="use_extra" value="false"/></launch>'}, "info"),
    ],
)
def test_what_sets_a_parameter(others: dict[str, str], level: str) -> None:
    assert in_cpp(GIVEN, IF, **others) == level


PYTHON = """\
from ament_index_python.packages import get_package_share_directory
from rclpy.node import Node


class Talker(Node):
    def __init__(self):
        super().__init__('talker')
        {}
        if {}:
            print(get_package_share_directory('nav2_bringup'))


def main():
    Talker()
"""
DECLARED = "self.declare_parameter('use_extra', False)"
KEPT = f"{DECLARED}; self.extra = self.get_parameter('use_extra').value"


@pytest.mark.parametrize(
    "given, condition, level",
    [
        (KEPT, "self.extra", "info"),
        (KEPT, "self.extra and self.count_subscribers('a')", "info"),
        (KEPT, "self.extra or self.count_subscribers('a')", "warning"),
        (KEPT, "not self.extra", "warning"),
        (KEPT, "self.count_subscribers('a')", "warning"),
        (KEPT.replace("False", "True"), "self.extra", "warning"),
        (KEPT.replace("False", "True"), "not self.extra", "info"),
        (f"{KEPT}; self.extra = input()", "self.extra", "warning"),
        (KEPT.replace(".value", ".get_parameter_value().bool_value"), "self.extra", "info"),
        (f"{DECLARED}; extra = bool(self.get_parameter('use_extra').value)", "extra", "info"),
        (DECLARED, "self.get_parameter('use_extra').value", "info"),
        ("extra = self.declare_parameter('use_extra', False).value", "extra", "info"),
        ("extra = self.get_parameter('use_extra').value", "extra", "warning"),
    ],
)
def test_a_condition_of_python(given: str, condition: str, level: str) -> None:
    files = {
        "package.xml": manifest("  <depend>rclpy</depend>\n  <depend>ament_index_python</depend>\n"),
        "setup.py": setup_py(scripts("talker = my_pkg.talker:main")),
        "my_pkg/__init__.py": "",
        "my_pkg/talker.py": PYTHON.format(given, condition),
    }
    said = told(files)
    assert said[0] == level
    assert level == "warning" or said[1] == OFF[2:].replace(" on,", " off," if "not" in condition else " on,")


@pytest.mark.parametrize("code, name", [("DEP112", "my_pgk"), ("DEP113", "my_pkg")])
@pytest.mark.parametrize("default, level", [("False", "info"), ("True", "warning")])
def test_other_look_ups_of_python(code: str, name: str, default: str, level: str) -> None:
    look_up = f"open(get_package_share_directory('{name}') + '/people.csv')"
    text = PYTHON.format(KEPT.replace("False", default), "self.extra")
    files = {
        "package.xml": manifest("  <depend>rclpy</depend>\n  <depend>ament_index_python</depend>\n"),
        "setup.py": setup_py(scripts("talker = my_pkg.talker:main")),
        "people.csv": "",
        "my_pkg/__init__.py": "",
        "my_pkg/talker.py": text.replace("get_package_share_directory('nav2_bringup')", look_up),
    }
    assert [each.severity.value for each in lint_files(files, [code]).findings] == [level]
