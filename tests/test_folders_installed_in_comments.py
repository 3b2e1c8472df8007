"""A folder whose install rule is a comment of CMakeLists.txt was left out on purpose, unless something opens it."""

from __future__ import annotations

import pytest

from rospkg_cli.example import CMAKE, manifest
from rospkg_cli.testing import lint_files

PACKAGE = {
    "package.xml": manifest("", "ament_cmake"),
    "launch/robot.launch.xml": "<launch>\n</launch>\n",
}
README = {"README.md": "Run `ros2 launch my_pkg robot.launch.xml`.\n"}
RULE = "# install(DIRECTORY {} DESTINATION share/${{PROJECT_NAME}})\n"


def told(comment: str, **more: str) -> tuple[str, bool]:
    cmake = CMAKE.replace("ament_package", f"{comment}\nament_package")
    (found,) = lint_files({**PACKAGE, "CMakeLists.txt": cmake, **more}, ["CMK101"]).findings
    return found.severity.value, "a comment of CMakeLists.txt installs it" in found.message


@pytest.mark.parametrize(
    "comment",
    [
        RULE.format("launch"),
        RULE.format("config launch/"),
        RULE.format("${CMAKE_CURRENT_SOURCE_DIR}/launch"),
        "# # Install launch files.\n# install(DIRECTORY\n#   launch\n#   DESTINATION share/${PROJECT_NAME}/\n# )\n",
        "# install(TARGETS a DESTINATION lib)\n\n# # install(\n# #   DIRECTORY launch\n# #   DESTINATION b)\n",
        "#[[\ninstall(DIRECTORY launch\n  DESTINATION share/${PROJECT_NAME})\n]]\n",
    ],
)
def test_a_folder_that_a_comment_installs(comment: str) -> None:
    assert told(comment) == ("info", True)
    assert told(comment, **README) == ("error", False)


@pytest.mark.parametrize(
    "comment",
    [
        "",
        RULE.format("config"),
        RULE.format("${other}/launch"),
        "# install(DIRECTORY config DESTINATION launch)\n",
        "# install the launch folder\n",
        "# install(TARGETS launch DESTINATION lib)\n",
    ],
)
def test_a_folder_that_no_comment_installs(comment: str) -> None:
    assert told(comment) == ("warning", False)


def test_a_folder_that_another_package_opens() -> None:
    needs = "  <exec_depend>my_pkg</exec_depend>\n  <export>"
    launch = '<launch>\n  <include file="$(find-pkg-share my_pkg)/launch/robot.launch.xml"/>\n</launch>\n'
    user = {
        "user/package.xml": manifest("", "ament_cmake", "user").replace("  <export>", needs),
        "user/launch/a.launch.xml": launch,
    }
    cmake = CMAKE.replace("ament_package", f"{RULE.format('launch')}\nament_package")
    own = {f"own/{path}": text for path, text in {**PACKAGE, "CMakeLists.txt": cmake}.items()}
    found = lint_files({**own, **user}, ["CMK101"]).findings
    assert [each.severity.value for each in found if each.location.path.startswith("own/")] == ["warning"]
