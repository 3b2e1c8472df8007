"""Plugins: what descriptions say, what sources export, who loads them."""

from __future__ import annotations

from pathlib import Path

import pytest

from rospkg_cli.disk import DiskTree
from rospkg_cli.engine.discovery.locate import locate
from rospkg_cli.engine.run.session import Session
from rospkg_cli.example import manifest
from rospkg_cli.testing import lint_files

HEAD = "cmake_minimum_required(VERSION 3.20)\nproject(my_pkg)\nfind_package(ament_cmake REQUIRED)\n"
LIBRARY = "add_library(planner SHARED src/planner.cpp)\ninstall(TARGETS planner DESTINATION lib)\n"
EXPORT = "pluginlib_export_plugin_description_file(nav2_core plugins.xml)\n"
TAIL = "ament_package()\n"
MACRO = "PLUGINLIB_EXPORT_CLASS(my_pkg::Planner, nav2_core::GlobalPlanner)\n"


def described(*types: str, path: str = "planner", base: str = "nav2_core::GlobalPlanner", name: str = "") -> str:
    classes = "".join(f'  <class {name} type="{each}" base_class_type="{base}"/>\n' for each in types)
    return f'<library path="{path}">\n{classes}</library>\n'


def package(cmake: str = LIBRARY + EXPORT, **files: str) -> dict[str, str]:
    """Return a package with one plugin; `files` by path, with `__` for `/` and `_DOT_` for `.`."""
    named = {path.replace("__", "/").replace("_DOT_", "."): text for path, text in files.items()}
    return {
        "package.xml": manifest("", "ament_cmake"),
        "CMakeLists.txt": HEAD + cmake + TAIL,
        "plugins.xml": described("my_pkg::Planner"),
        "src/planner.cpp": MACRO,
        **named,
    }


def said(files: dict[str, str], code: str) -> list[tuple[str, str]]:
    return [(f.location.path, f.message) for f in lint_files(files, [code]).findings]


def test_both_sides_agree() -> None:
    assert said(package(), "PLG002") == []


@pytest.mark.parametrize(
    "source",
    [
        "// " + MACRO,
        "#if 0\n" + MACRO + "#endif\n",
        "",
        MACRO.replace("Planner,", "Walker,"),
        'const char * s = "PLUGINLIB_EXPORT_CLASS(my_pkg::Planner, nav2_core::GlobalPlanner)";\n',
        'RCLCPP_INFO(logger, "%s", my_pkg::Planner::NAME);\n',
    ],
)
def test_no_source_exports_it(source: str) -> None:
    found = said(package(src__planner_DOT_cpp=source), "PLG002")
    assert [path for path, _ in found] == ["plugins.xml"]
    assert "no source exports `my_pkg::Planner`" in found[0][1]


@pytest.mark.parametrize(
    "source",
    [
        "CLASS_LOADER_REGISTER_CLASS(my_pkg::Planner,\n  nav2_core::GlobalPlanner)\n",
        "#ifdef FAST\n" + MACRO + "#endif\n",
        "MY_PLUGIN_REGISTER(my_pkg::Planner)\n",
        "#define MINE(x) PLUGINLIB_EXPORT_CLASS(x, nav2_core::GlobalPlanner)\nOUR_MACRO(Planner)\n",
    ],
)
def test_it_may_be_exported_otherwise(source: str) -> None:
    assert said(package(src__planner_DOT_cpp=source), "PLG002") == []


@pytest.mark.parametrize(
    "cmake",
    [
        "add_library(planner SHARED ${CMAKE_CURRENT_BINARY_DIR}/made.cpp)\n" + EXPORT,
        "add_library(planner SHARED ../shared/planner.cpp)\n" + EXPORT,
        "add_library(planner SHARED IMPORTED)\nadd_library(${NAME} SHARED src/planner.cpp)\n" + EXPORT,
        "include(FetchContent)\nFetchContent_Declare(planner URL x)\nFetchContent_MakeAvailable(planner)\n" + EXPORT,
    ],
)
def test_sources_that_are_not_seen(cmake: str) -> None:
    files = package(cmake, src__planner_DOT_cpp="")
    if "IMPORTED" in cmake:
        files["plugins.xml"] = described("my_pkg::Planner", path="other")
    assert said(files, "PLG002") == []


