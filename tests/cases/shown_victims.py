"""Who meets a fault of CMake: a package here that finds this one, and calls of a command that is defined anew."""

from __future__ import annotations

from rospkg_cli.example import CMAKE, Example, manifest

REDEFINED = "function(ament_add_gtest)\n  message(STATUS hi)\nendfunction()\n"
CALLED = "ament_add_gtest(test_arm test/arm.cpp)\n"
EXTRAS = CMAKE.replace("ament_package()", 'ament_package(CONFIG_EXTRAS "cmake/my_pkg-extras.cmake")')
USES = CMAKE.replace("my_pkg", "user").replace(
    "ament_package", "find_package(my_pkg REQUIRED)\nadd_executable(user a.cpp)\nament_package"
)


def package(lines: str) -> Example:
    text = CMAKE.replace("ament_package", f"{lines}ament_package")
    return Example(bad={"CMakeLists.txt": text}, good={}, on="ament_cmake")


def beside_user(*needs: str) -> Example:
    """A package whose extras require std_msgs, beside one that is built with it."""
    body = "".join(f"  <depend>{name}</depend>\n" for name in ("my_pkg", *needs))
    return Example(
        bad={
            "my_pkg/package.xml": manifest("", "ament_cmake"),
            "my_pkg/CMakeLists.txt": EXTRAS,
            "my_pkg/cmake/my_pkg-extras.cmake": "find_package(std_msgs REQUIRED)\n",
            "user/package.xml": manifest(body, "ament_cmake").replace("<name>my_pkg", "<name>user"),
            "user/CMakeLists.txt": USES,
            "user/a.cpp": "int main() {return 0;}\n",
        },
        good={},
        on="",
    )


CASES = {
    "CMK116": (package(REDEFINED), package(REDEFINED + CALLED)),
    "DEP111": (beside_user(), beside_user("std_msgs"), beside_user("sensor_msgs")),
}
