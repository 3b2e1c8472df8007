"""PRM007: parameters that a node gets, and whose names stand nowhere else in the code."""

from __future__ import annotations

import pytest

from rospkg_cli.example import BACKDROPS, CMAKE, existing_files, manifest
from rospkg_cli.finding import Finding
from rospkg_cli.testing import lint_files

BUILD = CMAKE.replace("ament_package", "add_library(talker src/talker.cpp)\nament_package")
CPP = """\
#include <rclcpp/rclcpp.hpp>
class Talker : public rclcpp::Node
{{
  Talker(const rclcpp::NodeOptions & options) : rclcpp::Node("talker", options)
  {{
    {}
  }}
}};
"""
PYTHON = """\
from rclpy.node import Node


class Talker({}):
    def __init__(self):
        super().__init__('talker'{})
        {}


def main():
    Talker()
"""
LOST = "nothing declares the parameter `model`: "
NEVER = f"{LOST}the variable is never set; declare it"
STOPS = f"{LOST}the node stops with ParameterNotDeclaredException; declare it"
GET = 'get_parameter("model", model);'
GETS = "self.model = self.get_parameter('model').value"


def linted(files: dict[str, str]) -> list[tuple[str, str]]:
    found: tuple[Finding, ...] = lint_files(
        {f"src/my_pkg/{k}".replace("my_pkg/../", ""): v for k, v in files.items()}, ["PRM007"]
    ).findings
    return [(each.severity.value, each.message) for each in found]


@pytest.mark.parametrize(
    "code, others, found",
    [
        (GET, {}, [("warning", NEVER)]),
        (f"{GET} {GET}", {}, [("warning", NEVER)]),
        ('auto model = get_parameter("model");', {}, [("warning", STOPS)]),
        ('try { get_parameter("model"); } catch (...) {}', {}, [("warning", NEVER)]),
        ('get_parameter_or("model", model, 1);', {}, []),
        ('get_parameter("robot_description", model);', {}, []),
        ('get_parameter("use_sim_time", model);', {}, []),
        (f'{GET} declare_parameter("model", 1);', {}, []),
        (f"{GET} declare_parameter(name, 1);", {}, []),
        (f'{GET} has_parameter("model");', {}, []),
        (f'{GET} load("model");', {}, []),
        (f"{GET} declareAll(this);", {}, []),
        (f"{GET} ParamListener listener(this);", {}, []),
        (
            f'{GET} get_parameter("size", size);',
            {},
            [
                (
                    "warning",
                    "nothing declares the parameters `model` and `size`: the variables are never set; declare them",
                )
            ],
        ),
        (GET, {"src/main.cpp": "options.allow_undeclared_parameters(true);"}, []),
        (GET, {"src/main.cpp": 'node->declare_parameter("model", 1);'}, []),
        (GET, {"src/main.cpp": 'const char * MODEL = "model";'}, []),
        ('helper.get_parameter("model", model); ParametersClient client;', {}, []),
    ],
)
def test_a_name_that_cpp_gets_alone(code: str, others: dict[str, str], found: list[tuple[str, str]]) -> None:
    files = {"package.xml": manifest("", "ament_cmake"), "CMakeLists.txt": BUILD, "src/talker.cpp": CPP.format(code)}
    assert linted({**files, **others}) == found


