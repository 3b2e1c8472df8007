"""SET308 undefined-setup-name."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.python.module_attributes import absent_attributes
from ...edits.setup_py import import_name, import_standard
from ...example import SETUP_PY, Example
from ...finding import Edit, Fix, Hit, Safety, Severity
from ...languages.python.called_modules import CalledModule, called_modules
from ...languages.python.place_kinds import is_in_function, is_run
from ...languages.python.undefined_names import UndefinedName, undefined_names
from ...light_dataclasses import replace
from ...package.setup.setup_py import SetupPy
from ...rule import rule
from ...suggest import nearest

ENTRY = "        ('share/' + package_name, ['package.xml']),\n"
GLOB = "        ('share/' + package_name + '/launch', «glob»('launch/*launch.[pxy][yma]*')),\n"
BAD = SETUP_PY.replace(ENTRY, ENTRY + GLOB)
GOOD = BAD.replace("«", "").replace("»", "")
LAUNCH = {"launch/robot.launch.xml": "<launch>\n</launch>\n"}
NO_FINDER = SETUP_PY.replace("find_packages(", "«find_packages»(").replace("import find_packages, ", "import ")
BEHIND = "; setup.py stops before, at another place"
LIBRARY = ("os", "sys", "glob", "pathlib")
OTHERS = {
    "find_packages": "setuptools",
    "find_namespace_packages": "setuptools",
    "setup": "setuptools",
    "Path": "pathlib",
}
"""What is imported from where."""


@rule(
    "SET308",
    "undefined-setup-name",
    over=SetupPy,
    severity=Severity.ERROR,
    levels={
        Severity.WARNING: "it is used in a function, which may not be called",
        Severity.INFO: "setup.py stops before, at another place",
    },
    examples=(
        Example(
            bad={**LAUNCH, "setup.py": BAD},
            good={"setup.py": f"from glob import glob\n\n{GOOD}"},
            fix=Safety.SAFE,
        ),
        Example(
            bad={"setup.py": NO_FINDER},
            good={"setup.py": SETUP_PY},
            fix=Safety.SAFE,
        ),
        Example(
            bad={**LAUNCH, "setup.py": f"import glob\n\n{BAD}"},
            good={"setup.py": f"import glob\n\n{GOOD.replace('glob(', 'glob.glob(')}"},
            fix=Safety.SAFE,
        ),
        Example(
            bad={"setup.py": SETUP_PY.replace("name=package_name", "name=«pakage_name»")},
            good={"setup.py": SETUP_PY},
        ),
    ),
)
def undefined_setup_name(setup: SetupPy) -> Iterator[Hit]:
    """
    ## What it does
    Finds names that setup.py uses and that it neither defines nor imports.
    It finds modules too that are called like the function of their name: `import glob`, and then `glob(…)`, and
    names that Python's modules do not have (`os.path.joint`, `from xml.etree import ET`).

    ## Why is this bad?
    The build stops with a NameError, or with a TypeError. A `glob(…)` that was copied without its import is the usual
    case.

    ## When it is quiet
    Where setup.py imports `*`, runs strings as code or looks names up in `globals()`, and where a NameError is caught.
    What follows the first such place is an info, as setup.py never gets there before that one is fixed.
    """
    hits = [*faults(setup)]
    sure = [each.span.start for each in hits if each.level is None and is_run(setup.file, each.span)]
    for each in hits:
        is_behind = bool(sure) and each.span.start > min(sure) and each.level is None
        yield replace(each, message=each.message + BEHIND, level=Severity.INFO) if is_behind else each


def faults(setup: SetupPy) -> Iterator[Hit]:
    """Yield what stops setup.py, each for itself."""
    reported: set[str] = set()
    for called in called_modules(setup.file):
        advice = f"write `{called.function}(…)`" if called.function else "name the function of it that you want to call"
        start = f"`{called.name}` is a module here, and is called like a function"
        message = f"{start}: setup.py stops with \"TypeError: 'module' object is not callable\"; {advice}"
        level = Severity.WARNING if is_in_function(setup.file, called.span) else None
        yield Hit(setup.path, called.span, message, level, fix=qualified(setup, called))
    for found in undefined_names(setup.file):
        if found.name in reported:
            continue
        reported.add(found.name)
        line = import_of(setup, found)
        near = nearest(found.name, found.known)
        advice = f"add `{line}`" if line else f"did you mean `{near}`?" if near else "define or import it"
        message = f"`{found.name}` is neither defined nor imported: setup.py stops with NameError; {advice}"
        fix = Fix(f"add `{line}`", import_by(setup, found.name, line)) if line else None
        yield Hit(
            setup.path,
            found.span,
            message,
            Severity.WARNING if is_in_function(setup.file, found.span) else None,
            fix=fix,
        )
    for absent in absent_attributes(setup.file):
        level = Severity.WARNING if is_in_function(setup.file, absent.span) else None
        ends = f"setup.py stops with {absent.raised}{absent.advice}"
        yield Hit(setup.path, absent.span, f"`{absent.module}` has no `{absent.name}`: {ends}", level)


def qualified(setup: SetupPy, called: CalledModule) -> Fix | None:
    if not called.function:
        return None
    edit = Edit(setup.path, called.span, called.function)
    return Fix(f"write `{called.function}`", (edit,), Safety.SAFE)


def import_of(setup: SetupPy, found: UndefinedName) -> str:
    """Return the line that imports a name which setup.py files often use; "" for other names."""
    is_module = setup.source.text.startswith(".", found.span.end)
    if found.name == "glob" and not is_module:
        return "from glob import glob"
    if found.name in OTHERS and not is_module:
        return f"from {OTHERS[found.name]} import {found.name}"
    return f"import {found.name}" if found.name in LIBRARY and is_module else ""


def import_by(setup: SetupPy, name: str, line: str) -> tuple[Edit, ...]:
    return import_name(setup, "setuptools", name) if "setuptools" in line else import_standard(setup, line)
