"""DEP109 unknown-import."""

from __future__ import annotations

from collections.abc import Iterable, Iterator

from ...checks.depends.former_names import FormerName, former_names, mistyped_tops
from ...checks.depends.missing_own_names import MissingOwnName, MissingOwnNames
from ...checks.depends.own_imports import OwnImports
from ...edits.same_infos import same_infos_once
from ...example import Example, scripts, setup_py
from ...finding import Edit, Fix, Hit, Related, Safety, Severity
from ...rule import rule

SPEECH = {
    "setup.py": setup_py(scripts("talker = my_pkg.talker:main")),
    "my_pkg/speech.py": "GREETING = 'hello'\n",
}
MAIN = "\n\n\ndef main():\n    print({})\n"
GOOD = {"my_pkg/talker.py": "from my_pkg.speech import GREETING" + MAIN.format("GREETING")}


@rule(
    "DEP109",
    "unknown-import",
    over=OwnImports,
    severity=Severity.ERROR,
    levels={
        Severity.WARNING: "it is in a function or a branch, which may not be run, a condition stands on the way to it, "
        "only tests reach it, it is in a library's module that nothing here imports, or in a program that nothing "
        "starts, while others are started",
        Severity.INFO: "nothing starts or imports the module, or leads to the function, or a page alone names it, "
        "other packages here import other parts of a library alone, it stands behind `rclpy.spin`, a loop or a switch "
        "that is off, or in a callback that nothing spins, or another package may have the module, and this one has "
        "one of its name",
    },
    examples=(
        Example(
            bad={**SPEECH, "my_pkg/talker.py": "from my_pkg.«speach» import GREETING" + MAIN.format("GREETING")},
            good=GOOD,
            fix=Safety.UNSAFE,
        ),
        Example(
            bad={**SPEECH, "my_pkg/talker.py": "from my_pkg.speech import «GRETING»" + MAIN.format("GRETING")},
            good=GOOD,
        ),
        Example(
            bad={**SPEECH, "my_pkg/talker.py": "from . import «speach»" + MAIN.format("speach.GREETING")},
            good={"my_pkg/talker.py": "from . import speech" + MAIN.format("speech.GREETING")},
        ),
    ),
)
def unknown_import(imports: OwnImports) -> Iterator[Hit]:
    """
    ## What it does
    Finds imports of a module, or of a name, that the package itself does not have.
    Modules of other packages of the workspace count where one of a near name is there. What nothing known has, and
    this package has by its own name, is an info: it may be left from a copy. So is a slip of the package's own name.

    ## Why is this bad?
    The build does not look: it is green, and the node ends with ModuleNotFoundError or ImportError when it starts.

    ## When it is quiet
    For optional imports and under `TYPE_CHECKING`, in files that nothing installs, where the module may be compiled or
    generated (a command of CMake may do so, an inner setup.py or the code of an extension names it, or git ignores it),
    where it lies in a folder that is not installed, where a module has a `__getattr__` or an unknown star import, and
    where the package changes `sys.path`. A module that no entry point and no other file of the package names or
    imports, while others start, is an info, and so is an import in a function that no program leads to, behind
    `rclpy.spin`, or under the `__main__` of an entry point's module. Of a library such a module is a warning: others
    may import it, or nothing does. It is an info where other packages here import the library, and none of them reaches
    that module, or where a comment in the module says that the name, or all that the module would hold, is still to be
    written.

    ## Fix safety
    The intended name is a guess.
    """
    for wrong, *others in same_names(MissingOwnNames(imports).all()):
        level = Severity.INFO if wrong.why else Severity.WARNING if is_uncertain(wrong) else None
        what = missing_module(wrong) if wrong.is_module else absence(imports, wrong)
        error = "ModuleNotFoundError" if wrong.is_module else "ImportError"
        intended = wrong.near or wrong.elsewhere
        advice = f"; did you mean `{intended}`?" if intended else ""
        fix = None
        each = (wrong, *others)
        written = [one for one in each if imports.files.source(one.path).slice(one.span) == wrong.name]
        if wrong.near and wrong.is_module and len(written) == len(each):
            edits = tuple(Edit(one.path, one.span, wrong.near) for one in each)
            fix = Fix(f"write `{wrong.near}`", edits, Safety.UNSAFE)
        places = tuple(Related(other.path, other.span, "here too") for other in others)
        yield Hit(wrong.path, wrong.span, f"{what}: the import raises {error}{advice}{wrong.why}", level, places, fix)
    former = list(former_names(imports))
    for typo in mistyped_tops(imports, former):
        top, own = (name.partition(".")[0] for name in (typo.each.module, typo.own))
        message = f"nothing known has a module `{top}`: the import raises ModuleNotFoundError; did you mean `{own}`?"
        yield Hit(typo.file.path, typo.each.span, message, Severity.INFO)
    yield from same_infos_once(map(at_former, former), "")


def at_former(one: FormerName) -> Hit:
    what = f"nothing known has a module `{one.each.module}`, and this package has `{one.own}`"
    message = f"{what}: the import raises ModuleNotFoundError where nothing else installs it; write `{one.own}`"
    return Hit(one.file.path, one.each.span, message, Severity.INFO)


def is_uncertain(wrong: MissingOwnName) -> bool:
    """Return whether an import may never run."""
    return wrong.is_local or not wrong.is_reached or bool(wrong.why)


def same_names(found: Iterable[MissingOwnName]) -> Iterable[list[MissingOwnName]]:
    """Return the imports of each name, those first that certainly run: a module that is gone is one cause."""
    by_name: dict[tuple[str, str], list[MissingOwnName]] = {}
    for each in sorted(found, key=lambda each: (bool(each.why), is_uncertain(each))):
        by_name.setdefault((each.package, each.name), []).append(each)
    return by_name.values()


def missing_module(wrong: MissingOwnName) -> str:
    below = f", where `{wrong.module}` would be" if wrong.module else ""
    return f"there is no module `{wrong.package}.{wrong.name}`{below}"


def absence(imports: OwnImports, wrong: MissingOwnName) -> str:
    """Return what a module lacks; of a package both a module and a name would do."""
    path = imports.installed.sources[wrong.package]
    kind = "no module or name" if path.endswith("__init__.py") else "no"
    return f"`{wrong.package}` has {kind} `{wrong.name}`"
