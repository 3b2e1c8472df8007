"""`rospkg add node` in packages of type ament_cmake, whatever form CMakeLists.txt has."""

from __future__ import annotations

import pytest
from adding import added, cmake_package, comes_back, executables, new_findings, taken, text

from rospkg_cli.change import ChangeError, NotUnderstoodError

LOWER = """\
cmake_minimum_required(VERSION 3.20)
project(my_pkg)

find_package(ament_cmake REQUIRED)

add_executable(old src/old.cpp)

# What is installed
install(TARGETS old
  DESTINATION lib/${PROJECT_NAME})

ament_package()
"""
BARE = """\
cmake_minimum_required(VERSION 3.20)
project(my_pkg)

find_package(ament_cmake REQUIRED)

ament_package()
"""
AUTO = """\
cmake_minimum_required(VERSION 3.20)
project(my_pkg)

find_package(ament_cmake_auto REQUIRED)
ament_auto_find_build_dependencies()

ament_auto_add_executable(old src/old.cpp)

ament_auto_package()
"""
BLOCK = """\
add_executable(idler src/idler.cpp)
target_compile_features(idler PRIVATE cxx_std_17)
target_link_libraries(idler PRIVATE
  rclcpp::rclcpp
)

"""
FORMS = {
    "lower": (LOWER, BLOCK + "# What is installed\ninstall(TARGETS old idler\n"),
    "nothing yet": (
        BARE,
        BLOCK + "install(TARGETS idler\n  DESTINATION lib/${PROJECT_NAME}\n)\n\nament_package()\n",
    ),
    "upper": (
        "CMAKE_MINIMUM_REQUIRED(VERSION 3.20)\nPROJECT(my_pkg)\n\nFIND_PACKAGE(ament_cmake REQUIRED)\n\n"
        "AMENT_PACKAGE()\n",
        "FIND_PACKAGE(ament_cmake REQUIRED)\nFIND_PACKAGE(rclcpp REQUIRED)\n\nADD_EXECUTABLE(idler src/idler.cpp)\n",
    ),
    "automatic": (
        AUTO,
        "ament_auto_add_executable(idler src/idler.cpp)\n\nament_auto_package()\n",
    ),
    "extras": (
        LOWER.replace("ament_package()", 'ament_package(CONFIG_EXTRAS "my_pkg-extras.cmake")'),
        BLOCK + "# What is installed\n",
    ),
    "a list in a variable": (
        LOWER.replace("install(TARGETS old", "set(programs old)\ninstall(TARGETS ${programs}"),
        "install(TARGETS ${programs} idler\n  DESTINATION lib/${PROJECT_NAME})",
    ),
    "one a line": (
        LOWER.replace("install(TARGETS old\n", "install(TARGETS\n  old\n"),
        "install(TARGETS\n  old\n  idler\n  DESTINATION",
    ),
    "four blanks": (
        LOWER.replace("\n  ", "\n    "),
        "target_link_libraries(idler PRIVATE\n    rclcpp::rclcpp\n)\n",
    ),
    "a standard for all": (
        LOWER.replace("find_package", "set(CMAKE_CXX_STANDARD 17)\nfind_package"),
        "add_executable(idler src/idler.cpp)\ntarget_link_libraries(idler PRIVATE\n",
    ),
    "tests before the rules": (
        BARE.replace(
            "ament_package()", "if(BUILD_TESTING)\n  find_package(ament_lint_auto REQUIRED)\nendif()\n\nament_package()"
        ),
        "install(TARGETS idler\n  DESTINATION lib/${PROJECT_NAME}\n)\n\nif(BUILD_TESTING)\n",
    ),
    "packages in a loop": (
        BARE.replace(
            "ament_package()", "foreach(each rclcpp)\n  find_package(${each} REQUIRED)\nendforeach()\n\nament_package()"
        ),
        "endforeach()\n\nadd_executable(idler src/idler.cpp)\n",
    ),
}


@pytest.mark.parametrize("form", FORMS)
def test_target_and_rule_look_like_the_others(form: str) -> None:
    cmake, expected = FORMS[form]
    files = cmake_package(cmake)
    if "rclcpp" in cmake:  # then it stays declared, as long as CMake names it
        files["package.xml"] = files["package.xml"].replace("  <export>", "  <depend>rclcpp</depend>\n  <export>")
    draft = added(files, "node", "idler:empty")
    assert expected in text(draft, "CMakeLists.txt")
    assert "idler" in executables(draft)
    assert "<depend>rclcpp</depend>" in text(draft, "package.xml")
    comes_back(files, draft, "node", "idler")


