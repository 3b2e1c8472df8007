"""Headers and types of messages that C++ names: those that there are, and those that only look so."""

from __future__ import annotations

import pytest

from rospkg_cli.example import CMAKE, INTERFACES_BODY, INTERFACES_CMAKE, manifest
from rospkg_cli.finding import Severity
from rospkg_cli.languages.cpp.code_text import code_text
from rospkg_cli.testing import lint_files

ERROR, WARNING, INFO = Severity.ERROR, Severity.WARNING, Severity.INFO
NODE = CMAKE.replace("ament_package", "add_executable(talker src/a.cpp)\nament_package")
USER = {"package.xml": manifest("  <depend>base</depend>\n", "ament_cmake"), "CMakeLists.txt": NODE}
BASE = {
    "base/package.xml": manifest(INTERFACES_BODY, "ament_cmake", "base"),
    "base/CMakeLists.txt": INTERFACES_CMAKE.replace("my_pkg", "base"),
    "base/msg/Status.msg": "float32 battery_level\n",
    "base/srv/SetMode.srv": "string mode\n---\nbool success\n",
}


def findings(source: str, more: dict[str, str] | None = None) -> list[tuple[Severity, str]]:
    user = {f"my_pkg/{path}": text for path, text in {**USER, "src/a.cpp": source, **(more or {})}.items()}
    found = lint_files({**BASE, **user}, ["IDL012"]).findings
    return [(each.severity, each.message.partition("did you mean `")[2].partition("`")[0]) for each in found]


@pytest.mark.parametrize(
    ("line", "expected"),
    [
        ("#include <base/msg/status.hpp>", []),
        ("#include <base/srv/set_mode.hpp>", []),
        ("#include <base/msg/status.h>", []),
        ("#include <base/srv/setmode.hpp>", [(ERROR, "base/srv/set_mode.hpp")]),
        ("#include <base/msg/stats.h>", [(ERROR, "base/msg/status.h")]),
        ("#include <base/msg/other.hpp>", [(ERROR, "")]),
        ("#include <base/msg/detail/other__struct.hpp>", []),
        ("#include <base/action/other.hpp>", []),
        ("#include <base/other.hpp>", []),
        ("#if A\n#include <base/msg/other.hpp>\n#endif", []),
        ("#include <std_msgs/msg/strin.hpp>", [(ERROR, "std_msgs/msg/string.hpp")]),
        ("#include <std_msgs/msg/strinx.hpp>", [(ERROR, "std_msgs/msg/string.hpp")]),
        ("#include <std_msgs/msg/strixx.hpp>", []),
        ("#include <base/srv/SetMode.hpp>", [(ERROR, "base/srv/set_mode.hpp")]),
        ("#include <base/srv/SetWords.hpp>", [(ERROR, "")]),
        ("#include <sensor_msgs/msg/NavSatFix.hpp>", [(ERROR, "sensor_msgs/msg/nav_sat_fix.hpp")]),
        ("#include <sensor_msgs/msg/WholeWorld.hpp>", []),
        ("#include <nobody_msgs/msg/NavSatFix.hpp>", [(ERROR, "nobody_msgs/msg/nav_sat_fix.hpp")]),
        ("#include <nobody_msgs/msg/NavSatFix.h>", []),
        ("#include <nobody/msg/NavSatFix.hpp>", []),
        ("#include <nobody_msgs/msg/strin.hpp>", []),
        ("base::msg::Status a;", []),
        ("base::msg::Stats a;", [(ERROR, "base::msg::Status")]),
        ("::base::msg::Stats a;", [(ERROR, "base::msg::Status")]),
        ("other::base::msg::Stats a;", []),
        ("mybase::msg::Stats a;", []),
        ("base::srv::SetMode_Request a;", []),
        ("base::srv::SetMode::Request a;", []),
        ("base::msg::Status_<A> a;", []),
        ("base::msg::to_yaml(a);", []),
        ("base::msg::SetMode a;", [(ERROR, "base::srv::SetMode")]),
        ("// base::msg::Stats a;", []),
        ('auto a = "base::msg::Stats";', []),
        ("#ifdef A\nbase::msg::Stats a;\n#endif", []),
        ("#ifndef A\n#define A\nbase::msg::Stats a;\n#endif", [(ERROR, "base::msg::Status")]),
        ("#ifdef A\n#endif\nbase::msg::Stats a;", [(ERROR, "base::msg::Status")]),
        ("base::msg::Stats a;\nbase::msg::Stats b;", [(ERROR, "base::msg::Status")]),
        ("#include <base/msg/stats.hpp>\nbase::msg::Stats b;", [(ERROR, "base/msg/status.hpp")]),
        ("std_msgs::msg::Strin a;", [(ERROR, "std_msgs::msg::String")]),
        ("std_msgs::msg::Whatever a;", []),
    ],
)
def test_what_a_source_names(line: str, expected: list[tuple[Severity, str]]) -> None:
    assert findings(f"{line}\nint main() {{return 0;}}\n") == expected


