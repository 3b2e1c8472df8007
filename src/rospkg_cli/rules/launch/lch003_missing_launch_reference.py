"""LCH003 missing-launch-reference."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.launch.launch_context import LaunchContext
from ...checks.launch.missing_reference import MissingReference
from ...checks.launch.missing_references import is_made_here, missing_references, references_missed_silently
from ...checks.launch.relative_parameter_files import relative_faults
from ...edits.fault_hits import hits
from ...edits.offers import how_to_have
from ...example import SETUP_PY_FOR_ALL, Example, manifest
from ...finding import Hit, Related, Severity
from ...rule import rule

LAUNCH = """\
<launch>
  <arg name="speed" default="1.0"/>
  <include file="$(find-pkg-share my_pkg)«/launch/wheel.launch.xml»"/>
  <let name="twice" value="$(var speed)"/>
</launch>
"""
PYTHON = """\
import os

from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    config = «os.path.join(get_package_share_directory('my_pkg'), 'config', 'robot_params.yaml')»
    return LaunchDescription([Node(package='my_pkg', executable='talker', parameters=[config])])
"""
SETUP = SETUP_PY_FOR_ALL.replace(
    "    license=", "    entry_points={'console_scripts': ['talker = my_pkg.talker:main']},\n    license="
)
NODE = {
    "package.xml": manifest("  <exec_depend>ros2launch</exec_depend>\n"),
    "setup.py": SETUP,
    "my_pkg/talker.py": "def main():\n    pass\n",
    "config/robot.yaml": "/**:\n  ros__parameters:\n    rate: 2.0\n",
}


@rule(
    "LCH003",
    "missing-launch-reference",
    over=LaunchContext,
    severity=Severity.ERROR,
    levels={
        Severity.WARNING: "a process that is started opens it, it is the default of an argument or in the current "
        "directory, its action has a condition, or the launch file is not installed",
        Severity.INFO: "what uses it is off by default or never added to the launch description, the argument or value "
        "never used, the file itself gives the argument another value, an included one takes no such argument, the "
        "node gets other parameters too, nothing shows that it reads one of that name, or people bring the file",
    },
    examples=(
        Example(
            bad={
                "package.xml": manifest("  <exec_depend>ros2launch</exec_depend>\n"),
                "launch/robot.launch.xml": LAUNCH,
                "launch/wheels.launch.xml": "<launch>\n</launch>\n",
            },
            good={"launch/robot.launch.xml": LAUNCH.replace("«", "").replace("»", "").replace("wheel.", "wheels.")},
        ),
        Example(
            bad={**NODE, "launch/robot.launch.py": PYTHON},
            good={"launch/robot.launch.py": PYTHON.replace("«", "").replace("»", "").replace("robot_params", "robot")},
        ),
    ),
)
def missing_launch_reference(scope: LaunchContext) -> Iterator[Hit]:
    """
    ## What it does
    Finds files that a launch file names and that do not exist.
    It follows paths in the share directory of this package or of another one of the workspace (`$(find-pkg-share x)/…`,
    `FindPackageShare`, `get_package_share_directory`, `MoveItConfigsBuilder`), and paths relative to the launch file. A
    path of which a part is known only when launch runs is reported where no file fits the rest. A parameter file that
    is given by a bare name, while the package installs one of that name, is looked for in the current directory. Of
    well-known packages it knows the launch files, and reports an include with nearly the name of one.

    ## Why is this bad?
    The build is green, and the launch stops at an included file that can't be opened, and at one that it opens itself
    or gives to xacro. All others are warnings: a node whose parameter file is missing starts without what it sets
    ("Parameter file path is not a file"), RViz with its default view, a camera without its calibration
    (`camera_info_url`).

    ## When it is quiet
    Left alone are files that code looks for first (`os.path.exists`, `try`; an info after `except OSError`), that the
    build, Python code or a command (`xacro … -o`) writes, that git ignores, or that a submodule brings; packages of
    which another package's CMake macro may install more; launch files of tests that CMake does not run; and files that
    a package nested in one of its name has (WSP005). It is a warning where the action has a condition that can't be
    evaluated.

    It is an info

    - where the defaults make the condition false, or the action, its function or the value (but to `print` it) is
      unused;
    - for the default of an argument that neither the file nor an included one uses, that only actions use which are off
      by default, or to which the file itself, each including file or each command of pages gives another value;
    - for a parameter file of a node that gets others as well;
    - for the value of a parameter, or an argument of the program, that no code of the node's package, where that is
      here, and no well-known node reads; of other nodes, where its name does not suggest a file (`…_file`, `…_path`,
      `map`, `url`);
    - behind the place where every launch ends, as it looks for a package that nothing brings;
    - where people bring the file and launch does not include it: a page or a script fetches, saves or copies it there
      by its name; its folder has only a README, or a `.gitkeep` where people fill it (`maps`); the launch file prints
      the name; or git ignores a folder that the build installs as a whole (`resource/`);
    - where a program writes it: code puts the name together (`'modified_' + a`) or gets it by a parameter it writes
      to, also from an argument for an output (`save_path`), or the program is called like `octomap_saver_node`;
    - where the name is to be replaced (`YOUR_ROBOT.urdf`, `# use your map`), or is used only where a `glob` found none.
    """
    for each in (*missing_references(scope), *references_missed_silently(scope)):
        if each.state in ("absent", "no slash") and not is_made_here(scope, each):
            from ...checks.launch.softened_references import softened  # few launch files miss a file

            softer, why = softened(scope, each)
            level = Severity(softer) if softer else None if each.stops_launch else Severity.WARNING
            others = tuple(Related(scope.file.path, span, "here too") for span in each.other_spans)
            yield Hit(scope.file.path, each.span, message(scope, each, why), level, others)
    yield from hits(scope.file.path, relative_faults(scope))


def message(scope: LaunchContext, missing: MissingReference, why: str) -> str:
    from ...checks.launch.missing_harm import harm_at  # few launch files miss a file

    return f"{harm_at(scope, missing, why)}; {hint(scope, missing)}"


def hint(scope: LaunchContext, missing: MissingReference) -> str:
    """Return what to do: begin the path with a slash, take the similar path, or make the file."""
    if missing.state == "no slash":
        return "begin it with `/`"
    if missing.better_path:
        other = missing.better_package not in ("", missing.package)
        return f"did you mean `{missing.better_path}`{f' of `{missing.better_package}`' if other else ''}?"
    facts = scope.workspace.named(missing.package)
    return how_to_have(facts, missing.path, scope.package) if facts else "add it, or correct the path"