def test_a_prebuilt_library() -> None:
    files = package(EXPORT, src__planner_DOT_cpp="", lib__libplanner_DOT_so="")
    assert said(files, "PLG002") == []
    files = package(EXPORT, src__planner_DOT_cpp="", lib__libother_DOT_so="")
    assert len(said(files, "PLG002")) == 1


def test_a_source_in_an_old_encoding_may_export_it() -> None:
    assert said({**package(), "src/planner.cpp": b"// \xe9\n"}, "PLG002") == []  # type: ignore[dict-item]


def test_python_plugins_are_exported_by_no_macro() -> None:
    python = described("my_pkg.my_module.MyPlugin", path="src", base="rqt_gui_py::Plugin")
    assert said(package(plugins_DOT_xml=python, src__planner_DOT_cpp=""), "PLG002") == []


def test_the_class_that_is_meant_is_written() -> None:
    files = package(plugins_DOT_xml=described("my_pgk::Planner", name='name="my_pkg/Planner"'))
    (finding,) = lint_files(files, ["PLG002"]).findings
    assert finding.fix is not None
    assert finding.fix.title == "write `my_pkg::Planner`"
    assert "`src/planner.cpp` exports `my_pkg::Planner`" in finding.message


def test_two_that_may_be_meant_are_none() -> None:
    source = MACRO + MACRO.replace("my_pkg", "other")
    found = lint_files(package(plugins_DOT_xml=described("a::Planner"), src__planner_DOT_cpp=source), ["PLG002"])
    first = found.findings[0]
    assert (first.location.path, first.fix) == ("plugins.xml", None)


@pytest.mark.parametrize(
    "change",
    [
        {"plugins_DOT_xml": described("my_pkg::Planner"), "test__test_planner_DOT_cpp": MACRO.replace("my", "your")},
        {"src__planner_DOT_cpp": MACRO + "#ifdef X\n" + MACRO.replace("my", "your") + "#endif\n"},
        {"src__unused_DOT_cpp": MACRO.replace("my", "your")},
        {"include__planner_DOT_hpp": MACRO.replace("my", "your")},
        {"src__planner_DOT_cpp": MACRO + MACRO.replace("my_pkg", "_NAMESPACE_")},
    ],
)
def test_what_is_exported_for_others_eyes(change: dict[str, str]) -> None:
    assert said(package(**change), "PLG002") == []


def test_a_description_that_package_xml_alone_exports_is_not_found() -> None:
    files = package(LIBRARY)
    files["package.xml"] = files["package.xml"].replace(
        "</build_type>", '</build_type>\n    <nav2_core plugin="${prefix}/plugins.xml"/>'
    )
    ((path, message),) = said(files, "PLG002")
    assert path == "package.xml"
    assert "pluginlib_export_plugin_description_file(nav2_core plugins.xml)" in message


def test_an_old_description_beside_the_exported_one_is_left_alone() -> None:
    assert said(package(old__plugin_DOT_xml=described("my_pkg::Planner", "my_pkg::Gone")), "PLG002") == []


def test_a_description_that_is_missing_is_said_once() -> None:
    files = package()
    del files["plugins.xml"]
    found = lint_files({**files, "plugin.xml": described("my_pkg::Planner")}, ["CMK102", "PLG002", "XML306"]).findings
    assert [f.code for f in found if f.location.path == "CMakeLists.txt"] == ["CMK102"]
    assert "(did you mean `plugin.xml`?): CMake stops" in found[0].message


