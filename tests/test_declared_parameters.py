"""Parameters that code declares, and parameter files compared with them."""

from __future__ import annotations

import pytest

from rospkg_cli.checks.params.library_definitions import library_faults
from rospkg_cli.example import CMAKE, manifest
from rospkg_cli.languages.cpp.file import read_cpp
from rospkg_cli.languages.python.file import parse_python
from rospkg_cli.languages.yaml.nodes import documents
from rospkg_cli.package.params import cpp_parameter_types
from rospkg_cli.package.params import cpp_parameters as cpp
from rospkg_cli.package.params import python_parameters as python
from rospkg_cli.package.params.declared_parameter import DeclaredParameter
from rospkg_cli.package.params.parameter_library import library
from rospkg_cli.source import Source
from rospkg_cli.testing import lint_files


def in_cpp(text: str, **types: str) -> list[tuple[str, bool, str, bool]]:
    found = cpp.declared_in(read_cpp(Source("src/a.cpp", text)), lambda name: types.get(name, ""))
    return [(each.name, each.tail, each.type, each.required) for each in found]


@pytest.mark.parametrize(
    "text, found",
    [
        ('declare_parameter("a", 1.0);', ("a", False, "double", False)),
        ('this->declare_parameter<double>("a");', ("a", False, "double", True)),
        ('node->declare_parameter<int>("a", 5);', ("a", False, "int", False)),
        ('declare_parameter("a", 5);', ("a", False, "int", False)),
        ('declare_parameter("a", -0.5f);', ("a", False, "double", False)),
        ('declare_parameter("a", 1e-3);', ("a", False, "double", False)),
        ('declare_parameter("a", true);', ("a", False, "bool", False)),
        ('declare_parameter("a", "x");', ("a", False, "string", False)),
        ('declare_parameter("a", std::string("x"));', ("a", False, "string", False)),
        ('declare_parameter("a", rclcpp::ParameterValue(1));', ("a", False, "int", False)),
        ('declare_parameter("a", rclcpp::PARAMETER_STRING_ARRAY);', ("a", False, "string[]", False)),
        ('declare_parameter("a", static_cast<float>(1));', ("a", False, "double", False)),
        ('declare_parameter<std::vector<std::string>>("a");', ("a", False, "string[]", True)),
        ('declare_parameter("a", std::vector<double>{1.0, 2.0});', ("a", False, "double[]", False)),
        ('declare_parameter("a", default_rate_);', ("a", False, "double", False)),
        ('declare_parameter("a", unknown());', ("a", False, "", False)),
        ('declare_parameter(name_ + ".a", 1);', (".a", True, "int", False)),
        ('declare_parameter(ns + std::string("a.b"), 1);', ("a.b", True, "int", False)),
        ('nav2_util::declare_parameter_if_not_declared(node, name + ".a", rclcpp::ParameterValue(1.5));',
         (".a", True, "double", False)),
        ('get_or_declare_parameter<double>(*this, "a");', ("a", False, "double", True)),
        ('node->declare_or_get_parameter("a", 0.5);', ("a", False, "double", False)),
        ('declare_parameter<int64_t>("a", 1);', ("a", False, "int", False)),
        ('declare_parameter("a", 1, descriptor, true);', ("a", False, "", False)),
        ('declare_parameter("a", 1, descriptor, false);', ("a", False, "int", False)),
    ],
)  # fmt: skip
def test_declarations_in_cpp(text: str, found: tuple[str, bool, str, bool]) -> None:
    assert in_cpp(f"Talker::Talker() {{ {text} }}", default_rate_="double") == [found]


@pytest.mark.parametrize(
    "text",
    ["declare_parameter(name, 1);", '// declare_parameter("a", 1);', 'declare_parameter(prefix + name, 1);',
     '#if 0\ndeclare_parameter("a", 1);\n#endif'],
)  # fmt: skip
def test_what_declares_nothing_that_can_be_told(text: str) -> None:
    assert in_cpp(text) == []


def test_types_of_variables() -> None:
    texts = [Source("a.hpp", 'double rate_;\nstd::vector<std::string> ids_{"a"};\nint x; double x;\n')]
    assert cpp_parameter_types.variables_of(texts, ["rate_", "ids_", "x", "other"]) == {
        "rate_": "double",
        "ids_": "string[]",
    }