def test_a_package_that_is_looked_for_below_an_early_return() -> None:
    early = "if(NOT WANTED)\n  return()\nendif()\nfind_package(rclcpp REQUIRED)\n\nament_package"
    draft = added(cmake_package(BARE.replace("\nament_package", early)), "node", "idler:empty")
    assert "find_package(rclcpp REQUIRED)\n\n" + BLOCK in text(draft, "CMakeLists.txt")


def test_lint_has_nothing_new_to_say() -> None:
    files = cmake_package(LOWER)
    assert new_findings(files, added(files, "node", "idler:empty")) == []


def test_line_ends_and_tabs_stay() -> None:
    files = cmake_package(LOWER.replace("\n  ", "\n\t").replace("\n", "\r\n"))
    draft = added(files, "node", "idler:empty")
    assert "target_link_libraries(idler PRIVATE\r\n\trclcpp::rclcpp\r\n)\r\n" in text(draft, "CMakeLists.txt")
    comes_back(files, draft, "node", "idler")


def test_every_kind_of_node_can_be_added_and_removed() -> None:
    from rospkg_cli.scaffold.node_kinds import offered_kinds

    files = cmake_package(LOWER)
    for kind in offered_kinds(["cpp"]):
        draft = added(files, "node", f"idler:{kind}")
        assert "idler" in executables(draft), kind
        assert new_findings(files, draft) == [], kind
        comes_back(files, draft, "node", "idler")


def test_many_nodes_leave_nothing_in_whatever_order() -> None:
    from rospkg_cli.scaffold.node_kinds import offered_kinds

    files = cmake_package(FORMS["a list in a variable"][0])
    names = [f"n_{kind.replace('-', '_')}:{kind}" for kind in offered_kinds(["cpp"])]
    draft = added(files, "node", *names)
    comes_back(files, draft, "node", *(name.partition(":")[0] for name in names))


@pytest.mark.parametrize("kind", ["service", "client"])
def test_nodes_about_a_service_can_be_added(kind: str) -> None:
    files = cmake_package(LOWER)
    draft = added(files, "node", f"idler:{kind}:std_srvs/SetBool@/go")
    assert '"/go"' in text(draft, "src/idler.cpp")
    assert "  ${std_srvs_TARGETS}\n" in text(draft, "CMakeLists.txt")
    assert new_findings(files, draft) == []


def test_a_component_is_a_library_and_an_executable() -> None:
    files = cmake_package(AUTO)
    draft = added(files, "node", "part:component")
    cmake = text(draft, "CMakeLists.txt")
    assert "ament_auto_add_library(part_component SHARED src/part.cpp)\n" in cmake
    assert "set_target_properties(part_component PROPERTIES OUTPUT_NAME ${PROJECT_NAME}_part)\n" in cmake
    assert 'rclcpp_components_register_node(part_component\n  PLUGIN "my_pkg::PartNode"\n  EXECUTABLE part)\n' in cmake
    assert "install(" not in cmake
    comes_back(files, draft, "node", "part")


def test_what_needs_no_ros_is_a_header_beside_the_source() -> None:
    draft = added(cmake_package(LOWER), "node", "talker:publisher", "teller:publisher")
    assert '#include "my_pkg/greeting.hpp"' in text(draft, "src/talker.cpp")
    assert "#ifndef MY_PKG__GREETING_HPP_" in text(draft, "src/my_pkg/greeting.hpp")
    assert "class Greeting" in text(draft, "src/my_pkg/greeting.hpp")
    after, _ = taken(draft, "node", "talker")
    assert after.entry("src/my_pkg/greeting.hpp")
    assert after.entry("src/describe.hpp")
    last, _ = taken(after, "node", "teller")
    assert last.entry("src/my_pkg/greeting.hpp") is None
    assert last.entry("src/describe.hpp") is None


def test_the_library_of_a_package_of_ours_is_linked() -> None:
    from planned import plan, texts

    files = texts(plan("my_pkg", template="ament_cmake"))
    draft = added(files, "node", "clock:timer")
    assert "target_link_libraries(clock PRIVATE\n  ${PROJECT_NAME}\n  ${rcl_interfaces_TARGETS}" in text(
        draft, "CMakeLists.txt"
    )
    assert draft.entry("include/my_pkg/countdown.hpp")
    assert new_findings(files, draft) == []
    comes_back(files, draft, "node", "clock")


def test_a_library_of_ours_gets_nodes() -> None:
    from planned import plan, texts

    files = texts(plan("my_pkg", template="library"))
    for node in ("talker:publisher", "ear:subscriber:python"):
        draft = added(files, "node", node)
        assert executables(draft) == {node.partition(":")[0]}
        assert new_findings(files, draft) == []
        comes_back(files, draft, "node", node.partition(":")[0])


