"""DEP111 unexported-find-package."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.depends.handed_on_packages import HandedOnPackages
from ...checks.depends.required_by_cmake import OF_CMAKE
from ...edits.undeclared_dependency import declaration
from ...example import CMAKE, Example, manifest
from ...finding import Hit, Safety, Severity
from ...ros.manifest import is_buildtool
from ...rule import rule

EXTRAS = CMAKE.replace("ament_package()", 'ament_package(CONFIG_EXTRAS "cmake/my_pkg-extras.cmake")')


@rule(
    "DEP111",
    "unexported-find-package",
    over=HandedOnPackages,
    severity=Severity.WARNING,
    levels={
        Severity.INFO: "where something that is handed on may bring it, or no package of the workspace that is built "
        "with this one lacks it, and it is no library for others, or rosdep installs it here and "
        "nothing shows a release"
    },
    examples=(
        Example(
            on="ament_cmake",
            bad={
                "CMakeLists.txt": EXTRAS,
                "cmake/my_pkg-extras.cmake": "find_package(«std_msgs» REQUIRED)\n",
            },
            good={
                "package.xml": manifest("  <build_export_depend>std_msgs</build_export_depend>\n", "ament_cmake"),
            },
            fix=Safety.SAFE,
        ),
    ),
)
def unexported_find_package(packages: HandedOnPackages) -> Iterator[Hit]:
    """
    ## What it does
    Finds packages that CMake files for others require and package.xml does not hand on.
    The files that `ament_package(CONFIG_EXTRAS …)` names run in every package that finds this one. What they require
    must be a `<build_export_depend>`, a `<buildtool_export_depend>`, or a `<depend>`. What
    `ament_export_dependencies()` names must be one of these or an `<exec_depend>`; what is found and not declared at
    all is another matter (DEP104).

    ## Why is this bad?
    Where a release is installed, or nothing else brings it, the CMake of each package that uses this one stops with
    "Could not find a package configuration file".

    ## When it is quiet
    What comes with a package that is handed on is there; where that is not known of each of them, it is an info. Calls
    in blocks (`if`, functions, macros) and without REQUIRED are left alone. It is an info, too, where no package of the
    workspace is built with this one and lacks what is missing, unless it is a library for others. `rosdep
    install` installs what the packages of a repository declare for their own builds, too: such a requirement is a
    warning only where the repository is visibly released, or where the package required lies in the workspace itself.

    ## Fix safety
    The fix is unsafe where no released package has the name, or a comment of package.xml leaves it out.

    ## References
    - REP-149, build_export_depend and buildtool_export_depend
    """
    for each in packages.missing():
        name = each.names[0]
        tag = "buildtool_export_depend" if is_buildtool(name) else "build_export_depend"
        stops = (
            f"Could NOT find {each.cmake}" if each.cmake in OF_CMAKE else "Could not find a package configuration file"
        )
        where = "in a release" if each.is_installed else "on a clean machine"
        message = (
            f"every package that uses this one requires `{each.cmake}` here, and package.xml does not hand it on: "
            f'{where} their CMake stops with "{stops}"; add <{tag}>{name}</{tag}>'
        )
        level = None if each.is_certain else Severity.INFO
        yield Hit(each.path, each.span, message, level, fix=declaration(packages.declared, tag, name))