@pytest.mark.parametrize(
    "text, found",
    [
        ("self.declare_parameter('a', 1.0)", [("a", "double")]),
        ("self.declare_parameter('a', value=-1)", [("a", "int")]),
        ("self.declare_parameter('a', True)", [("a", "bool")]),
        ("self.declare_parameter('a', ['x', 'y'])", [("a", "string[]")]),
        ("self.declare_parameter('a', [1, 'y'])", [("a", "")]),
        ("self.declare_parameter('a', rclpy.Parameter.Type.DOUBLE_ARRAY)", [("a", "double[]")]),
        ("self.declare_parameter('a')", [("a", "")]),
        ("self.declare_parameter('a', 1.0, ignore_override=True)", [("a", "")]),
        ("self.declare_parameter('a', 1.0, ignore_override=False)", [("a", "double")]),
        ("self.declare_parameter('a', 1.0, descriptor, True)", [("a", "")]),
        ("self.declare_parameter(name, 1.0)", []),
        ("self.declare_parameters('ns', [('a', 1), ('b', 'x')])", [("ns.a", "int"), ("ns.b", "string")]),
    ],
)
def test_declarations_in_python(text: str, found: list[tuple[str, str]]) -> None:
    assert [(each.name, each.type) for each in python.declared_in(parse_python(Source("a.py", text + "\n")))] == found


def test_a_tail_fits_whatever_stands_before_it() -> None:
    tail = DeclaredParameter(".speed", True, "double", False, "a.cpp")
    assert tail.fits("FollowPath.speed")
    assert not tail.fits("FollowPath.max_speed")
    assert not tail.fits("speeds")


NODE = """\
Talker() : Node("talker")
{
  declare_parameter("rate", 10.0);
  declare_parameter("frame", "map");
  declare_parameter("gains", std::vector<double>{1.0});
  declare_parameter("count", 3);
  declare_parameter("top_speed", 1.0);
}
"""


def package(values: str, node: str = NODE, **others: str) -> dict[str, str]:
    cmake = CMAKE.replace(
        "ament_package",
        "add_library(a src/talker.cpp)\ninstall(DIRECTORY config DESTINATION share/${PROJECT_NAME})\nament_package",
    )
    return {
        "src/my_pkg/package.xml": manifest("", "ament_cmake"),
        "src/my_pkg/CMakeLists.txt": cmake,
        "src/my_pkg/src/talker.cpp": node,
        "src/my_pkg/config/robot.yaml": "talker:\n  ros__parameters:\n"
        + "".join(f"    {v}\n" for v in values.split("; ")),
        **others,
    }


@pytest.mark.parametrize(
    "values, said",
    [
        ("rate: 5.0; frame: odom; count: 5", []),
        ("rate: 5; frame: odom; count: 5", ["PRM006 `rate` is declared as double"]),
        ("rate: 5.0; frame: odom; count: 5.0", ["PRM006 `count` is declared as int"]),
        ("rate: 5.0; frame: 5; count: 5", ["PRM006 `frame` is declared as string"]),
        ("rate: __RATE__; frame: odom; count: COUNT_OF_ALL", []),
        ("rate: 5.0; frame: y; count: 5", ["PRM006 `frame` is declared as string"]),
        ("rate: 5.0; gains: [1, 2]; count: 5", ["PRM006 `gains` is declared as double[]"]),
        ("rate: $(var rate); gains: [1.0]; count: 5", []),
        ("rate: 5.0; freme: odom; count: 5", ["PRM007 `my_pkg` declares no parameter `freme`"]),
        ("rate: 5.0; colour: odom; count: 5", []),
        ("rate: 5.0; speed_top: 2.0; count: 5", ["PRM007 `my_pkg` declares no parameter `speed_top`"]),
        ("rate: 5.0; frame: odom; counts: 5; count: 3", []),
        ("other: 5; things: 6; rate: 5", []),
    ],
)
def test_values_against_declarations(values: str, said: list[str]) -> None:
    found = [f"{f.code} {f.message}" for f in lint_files(package(values), ["PRM006", "PRM007"]).findings]
    assert [text[: len(want)] for text, want in zip(found, said, strict=True)] == said


