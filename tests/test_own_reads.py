"""Whose parameters code gets: a client, another object or a base class elsewhere has what code does not declare."""

from __future__ import annotations

import pytest

from rospkg_cli.example import CMAKE, manifest
from rospkg_cli.testing import lint_files

BUILD = CMAKE.replace(
    "ament_package",
    "add_executable(talker src/talker.cpp)\ninstall(TARGETS talker DESTINATION lib/${PROJECT_NAME})\nament_package",
)
CPP = """\
#include <rclcpp/rclcpp.hpp>
{more}
class Talker : public {base}
{{
public:
  Talker() : {base}("talker")
  {{
    declare_parameter("rate", 1.0);
    {get}
  }}
}};
int main() {{rclcpp::spin(std::make_shared<Talker>());}}
"""
PYTHON = """\
import rclpy
from rclpy.node import Node
from elsewhere import Base, Helper
from my_pkg.made import listener


class Talker({base}):
    def __init__(self):
        super().__init__('talker')
        self.declare_parameter('rates', 1.0)
        {get}


def main():
    rclpy.init()
    rclpy.spin(Talker())
"""
SETUP = """\
from setuptools import setup
setup(name='my_pkg', version='0.0.1', packages=['my_pkg'],
      data_files=[('share/my_pkg', ['package.xml'])],
      entry_points={'console_scripts': ['talker = my_pkg.talker:main']})
"""


def levels(files: dict[str, str]) -> list[str]:
    return [each.severity.value for each in lint_files(files, ["PRM007"]).findings]


def in_cpp(get: str, base: str = "rclcpp::Node", more: str = "") -> list[str]:
    code = CPP.format(get=get, base=base, more=more)
    files = {"package.xml": manifest("  <depend>rclcpp</depend>\n", "ament_cmake"), "CMakeLists.txt": BUILD}
    return levels(files | {"src/talker.cpp": code})


def in_python(get: str, base: str = "Node") -> list[str]:
    files = {"package.xml": manifest("  <exec_depend>rclpy</exec_depend>\n", "ament_python"), "setup.py": SETUP}
    return levels(files | {"my_pkg/__init__.py": "", "my_pkg/talker.py": PYTHON.format(get=get, base=base)})


@pytest.mark.parametrize(
    ("get", "expected"),
    [
        ('x_ = get_parameter("rates").as_double();', ["error"]),
        ('x_ = this->get_parameter("rates").as_double();', ["error"]),
        ('x_ = node_->get_parameter("rates").as_double();', ["error"]),
        ('x_ = node_.lock()->get_parameter("rates").as_double();', ["error"]),
        ('x_ = client_->get_parameter<double>("rates");', []),
        ('x_ = node_client_->get_parameter<double>("rates", 1.0);', []),
        ('x_ = camera_.get_parameter("rates").as_double();', []),
        ('x_ = camera_.get_parameter("rates").as_double(); camera_.declare_parameter("size", 1);', ["error"]),
        ('if (has_parameter("rates")) x_ = get_parameter("rates").as_double();', ["info"]),
        ('get_parameter_or("rates", x_, 1.0);', ["warning"]),
    ],
)
def test_cpp_may_ask_another_object(get: str, expected: list[str]) -> None:
    assert in_cpp(get) == expected


@pytest.mark.parametrize(
    ("base", "more", "expected"),
    [
        ("rclcpp_lifecycle::LifecycleNode", "", ["error"]),
        ("drivers::Driver", "", ["info"]),
        ("Driver", "class Driver : public rclcpp::Node {};", ["error"]),
        ("Driver", "class Driver final : public drivers::Driver<int> {};", ["info"]),
    ],
)
def test_a_base_class_elsewhere_may_declare_more(base: str, more: str, expected: list[str]) -> None:
    assert in_cpp('x_ = get_parameter("rates").as_double();', base, more) == expected


@pytest.mark.parametrize(
    ("get", "expected"),
    [
        ('x_ = get_parameter("depth").as_int();', ["warning"]),
        ('x_ = get_parameter("depth").as_int(); y_ = std::make_shared<drivers::Driver>(this);', []),
        ('x_ = get_parameter("depth").as_int(); drivers::Driver driver{shared_from_this()};', []),
        (
            'x_ = get_parameter("depth").as_int(); y_ = std::make_shared<tf2_ros::Listener>(b_, this);',
            ["warning"],
        ),
        ('x_ = get_parameter("depth").as_int(); y_ = std::bind(&Talker::on, this, x);', ["warning"]),
        ('x_ = get_parameter("depth").as_int(); y_ = create<std_msgs::msg::Int>("y", [this, x]() {});', ["warning"]),
    ],
)
def test_what_is_handed_a_node_may_declare_more(get: str, expected: list[str]) -> None:
    assert in_cpp(f'y_ = get_parameter("rate").as_double(); {get}') == expected


@pytest.mark.parametrize(
    ("get", "base", "expected"),
    [
        ("self.x = self.get_parameter('rate').value", "Node", ["error"]),
        ("self.x = self.node.get_parameter('rate').value", "Node", ["error"]),
        ("self.x = self.helper.get_parameter('rate').value", "Node", []),
        ("self.x = self.client_node.get_parameter('rate').value", "Node", []),
        ("self.x = self.get_parameter('rate').value", "Base", ["info"]),
        ("self.x = self.get_parameter('rate').value if self.has_parameter('rate') else 1", "Node", ["info"]),
        ("self.x = self.get_parameter('rates').value, self.get_parameter('depth').value", "Node", ["warning"]),
        ("self.x = self.get_parameter('rates').value, self.get_parameter('depth').value, Helper(self)", "Node", []),
        ("self.x = self.get_parameter('rates').value, self.get_parameter('depth').value, listener(self)", "Node", []),
    ],
)
def test_python_may_ask_another_object(get: str, base: str, expected: list[str]) -> None:
    assert in_python(get, base) == expected
