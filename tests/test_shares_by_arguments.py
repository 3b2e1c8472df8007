"""A folder that launch files open in the package that an argument names, by default another one (CMK101)."""

from __future__ import annotations

import pytest

from rospkg_cli.example import CMAKE, manifest
from rospkg_cli.testing import lint_files

PACKAGE = {
    "package.xml": manifest("  <exec_depend>ros2launch</exec_depend>\n", "ament_cmake"),
    "CMakeLists.txt": CMAKE.replace(
        "ament_package", "install(DIRECTORY launch DESTINATION share/${PROJECT_NAME})\nament_package"
    ),
    "maps/hall.yaml": "image: hall.pgm\n",
    "maps/hall.pgm": "P5",
}
START = """\
def generate_launch_description():
    declared = DeclareLaunchArgument(
        'description_package',
        description='Package (of the robot) with its maps.',
        default_value={},
    )
    description_package = LaunchConfiguration('description_package')
{}    return LaunchDescription([declared, places])
"""
JOINED = "    places = PathJoinSubstitution([FindPackageShare({}), 'maps', 'hall.yaml'])\n"
HELD = JOINED.format("description_package")
PERFORMED = "    name = {}\n    places = os.path.join(get_package_share_directory(name), 'maps', 'hall.yaml')\n"


def level(default: str, places: str, before: str = "") -> str:
    files = {**PACKAGE, "launch/a.launch.py": before + START.format(default, places)}
    (found,) = lint_files(files, ["CMK101"]).findings
    return found.severity.value


@pytest.mark.parametrize(
    "places",
    [
        HELD,
        JOINED.format("LaunchConfiguration('description_package')"),
        JOINED.format("package=LaunchConfiguration('description_package')"),
        PERFORMED.format("description_package.perform(context)"),
        PERFORMED.format("context.perform_substitution(description_package)"),
        PERFORMED.format("LaunchConfiguration('description_package').perform(context)"),
        PERFORMED.format("context.perform_substitution(LaunchConfiguration('description_package'))"),
        PERFORMED.format("context.launch_configurations['description_package']"),
    ],
)
def test_the_package_is_the_default_of_an_argument(places: str) -> None:
    assert level("'arm_description'", places) == "info"
    assert level("'my_pkg'", places) == "error"
    assert level("find_it()", places) == "error"
    assert level("''", places) == "error"


def test_a_default_in_a_variable() -> None:
    assert level("ROBOT", HELD, "ROBOT = 'arm_description'\n") == "info"
    assert level("ROBOT", HELD, "ROBOT = 'my_pkg'\n") == "error"
    assert level("ROBOT", HELD, "ROBOT = find()\n") == "error"


def test_arguments_whose_defaults_differ() -> None:
    other = "OTHER = DeclareLaunchArgument('description_package', default_value='my_pkg')\n"
    assert level("'arm_description'", HELD, other) == "error"
