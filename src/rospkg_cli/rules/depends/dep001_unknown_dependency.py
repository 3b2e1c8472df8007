"""DEP001 unknown-dependency."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.depends.dependency_names import DependencyNames
from ...checks.depends.unknown_dependencies import UnknownDependencies
from ...edits.manifest import remove_element, rename_dependency, split_dependency
from ...example import Example, manifest
from ...finding import Fix, Hit, Related, Safety, Severity
from ...rule import rule

LINE = "  <exec_depend>{}</exec_depend>\n"


@rule(
    "DEP001",
    "unknown-dependency",
    over=DependencyNames,
    severity=Severity.WARNING,
    levels={
        Severity.INFO: "where another distribution or a missing repository may have it, a variable asks for it, a "
        "page has rosdep skip it, or rosdep has a list of the repository's own"
    },
    examples=(
        Example(
            bad={"package.xml": manifest(LINE.format("«opencv-python»"))},
            good={"package.xml": manifest(LINE.format("python3-opencv"))},
            fix=Safety.UNSAFE,
        ),
        Example(
            bad={"package.xml": manifest(LINE.format("«sensor_msg»"))},
            good={"package.xml": manifest(LINE.format("sensor_msgs"))},
            fix=Safety.UNSAFE,
        ),
        Example(
            on="ament_cmake",
            bad={"package.xml": manifest(LINE.format("«Eigen3»"), "ament_cmake")},
            good={"package.xml": manifest(LINE.format("eigen"), "ament_cmake")},
            fix=Safety.UNSAFE,
        ),
        Example(
            bad={"package.xml": manifest(LINE.format("«python3-numpy, python3-yaml»"))},
            good={"package.xml": manifest(LINE.format("python3-numpy") + LINE.format("python3-yaml"))},
            fix=Safety.SAFE,
        ),
    ),
)
def unknown_dependency(names: DependencyNames) -> Iterator[Hit]:
    """
    ## What it does
    Finds dependencies whose name is neither a known ROS package nor a rosdep key.
    Packages of the target, of the workspace and of an installed prefix are known. Always reported are names of PyPI,
    Ubuntu, CMake, Python 2 or Python modules that rosdep calls otherwise, modules of Python itself, renamed packages,
    two names in one tag, and names with a typo in a released package, a key or a package of the workspace. Any other
    unknown name is reported only where `rospkg index update` has fetched the names, and so is one that a named target
    lacks (but for packages of other distributions that Rolling lacks: they come and go there, as they are rebuilt).

    ## Why is this bad?
    `rosdep install` ends with "Cannot locate rosdep definition for [opencv-python]", and with it every CI build.

    ## When it is quiet
    Packages of the workspace, of an installed prefix (AMENT_PREFIX_PATH, /opt/ros) and of any distribution are known.
    Where a `.repos` file or an empty submodule says that more packages belong to the workspace, a name that resembles
    one of the repositories that are missing is left alone, and another that nothing explains is an info. So is a name
    that a page, a script or a job here has rosdep skip (`--skip-keys`), or that a repository has which these fetch
    (`git clone …/sensor_msg`), and one that is no slip of a package where rosdep has further lists: a YAML file called
    after it has the name, a page or a script writes into /etc/ros/rosdep/sources.list.d, or the packages here need two
    more unknown keys. Dependencies whose condition excludes the targets, and doc_depend, are left alone. No other name
    is suggested for a plain CMake project of the workspace, which colcon builds and rosdep does not know.

    ## Fix safety
    The name is replaced by the suggested one; where only a letter differs, another one may be right. The line goes
    where that is the package itself, or declared already. There is none where
    `ament_auto_find_build_dependencies()` finds what the build needs by the name that package.xml has.
    """
    manifest = names.declared.manifest
    for each in UnknownDependencies(names).all():
        name = each.dependency.name
        advice = each.advice or (f"write `{each.suggestion}`" if each.suggestion else "")
        others = names.repeated(each.dependency)
        fix = None
        if each.suggestion:
            edits = tuple(rename_dependency(manifest, d, each.suggestion) for d in (each.dependency, *others))
            fix = Fix(f"write `{each.suggestion}`", edits, Safety.UNSAFE)
        elif each.is_needless:
            doomed = tuple(remove_element(manifest, d.element) for d in (each.dependency, *others))
            fix = Fix("remove the line", doomed, Safety.UNSAFE)
        elif each.parts:
            edit = split_dependency(manifest, each.dependency, each.parts)
            fix = Fix(f"Write {len(each.parts)} dependencies", (edit,))
        related = tuple(Related(manifest.path, other.span, "and here") for other in others)
        message = f'`{name}` {each.reason}: `rosdep install` ends with "{each.rosdep_error.format(name)}"'
        message += f"; {advice}" if advice else ""
        aside = names.unneeded.why(each.dependency.name, may_be_key=each.may_be_key)
        level, message = Severity.INFO if each.is_uncertain or aside else None, message + aside
        yield Hit(manifest.path, each.dependency.span, message, level, related, fix)
