"""SET311 undeclared-requirement."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.setup.undeclared_requirements import UndeclaredRequirements
from ...edits.undeclared_dependency import declaration
from ...example import Example, manifest, setup_py
from ...finding import Hit, Safety, Severity
from ...rule import rule

SETUP = setup_py()
BAD = SETUP.replace("['setuptools']", "['setuptools', '«pyserial»']")


@rule(
    "SET311",
    "undeclared-requirement",
    over=UndeclaredRequirements,
    severity=Severity.INFO,
    examples=(
        Example(
            bad={"setup.py": BAD},
            good={"package.xml": manifest("  <exec_depend>python3-serial</exec_depend>\n")},
            fix=Safety.SAFE,
        ),
    ),
)
def undeclared_requirement(requirements: UndeclaredRequirements) -> Iterator[Hit]:
    """
    ## What it does
    Finds Python libraries in `install_requires` that package.xml does not declare.

    ## Why is this bad?
    colcon does not run pip: on a clean machine nothing installs the library, since rosdep reads package.xml alone.

    ## When it is quiet
    For libraries without a rosdep key, for those that a declared dependency brings or that only some machines need
    (`; python_version < "3"`), and where a module imports the library too (DEP101 reports it).
    """
    for said, name, key in requirements.found():
        message = (
            f"`{name}` is not declared in package.xml: rosdep does not install it; add <exec_depend>{key}</exec_depend>"
        )
        fix = declaration(requirements.declared, "exec_depend", key)
        yield Hit(said.path, said.shown, message, fix=fix)
