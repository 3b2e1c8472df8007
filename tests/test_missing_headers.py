"""Headers of the workspace that C++ includes: those that are there, those that a build makes, and misspelt ones."""

from __future__ import annotations

import pytest

from rospkg_cli.example import CMAKE, manifest
from rospkg_cli.finding import Severity
from rospkg_cli.testing import lint_files

ERROR, WARNING, INFO = Severity.ERROR, Severity.WARNING, Severity.INFO
BASE = {
    "base/package.xml": manifest("", "ament_cmake", "base"),
    "base/CMakeLists.txt": CMAKE.replace("my_pkg", "base"),
    "base/include/base/frames.hpp": "",
}
OWN = {"my_pkg/include/my_pkg/words.hpp": "", "my_pkg/src/helper.hpp": "", "my_pkg/src/deep/v1.hpp": ""}
GIVEN = tuple[Severity, str]


def findings(source: str, lines: str = "", **more: str) -> list[GIVEN]:
    """Lint a package whose one source is given; more files are named with `__` for `/`."""
    start = "include_directories(include)\nadd_executable(talker src/a.cpp)"
    cmake = CMAKE.replace("ament_package", f"{start}\n{lines}\nament_package")
    files = {
        "my_pkg/package.xml": manifest("  <depend>base</depend>\n", "ament_cmake"),
        "my_pkg/CMakeLists.txt": cmake,
        "my_pkg/src/a.cpp": f"{source}\nint main() {{return 0;}}\n",
        **BASE,
        **OWN,
        **{name.replace("__", "/") + ".hpp": text for name, text in more.items() if name != "base_lines"},
    }
    files["base/CMakeLists.txt"] = files["base/CMakeLists.txt"].replace(
        "ament_p", more.get("base_lines", "") + "ament_p"
    )
    found = lint_files(files, ["CMK201"]).findings
    return [(each.severity, each.message.partition("did you mean `")[2].partition("`")[0]) for each in found]


@pytest.mark.parametrize(
    ("line", "expected"),
    [
        ('#include "my_pkg/words.hpp"', []),
        ('#include "my_pkg/wodrs.hpp"', [(ERROR, "my_pkg/words.hpp")]),
        ("#include <my_pkg/wodrs.hpp>", [(ERROR, "my_pkg/words.hpp")]),
        ('#include "my_pkg/renamed_long_ago.hpp"', [(ERROR, "")]),
        ('#include "my_pkg/more/words.hpp"', [(ERROR, "my_pkg/words.hpp")]),
        ('#include "my_pkg/many_words.hpp"', [(ERROR, "")]),
        ('#include "my_pkg/wordings.hpp"', [(ERROR, "my_pkg/words.hpp")]),
        ('#include "my_pkg/words.h"', [(ERROR, "my_pkg/words.hpp")]),
        ('#include "my_pkg/msg/wodrs.hpp"', []),
        ('#include "my_pkg/wodrs"', []),
        ('#include "my_pkg/words.hp"', [(ERROR, "my_pkg/words.hpp")]),
        ('#include "my_pkg/generated.inc"', []),
        ('#include "my_pkg/../wodrs.hpp"', []),
        ('#if A\n#include "my_pkg/wodrs.hpp"\n#endif', []),
        ('#if __has_include("x")\n#endif\n#include "my_pkg/wodrs.hpp"', []),
        ('#include "base/frames.hpp"', []),
        ('#include "base/frame.hpp"', [(ERROR, "base/frames.hpp")]),
        ('#include "base/renamed_long_ago.hpp"', [(ERROR, "")]),
        ('#include "other/frame.hpp"', []),
        ('#include "helper.hpp"', []),
        ('#include "hepler.hpp"', [(ERROR, "helper.hpp")]),
        ('#include "hepelr.hpp"', [(ERROR, "helper.hpp")]),
        ('#include "hepe.hpp"', []),
        ("#include <hepler.hpp>", []),
        ('#include "words.hpp"', []),
        ('#include "wrods.hpp"', []),
        ('#include "deep/v1.hpp"', []),
    ],
)
def test_what_a_source_includes(line: str, expected: list[GIVEN]) -> None:
    assert findings(line) == expected


def test_a_number_is_no_misspelling() -> None:
    more = {"my_pkg__src__part_1": ""}
    assert findings('#include "part_2.hpp"', **more) == []
    assert findings('#include "patr_1.hpp"', **more) == [(ERROR, "part_1.hpp")]