def test_what_is_exported_to_rqt_by_package_xml_is_found() -> None:
    files = package(LIBRARY, plugins_DOT_xml=described("my_pkg::Planner", base="qt_gui_cpp::PluginProvider"))
    export = '<qt_gui plugin="${prefix}/plugins.xml"/>'
    files["package.xml"] = files["package.xml"].replace("  </export>", f"    {export}\n  </export>")
    assert said(files, "PLG002") == []


LIBRARIES = [
    ("planner", None),
    ("lib/planner", None),
    ("some_folder/planner", None),
    ("planer", "write `planner`, where it is compiled"),
    ("lib/libplanner", "write `planner`, where it is compiled"),
    ("libplanner.so", "write `planner`, where it is compiled"),
    ("libplanner", "begins with `lib`"),
]


@pytest.mark.parametrize("path, told", LIBRARIES)
def test_the_library_of_a_description(path: str, told: str | None) -> None:
    found = said(package(plugins_DOT_xml=described("my_pkg::Planner", path=path)), "PLG004")
    assert [told in message for _, message in found] == ([True] if told else []), found


def test_the_name_of_the_file_counts() -> None:
    renamed = LIBRARY + "set_target_properties(planner PROPERTIES OUTPUT_NAME my_planner)\n" + EXPORT
    assert said(package(renamed, plugins_DOT_xml=described("my_pkg::Planner", path="my_planner")), "PLG004") == []
    ((_, message),) = said(package(renamed, plugins_DOT_xml=described("my_pkg::Planner", path="my_planer")), "PLG004")
    assert "`my_planner`" in message


@pytest.mark.parametrize(
    "cmake",
    [
        "add_library(${NAME} SHARED src/planner.cpp)\n",
        "include(ExternalProject)\nExternalProject_Add(other URL x)\n" + LIBRARY,
        LIBRARY + "set_target_properties(planner PROPERTIES OUTPUT_NAME ${NAME})\n",
    ],
)
def test_libraries_that_may_be_made_otherwise(cmake: str) -> None:
    files = package(cmake + EXPORT, plugins_DOT_xml=described("my_pkg::Planner", path="other"))
    assert said(files, "PLG004") == []


def test_a_static_library_can_not_be_loaded() -> None:
    ((_, message),) = said(package(LIBRARY.replace("SHARED", "STATIC") + EXPORT), "PLG004")
    assert "make it `SHARED`" in message


@pytest.mark.parametrize(
    "install",
    [
        "install(TARGETS planner LIBRARY DESTINATION lib/${PROJECT_NAME})\n",
        "set(all planner other)\ninstall(TARGETS ${all} DESTINATION lib)\n",
        "get_property(LATER GLOBAL PROPERTY later)\ninstall(TARGETS ${LATER} DESTINATION lib)\n",
        "install(FILES $<TARGET_FILE:planner> DESTINATION lib)\n",
    ],
)
def test_libraries_that_are_installed(install: str) -> None:
    assert said(package("add_library(planner SHARED src/planner.cpp)\n" + install + EXPORT), "PLG004") == []


def test_a_library_that_is_not_installed() -> None:
    bare = "add_library(planner SHARED src/planner.cpp)\n"
    ((_, message),) = said(package(bare + EXPORT), "PLG004")
    assert "`planner` is not installed" in message
    tests = f"if(BUILD_TESTING)\n{bare}{EXPORT}endif()\n"
    assert said(package(tests), "PLG004") == []
    auto = "find_package(ament_cmake_auto)\nament_auto_add_library(planner SHARED src/planner.cpp)\n" + EXPORT
    files = package(auto)
    files["CMakeLists.txt"] = files["CMakeLists.txt"].replace("ament_package", "ament_auto_package")
    assert said(files, "PLG004") == []


def rqt(base: str, *listed: str, cmake: str = "") -> dict[str, str]:
    kind = "my_pkg.panel.Panel" if "_py" in base else "my_pkg::Panel"
    lines = "".join(f'    <rqt_gui plugin="${{prefix}}/{file}"/>\n' for file in listed)
    return {
        "package.xml": manifest("", "ament_cmake").replace("  </export>", lines + "  </export>"),
        "CMakeLists.txt": HEAD + cmake + TAIL,
        "a.xml": described(kind, base=base),
        "b.xml": described(kind + "2", base=base),
    }


