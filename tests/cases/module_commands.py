"""Commands of modules of CMake that nothing includes (CMK114), and silences."""

from __future__ import annotations

from rospkg_cli.example import CMAKE, Example, manifest

ASKS = "pkg_check_modules(PARTS REQUIRED parts)\n"
BODY = "  <buildtool_depend>pkg-config</buildtool_depend>\n  <depend>rclcpp</depend>\n"


def asks(before: str, call: str = ASKS, files: dict[str, str] | None = None) -> Example:
    text = CMAKE.replace("ament_package", f"{before}{call}ament_package")
    return Example(
        bad={"package.xml": manifest(BODY, "ament_cmake"), "CMakeLists.txt": text, **(files or {})},
        good={},
        on="ament_cmake",
    )


CASES = {
    "CMK114": (
        asks(""),
        asks("find_package(rclcpp REQUIRED)\n"),
        asks("find_package(PkgConfig REQUIRED)\n"),
        asks("find_package(PkgConfig)\nif(PkgConfig_FOUND)\n", f"{ASKS}endif()\n"),
        asks("if(WITH)\n  find_package(PkgConfig)\nendif()\n"),
        asks("include(FindPkgConfig)\n"),
        asks("include(${WHERE}/parts.cmake)\n"),
        asks("if(WITH)\n", f"{ASKS}endif()\n"),
        asks("function(pkg_check_modules)\nendfunction()\n"),
        asks("find_package(Parts)\n", files={"cmake/FindParts.cmake": "find_package(PkgConfig)\n"}),
        asks("", f"{ASKS}find_package(PkgConfig)\n"),
        asks("", "check_cxx_compiler_flag(-mavx2 HAS_AVX2)\n"),
        asks("", "FetchContent_Declare(parts URL https://example.com/parts.zip)\n"),
        asks("include(FetchContent)\n", "FetchContent_Declare(parts URL https://example.com/parts.zip)\n"),
        asks("", "cmake_dependent_option(A b ON C OFF)\ngenerate_export_header(core)\n"),
    ),
}