@pytest.mark.parametrize(
    ("lines", "near", "far"),
    [
        ("", True, True),
        ("configure_file(a.in ${CMAKE_CURRENT_BINARY_DIR}/include/my_pkg/wodrs.hpp)", False, True),
        ("configure_file(a.in ${CMAKE_CURRENT_BINARY_DIR}/${SOMETHING})", True, False),
        ("generate_parameter_library(wodrs src/a.yaml)", False, True),
        ("generate_export_header(talker)", True, True),
        ("add_custom_command(OUTPUT ${CMAKE_BINARY_DIR}/wodrs.hpp COMMAND tool)", False, False),
        ("add_custom_command(OUTPUT b COMMAND tool ${CMAKE_CURRENT_SOURCE_DIR})", True, False),
        ("protobuf_generate(TARGET talker)", True, False),
        ("team_generate(talker)", True, False),
        ("include(${WHEREVER})", True, False),
        ("externalproject_add(a)", True, False),
    ],
)
def test_what_a_build_makes(lines: str, near: bool, far: bool) -> None:
    assert len(findings('#include "my_pkg/wodrs.hpp"', lines)) == near
    assert len(findings('#include "my_pkg/renamed_long_ago.hpp"', lines)) == far
    theirs = lines.replace("talker", "base")
    assert len(findings('#include "base/renamed_long_ago.hpp"', base_lines=f"{theirs}\n")) == (
        far and near and "gen" not in lines
    )


def test_a_folder_of_two_packages() -> None:
    source = '#include "my_pkg/renamed_long_ago.hpp"'
    assert findings(source, base__include__my_pkg__renamed_long_ago="") == []
    assert findings(source, base__include__my_pkg__other="") == [(ERROR, "")]
    assert findings(source, base__include__my_pkg__other="", base_lines="team_generate(a)\n") == []


def test_what_the_package_does_not_compile_is_milder() -> None:
    header = '#include "my_pkg/wodrs.hpp"\n'
    assert findings("", my_pkg__include__my_pkg__b=header) == [(INFO, "my_pkg/words.hpp")]
    assert findings('#include "my_pkg/b.hpp"', my_pkg__include__my_pkg__b=header) == [(ERROR, "my_pkg/words.hpp")]


def test_a_header_that_git_ignores_is_made_by_somebody() -> None:
    source = '#include "my_pkg/renamed_long_ago.hpp"'
    files = {
        "package.xml": manifest("", "ament_cmake"),
        "CMakeLists.txt": CMAKE.replace("ament_package", "add_executable(talker src/a.cpp)\nament_package"),
        "src/a.cpp": f"{source}\nint main() {{return 0;}}\n",
        "include/my_pkg/words.hpp": "",
    }
    assert len(lint_files(files, ["CMK201"]).findings) == 1
    assert lint_files({**files, ".gitignore": "renamed_*.hpp\n"}, ["CMK201"]).findings == ()


@pytest.mark.parametrize(
    ("line", "expected"),
    [
        ("#include <ros/ros.h>", [(ERROR, "rclcpp/rclcpp.hpp")]),
        ("#include <ros/names.h>", [(ERROR, "")]),
        ("#include <ros/rsos.h>", []),
        ("#if A\n#include <ros/ros.h>\n#endif", []),
        ('#if __has_include("x")\n#endif\n#include <ros/ros.h>', []),
        ("#include <std_msgs/String.h>", [(ERROR, "std_msgs/msg/string.hpp")]),
        ("#include <sensor_msgs/NavSatFix.h>", [(ERROR, "sensor_msgs/msg/nav_sat_fix.hpp")]),
        ("#include <std_msgs/Whatever.h>", [(INFO, "pkg/msg/name.hpp")]),
        ("#include <std_msgs/Whatever.h>\n#include <std_msgs/String.h>", [(ERROR, "std_msgs/msg/string.hpp")]),
        ("#include <nobody_msgs/String.h>", []),
        ("#include <std_msgs/string.h>", [(ERROR, "std_msgs/msg/string.h")]),
        ("#include <std_msgs/strange.hpp>", []),
        ("#include <sensor_msgs/imu.hpp>", []),
    ],
)
def test_headers_of_ros_1(line: str, expected: list[GIVEN]) -> None:
    assert of_nobody(line) == expected


@pytest.mark.parametrize(
    ("line", "expected"),
    [
        ('#include "my_pkgg/words.hpp"', [(ERROR, "my_pkg/words.hpp")]),
        ('#include "my_pkgg/wodrs.hpp"', []),
        ('#include "my_gpkg/words.hpp"', [(ERROR, "my_pkg/words.hpp")]),
        ('#include "mx_gpkg/words.hpp"', []),
        ('#include "my_pkg2/words.hpp"', [(WARNING, "my_pkg/words.hpp")]),
        ('#include "My_pkgg/words.hpp"', []),
        ("#include <toolbxo/frames.hpp>", []),
        ("#include <sensor_mgs/msg/nav_sat_fix.hpp>", [(ERROR, "sensor_msgs/msg/nav_sat_fix.hpp")]),
        ("#include <sensor_mgs/msg/whole_world.hpp>", []),
        ("#include <rclccp/rclcpp.hpp>\n#include <rclcpp/a.hpp>", []),
        (
            "#include <rclccp/rclcpp.hpp>\n#include <rclcpp/a.hpp>\n#include <rclcpp/b.hpp>",
            [(ERROR, "rclcpp/rclcpp.hpp")],
        ),
    ],
)
def test_a_folder_of_no_package(line: str, expected: list[GIVEN]) -> None:
    assert of_nobody(line) == expected