def test_rqt_plugins_in_python_are_listed_in_package_xml() -> None:
    assert said(rqt("rqt_gui_py::Plugin", "a.xml", "b.xml"), "PLG006") == []
    ((path, message),) = said(rqt("rqt_gui_py::Plugin", "a.xml"), "PLG006")
    assert path == "b.xml"
    assert '<rqt_gui plugin="${prefix}/b.xml"/>' in message


def test_rqt_plugins_in_cpp_need_not_be() -> None:
    cmake = "".join(f"pluginlib_export_plugin_description_file(rqt_gui {file})\n" for file in ("a.xml", "b.xml"))
    assert said(rqt("rqt_gui_cpp::Plugin", cmake=cmake), "PLG006") == []
    ((path, message),) = said(rqt("rqt_gui_cpp::Plugin", "a.xml", cmake=cmake), "PLG006")
    assert path == "CMakeLists.txt"
    assert "lists `a.xml`, not `b.xml`" in message


def loading(text: str, name: str = "server") -> dict[str, str]:
    """Return a package that loads plugins."""
    return {
        f"{name}/package.xml": manifest("", "ament_cmake", name),
        f"{name}/CMakeLists.txt": HEAD.replace("my_pkg", name) + "add_library(s src/s.cpp)\n" + TAIL,
        f"{name}/include/s.hpp": "class S { pluginlib::ClassLoader<Base> loader_; };\n",
        f"{name}/src/s.cpp": text,
    }


def beside(files: dict[str, str]) -> dict[str, str]:
    return {f"my_pkg/{path}": text for path, text in files.items()}


OURS = package(
    LIBRARY + EXPORT.replace("nav2_core", "server"), plugins_DOT_xml=described("my_pkg::Planner", base="srv::Base")
)
MOVED = {**OURS, "CMakeLists.txt": OURS["CMakeLists.txt"].replace("file(server", "file(server_core")}
LOADS = 'S::S() : loader_("server", "srv::Base") {}\n'


def test_a_loader_of_the_workspace_says_where_its_plugins_go() -> None:
    assert said({**loading(LOADS), **beside(OURS)}, "PLG005") == []
    ((path, message),) = said({**loading(LOADS), **beside(MOVED)}, "PLG005")
    assert path == "my_pkg/CMakeLists.txt"
    assert "`srv::Base` is loaded from `server`" in message


@pytest.mark.parametrize(
    "loads",
    [
        'S::S() : loader_("server", "srv::Other") {}\n',
        'S::S() : loader_(name, "srv::Base") {}\n',
        '// S::S() : loader_("server", "srv::Base") {}\n',
    ],
)
def test_without_a_loader_nothing_is_said(loads: str) -> None:
    assert said({**loading(loads), **beside(MOVED)}, "PLG005") == []


def test_a_package_that_is_known_may_load_them_too() -> None:
    moved = OURS["CMakeLists.txt"].replace("file(server", "file(rviz_common")
    assert said({**loading(LOADS), **beside({**OURS, "CMakeLists.txt": moved})}, "PLG005") == []


def test_two_bases_in_one_description_are_exported_twice() -> None:
    xml = "<class_libraries>\n" + described("my_pkg::Planner", base="srv::Base")
    xml += described("my_pkg::Planner", base="nav2_core::GlobalPlanner") + "</class_libraries>\n"
    both = package(LIBRARY + EXPORT + EXPORT.replace("nav2_core", "server"), plugins_DOT_xml=xml)
    assert said({**loading(LOADS), **beside(both)}, "PLG005") == []


@pytest.mark.parametrize(
    "base, found",
    [
        ("nav2_core::GlobalPlaner", True),
        ("nav2_core::SomethingNew", False),
        ("mine::GlobalPlanner", False),
        ("nav2_core::GlobalPlanner", False),
    ],
)
def test_the_name_of_the_base(base: str, found: bool) -> None:
    source = MACRO.replace("nav2_core::GlobalPlanner", "Base")
    files = package(plugins_DOT_xml=described("my_pkg::Planner", base=base), src__planner_DOT_cpp=source)
    assert len(said(files, "PLG005")) == found


