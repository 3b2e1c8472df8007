"""Distributions that a page names in a statement that denies them are not meant."""

from __future__ import annotations

import pytest

from rospkg_cli.checks.repository.denied_distributions import without_denied
from rospkg_cli.checks.repository.distribution_names import names_in
from rospkg_cli.example import CMAKE, manifest
from rospkg_cli.testing import lint_files


def named(text: str) -> list[str]:
    return sorted(names_in(text.lower()))


@pytest.mark.parametrize(
    "text",
    [
        "Tested on Humble (22.04). It will likely not work with newer or older ones (Rolling, Foxy ...).",
        "Foxy and Galactic are not supported. Use Humble.",
        "Jazzy is no longer supported, use Humble",
        "For Humble; it has not been tested on Jazzy.",
        "For Humble.\nIt doesn't compile\nwith Jazzy",
        "- [ ] Port to Jazzy\n- [x] Humble",
        "| Jazzy | not supported |\n| Humble | supported |",
        "Humble: supported\nJazzy: untested\n",
        "We dropped support for Foxy. Humble is the default.",
        "ROS 2 Humble (not Foxy)",
        "Written for Humble rather than ROS 2 Jazzy",
        "Jazzy support is planned. This is for Humble.",
        "Made with Humble. Do not use Jazzy",
        "不支持 Foxy，仅支持 Humble",
    ],
)
def test_what_is_denied(text: str) -> None:
    assert named(text) == ["humble"]


@pytest.mark.parametrize(
    "text",
    [
        "The Humble version does not support several robots. Jazzy does",
        "Works on Humble but not on Windows. Jazzy needs no patch.",
        "If you are not using Humble, write jazzy instead",
        "It is not available on Humble as a package, nor on Jazzy",
        "Not tested on real robots, but works on Humble and Jazzy",
        "The camera does not work with USB 2.\n\nHumble and Jazzy",
        "It does not run without a GPU; Humble, Jazzy",
    ],
)
def test_what_is_not_denied(text: str) -> None:
    assert named(text) == ["humble", "jazzy"]


def test_a_page_without_such_a_word_is_left_as_it_is() -> None:
    assert without_denied("for humble") == "for humble"


@pytest.mark.parametrize(
    "page, level",
    [
        ("For Humble and Jazzy.\n", "warning"),
        ("For Humble. It will likely not work with newer versions (Rolling).\n", "info"),
        ("For Humble; Jazzy is not supported yet.\n", "info"),
    ],
)
def test_what_stops_in_a_distribution_that_is_denied(page: str, level: str) -> None:
    lines = (
        "find_package(rclcpp REQUIRED)\nadd_executable(node src/node.cpp)\ntarget_link_libraries(node rclcpp::rclcpp)\n"
    )
    files = {
        "package.xml": manifest("  <depend>rclcpp</depend>\n", "ament_cmake"),
        "CMakeLists.txt": CMAKE.replace("ament_package()", f"{lines}ament_package()"),
        "src/node.cpp": "#include <ament_index_cpp/get_package_share_directory.hpp>\nint main() {return 0;}\n",
        "README.md": page,
    }
    assert [each.severity.value for each in lint_files(files, ["CMK121"]).findings] == [level]
