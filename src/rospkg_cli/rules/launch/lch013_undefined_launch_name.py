"""LCH013 undefined-launch-name."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.depends.unwritten_parts import why_open
from ...checks.launch.late_names import late_names
from ...checks.launch.wrong_imports import wrong_attributes, wrong_imports
from ...checks.python.module_attributes import absent_attributes
from ...example import Example, manifest
from ...finding import Hit, Severity
from ...languages.python.file import PythonFile
from ...languages.python.place_kinds import is_in_branch, is_passed_over
from ...languages.python.undefined_names import UndefinedName, undefined_names
from ...languages.python.unreached_functions import unreached_functions
from ...light_dataclasses import dataclass
from ...package.launch.launch_evaluator import ENTRIES, stops_with
from ...package.launch.launch_file import LaunchFile
from ...rule import rule

NEEDED = manifest("  <exec_depend>ros2launch</exec_depend>\n")
BAD = """\
from launch import LaunchDescription
from launch.actions import LogInfo


def generate_launch_description():
    return LaunchDescription([
        «DeclareLaunchArgument»('rate', default_value='10'),
        LogInfo(msg='up'),
    ])
"""
BAD_IMPORT = """\
from launch import LaunchDescription
from launch.actions import LogInfo
from launch.substitutions import «FindPackageShare»


def generate_launch_description():
    return LaunchDescription([LogInfo(msg=FindPackageShare('my_pkg'))])
"""

LEVELS = (None, Severity.WARNING, Severity.INFO)


@dataclass(frozen=True, slots=True)
class UseOfName:
    """A use of an undefined name, and how bad it is."""

    found: UndefinedName
    level: Severity | None
    ends: str


@rule(
    "LCH013",
    "undefined-launch-name",
    over=LaunchFile,
    severity=Severity.ERROR,
    levels={
        Severity.WARNING: "the name is used in one branch of an `if`, or in an annotation",
        Severity.INFO: "the function that uses it is never called, or a comment asks for the name",
    },
    examples=(
        Example(
            bad={"package.xml": NEEDED, "launch/a.launch.py": BAD},
            good={"launch/a.launch.py": BAD.replace("import LogInfo", "import DeclareLaunchArgument, LogInfo")},
        ),
        Example(
            bad={"package.xml": NEEDED, "launch/a.launch.py": BAD_IMPORT},
            good={"launch/a.launch.py": BAD_IMPORT.replace("launch.sub", "launch_ros.sub")},
        ),
    ),
)
def undefined_launch_name(file: LaunchFile) -> Iterator[Hit]:
    """
    ## What it does
    Finds undefined names and wrong launch imports in Python launch files.
    A name is neither defined nor imported, a name of launch or launch_ros is imported from a module that does not have
    it or read from one (`launch.substitution.x`), one that a module of Python does not have (`os.path.joint`), or a
    local name is used above the one line of its function that assigns it.

    ## Why is this bad?
    The launch stops with a NameError as soon as the name is used (often only for one value of an argument), or with an
    ImportError at once.

    ## When it is quiet
    Left alone are files that import `*`, that run strings as code or use `locals()`, and optional imports (`try …
    except ImportError`). It is an info, once for each, in a function that is never called: neither the function that
    launch calls (in a test, `generate_test_description`) nor the module level leads to it, by calls or by its name
    (`OpaqueFunction(function=setup)`), or only an uncalled method calls it. It is an info in a branch that is never
    taken (`DEBUG = False` … `if DEBUG:`), and for a name of which a comment says that it is still to be defined.
    """
    if file.python is None or not file.has_entry_point:
        return
    found: dict[str, list[UseOfName]] = {}
    wrong = list(wrong_imports(file.python))
    for name in undefined_names(file.python, with_types=True):
        if name.name not in {each.near for each in wrong}:  # its import is misspelt
            found.setdefault(name.name, []).append(weighed(file.python, name))
    for uses in found.values():
        use = min(uses, key=lambda one: LEVELS.index(one.level))
        from ...checks.launch.intended_names import hint  # few launch files have an undefined name

        left = why_open(file.python, use.found.name, use.found.span)
        message = f"`{use.found.name}` is defined nowhere: {use.ends}{left or hint(use.found)}"
        yield Hit(file.path, use.found.span, message, Severity.INFO if left else use.level)
    for late in late_names(file.python):
        unreached = {each.name for each in unreached_functions(file.python, ENTRIES)}
        level = Severity.INFO if late.function in unreached else None
        message = f"`{late.name}` is used here and assigned in line {late.line}"
        message = f"{message}: {stops_with(file.python)} UnboundLocalError; assign it first"
        yield Hit(file.path, late.span, message, level)
    for each in (*wrong, *wrong_attributes(file.python)):
        better = f"import it from `{each.home}`" if each.home else f"did you mean `{each.near}`?"
        raised = "AttributeError" if each.is_attribute else "ImportError"
        message = f"`{each.module}` has no `{each.name}`: {stops_with(file.python)} {raised}; {better}"
        yield Hit(file.path, each.span, message)
    for absent in absent_attributes(file.python):
        use = weighed(file.python, UndefinedName(absent.name, absent.span, frozenset()))
        ends = use.ends.replace("NameError", absent.raised)
        message = f"`{absent.module}` has no `{absent.name}`: {ends}{absent.advice}"
        yield Hit(file.path, absent.span, message, use.level)


def weighed(file: PythonFile, found: UndefinedName) -> UseOfName:
    """Return a use with its level, and with what happens there."""
    for each in unreached_functions(file, ENTRIES):
        if file.span(each.body[0]).start <= found.span.start < file.span(each.body[-1]).end:
            ends = f"`{each.name}` raises NameError once something calls it, which nothing here does"
            return UseOfName(found, Severity.INFO, ends)
    if is_passed_over(file, found.span):
        return UseOfName(found, Severity.INFO, "Python raises NameError in a branch that it never takes")
    ends = f"{stops_with(file)} NameError"
    if found.is_annotation:
        return UseOfName(found, Severity.WARNING, f"before Python 3.14, which Lyrical has, {ends}")
    if is_in_branch(file, found.span):
        return UseOfName(found, Severity.WARNING, f"{ends} where it gets here")
    return UseOfName(found, None, ends)