NEIGHBOUR = {"src/other/package.xml": manifest("", "ament_cmake", "other"), "src/other/src/talker.cpp": NODE}
NEEDS_IT = {"src/my_pkg/package.xml": manifest("  <exec_depend>other</exec_depend>\n", "ament_cmake")}


@pytest.mark.parametrize(
    "values, depends, found",
    [
        ("rate: 5; frame: odom", True, 1),
        ("rate: 5; frame: odom", False, 0),
        ("rate: 5; frame: odom; count: 5", False, 1),
        ("rate: 5; count: 5; type: x; size: 2", True, 0),
        ("rate: 5", True, 0),
    ],
)
def test_a_neighbour_declares_them_where_more_than_names_says_so(values: str, depends: bool, found: int) -> None:
    """`type` and `frame_id` are names of many: two of them are no proof."""
    files = {**package(values, "", **NEIGHBOUR), **(NEEDS_IT if depends else {})}
    findings = lint_files(files, ["PRM006"]).findings
    assert len(findings) == found
    assert all("`rate` is declared as double in `src/talker.cpp`: an int stops" in each.message for each in findings)


@pytest.mark.parametrize("name", ["frames", "frame"])
def test_a_name_is_mended_with_its_type(name: str) -> None:
    node = NODE.replace('"frame", "map"', f'"{name}s", std::vector<std::string>{{}}')
    (finding,) = lint_files(package(f"rate: 5.0; {name}: odom; count: 5", node), ["PRM007"]).findings
    assert finding.fix is not None
    assert [edit.text for edit in finding.fix.operations] == [f"{name}s", "[", "]"]  # type: ignore[union-attr]


def test_a_name_for_a_value_of_another_type_has_no_fix() -> None:
    node = NODE.replace('"frame", "map"', '"frames", 3')
    (finding,) = lint_files(package("rate: 5.0; frame: odom; count: 5", node), ["PRM007"]).findings
    assert finding.fix is None


@pytest.mark.parametrize(
    "code, level",
    [
        ('get_parameter("rte");', "error"),
        ('get_parameter("rte", rate_);', "warning"),
        ('get_parameter_or("rte", rate_, 1.0);', "warning"),
        ('try { get_parameter("rte"); } catch (...) {}', "warning"),
        ('if (has_parameter("rte")) { get_parameter("rte"); }', "info"),
        ('options.allow_undeclared_parameters(true); get_parameter("rte");', ""),
        ('options.automatically_declare_parameters_from_overrides(true); get_parameter("rte");', ""),
    ],
)
def test_a_read_that_throws_is_an_error(code: str, level: str) -> None:
    findings = lint_files(package("rate: 5.0", NODE.replace("}\n", f"  {code}\n}}\n")), ["PRM007"]).findings
    assert [each.severity.value for each in findings] == ([level] if level else [])
    ends = "the node stops with ParameterNotDeclaredException" if level == "error" else "the variable is never set"
    ends = "the value that is set for it is never seen" if "_or" in code else ends
    assert all(ends in each.message for each in findings)


def test_declarations_that_differ_say_nothing() -> None:
    other = NODE.replace("10.0", "10")
    files = package("rate: 5; frame: odom", NODE, **{
        **NEIGHBOUR, "src/other/src/talker.cpp": other,
    })  # fmt: skip
    assert not lint_files(files, ["PRM006"]).findings


def test_a_parameter_of_any_type_takes_any_value() -> None:
    node = NODE.replace('declare_parameter("rate"', 'descriptor.dynamic_typing = true;\n  declare_parameter("rate"')
    assert not lint_files(package("rate: 5; frame: odom", node), ["PRM006"]).findings


@pytest.mark.parametrize(
    ("line", "count"),
    [
        ("yaml.safe_load(x)['{}']", 0),
        ("yaml.safe_load(x).get('{}', {{}})", 0),
        ("yaml.safe_load(x)", 1),
        ("a['{}']", 1),
    ],
)
def test_a_block_that_a_launch_file_reads_itself_is_given_to_no_node(line: str, count: int) -> None:
    files = package("rate: 5; frame: odom; count: 5")
    launch = "def generate_launch_description():\n    return " + line.format("talker") + "\n"
    files = {**files, "src/my_pkg/launch/a.launch.py": launch}
    assert len(lint_files(files, ["PRM006"]).findings) == count


