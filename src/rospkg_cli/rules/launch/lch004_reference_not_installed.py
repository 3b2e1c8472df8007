"""LCH004 reference-not-installed."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from ...checks.launch.missing_reference import MissingReference
from ...checks.launch.reference_install import InstalledReferences, ReferenceInstall
from ...edits.install_file import install_for_cmake, install_for_setup
from ...example import CMAKE, Example, manifest
from ...finding import Edit, Fix, Hit, Related, Safety, Severity
from ...rule import rule

LAUNCH = """\
<launch>
  <include file="$(find-pkg-share my_pkg)«/launch/wheels.launch.xml»"/>
</launch>
"""
ONE = CMAKE.replace(
    "ament_package",
    "install(FILES launch/robot.launch.xml\n  DESTINATION share/${PROJECT_NAME}/launch\n)\nament_package",
)
BOTH = ONE.replace("robot.launch.xml", "robot.launch.xml launch/wheels.launch.xml")


@rule(
    "LCH004",
    "reference-not-installed",
    over=InstalledReferences,
    severity=Severity.ERROR,
    levels={
        Severity.WARNING: "a process that is started opens it, the path is or holds the default of an argument, or its "
        "action has a condition",
        Severity.INFO: "nothing uses the argument or value, adds its action or calls the function, the file itself "
        "gives the argument another value, an included one takes no such argument, or nothing shows "
        "that the node reads a parameter of that name",
    },
    examples=(
        Example(
            on="ament_cmake",
            bad={
                "package.xml": manifest("  <exec_depend>ros2launch</exec_depend>\n", "ament_cmake"),
                "CMakeLists.txt": ONE,
                "launch/robot.launch.xml": LAUNCH,
                "launch/wheels.launch.xml": "<launch>\n</launch>\n",
            },
            good={"CMakeLists.txt": BOTH},
            fix=Safety.SAFE,
        ),
    ),
)
def reference_not_installed(package: InstalledReferences) -> Iterator[Hit]:
    """
    ## What it does
    Finds files that a launch file names in a share directory and that are not installed there.
    They exist in the source, but the package does not install them, or installs them elsewhere. What one install rule
    puts elsewhere is one finding.

    ## Why is this bad?
    Only what is installed is found. The build is green, and the launch stops at an included file ("No such file or
    directory"); at a parameter file it goes on, with "Parameter file path is not a file" and the node's defaults.

    ## When it is quiet
    Where nothing of the folder is installed, or setup.py leaves it out, only SET206, SET207 or CMK101 reports it. Paths
    that are checked first or that the build writes are left alone, and so are packages whose install rules are not all
    known.

    It is a warning where launch itself does not open the file, as RViz and nodes start with their defaults without it,
    and where the action has a condition.

    It is an info

    - for the default of an argument that neither the file nor one that it includes uses;
    - for actions that are never added, functions that are never called, and arguments that an included file does not
      declare;
    - for the value of a parameter that no node is shown to read (LCH003);
    - behind the place where every launch ends, as it looks for a package that nothing here brings.
    """
    for found in package.missing():
        (files, missing), *others = sorted(found, key=lambda each: level_of(*each)[0].rank, reverse=True)
        edits = repair(files, missing) if missing.state == "not installed" else ()
        fix = Fix(f"install {missing.path}", edits) if edits else None
        level, why = level_of(files, missing)
        places = [Related(files.scope.file.path, span, "here too") for span in missing.other_spans]
        places += [Related(file.scope.file.path, each.span, f"`{each.path}` too") for file, each in others]
        row = files.rule_of(missing)
        places += [Related(row.path, row.span, "installed here")] if row is not None else []
        yield Hit(files.scope.file.path, missing.span, message(missing, others, why), level, tuple(places), fix)


def level_of(files: ReferenceInstall, missing: MissingReference) -> tuple[Severity, str]:
    from ...checks.launch.softened_references import softened  # few launch files name what is not installed

    softer, why = softened(files.scope, missing)
    own = Severity.ERROR if missing.stops_launch else Severity.WARNING
    return (Severity(softer) if softer else own), f"{why and ', '}{why}"


def repair(files: ReferenceInstall, missing: MissingReference) -> tuple[Edit, ...]:
    if missing.package != files.name:
        return ()
    if files.cmake is not None:
        return install_for_cmake(files.cmake, files.name, missing.path)
    return install_for_setup(files.setup, files.name, missing.path) if files.setup is not None else ()


def message(missing: MissingReference, others: Sequence[tuple[ReferenceInstall, MissingReference]], why: str) -> str:
    if missing.state != "elsewhere":
        return (
            f"`{missing.path}` is there, but `{missing.package}` does not install it: the build is green, and the "
            f"launch does not find it{why}; install it"
        )
    names = {each.path for _, each in others} - {missing.path}
    what = f"`{missing.path}` and {len(names)} more go" if names else f"`{missing.path}` goes"
    place = f"`share/{missing.package}/{missing.path}`"
    return (
        f"{what} to `{missing.better_path}`, and {place} is looked for: it is not found{why}; correct the destination"
    )
