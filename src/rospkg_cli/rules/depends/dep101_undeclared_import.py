"""DEP101 undeclared-import."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.depends.name_source import is_left_out
from ...checks.depends.undeclared_imports import ImportDependencies, UndeclaredImport
from ...edits.undeclared_hits import BroughtUse, advice, declaration, left_to_others, related
from ...example import Example, manifest
from ...finding import Hit, Related, Safety, Severity
from ...rule import rule

RUN = "rosdep does not install it, and the import raises ModuleNotFoundError"
BUILD = "rosdep does not install it, and `colcon build` stops with ModuleNotFoundError"

BAD = "import rclpy\nfrom «trajectory_msgs.msg» import JointTrajectory\n"


@rule(
    "DEP101",
    "undeclared-import",
    over=ImportDependencies,
    severity=Severity.WARNING,
    levels={
        Severity.INFO: "where a declared dependency brings or may bring it, where package.xml has it in a comment, and "
        "where only PyPI has it"
    },
    examples=(
        Example(
            bad={
                "package.xml": manifest("  <exec_depend>rclpy</exec_depend>\n"),
                "my_pkg/viewer.py": BAD,
            },
            good={
                "package.xml": manifest(
                    "  <exec_depend>rclpy</exec_depend>\n  <exec_depend>trajectory_msgs</exec_depend>\n"
                )
            },
            fix=Safety.SAFE,
        ),
        Example(
            bad={"my_pkg/viewer.py": "import «cv2»\n"},
            good={"package.xml": manifest("  <exec_depend>python3-opencv</exec_depend>\n")},
            fix=Safety.SAFE,
        ),
    ),
)
def undeclared_import(imports: ImportDependencies) -> Iterator[Hit]:
    """
    ## What it does
    Finds imports of ROS packages and Python libraries that package.xml does not declare.
    A library counts if it has a rosdep key. What setup.py imports is needed to build. Tests and launch files have rules
    of their own.

    ## Why is this bad?
    It works where the module happens to be installed. On a clean machine `rosdep install` skips what package.xml does
    not name, and the node ends with ModuleNotFoundError; a released package is broken for all users.

    ## When it is quiet
    Of a file that imports `rospy` only that is said, for nothing behind it runs, and of several such files once. What a
    declared dependency certainly installs, be it for tests or the build, can't be missing where `rosdep install` ran,
    nor can what rosdep itself needs (PyYAML): that is one info, which names who brings it. What may come with a
    declared one is another: with a package that is neither here nor in the table of what is installed with what,
    anything may come. Left out are optional imports: under `try` … `except ImportError`, `TYPE_CHECKING`, a condition
    on the machine, or one that asks for the package (`if 'pkg' in get_packages_with_prefixes()`), and branches that
    never run. So are files that nothing installs, and the package's own modules.

    ## Fix safety
    The fix is unsafe where only PyPI has the library, where no released package has the name, or where a comment of
    package.xml leaves it out.

    ## References
    - REP-149, exec_depend
    """
    brought: list[BroughtUse] = []
    run, setup = imports.missing(), imports.missing_in_setup()
    for kind, found, ends in (("exec_depend", run, RUN), ("build_depend", setup, BUILD)):
        for missing in found:
            if missing.bringer:
                first = missing.places[0]
                brought.append(BroughtUse(missing.name, missing.bringer, kind, first.path, first.span))
            else:
                yield undeclared(imports, missing, kind, ends)
    yield from left_to_others(imports.declared, brought, "imported")
    if leftovers := list(imports.ros1_leftovers()):
        first, *others = leftovers
        files, end = (f"this file and {len(others)} more", "end") if others else ("this file", "ends")
        message = (
            f"`{first.module}` is a module of ROS 1: {files} {end} with ModuleNotFoundError before anything else; port "
            f"{'them' if others else 'it'} to rclpy, or do not install {'them' if others else 'it'}"
        )
        places = tuple(Related(each.path, each.span, "and here") for each in others)
        yield Hit(first.path, first.span, message, related=places)


def undeclared(imports: ImportDependencies, missing: UndeclaredImport, kind: str, ends: str) -> Hit:
    first, declared = missing.places[0], imports.declared
    shown = "" if missing.name == first.module.partition(".")[0] else f" here as `{first.module}`"
    message = (
        f"`{missing.name}` is imported{shown} and not declared: on a clean machine {ends}; "
        f"{advice(declared, kind, missing.name)}"
    )
    places = related((place.path, place.span) for place in missing.places)
    mild = is_left_out(declared, missing.name)
    fix = declaration(declared, kind, missing.name)
    return Hit(first.path, first.span, message, Severity.INFO if mild else None, places, fix)
