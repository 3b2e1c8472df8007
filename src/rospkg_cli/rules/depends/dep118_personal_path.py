"""DEP118 personal-path."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from ...checks.home_paths.home_path import HomePath
from ...checks.home_paths.home_paths import HomePaths
from ...checks.home_paths.share_advice import WHY, advice, giver, image_advice
from ...example import SETUP_PY_FOR_ALL, Example, manifest
from ...finding import Hit, Related, Severity
from ...rule import rule

LAUNCH = """\
from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription(
        [Node(package='my_pkg', executable='talker', parameters=[{}])]
    )
"""
SHARE = "from ament_index_python.packages import get_package_share_path\n"
SETUP = SETUP_PY_FOR_ALL.replace(
    "    license=", "    entry_points={'console_scripts': ['talker = my_pkg.talker:main']},\n    license="
)
FILES = {
    "package.xml": manifest(
        "  <exec_depend>ament_index_python</exec_depend>\n"
        "  <exec_depend>launch</exec_depend>\n"
        "  <exec_depend>launch_ros</exec_depend>\n"
        "  <exec_depend>ros2launch</exec_depend>\n"
    ),
    "setup.py": SETUP,
    "my_pkg/talker.py": "def main():\n    pass\n",
    "config/robot.yaml": "/**:\n  ros__parameters:\n    rate: 2.0\n",
}


@rule(
    "DEP118",
    "personal-path",
    over=HomePaths,
    severity=Severity.WARNING,
    levels={
        Severity.INFO: "the file is not of the workspace, many have an account of that name, code asks or tries "
        "something else first, nothing installs, compiles, starts or names the file, YAML or launch files replace it, "
        "a switch is off, nothing leads to the function or reads the variable or argument, the launch ends before, "
        "something writes the file, a comment or page says to change it, it is one of several places for modules, a "
        "dialog for files begins there, it is for another machine, YAML has it and the repository no such file, a "
        "launch file has it without a suffix and no file is called so, or no code here or known node is shown to read "
        "a value of YAML by its key"
    },
    examples=(
        Example(
            bad={**FILES, "launch/robot.launch.py": LAUNCH.format("'«/home/ada/ws/src/my_pkg/config/robot.yaml»'")},
            good={
                "launch/robot.launch.py": SHARE
                + LAUNCH.format("str(get_package_share_path('my_pkg') / 'config' / 'robot.yaml')")
            },
        ),
        Example(
            bad={
                **FILES,
                "maps/office.pgm": "P2 1 1 1 0\n",
                "maps/office.yaml": "image: «/home/ada/ws/src/my_pkg/maps/office.pgm»\nresolution: 0.05\n",
            },
            good={"maps/office.yaml": "image: office.pgm\nresolution: 0.05\n"},
        ),
    ),
)
def personal_path(paths: HomePaths) -> Iterator[Hit]:
    """
    ## What it does
    Finds paths in one person's home folder.
    Launch files, YAML, CMakeLists.txt and code are read for `/home/ada/…` and `/Users/ada/…`. Those of a package are
    one finding; those that lead to files of the workspace are apart from the others.

    ## Why is this bad?
    The package works on one machine. Everybody else gets "No such file or directory", or a node that starts with its
    defaults, and there where the workspace is moved or only installed.

    ## When it is quiet
    Tests, comments, texts that are only shown (descriptions, help, logs), what a substitution fills in, what is under a
    condition that never holds on Linux, and paths below the home of an account that robots, containers and examples
    have (`/home/ubuntu`), of one that a Dockerfile or a unit of systemd names, or in code that asks whether something
    exists or tries something else first (`except`, `catch`, `or`), unless they lead into the workspace: then they are
    an info. So is the default of a parameter for which all YAML of the package that gives it has another value, or
    launch files have one, a value of YAML that they replace (nav2's, by its argument `map`, too), what RViz or YAML
    that nothing names has, a script in a folder that is none for code, a program that nothing starts while others are,
    what code goes on without (`except OSError`), a default that all callers give (of a function, or of an argument,
    where they start or include the launch file), what is for a machine that code asks for (`gethostname`) or `ssh`
    leads to, the default of an environment variable or option that what is run gives, a launch file whose twin in
    another language alone is named, a source that no target compiles, or a part of one under a macro that nothing
    defines, a header that no compiled file includes and nothing installs, a module that nothing starts or imports while
    others are, or only such modules, a launch file or script that nothing installs or names, one that setup.py puts
    among the programs without the bit to be executed, a function that no program leads to, an action that a launch file
    never adds, what a switch or an option turns off or a default does not choose, a variable, constant or member which
    nothing reads, the folder in which a dialog for files begins, and what a comment at it, or a line of a page that
    names the file or the home, says to change. A script that nothing names is left too where it is only a part of a
    folder in the share directory, or where not all that is installed is known and CMake does not name its folder. A
    value of YAML or a launch file without a suffix that is the path of no file or folder is an info as well: what reads
    it adds a suffix (slam_toolbox's `map_file_name`), or writes there. So is one of YAML that no file here ends with
    (but for the image of a map), the default of an argument that nothing reads, and what is written or made:
    `open(…, 'w')`, `np.save`, `ofstream`, `makedirs`, `map_saver_cli -f`, a parameter called `output_dir`, also by
    another name, a parameter or a function of the same file, or with a value of YAML, and none of them reads. And so is
    a value of YAML that nothing is shown to read: no code of the workspace declares the parameter or has its key as a
    text or attribute, and no well-known node has it in a supported distribution (bt_navigator has no
    `default_bt_xml_filename` after Foxy), unless the repository is only for those that have it; in launch files it is
    one of a parameter that the node, if its code or parameters are known, does not have, or whose name else says
    nothing of a file. Robots and worlds are URD002's.
    """
    into = sorted((each for each in paths.found if each.of_package is not None), key=is_mild)
    others = [each for each in paths.found if each.of_package is None and not each.may_be_there]
    if into:
        yield one(into, Severity.INFO if is_mild(into[0]) else Severity.WARNING, advice(paths, into[0]))
    if others:
        in_build = others[0].path.endswith("CMakeLists.txt")
        how = "find it with find_package() or find_path()" if in_build else image_advice(paths, others[0])
        yield one(others, Severity.INFO, how or giver(paths, others[0]))


def is_mild(found: HomePath) -> bool:
    return found.may_be_there or found.is_seldom_read or any(getattr(found, each) for each in WHY)


def one(found: Sequence[HomePath], level: Severity, how: str) -> Hit:
    first, *others = found
    again = tuple(Related(each.path, each.span, f"`{each.text}` too") for each in others)
    more = f" and {len(others)} more" if others else ""
    verb, them = ("are", "they are") if others else ("is", "it is")
    message = f"`{first.text}`{more} {verb} on one machine: elsewhere {them} missing; {how}"
    reasons = {name: why for name, why in WHY.items() if first.of_package or name != "is_unclaimed"}
    why = next((why for name, why in reasons.items() if all(getattr(each, name) for each in found)), "")
    return Hit(first.path, first.span, f"{message}{why}", level, again)
