"""DEP101 undeclared-import."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.depends.undeclared_imports import ImportDependencies, UndeclaredImport
from ...edits.manifest import add_dependency
from ...example import Example, manifest
from ...finding import Fix, Hit, Related, Safety, Severity
from ...rule import rule

BAD = "import rclpy\nfrom «sensor_msgs.msg» import Image\n"


@rule(
    "DEP101",
    "undeclared-import",
    over=ImportDependencies,
    severity=Severity.WARNING,
    levels={Severity.INFO: "where package.xml has it in a comment"},
    examples=(
        Example(
            bad={
                "package.xml": manifest("  <exec_depend>rclpy</exec_depend>\n"),
                "my_pkg/viewer.py": BAD,
            },
            good={
                "package.xml": manifest(
                    "  <exec_depend>rclpy</exec_depend>\n  <exec_depend>sensor_msgs</exec_depend>\n"
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
    A library counts if it has a rosdep key. What setup.py imports is needed to build. Optional imports are left out:
    those under `try` … `except ImportError`, under `TYPE_CHECKING`, and under conditions on the machine. So are tests
    and launch files, which have rules of their own.

    ## Why is this bad?
    It works where the module happens to be installed. On a clean machine `rosdep install` skips what package.xml does
    not name, and the node ends with ModuleNotFoundError; a released package is broken for all users.

    ## References
    - REP-149, exec_depend
    """
    for missing in imports.missing():
        ends = "on a clean machine rosdep does not install it and the import raises ModuleNotFoundError"
        yield undeclared(imports, missing, "exec_depend", ends)
    for missing in imports.missing_in_setup():
        ends = "on a clean machine rosdep does not install it and `colcon build` stops with ModuleNotFoundError"
        yield undeclared(imports, missing, "build_depend", ends)


def undeclared(imports: ImportDependencies, missing: UndeclaredImport, kind: str, ends: str) -> Hit:
    first, *others = missing.places
    tag = f"<{kind}>{missing.name}</{kind}>"
    message = (
        f"package.xml does not declare `{missing.name}`, which is imported here as `{first.module}`: {ends}; add {tag}"
    )
    fix = Fix(f"add {tag}", (add_dependency(imports.declared.manifest, kind, missing.name),))
    related = tuple(Related(place.path, place.span, "and here") for place in others[:3])
    level = Severity.INFO if missing.name in imports.declared.commented_out else None
    return Hit(first.path, first.span, message, level, related, fix)
