"""DEP116 undeclared-share-package."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.depends.name_source import is_unmet_at_run
from ...checks.looked_up_packages import LookedUpPackages
from ...checks.lookups_for_users import ROUND
from ...edits.brought_hits import BroughtUse, left_to_others, related
from ...edits.undeclared_dependency import advice, declaration, where_absent
from ...example import Example, manifest, scripts, setup_py
from ...finding import Hit, Safety, Severity
from ...rule import rule

MODULE = """\
from ament_index_python.packages import get_package_share_directory


def main():
    print(get_package_share_directory(«'nav2_bringup'»))
"""
SETUP = setup_py(scripts("talker = my_pkg.talker:main"))
NEEDS = "  <exec_depend>ament_index_python</exec_depend>\n"


@rule(
    "DEP116",
    "undeclared-share-package",
    over=LookedUpPackages,
    severity=Severity.WARNING,
    levels={
        Severity.INFO: "a dependency brings or may bring it, an unreleased repository declares it in another package "
        "or installs it by apt, package.xml has it in a comment or for older distributions alone, an `if` chooses it, "
        "only a parameter leads there that is off by default and that nothing sets, or nothing does, a named "
        "distribution lacks it, nothing starts the program, or only packages that have it, or none, use the library "
        "that looks for it, it needs this package, or a page calls it optional"
    },
    examples=(
        Example(
            bad={"package.xml": manifest(NEEDS), "my_pkg/talker.py": MODULE, "setup.py": SETUP},
            good={"package.xml": manifest(f"{NEEDS}  <exec_depend>nav2_bringup</exec_depend>\n")},
            fix=Safety.SAFE,
        ),
    ),
)
def undeclared_share_package(packages: LookedUpPackages) -> Iterator[Hit]:
    """
    ## What it does
    Finds packages whose files installed code looks for and package.xml does not declare.
    Python modules and C++ are read for `get_package_share_directory()` and its like with a literal name.

    ## Why is this bad?
    It works where the package happens to be installed. On a clean machine `rosdep install` skips what package.xml does
    not name, and the node ends with PackageNotFoundError.

    ## When it is quiet
    What a declared dependency certainly installs is one info, and what may come with one is another, as are names that
    are unknown where a repository is listed and not here; else those are DEP112's. What is imported, included or
    launched as well is reported by DEP101, DEP105 and DEP103. Code that catches that or asks first, tests, and files
    that nothing installs are left alone. What an `if` chooses, whose other branch looks for another package, is an
    info, and so is what stands in a module that nothing starts or imports, in a program that nothing starts while
    others are started, in a function that nothing calls, behind a condition on a parameter or a constant whose default
    keeps it from holding, where no YAML, launch file, page or script sets it, or in a source that no target compiles,
    while others, and what another package of the repository declares, or a list or a script of it installs (apt alone),
    where nothing shows a release, and what one of the distributions lacks that the repository names, while others have
    it. What a library without programs looks for is an info where that package uses the library itself, where no
    package here uses it nor a page builds it by name or imports it, or where each that calls the function or links the
    library declares what is looked for, or something that brings it, or starts something of it. So is a package of the
    workspace that itself needs this one, as its launch files start programs of it: to declare it would make a circle;
    and what a page, a script or a comment calls optional.

    ## Fix safety
    The fix is unsafe where no released package has the name, or a comment of package.xml leaves it out. There is none
    where the package uses this library itself.

    ## References
    - REP-149, exec_depend
    """
    declared = packages.declared
    found = packages.undeclared()
    bringers = declared.bringers(found, runs=True)
    brought: list[BroughtUse] = []
    for name, places in found.items():
        first = places[0]
        if bringer := bringers.get(name):
            brought.append(BroughtUse(name, bringer, "exec_depend", first.path, first.span))
            continue
        goes_round = first.why_seldom == ROUND
        todo = "" if goes_round else f"; {advice(declared, 'exec_depend', name)}"
        left = "" if first.why_seldom else packages.launch.left_out.why(name, (each.path for each in places))
        message = (
            f"`{name}` is not declared, and this looks for files of it: {where_absent(declared, name)} the node "
            f"ends with PackageNotFoundError{todo}{first.why_seldom}{left}"
        )
        is_mild = is_unmet_at_run(declared, name) or all(each.is_chosen or each.why_seldom for each in places)
        level = Severity.INFO if is_mild or left else None
        other_places = related((each.path, each.span) for each in places)
        fix = None if goes_round else declaration(declared, "exec_depend", name)
        yield Hit(first.path, first.span, message, level, other_places, fix)
    yield from left_to_others(declared, brought, "looked for by code")