@pytest.mark.parametrize(
    ("find", "expected"),
    [
        ("find_package(other REQUIRED)", [(ERROR, "my_pkg/whole_world.h")]),
        ("find_package(my_pkg_msgs REQUIRED)", [(ERROR, "my_pkg/whole_world.h")]),
        ("find_package(my_pkg_core REQUIRED)", []),
        ("find_library(MY_PKG libmy_pkg)", []),
        ("find_path(MY_PKG_DIR my_pkg/whole_world.h)", []),
        ("pkg_check_modules(MINE REQUIRED my_pkg)", []),
    ],
)
def test_a_library_called_like_the_package_may_have_its_headers(find: str, expected: list[GIVEN]) -> None:
    assert of_nobody("#include <my_pkg/whole_world.h>", find=f"{find}\n") == expected
    assert [level for level, _ in of_nobody("#include <my_pkg/wrods.hpp>", find=f"{find}\n")] == [ERROR]


def test_a_folder_that_is_there_is_not_misspelt() -> None:
    line = '#include "my_pkgg/words.hpp"'
    assert of_nobody(line, **{"src/my_pkgg/more.hpp": ""}) == []
    assert of_nobody(line, **{"package.xml": manifest("<depend>my_pkgg</depend>", "ament_cmake")}) == []


def test_a_package_of_ros_1_has_its_headers() -> None:
    line = "#include <ros/ros.h>"
    find, declared = "find_package(roscpp REQUIRED)\n", manifest("<depend>roscpp</depend>", "ament_cmake")
    assert of_nobody(f"{line}\n#include <tf/tf.h>", find=find) == [(INFO, "")]
    assert of_nobody(line, find=find, **{"package.xml": declared}) == []
    header = {"include/my_pkg/a.hpp": f"{line}\n"}
    assert of_nobody("", **header) == []
    assert of_nobody('#include "my_pkg/a.hpp"', **header) == [(ERROR, "rclcpp/rclcpp.hpp")]
    assert of_nobody("", **{"include/my_pkg/a.hpp": '#include "my_pkgg/words.hpp"\n'}) == [(INFO, "my_pkg/words.hpp")]
    assert of_nobody(f"#include <ros/time.h>\n{line}") == [(ERROR, "rclcpp/time.hpp")]
    assert of_nobody(line, **{"include/ros/ros.h": ""}) == []


def of_nobody(source: str, find: str = "", **more: str) -> list[GIVEN]:
    """Lint a package that depends on rclcpp and sensor_msgs, with one source, for headers that no package has."""
    depends = "".join(f"  <depend>{name}</depend>\n" for name in ("rclcpp", "sensor_msgs"))
    find = f"include_directories(include)\n{find}"
    files = {
        "package.xml": manifest(depends, "ament_cmake"),
        "CMakeLists.txt": CMAKE.replace("ament_package", f"{find}add_executable(talker src/a.cpp)\nament_package"),
        "src/a.cpp": f"{source}\nint main() {{return 0;}}\n",
        "include/my_pkg/words.hpp": "",
        **more,
    }
    messages = [(each.severity, each.message) for each in lint_files(files, ["CMK201"]).findings]
    return [(level, text.split("`")[3] if text.count("`") > 2 else "") for level, text in messages]


@pytest.mark.parametrize(
    ("rule", "expected"),
    [("lib/ DESTINATION include/base", []), ("lib/ DESTINATION share/base", [(ERROR, "")]),
     ("include/ DESTINATION include", [(ERROR, "")]), ("include/ DESTINATION include/base", [(ERROR, "")])],
)  # fmt: skip
def test_headers_that_are_installed_from_another_folder(rule: str, expected: list[GIVEN]) -> None:
    lines = f"install(DIRECTORY {rule})\n"
    assert findings('#include "base/buses.hpp"', base_lines=lines, base__lib__bus="") == expected


@pytest.mark.parametrize(("name", "expected"), [("words", []), ("wodrs", [(ERROR, "")])])
def test_headers_of_a_package_of_interfaces_lie_one_folder_deeper(name: str, expected: list[GIVEN]) -> None:
    assert findings(f'#include "base/{name}.hpp"', base__include__base__base__words="") == expected