def test_the_base_of_a_class_without_source_is_not_judged() -> None:
    xml = described("my_pkg::Planner", base="nav2_core::GlobalPlaner")
    files = package(plugins_DOT_xml=xml, src__planner_DOT_cpp="")
    assert len(said(files, "PLG002")) == 1
    assert said(files, "PLG005") == []


def test_a_loader_that_goes_astray() -> None:
    files = {**loading(LOADS.replace('"server"', '"srv"')), **beside(OURS)}
    ((path, message),) = said(files, "PLG005")
    assert path == "server/src/s.cpp"
    assert "`srv` is no known package" in message
    assert "write `server`" in message
    alone = loading(LOADS.replace('"server"', '"srv"'))
    assert said(alone, "PLG005") == []


NAMED = package(plugins_DOT_xml=described("my_pkg::Planner", name='name="my_pkg/Planner"'))


def robot(text: str, path: str = "robot/urdf/robot.urdf.xacro") -> dict[str, str]:
    return {"robot/package.xml": manifest("", "ament_cmake", "robot"), path: text, **beside(NAMED)}


def hardware(name: str) -> str:
    return f"<robot><ros2_control><hardware>\n<plugin>{name}</plugin>\n</hardware></ros2_control></robot>\n"


@pytest.mark.parametrize(
    "text, path",
    [
        (hardware("my_pkg/Planer"), "robot/urdf/robot.urdf.xacro"),
        (hardware("my_pkg::Planner"), "robot/urdf/robot.urdf"),
        (hardware("old_pkg/Planner"), "robot/urdf/robot.urdf"),
        ('<robot><param name="device_plugin">my_pkg/Planer</param></robot>', "robot/urdf/robot.urdf"),
        ("a:\n  plugin: 'my_pkg/Planer'  # mine\n", "robot/config/a.yaml"),
        ('- Class: "my_pkg/Planer"\n', "robot/rviz/a.rviz"),
        ("- type: my_pkg/planner/Planner\n", "robot/config/a.yml"),
        ("a:\n  wheels.type: my_pkg/Planer\n", "robot/config/a.yaml"),
        ('a:\n  "base/arm.wheels.type": my_pkg/Planer\n', "robot/config/a.yaml"),
        ("a:\n  plugin_name: my_pkg::Planer\n", "robot/config/a.yaml"),
        ("a:\n  {% if x %}\n  plugin: my_pkg/Planer\n  {% endif %}\n", "robot/config/a.yaml.j2"),
        ("a:\n  plugin: my_pkg/Planer\n", "robot/config/a.yml.in"),
    ],
)
def test_a_name_that_nobody_describes(text: str, path: str) -> None:
    (finding,) = lint_files(robot(text, path), ["PLG003"]).findings
    assert finding.location.path == path
    assert finding.excerpt[finding.location.column - 1 : finding.location.end_column - 1] in text
    assert finding.fix is not None
    assert finding.fix.title == "write `my_pkg/Planner`"


@pytest.mark.parametrize(
    "text, path",
    [
        (hardware("my_pkg/Planner"), "robot/urdf/robot.urdf.xacro"),
        (hardware("nav2_core/Planner"), "robot/urdf/robot.urdf"),
        (hardware("old_pkg/Other"), "robot/urdf/robot.urdf"),
        (hardware("$(arg plugin)"), "robot/urdf/robot.urdf.xacro"),
        (f"<robot><!-- {hardware('my_pkg/Planer')} --></robot>", "robot/urdf/robot.urdf"),
        ("a:\n  path: my_pkg/Planer\n  type: my_pkg/msg/Planer.msg\n  plugin: Planer\n", "robot/config/a.yaml"),
        (hardware("my_pkg/Planer"), "robot/test/robot.urdf"),
        (hardware("my_pkg/Planer"), "robot/urdf/robot.txt"),
        ("a:\n  plugin: {{ my_pkg/Planer }}\n", "robot/config/a.yaml.j2"),
        ("a:\n  my.wheel_type: my_pkg/Planer\n", "robot/config/a.yaml"),
        ("a:\n  plugin: my_pkg/Planer\n", "robot/config/a.yaml.bak"),
    ],
)
def test_names_that_may_be_right(text: str, path: str) -> None:
    assert said(robot(text, path), "PLG003") == []


