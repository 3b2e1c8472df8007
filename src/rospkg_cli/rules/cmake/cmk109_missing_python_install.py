"""CMK109 missing-python-install."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.cmake.forgotten_python import ForgottenPython
from ...checks.cmake.modules_next_to_scripts import LeftModule, modules_left_behind
from ...checks.cmake.uninstalled_python import PythonPackages
from ...edits.cmake_install import install_script
from ...edits.cmake_python import install_python_package, python_install
from ...edits.plain_names import only_plain_names
from ...example import CMAKE, Example, manifest
from ...finding import Fix, Hit, Related, Safety, Severity
from ...rule import rule

SCRIPT = "#!/usr/bin/env python3\nfrom my_pkg.words import HELLO\n\nprint(HELLO)\n"
INSTALL = "install(PROGRAMS scripts/hello.py DESTINATION lib/${PROJECT_NAME})\n"
BAD = CMAKE.replace("ament_package()", f"{INSTALL}«ament_package()»")
FOUND = "find_package(ament_cmake REQUIRED)\n"
GOOD = (
    BAD.replace("«", "")
    .replace("»", "")
    .replace(FOUND, f"{FOUND}find_package(ament_cmake_python REQUIRED)\n")
    .replace(INSTALL, f"{INSTALL}\nament_python_install_package(${{PROJECT_NAME}})\n")
)
HELLO = "scripts/hello.py"
ALONE = "install(PROGRAMS\n  scripts/hello.py\n  DESTINATION lib/${PROJECT_NAME}\n)\n"
BODY = "  <buildtool_depend>ament_cmake_python</buildtool_depend>\n"


@rule(
    "CMK109",
    "missing-python-install",
    over=PythonPackages,
    severity=Severity.ERROR,
    levels={
        Severity.WARNING: "a module next to a script, which a build with --symlink-install finds; only data "
        "imports it; or interfaces take its name",
        Severity.INFO: "nothing in the package imports it, or nothing is known to reach the import",
    },
    examples=(
        Example(
            bad={
                "package.xml": manifest(BODY, "ament_cmake"),
                "CMakeLists.txt": BAD,
                "scripts/hello.py": SCRIPT,
                "my_pkg/__init__.py": "",
                "my_pkg/words.py": "HELLO = 'hello'\n",
            },
            good={"CMakeLists.txt": GOOD},
            on="ament_cmake",
            fix=Safety.SAFE,
        ),
        Example(
            bad={
                "CMakeLists.txt": CMAKE.replace("ament_package", ALONE.replace(HELLO, f"«{HELLO}»") + "ament_package"),
                "scripts/hello.py": SCRIPT.replace("my_pkg.words", "words"),
                "scripts/words.py": "HELLO = 'hello'\n",
            },
            good={
                "CMakeLists.txt": CMAKE.replace(
                    "ament_package", ALONE.replace(HELLO, f"{HELLO}\n  scripts/words.py") + "ament_package"
                )
            },
            on="ament_cmake",
            fix=Safety.SAFE,
        ),
    ),
)
def missing_python_install(packages: PythonPackages) -> Iterator[Hit]:
    """
    ## What it does
    Finds Python packages of a CMake package that are imported at run time and not installed.
    An installed script or launch file imports them, and no `ament_python_install_package()` installs them. Modules that
    a script imports from its own folder have to be installed next to it. The Python package that is called like the
    package counts, too, where ament_cmake_python is looked for and nothing installs any file of it.

    ## Why is this bad?
    The build is green, and the script ends with ModuleNotFoundError.

    ## When it is quiet
    Where install rules can't be evaluated, where the import is guarded by `try`, where the script changes `sys.path`,
    where an environment hook of the package may set PYTHONPATH, and where the folder is installed next to the script.
    It is an info in a function that nothing leads to, in a script that ends at `import rospy` before, in one among
    the data that nothing starts or names, in one that pages and scripts give to Python by its path alone, and where one
    puts the source on PYTHONPATH or has pip link to it.
    """
    cmake = packages.package.cmake
    ends = [call for call in cmake.calls if call.name.endswith(("ament_package", "ament_auto_package"))]
    if not packages.package.is_ament or not ends:
        return
    for each in packages.uninstalled():
        place = ends[-1]
        start = (
            f"the Python package `{each.folder}` is not installed: `{each.path}`, which imports `{each.module}`, ends"
        )
        message = f"{start} with ModuleNotFoundError; {repair(packages, each.folder)}{each.why_unmet}"
        related = Related(each.path, each.span, "it is imported here")
        is_certain = each.is_started and not is_generated(packages, each.folder)
        level = Severity.INFO if each.why_unmet else None if is_certain else Severity.WARNING
        fix = installing(packages, each.folder)
        yield Hit(place.path, place.command.span, message, level, (related,), fix)
    if name := ForgottenPython(packages).name():
        start = f"the Python package `{name}` is not installed, though CMake looks for ament_cmake_python"
        message = f"{start}: nothing can import it; {repair(packages, name)}"
        fix = installing(packages, name)
        yield Hit(ends[-1].path, ends[-1].command.span, message, Severity.INFO, fix=fix)
    for left in modules_left_behind(packages):
        yield next_to_script(packages, left)


def is_generated(packages: PythonPackages, name: str) -> bool:
    """Return whether interfaces make a Python package of this name: CMake stops at a second one (CMK006)."""
    return name == packages.package.facts.name and bool(packages.package.cmake.interface_targets)


def repair(packages: PythonPackages, name: str) -> str:
    if is_generated(packages, name):
        return f"the interfaces make a `{name}` of their own: move the modules to another package"
    return f"call `{call_for(packages, name)}`"


def call_for(packages: PythonPackages, name: str) -> str:
    return python_install(name, packages.folders[name])


def installing(packages: PythonPackages, name: str) -> Fix | None:
    if is_generated(packages, name):
        return None
    edits = install_python_package(packages.package.cmake, name, packages.folders[name])
    return only_plain_names(Fix(f"install the Python package {name}", edits), name)


def next_to_script(packages: PythonPackages, left: LeftModule) -> Hit:
    script = install_script(packages.package.cmake, left.source) if not left.needs_folder else None
    fix = only_plain_names(Fix(f"install `{left.source}`", (script,)), left.source) if script else None
    related = Related(left.script, left.imported, "it is imported here")
    level = Severity.INFO if left.why_unmet else Severity.WARNING
    return Hit(left.path, left.span, left.sentence, level, (related,), fix)