def test_a_header_may_be_the_packages_own() -> None:
    source = "#include <base/msg/other.hpp>\n"
    assert findings(source) == [(ERROR, "")]
    assert findings(source, {"include/base/msg/other.hpp": ""}) == []


def test_a_class_may_be_the_packages_own() -> None:
    files = {"package.xml": BASE["base/package.xml"], "msg/Status.msg": BASE["base/msg/Status.msg"]}
    files["CMakeLists.txt"] = BASE["base/CMakeLists.txt"].replace("ament_pack", "add_library(a src/a.cpp)\nament_pack")
    files["srv/SetMode.srv"] = BASE["base/srv/SetMode.srv"]
    use = "base::msg::Helper help;\n"
    assert len(lint_files({**files, "src/a.cpp": use}, ["IDL012"]).findings) == 1
    own = f"namespace base::msg {{ class Helper {{}}; }}\n{use}"
    assert lint_files({**files, "src/a.cpp": own}, ["IDL012"]).findings == ()


def test_a_class_that_a_file_puts_into_the_namespace_of_others() -> None:
    use = "base::msg::Helper help;\nint main() {return 0;}\n"
    assert findings(use) == [(ERROR, "")]
    assert findings(f"namespace base {{ namespace msg {{ using Helper = Status; }} }}\n{use}") == []
    assert findings(f"namespace other {{ using Helper = int; }}\n{use}") == [(ERROR, "")]


def test_what_the_package_does_not_compile_is_milder() -> None:
    header = {"include/my_pkg/a.hpp": "#include <base/msg/stats.hpp>\n"}
    assert findings("int main() {return 0;}\n", header) == [(INFO, "base/msg/status.hpp")]
    assert findings("#include <my_pkg/a.hpp>\n", header) == [(ERROR, "base/msg/status.hpp")]
    assert findings("int main() {return 0;}\n", {"src/b.cpp": header["include/my_pkg/a.hpp"]}) == []


def test_code_keeps_its_place() -> None:
    text = '#if A\nint a;\n#endif\nint b; // c\nauto d = "e";\n'
    code = code_text(text)
    assert len(code) == len(text)
    assert code.split() == ["int", "b;", "auto", "d", "=", ";"]
    assert code.index("int b;") == text.index("int b;")


CAPITAL = "#include <std_msgs/msg/String.hpp>\nint main() {return 0;}\n"
MADE = "${CMAKE_CURRENT_BINARY_DIR}/std_msgs/msg/String.hpp"


def with_cmake(lines: str, source: str = CAPITAL) -> list[tuple[Severity, str]]:
    return findings(source, {"CMakeLists.txt": NODE.replace("ament_package", f"{lines}\nament_package")})


@pytest.mark.parametrize(
    "lines",
    [
        "dds_types(my_types MESSAGES builtin_interfaces/Time std_msgs/String)",
        "dds_types(my_types std_msgs/msg/String)",
        'dds_types(my_types "std_msgs/msg/Int8.idl;std_msgs/msg/String.idl")',
        "dds_types(String PACKAGE std_msgs)",
        f"add_custom_command(OUTPUT {MADE} COMMAND ddsgen String.idl)",
        f"configure_file(String.hpp.in {MADE})",
    ],
)
def test_a_header_that_the_build_may_make_of_a_message_is_left_alone(lines: str) -> None:
    assert with_cmake(lines) == []


@pytest.mark.parametrize(
    "lines",
    [
        "",
        "dds_types(my_types MESSAGES std_msgs/Header)",
        "dds_types(my_types MESSAGES other_msgs/String)",
        "dds_types(my_types DEPENDENCIES std_msgs)",
        "if(BUILD_TESTING)\n  dds_types(my_types std_msgs/String)\nendif()",
        "message(STATUS std_msgs/String)",
        "ament_target_dependencies(talker std_msgs String)",
        "function(own_types)\nendfunction()\nown_types(std_msgs/String)",
        f"add_custom_command(OUTPUT {MADE.replace('std_msgs', 'other_msgs')} COMMAND ddsgen String.idl)",
    ],
)
def test_a_header_that_no_command_makes_stays_an_error(lines: str) -> None:
    assert with_cmake(lines) == [(ERROR, "std_msgs/msg/string.hpp")]


def test_a_slip_of_another_name_stays_an_error_beside_a_macro() -> None:
    source = "#include <std_msgs/msg/strin.hpp>\nint main() {return 0;}\n"
    assert with_cmake("dds_types(my_types std_msgs/String)", source) == [(ERROR, "std_msgs/msg/string.hpp")]
    assert with_cmake("dds_types(my_types base/SetMode)", source.replace("std_msgs/msg/strin", "base/srv/setmode")) == [
        (ERROR, "base/srv/set_mode.hpp")
    ]
