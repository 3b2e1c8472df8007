"""Headers that are included from the folder of the package's former name, with another digit (CMK201)."""

from __future__ import annotations

from rospkg_cli.example import CMAKE, Example, manifest

PROGRAM = """\
include_directories(include)
add_executable(talker src/talker.cpp)
install(TARGETS talker DESTINATION lib/${PROJECT_NAME})
install(DIRECTORY include/ DESTINATION include)
"""
OWN = {"include/my_pkg/words.h": "int words();\n"}


def includes(header: str, body: str = "", files: dict[str, str] | None = None) -> Example:
    text = CMAKE.replace("ament_package", f"{PROGRAM}ament_package")
    source = {"src/talker.cpp": f"#include <{header}>\nint main() {{return 0;}}\n"}
    package = {"package.xml": manifest(body, "ament_cmake"), "CMakeLists.txt": text, **source, **OWN, **(files or {})}
    return Example(bad=package, good={}, on="ament_cmake")


CASES = {
    "CMK201": (
        includes("my_pkg2/words.hpp"),
        includes("my_pkg_1/words.h"),
        includes("my_pkg2/verbs.hpp"),
        includes("my_pkg2/words.hpp", "  <depend>my_pkg2</depend>\n"),
        includes("my_pkg2/words.hpp", "", {"third_party/my_pkg2/words.hpp": "int words();\n"}),
        includes("my_pkgs2/words.hpp"),
        includes("your_pkg2/words.hpp"),
        includes("boost/words.hpp"),
    ),
}