@pytest.mark.parametrize(
    "options, tag, found",
    [
        ('"talker", options', "exec_depend", [("warning", NEVER)]),
        ('"talker", options', "depend", []),
        ('"talker"', "depend", [("warning", NEVER)]),
        ('"talker", ""', "build_depend", [("warning", NEVER)]),
        ('"talker", rclcpp::NodeOptions()', "build_depend", []),
        ("name", "depend", []),
    ],
)
def test_who_builds_on_a_node_may_choose_its_options(options: str, tag: str, found: list[tuple[str, str]]) -> None:
    text = CPP.format(GET).replace('"talker", options', options)
    files = {"package.xml": manifest("", "ament_cmake"), "CMakeLists.txt": BUILD, "src/talker.cpp": text}
    other = manifest(f"  <{tag}>my_pkg</{tag}>\n", "ament_cmake").replace("<name>my_pkg", "<name>other_pkg")
    program = "add_executable(run main.cpp)\ninstall(TARGETS run DESTINATION lib/other_pkg)\nament_package"
    bare = CMAKE.replace("my_pkg", "other_pkg")
    built = {
        "CMakeLists.txt": bare.replace("ament_package", program),
        "main.cpp": "int main() {}",
        "package.xml": other,
    }
    others = {f"../other_pkg/{name}": text for name, text in built.items()}
    assert linted({**files, **others}) == found
    assert linted({**files, **others, "../other_pkg/CMakeLists.txt": bare}) == [("warning", NEVER)]


def test_many_names_are_counted() -> None:
    reads = " ".join(f'get_parameter("model_{number}", model);' for number in range(5))
    files = {"package.xml": manifest("", "ament_cmake"), "CMakeLists.txt": BUILD, "src/talker.cpp": CPP.format(reads)}
    ((_, message),) = linted(files)
    assert message.startswith("nothing declares the parameters `model_0`, `model_1`, `model_2` and 2 more: the")


def test_a_class_that_is_no_node_may_get_anything() -> None:
    text = CPP.format(GET).replace('rclcpp::Node("talker", options)', "Other(options)")
    files = {"package.xml": manifest("", "ament_cmake"), "CMakeLists.txt": BUILD, "src/talker.cpp": text}
    assert linted(files) == []


@pytest.mark.parametrize(
    "code, base, options, found",
    [
        (GETS, "Node", "", [("warning", STOPS)]),
        (f"{GETS}\n        {GETS}", "Node", "", [("warning", STOPS)]),
        (f"try:\n            {GETS}\n        except Exception:\n            pass", "Node", "", [("info", "")]),
        ("self.get_parameter_or('model', 1)", "Node", "", []),
        ("self.client.get_parameter('model')", "Node", "", []),
        ("self.get_parameter('robot_description')", "Node", "", []),
        (GETS, "Other", "", []),
        (GETS, "Node, Other", "", []),
        (GETS, "Node", ", allow_undeclared_parameters=True", []),
        (f"self.declare_parameter('model', 1)\n        {GETS}", "Node", "", []),
        (f"self.declare_parameters('', [('model', 1)])\n        {GETS}", "Node", "", []),
        (f"self.declare_parameter(name, 1)\n        {GETS}", "Node", "", []),
        (f"declare(self, 'model')\n        {GETS}", "Node", "", []),
    ],
)
def test_a_name_that_python_gets_alone(code: str, base: str, options: str, found: list[tuple[str, str]]) -> None:
    files = {**existing_files(BACKDROPS["ament_python"]), "my_pkg/talker.py": PYTHON.format(base, options, code)}
    said = linted({name: text for name, text in files.items() if isinstance(text, str)})
    assert [level for level, _ in said] == [level for level, _ in found]
    assert all(text.startswith(LOST) for _, text in said)


@pytest.mark.parametrize(
    "line, base, count",
    [
        ("from other.node import Node", "Node", 0),
        ("from rclpy.node import Node as RosNode\nfrom other.node import Node", "Node", 0),
        ("import rclpy\n\n\nclass Node:\n    pass", "Node", 0),
        ("from rclpy.node import Node as RosNode", "RosNode", 1),
        ("from rclpy import node", "node.Node", 1),
    ],
)
def test_a_node_is_what_comes_from_rclpy(line: str, base: str, count: int) -> None:
    text = PYTHON.format(base, "", GETS).replace("from rclpy.node import Node", f"import rclpy\n{line}")
    files = {**existing_files(BACKDROPS["ament_python"]), "my_pkg/talker.py": text}
    assert len(linted({name: text for name, text in files.items() if isinstance(text, str)})) == count