def test_python_in_a_package_that_cmake_builds() -> None:
    files = cmake_package(LOWER)
    draft = added(files, "node", "ear:subscriber:python")
    cmake = text(draft, "CMakeLists.txt")
    assert "find_package(ament_cmake REQUIRED)\nfind_package(ament_cmake_python REQUIRED)\n" in cmake
    assert "ament_python_install_package(${PROJECT_NAME})\n" in cmake
    assert "install(PROGRAMS scripts/ear\n  DESTINATION lib/${PROJECT_NAME}\n)\n" in cmake
    script = draft.entry("scripts/ear")
    assert script is not None
    assert script.is_executable
    assert "from my_pkg.ear import main" in text(draft, "scripts/ear")
    assert executables(draft) == {"old", "ear"}
    assert new_findings(files, draft) == []
    comes_back(files, draft, "node", "ear")
    again = added({**files, **{p: text(draft, p) for p in draft.changes}}, "node", "eye:subscriber:python")
    assert "install(PROGRAMS scripts/ear scripts/eye\n" in text(again, "CMakeLists.txt")


def test_what_is_python_already_stays_so() -> None:
    cmake = BARE.replace(
        "\nament_package",
        "find_package(ament_cmake_python REQUIRED)\nament_python_install_package(robot)\n\nament_package",
    )
    draft = added(cmake_package(cmake, **{"robot/__init__.py": ""}), "node", "idler:empty")
    assert "from robot.idler import main" in text(draft, "scripts/idler")
    assert draft.entry("robot/idler.py")
    made = cmake.replace("\nament_package", "pybind11_add_module(fast src/old.cpp)\n\nament_package")
    files = cmake_package(made, **{"robot/__init__.py": ""})
    after, _ = taken(added(files, "node", "idler:empty:python"), "node", "idler")
    assert text(after, "CMakeLists.txt") == made
    assert after.entry("robot/__init__.py")


def test_what_can_not_be_there_is_refused() -> None:
    taken_name = cmake_package(LOWER.replace("add_executable(old", "add_executable(idler"))
    with pytest.raises(ChangeError, match=r"CMakeLists.txt has a target `idler` already"):
        added(taken_name, "node", "idler:empty")
    calls = "rosidl_generate_interfaces(my_pkg msg/A.msg)\nament_python_install_package(my_pkg)\nadd_executable"
    interfaces = LOWER.replace("add_executable", calls)
    with pytest.raises(ChangeError, match=r"installs one of the same name.*ear:subscriber:cpp"):
        added(cmake_package(interfaces), "node", "ear:subscriber:python")
    other = cmake_package(LOWER)
    other["package.xml"] = other["package.xml"].replace("ament_cmake</build_type>", "ament_cargo</build_type>")
    with pytest.raises(ChangeError, match="build type `ament_cargo`"):
        added(other, "node", "idler:empty")


def test_python_beside_interfaces_has_a_package_of_its_own_name() -> None:
    """The one that CMake generates for the interfaces is called like the package."""
    made = LOWER.replace("add_executable", "rosidl_generate_interfaces(my_pkg msg/A.msg)\nadd_executable")
    files = cmake_package(made, **{"msg/A.msg": "int32 a\n"})
    draft = added(files, "node", "idler:empty:python")
    assert "ament_python_install_package(my_pkg_nodes)" in text(draft, "CMakeLists.txt")
    assert "from my_pkg_nodes.idler import main" in text(draft, "scripts/idler")
    assert "idler" in executables(draft)
    comes_back(files, draft, "node", "idler")


def test_python_depends_fully_on_what_cmake_requires() -> None:
    files = cmake_package(LOWER.replace("add_exec", "find_package(std_msgs REQUIRED)\nadd_exec"))
    assert "<depend>std_msgs</depend>" in text(added(files, "node", "idler:subscriber:python"), "package.xml")


def test_without_an_end_the_lines_are_shown() -> None:
    with pytest.raises(NotUnderstoodError, match=r"no ament_package\(\) at its end") as refused:
        added(cmake_package(LOWER.partition("# What")[0]), "node", "idler:empty")
    assert refused.value.details[:2] == ("CMakeLists.txt:", "    add_executable(idler src/idler.cpp)")


def test_a_source_that_was_edited_is_kept() -> None:
    files = cmake_package(LOWER)
    draft = added(files, "node", "idler:empty")
    edited = {path: text(draft, path) for path in draft.tree.files()}
    edited["src/idler.cpp"] = edited["src/idler.cpp"].replace('"ready"', '"set"')
    with pytest.raises(ChangeError, match=r"`idler` is not as `add` writes it; --force"):
        taken(added(edited, "node", "other:empty"), "node", "idler")
    after, _ = taken(added(edited, "node", "other:empty"), "node", "idler", force=True)
    assert after.entry("src/idler.cpp") is None
    assert "idler" not in text(after, "CMakeLists.txt")
    with pytest.raises(ChangeError, match="no source of a node `nobody`"):
        taken(draft, "node", "nobody")
