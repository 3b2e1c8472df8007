"""Values under a name that nothing declares, and that code may read all the same (PRM007)."""

from __future__ import annotations

import pytest

from rospkg_cli.example import CMAKE, manifest
from rospkg_cli.testing import lint_files

CODE = """\
#include <rclcpp/rclcpp.hpp>
class Talker : public rclcpp::Node
{
public:
  Talker() : Node("talker")
  {
    max_ = declare_parameter("max_speed", 1.0);
    min_ = declare_parameter("min_speed", 1.0);
    rate_ = declare_parameter("rate", 1);
    MORE
  }
};
int main() {rclcpp::spin(std::make_shared<Talker>());}
"""
LAUNCH = (
    '<launch><node pkg="my_pkg" exec="talker" name="talker"><param from="$(find-pkg-share my_pkg)/config/a.yaml"/>'
    "</node></launch>\n"
)
BUILD = CMAKE.replace(
    "ament_package",
    "add_executable(talker src/talker.cpp)\ninstall(TARGETS talker DESTINATION lib/${PROJECT_NAME})\n"
    "install(DIRECTORY launch config DESTINATION share/${PROJECT_NAME})\nament_package",
)


def found(more: str = "", name: str = "max_sped", launch: str = LAUNCH) -> list[str]:
    values = f"talker:\n  ros__parameters:\n    {name}: 2.0\n    min_speed: 3.0\n    rate: 5\n"
    every = {
        "package.xml": manifest("  <depend>rclcpp</depend>\n", "ament_cmake"),
        "CMakeLists.txt": BUILD,
        "src/talker.cpp": CODE.replace("MORE", more),
        "launch/a.launch.xml": launch,
        "config/a.yaml": values if launch == LAUNCH else "a: 1\n",
    }
    return [f"{each.severity.value}: {each.message}" for each in lint_files(every, ["PRM007"]).findings]


def test_nothing_reads_it() -> None:
    (message,) = found()
    assert message.startswith("warning: `my_pkg` declares no parameter `max_sped`: the value is dropped; did you mean")


@pytest.mark.parametrize(
    "more",
    [
        "declare_parameter(NAME, 1.0);",
        'for (auto each : {"max_sped"}) add(each);',
        "DECLARE(max_sped);",
        "for (auto & each : get_node_parameters_interface()->get_parameter_overrides()) use(each);",
        'for (auto & each : list_parameters({"joints"}, 2).names) use(each);',
        "options.allow_undeclared_parameters(true);",
        "driver_ = std::make_shared<drivers::Driver>(this);",
    ],
)
def test_code_may_read_it_otherwise(more: str) -> None:
    (message,) = found(more)
    assert message.startswith("info: ")
    assert "unless the code here reads it otherwise" in message


def test_another_number_is_another_parameter() -> None:
    assert [each.partition(":")[0] for each in found(name="max_speed2")] == ["info"]


def test_a_base_class_elsewhere_may_read_it() -> None:
    assert [each.partition(":")[0] for each in found("} struct Other : public drivers::DriverNode {")] == ["info"]
    assert [each.partition(":")[0] for each in found("} struct Other : public drivers::Driver {")] == ["warning"]


@pytest.mark.parametrize(("more", "level"), [("", "warning"), ("declare_parameter(NAME, 1.0);", "info")])
def test_a_launch_file_may_give_it(more: str, level: str) -> None:
    launch = (
        '<launch><node pkg="my_pkg" exec="talker"><param name="max_sped" value="2.0"/><param name="rate" value="3"/>'
        '<param name="min_speed" value="3.0"/></node></launch>\n'
    )
    assert [each.partition(":")[0] for each in found(more, launch=launch)] == [level]
