"""Findings to look at, as a linter of today words them: of a beginner's package, and of forty packages from a seed.

They are written here and not found, so that the screens show the layout and don't change with a rule.
"""

from __future__ import annotations

from random import Random

from rospkg_cli.engine.run.results import Results
from rospkg_cli.finding import Edit, Finding, Fix, Location, Safety, Severity
from rospkg_cli.source import Span

SEED = 18
PARTS = ("arm", "base", "camera", "dock", "gripper", "lidar", "map", "planner", "route", "teleop")
KINDS = ("bringup", "core", "msgs_tools", "utils")
NAMES = ("rviz2", "tf2_ros", "robot_state_publisher", "nav2_map_server", "rosbag2_transport", "lifecycle_msgs")

Shape = tuple[str, str, Severity, str, str, str, str]
"""Code, name, level, path, line of source (`«…»` around the spot), message, title of the fix; `{p}` is the package,
`{n}` a name."""

SHAPES: tuple[Shape, ...] = (
    (
        "SET101", "entry-point-module-missing", Severity.ERROR, "setup.py",
        "            'start = «{p}.start_{n}»:main',",
        "there is no module `{p}.start_{n}`: the build is green, and `ros2 run {p} start` raises ModuleNotFoundError",
        "",
    ),
    (
        "PLG002", "unexported-plugin", Severity.ERROR, "plugins.xml",
        '    <class type="«{p}::Checker»" base_class_type="nav2_core::GoalChecker" name="a/very/long/name/of/{n}">',
        "no source exports `{p}::Checker`: loading it fails; add "
        "`PLUGINLIB_EXPORT_CLASS({p}::Checker, nav2_core::GoalChecker)` to its source, or remove it here",
        "",
    ),
    (
        "DEP103", "undeclared-launch-package", Severity.WARNING, "launch/{n}.launch.py",
        "        package='«{n}»',",
        "`{n}` is not declared, and this launch file starts a node of it: on a clean machine rosdep does not "
        "install it and the launch ends with \"package '{n}' not found\"",
        "Add <exec_depend>{n}</exec_depend>",
    ),
    (
        "DEP102", "undeclared-test-import", Severity.WARNING, "test/test_{p}_launch.py",
        "from «{n}.msg» import Message",
        "`{n}` is not declared, which this test imports as `{n}.msg`: `colcon test` fails with ModuleNotFoundError",
        "Add <test_depend>{n}</test_depend>",
    ),
    (
        "XML104", "placeholder-metadata", Severity.WARNING, "package.xml",
        "  <description>«The {p} package»</description>",
        "the description only repeats the package's name; say in one sentence what the package does",
        "",
    ),
    (
        "XML306", "missing-exported-file", Severity.WARNING, "package.xml",
        '    <nav2_core plugin="«{n}.xml»"/>',
        "`{n}.xml`, exported to `nav2_core`, does not exist: ROS 2 goes by what CMake exports; "
        "add the file or fix the line",
        "",
    ),
    (
        "DEP105", "undeclared-include", Severity.INFO, "src/{n}.cpp",
        '#include "«{n}/header.hpp»"',
        "`{n}` is not declared, and its `{n}/header.hpp` is included: another dependency brings it",
        "Add <depend>{n}</depend>",
    ),
)  # fmt: skip


def finding(shape: Shape, package: str, name: str, folder: str, line: int) -> Finding:
    code, title, level, path, source, message, fix = (
        part.replace("{p}", package).replace("{n}", name) if isinstance(part, str) else part for part in shape
    )
    assert isinstance(level, Severity)
    start, end = source.index("«"), source.index("»") - 1
    span = Span(100 * line, 100 * line + end - start)
    place = Location(f"{folder}{path}", span, line, start + 1, line, end + 1)
    safety = Safety.UNSAFE if code == "DEP102" and line % 7 == 0 else Safety.SAFE
    repair = Fix(fix, (Edit(f"{folder}package.xml", Span(0, 0), "x"),), safety) if fix else None
    excerpt = source.replace("«", "").replace("»", "")
    return Finding(code, title, level, message, place, package, excerpt, fix=repair)


def forty() -> Results:
    """Return the results of a run over forty packages in ten repositories; the same ones each time."""
    random = Random(SEED)
    found = []
    for part in PARTS:
        for kind in KINDS:
            package, folder = f"{part}_{kind}", f"src/{part}_stack/{part}_{kind}/"
            for _ in range(random.choice((0, 0, 0, 1, 2, 5))):
                shape = random.choices(SHAPES, (2, 2, 12, 10, 3, 2, 14))[0]
                found.append(finding(shape, package, random.choice(NAMES), folder, random.randrange(3, 200)))
    return Results(tuple(sorted(found, key=lambda each: each.sort_key)), packages=40, files=1234)


def beginner() -> Results:
    """Return the results of a run over a first package."""
    found = [finding(shape, "my_robot", "rviz2", "", 10 + 3 * number) for number, shape in enumerate(SHAPES)]
    return Results(tuple(sorted(found, key=lambda each: each.sort_key)), packages=1, files=14)
