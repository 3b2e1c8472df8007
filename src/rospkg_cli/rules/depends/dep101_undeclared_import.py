"""DEP101 undeclared-import."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.depends.hand_installs import BY_PAGE
from ...checks.depends.import_use import UndeclaredImport
from ...checks.depends.name_source import is_unmet_at_run
from ...checks.depends.undeclared_imports import ImportDependencies
from ...edits.brought_hits import BroughtUse, left_to_others, related
from ...edits.ros1_hits import ros1_leftovers, unneeded
from ...edits.undeclared_dependency import advice, declaration, where_absent
from ...example import Example, manifest
from ...finding import Hit, Safety, Severity
from ...rule import rule

RUN = "the import raises ModuleNotFoundError"
LACKS = {"on a clean machine": "rosdep does not install it, and ", "in a release": "it is not installed, and "}
"""What happens first, by the place where a module is missing."""
BUILD = "`colcon build` stops with ModuleNotFoundError"

RCLPY = "  <exec_depend>rclpy</exec_depend>\n"
BAD = "import rclpy\nfrom «trajectory_msgs.msg» import JointTrajectory\n"
ONLY_LAUNCH = "only launch files need it, and `ros2 launch` brings it"


@rule(
    "DEP101",
    "undeclared-import",
    over=ImportDependencies,
    severity=Severity.WARNING,
    levels={
        Severity.INFO: "where a declared dependency brings or may bring it, where package.xml has it in a comment or "
        "for older distributions alone, where an unreleased repository declares it in another package or installs it "
        "by apt, where only PyPI has it or it is installed by pip or by hand, or called optional, where nothing but "
        "launch files, only `try`, or nothing at all imports the module or starts the script, where nothing leads to "
        "the function, where another Python or image has it, where one that is named lacks it, or it needs this one"
    },
    examples=(
        Example(
            bad={"package.xml": manifest(RCLPY), "my_pkg/viewer.py": BAD},
            good={"package.xml": manifest(f"{RCLPY}  <exec_depend>trajectory_msgs</exec_depend>\n")},
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
    not name, and the node ends with ModuleNotFoundError; a released package is broken for all users, also where another
    package next to it declares the same. Who builds the repository from source has what any package of it declares:
    that is an info where nothing shows a release.

    ## When it is quiet
    Of a file that imports `rospy` only that is said, for nothing behind it runs, and of several such files once; it is
    an info where a page, script or container that has ROS 1 (`/opt/ros/noetic`, `ros:noetic`, `roscore`) runs the file
    by its path, or nothing imports this module of a package without programs, but others of it. What stands behind `tf`
    or the like is an info, and what the file says to pip install. What a declared dependency certainly installs, be it
    for tests or the build, can't be missing where `rosdep install` ran, nor can what rosdep itself needs (PyYAML,
    rospkg): that is one info, which names who brings it. What may come with a declared one is another: anything may,
    with a package that is neither here nor in the tables. A module that no entry point or other file names, next to
    others that start, is an info, be it that a script imports it whose install rule stands in a comment; as is a script
    that nothing starts or names while other programs are started, unless the build names it, what lies in a folder of
    tools (`benchmarks/`) and is no part of a program, and one that others import under `try` … `except ImportError`
    alone; so is an import under a condition (`if self.plot:`), in a function that no program leads to, behind
    `rclpy.spin`, or under the `__main__` of an entry point's module, what `ros2 launch` brings, where only launch files
    import the module, and a library that a list for pip or conda (requirements.txt, pyproject.toml, a lock file, …), a
    Dockerfile, a script, a job or a page of the repository has pip install, alone, with one that requires it (torch
    with `ultralytics`) or by `install_requires` of a package that it has pip install, be it of ROS as well (`pin`),
    that comes with another import which only PyPI has, or that a page, or a comment of package.xml, says to install by
    hand or by pip, or calls optional, a framework for graphic cards (torch), an unknown package whose repository a page
    links to or fetches, or what Blender, Isaac Sim, Webots or a microcontroller runs. So is a library in programs that
    all import what these bring, or where a page that builds or starts the package enters an environment
    (`conda activate`, `uv run`, `python3 -m venv` without `--system-site-packages`): that Python sees no library of
    rosdep, or where containers build on an image that is not of ROS or Ubuntu. Left out are optional imports: under
    `try` … `except ImportError`, `TYPE_CHECKING`, a condition on the machine, or one that asks for the package
    (`if 'pkg' in get_packages_with_prefixes()`), and branches that never run. So are files that nothing installs, own
    modules, and libraries that rosdep has for older releases of Ubuntu alone. A package here that needs this one
    itself, in a circle, is an info; so is what one of the distributions that the repository names lacks.

    ## Fix safety
    The fix is unsafe where only PyPI has the library, not all distributions have it, or a comment leaves it out.

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
    yield from ros1_leftovers(imports)


def undeclared(imports: ImportDependencies, missing: UndeclaredImport, kind: str, ends: str) -> Hit:
    first, declared = missing.places[0], imports.declared
    end, is_launch = unneeded(imports, missing.places), imports.reach.is_for_launch(missing)
    shown = "" if missing.name == first.module.partition(".")[0] else f" here as `{first.module}`"
    where = where_absent(declared, *imports.serving(missing), built=ends == BUILD)
    what = ONLY_LAUNCH if is_launch else f"{where} {LACKS.get(where, '')}{ends}"
    todo = advice(declared, kind, *imports.serving(missing))
    if not end:
        end = imports.sources.why_pip(missing) or imports.reach.why_seldom(missing.places)
        end = end or (BY_PAGE if imports.sources.is_by_hand(missing) else imports.reach.why_unstarted(missing.places))
        end = end or imports.sources.why_unmet(missing)
    message = f"`{missing.name}` is imported{shown} and not declared: {what}; {todo}{end}"
    mild = bool(end) or is_launch or is_unmet_at_run(declared, missing.name, imports.serving(missing))
    fix = declaration(declared, kind, missing.name)
    places = related((each.path, each.span) for each in missing.places)
    return Hit(first.path, first.span, message, Severity.INFO if mild else None, places, fix)
