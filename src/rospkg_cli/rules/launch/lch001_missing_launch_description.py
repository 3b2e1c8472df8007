"""LCH001 missing-launch-description."""

from __future__ import annotations

import re
from collections.abc import Iterator

from ...checks.launch.launch_context import LaunchContext
from ...checks.launch.launch_modules import describes_nothing, is_imported, makes_its_own
from ...checks.python.unwritten_modules import why_left_to_write
from ...example import Example, manifest
from ...finding import Hit, Severity
from ...lazy_regex import regex
from ...package.file_role import role_of
from ...rule import rule
from ...source import Span

STARTABLE = regex(r"(.*[._-])?launch\.py", re.IGNORECASE)

GOOD = """\
from launch import LaunchDescription


def generate_launch_description():
    return LaunchDescription([])
"""


IN_LAUNCH = regex(r"(?:^|/)launch(?:es)?/")


@rule(
    "LCH001",
    "missing-launch-description",
    over=LaunchContext,
    severity=Severity.ERROR,
    levels={
        Severity.INFO: "the file has only comments, imports nothing of launch, or a comment asks for code to be written"
    },
    examples=(
        Example(
            bad={
                "package.xml": manifest("  <exec_depend>ros2launch</exec_depend>\n"),
                "launch/robot.launch.py": "«»" + GOOD.replace("generate_launch_description", "launch_description"),
            },
            good={"launch/robot.launch.py": GOOD},
        ),
    ),
)
def missing_launch_description(scope: LaunchContext) -> Iterator[Hit]:
    """
    ## What it does
    Finds Python launch files without a function `generate_launch_description`.
    Checked are `*.launch.py` and `*_launch.py`.

    ## Why is this bad?
    `ros2 launch` loads the file and ends with "launch file at '…' does not contain the required function
    'generate_launch_description()'".

    ## When it is quiet
    Left alone are

    - files whose name does not end in `launch.py`, modules outside of launch folders (`my_pkg/gen_launch.py`), and
      tests;
    - files that are programs (`__main__`, `LaunchService`), that import `*`, or that another Python file of the package
      imports or loads;
    - files with a function under a decorator of another package, which may make the entry point (`@launch_this`).

    A function that is imported or assigned counts as defined. It is an info where every line of the file is a comment,
    where the file imports nothing of `launch`, and in an exercise: a comment says that the function, or the whole file,
    is still to be written.
    """
    file = scope.file
    name = file.path.rpartition("/")[2]
    is_module = name.endswith("_launch.py") and not IN_LAUNCH.search(file.path)
    installed = role_of(file.path) == "launch" and not is_module
    if file.python is None or file.has_entry_point or not installed or not STARTABLE.fullmatch(name):
        return
    if makes_its_own(file.python) or is_imported(file.path, scope.files):
        return
    message = (
        f"`{name}` defines no `generate_launch_description`: `ros2 launch` refuses it; define it, "
        f"or give a file that others import another ending"
    )
    left = why_left_to_write(file.python, "generate_launch_description")
    is_mild = bool(left) or describes_nothing(file.python)
    yield Hit(file.path, Span(0, 0), message + left, Severity.INFO if is_mild else None)
