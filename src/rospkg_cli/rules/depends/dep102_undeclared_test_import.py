"""DEP102 undeclared-test-import."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.depends.hand_installs import BY_PAGE
from ...checks.depends.imports_of_tests import ImportsOfTests
from ...checks.depends.name_source import is_unmet
from ...checks.depends.undeclared_imports import ImportDependencies
from ...edits.brought_hits import BroughtUse, left_to_others, related
from ...edits.undeclared_dependency import advice, declaration, where_absent
from ...example import Example, manifest
from ...finding import Hit, Safety, Severity
from ...rule import rule

NEVER_RUN = "; `colcon test` does not run this file today"


@rule(
    "DEP102",
    "undeclared-test-import",
    over=ImportDependencies,
    severity=Severity.WARNING,
    levels={
        Severity.INFO: "where a declared dependency or colcon brings or may bring it, an unreleased repository "
        "declares it in another package or installs it by apt, package.xml has it in a comment or for older "
        "distributions alone, pip or a page's reader installs it, setup.py does not ask for pytest, or `colcon test` "
        "does not run the file or reach the function, or it needs this package itself"
    },
    examples=(
        Example(
            bad={"test/test_viewer.py": "import «cv2»\n\n\ndef test_version():\n    assert cv2.__version__\n"},
            good={"package.xml": manifest("  <test_depend>python3-opencv</test_depend>\n")},
            fix=Safety.SAFE,
        ),
    ),
)
def undeclared_test_import(imports: ImportDependencies) -> Iterator[Hit]:
    """
    ## What it does
    Finds imports in `test/` and `tests/` that package.xml does not declare.
    ROS packages are checked, and Python libraries that have a rosdep key. Any tag will do; what only tests use belongs
    in test_depend.

    ## Why is this bad?
    `colcon test` passes on the machine where the module happens to be installed and fails on a clean one: rosdep and
    the build farm install what package.xml names.

    ## When it is quiet
    What a declared dependency certainly installs can't be missing, nor can pytest, which colcon needs itself: that is
    one info, which names who brings it. What may come with a declared one is another: with a package that is neither
    here nor in the table of what is installed with what, anything may come. It is an info, too, where setup.py does not
    ask for pytest: `colcon test` runs unittest then; where another package of the repository declares it, or a list or
    a command of it installs it (apt alone), and nothing shows a release; where the repository has pip install it, or
    people have it otherwise (DEP101); and for a launch test that CMake does not register, or whose name pytest does not
    look for. Left out are optional imports, helpers that no test uses, launch_ros and launch_testing where a declared
    dependency certainly brings them, and what installed code imports as well (DEP101). A package here that needs this
    one itself is an info, for to declare it would make a circle; where it declares this one, nothing is said.

    ## Fix safety
    The fix is unsafe where only PyPI has the library, where no released package has the name, or where a comment of
    package.xml leaves it out.

    ## References
    - REP-149, test_depend
    """
    brought: list[BroughtUse] = []
    declared, tests = imports.declared, ImportsOfTests(imports)
    for missing in tests.missing():
        first = missing.places[0]
        if missing.bringer:
            brought.append(BroughtUse(missing.name, missing.bringer, "test_depend", first.path, first.span))
            continue
        brings = ", ".join(f"`{name}`" for name in missing.also_provides)
        others = f", which brings {brings} as well" if brings else ""
        where = where_absent(declared, *imports.serving(missing), built=True)
        fails = "`colcon test`" if tests.has_pytest else "pytest, which setup.py does not ask for,"
        todo = advice(declared, "test_depend", *imports.serving(missing))
        message = (
            f"`{missing.name}` is imported by tests and not declared: {where} "
            f"{fails} fails with ModuleNotFoundError; {todo}{others}"
        )
        why = imports.reach.why_seldom(missing.places) if tests.has_pytest else ""
        end = NEVER_RUN if tests.are_never_run(missing.places) else why
        end = end or imports.sources.why_pip(missing) or (BY_PAGE if imports.sources.is_by_hand(missing) else "")
        end = end or imports.sources.why_brought(missing)
        places = related((place.path, place.span) for place in missing.places)
        is_mild = bool(end) or is_unmet(declared, missing.name, imports.serving(missing)) or not tests.has_pytest
        level = Severity.INFO if is_mild else None
        fix = declaration(declared, "test_depend", missing.name)
        yield Hit(first.path, first.span, f"{message}{end}", level, places, fix)
    yield from left_to_others(declared, brought, "imported by tests")
