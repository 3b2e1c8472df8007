"""SET102 entry-point-attribute-missing."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.python.unwritten_modules import why_left_to_write
from ...checks.setup.module_contents import ModuleContents
from ...checks.setup.started_entry_points import StartedEntryPoints
from ...example import Example, scripts, setup_py
from ...finding import Hit, Severity
from ...rule import rule
from ...suggest import nearest

BAD = {
    "setup.py": setup_py(scripts("talker = my_pkg.talker:«main»")),
    "my_pkg/talker.py": "def mian():\n    print('hello')\n",
}
SCRIPT = "print('hello')\n"


@rule(
    "SET102",
    "entry-point-attribute-missing",
    over=StartedEntryPoints,
    severity=Severity.ERROR,
    levels={
        Severity.WARNING: "the module starts what it does when it is imported, Webots loads its class, or nothing here "
        "starts the program, though others of the package are started",
        Severity.INFO: "a comment says that the function, or the whole module, is still to be written",
    },
    examples=(
        Example(bad=BAD, good={"my_pkg/talker.py": "def main():\n    print('hello')\n"}),
        Example(
            bad={**BAD, "my_pkg/talker.py": "from .speech import say\n", "my_pkg/speech.py": "say = print\n"},
            good={"my_pkg/talker.py": "from .speech import *\n", "my_pkg/speech.py": "main = say = print\n"},
        ),
    ),
)
def entry_point_attribute_missing(started: StartedEntryPoints) -> Iterator[Hit]:
    """
    ## What it does
    Finds entry points whose module exists and does not define the function or class.
    Assignments at the top level, imports, `if` and `try`, star imports from the package's own modules and `__getattr__`
    are understood.

    ## Why is this bad?
    The build is green; starting the executable raises AttributeError, or ImportError with an older setuptools. A module
    that imports `rospy` ends there before: ModuleNotFoundError. A driver for Webots, a class with `init` and `step`, is
    loaded by its name and seldom started so: a warning.

    ## When it is quiet
    Where the module is of another package, can't be read, has a `__getattr__`, or is generated. Where it has a star
    import of something unknown, only a misspelling of a name that it defines itself is reported. It is a warning where
    nothing in the workspace starts or names the program, while another one of the package is started, and an info in an
    exercise: a comment says that the function, or all that the module would hold, is still to be written.
    """
    package, contents = started.package, ModuleContents(started.package)
    for entry in package.setup.entry_points:
        if entry.fault or not entry.attribute or contents.has_attribute(entry.module, entry.attribute):
            continue
        path = package.setup.file_of(entry.module) or ""
        file = package.modules.at(path)
        names = list(file.definitions) if file else []
        near = nearest(entry.attribute.partition(".")[0], names)
        hint = f"; did you mean `{near}`?" if near else "; define it there, or name what is"
        start = f"`ros2 run {package.name} {entry.name}`" if entry.is_script else f"loading `{entry.name}`"
        if contents.runs_when_imported(entry.module):
            message = (
                f"`{path}` has no top-level `{entry.attribute}`: it runs because importing it starts it, and ends with "
                "AttributeError; put that into a function"
            )
            yield Hit(entry.path, entry.attribute_span, message, Severity.WARNING)
            continue
        what, left = f"has no top-level `{entry.attribute.partition('.')[0]}`", started.left(entry)
        message = f"`{path}` {what}: the build is green, and {start} raises AttributeError{hint}"
        is_seldom = bool(left) or contents.is_webots_driver(entry.module)
        if module := contents.ros1_module(entry.module):
            what, is_seldom = f"imports `{module}` of ROS 1 and has no top-level `{entry.attribute}`", bool(left)
            message = f"`{path}` {what}: {start} raises ModuleNotFoundError; port it, or take this line out"
        level = Severity.WARNING if is_seldom else None
        if file and (open_ := why_left_to_write(file, entry.attribute.partition(".")[0])):
            left, level = open_, Severity.INFO
        yield Hit(entry.path, entry.attribute_span, message + left, level)