@pytest.mark.parametrize("read, count", [("max_height", 0), ("max_rnage", 1)])
def test_parameters_of_a_plugin_may_be_declared_by_its_base_class(read: str, count: int) -> None:
    code = f"""\
#include <nav2_costmap_2d/obstacle_layer.hpp>
void Layer::onInitialize() {{
  ObstacleLayer::onInitialize();
  max_ = node->get_parameter(name_ + ".{read}").as_double();
  node->declare_parameter(name_ + ".max_range", 0.1);
}}
"""
    assert len(lint_files(package("rate: 5.0", code), ["PRM007"]).findings) == count


def test_a_read_that_nobody_declares() -> None:
    node = NODE.replace("}\n", '  get_parameter("rte", rate_);\n  get_parameter("use_sim_time", s_);\n}\n')
    (finding,) = lint_files(package("rate: 5.0", node), ["PRM007"]).findings
    assert "`rte`" in finding.message
    assert "`rate`" in finding.message


def test_definitions_of_a_parameter_library() -> None:
    text = """\
ctrl:
  rate: {type: double, default_value: 5}
  names: {type: string_array}
  gains:
    __map_names:
      p: {type: double, default_value: 1.0}
  note: {type: none}
"""
    source = Source("src/p.yaml", text)
    found = library(source, documents(source), False)
    assert not any(library_faults(found))
    assert [each.keys for each in found.definitions] == [
        ("rate",), ("names",), ("gains", "__map_names", "p"), ("note",),
    ]  # fmt: skip


@pytest.mark.parametrize(
    "fields, said",
    [
        ("{type: double, default_value: 1e-3}", "which is no `double`"),
        ("{type: int, default_value: 1.5}", "which is no `int`"),
        ("{type: bool, default_value: 'true'}", "which is no `bool`"),
        ("{type: string, default_value: 5}", "which is no `string`"),
        ("{type: string, default_value: off}", "which is no `string`"),
        ("{type: int_array, default_value: [1, x]}", "which is no `int`"),
        ("{type: double_array_fixed_3, default_value: 1.0}", "is no list"),
        ("{type: strng}", "no type of a parameter (did you mean `string`?)"),
        ("{default_value: 1}", "has no `type`"),
        ("{type: int, defaultvalue: 1}", "no field of a parameter"),
        ("{type: int, validation: {gt_than<>: [1]}}", "no validator"),
        ("{type: string_fixed_25, default_value: abc}", ""),
        ("{type: int, default_value: ~, validation: {gt<>: [1], my::own: null}}", ""),
        ("{type: string_array, default_value: []}", ""),
    ],
)
def test_faults_of_a_parameter_library(fields: str, said: str) -> None:
    source = Source("src/p.yaml", f"ctrl:\n  a: {fields}\n")
    faults = list(library_faults(library(source, documents(source), False)))
    assert bool(faults) is bool(said), faults
    assert all(said in fault.message for fault in faults)


@pytest.mark.parametrize(
    "path, call",
    [
        ("CMakeLists.txt", "generate_parameter_library(p src/p.yaml)"),
        ("CMakeLists.txt", "Generate_Parameter_Library(p src/p.yaml)"),
        ("cmake/parameters.cmake", "generate_parameter_library(p src/p.yaml)"),
    ],
)
def test_definitions_declare_parameters(path: str, call: str) -> None:
    files = package("rate: 5; names: [a]", "")
    files["src/my_pkg/src/p.yaml"] = "my_pkg:\n  rate: {type: double}\n  names: {type: string_array}\n"
    line = call if path == "CMakeLists.txt" else f"include({path})"
    files["src/my_pkg/CMakeLists.txt"] = CMAKE.replace("ament_package", f"{line}\nament_package")
    if path != "CMakeLists.txt":
        files[f"src/my_pkg/{path}"] = f"{call}\n"
    (finding,) = lint_files(files, ["PRM006", "PRM009"]).findings
    assert (finding.code, "`src/p.yaml`" in finding.message) == ("PRM006", True)