def test_what_people_forget_of_a_name() -> None:
    ours = {**NAMED, "plugins.xml": NAMED["plugins.xml"].replace("my_pkg/Planner", "my_pkg/Route Planner")}
    files = {**robot("- Class: my_pkg/Route Planner\n- Class: my_pkg/RoutePlanner\n", "robot/a.rviz"), **beside(ours)}
    (finding,) = lint_files(files, ["PLG003"]).findings
    assert finding.location.line == 2
    assert "write `my_pkg/Route Planner`" in finding.message


def test_components_and_interfaces_may_be_named_alike() -> None:
    register = 'rclcpp_components_register_node(planner PLUGIN "my_pkg::Node" EXECUTABLE node)\n'
    ours = {
        **NAMED,
        "CMakeLists.txt": NAMED["CMakeLists.txt"].replace("ament_package", register + "ament_package"),
        "msg/Status.msg": "bool ok\n",
    }
    for name in ("my_pkg::Node", "my_pkg/Status"):
        files = {**robot(f"plugin: {name}\ntype: {name}\n", "robot/config/a.yaml"), **beside(ours)}
        assert said(files, "PLG003") == []


def test_a_description_that_is_not_known_keeps_quiet() -> None:
    unknown = NAMED["CMakeLists.txt"].replace("ament_package", f"{EXPORT.replace('plugins', '${X}')}ament_package")
    files = {**robot(hardware("my_pkg/Planer")), **beside({**NAMED, "CMakeLists.txt": unknown})}
    assert said(files, "PLG003") == []


def test_where_only_the_description_is_checked_it_is_told_there(tmp_path: Path) -> None:
    for path, text in robot(hardware("my_pkg::Planner")).items():
        (tmp_path / path).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / path).write_text(text)
    located = locate([tmp_path / "my_pkg"], tmp_path)
    (finding,) = Session(DiskTree(located.root), located.scope, frozenset({"PLG003"})).run().findings
    assert finding.location.path == "my_pkg/plugins.xml"
    assert "`robot` uses the plugin `my_pkg::Planner`" in finding.message


@pytest.mark.parametrize("code", ["PLG002", "PLG003", "PLG004", "PLG005", "PLG006"])
def test_ros_1_has_other_ways(code: str) -> None:
    wrong = package(LIBRARY, plugins_DOT_xml=described("my_pkg::Planner", path="other"))
    wrong["plugin.xml"] = described("my_pkg.panel.Panel", base="rqt_gui_py::Plugin")
    wrong["config/a.yaml"] = "plugin: my_pkg/Nothing\n"
    wrong["package.xml"] = manifest("", "catkin").replace(
        "  </export>", '    <a plugin="${prefix}/plugins.xml"/></export>'
    )
    assert said(wrong, code) == []


def test_a_plugin_of_qt_gui_is_listed_there() -> None:
    ((_, message),) = said({**package(), "plugin.xml": described("my_pkg.P", base="qt_gui_py::Plugin")}, "PLG006")
    assert '<qt_gui plugin="${prefix}/plugin.xml"/>' in message


def test_components_of_the_old_kind_are_no_plugins() -> None:
    source = "CLASS_LOADER_REGISTER_CLASS(my_pkg::Planner, rclcpp::Node)\n"
    files = package(LIBRARY, src__planner_DOT_cpp=source)
    del files["plugins.xml"]
    assert said(files, "PLG002") == []
