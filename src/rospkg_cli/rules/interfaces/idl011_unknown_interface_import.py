"""IDL011 unknown-interface-import."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.interfaces.interface_imports import InterfaceImports, WrongInterfaceImport
from ...checks.interfaces.known_interfaces import NAMES, base_name
from ...example import Example, manifest
from ...finding import Edit, Fix, Hit, Safety, Severity
from ...rule import rule

NEEDS_STD_MSGS = {"package.xml": manifest("  <exec_depend>std_msgs</exec_depend>\n")}
LEFT = "; nothing starts or imports this module"
GOOD = "from std_msgs.msg import String\n\nprint(String)\n"


@rule(
    "IDL011",
    "unknown-interface-import",
    over=InterfaceImports,
    severity=Severity.ERROR,
    levels={
        Severity.WARNING: "it is in a function or a branch, which may not be run, a condition stands on the way to it, "
        "only tests run it, or it is in a program that nothing starts, though others are started",
        Severity.INFO: "nothing installs the file, starts or imports the module, or leads to the function, or a page "
        "alone names it, or it stands behind `rclpy.spin`, a loop or a switch that is off, in a callback that nothing "
        "spins, or under `__main__` of an entry point's module, or the package is for older distributions alone, which "
        "may have it",
    },
    examples=(
        Example(
            bad={
                **NEEDS_STD_MSGS,
                "my_pkg/talker.py": GOOD.replace("import String", "import «Sting»").replace("(String", "(Sting"),
            },
            good={"my_pkg/talker.py": GOOD},
        ),
        Example(
            bad={**NEEDS_STD_MSGS, "my_pkg/talker.py": GOOD.replace("std_msgs.msg", "«std_msgs.msgs»")},
            good={"my_pkg/talker.py": GOOD},
            fix=Safety.UNSAFE,
        ),
        Example(
            bad={"my_pkg/talker.py": GOOD.replace("std_msgs.msg", "«my_pkg.msg»")},
            good={**NEEDS_STD_MSGS, "my_pkg/talker.py": GOOD},
        ),
    ),
)
def unknown_interface_import(imports: InterfaceImports) -> Iterator[Hit]:
    """
    ## What it does
    Finds Python imports of messages, services and actions that their package does not have.
    It also finds those that are taken out of the package itself (`from std_msgs import String`), and not of its module
    `msg`, `srv` or `action`.

    ## Why is this bad?
    The build does not look: it is green, and the node ends with ImportError when it starts. A package has the messages
    of its own .msg files, which only a package of CMake can generate code of, and only of those that it lists.

    ## When it is quiet
    Where the package is not in the workspace, unless one of its messages has a near name or the name is that of a
    service or action of it, also with the ending of ROS 1, and no list of repositories fetches another version; where
    it makes its interfaces while it is built, or has a Python module of that name; for optional imports, and in files
    that nothing installs, but for an info on a name that a package of the workspace lacks. A module that no entry point
    and no other file of the package names or imports, though others are started, is an info, and so is what is in a
    function that no program leads to, behind `rclpy.spin`, or under the `__main__` of an entry point's module, and a
    message that a comment or a page has people write. So is, where a repository is for unsupported distributions alone,
    what a package elsewhere has as another kind now.

    ## Fix safety
    The intended name is a guess.
    """
    for wrong in imports.wrong():
        level = Severity.WARNING if wrong.is_local else None
        level = Severity.INFO if wrong.is_uninstalled or wrong.why or wrong.is_left else level
        fix = None
        if wrong.kind and wrong.kind not in NAMES:
            fix = Fix(f"write `{wrong.intended}`", (Edit(wrong.path, wrong.span, wrong.intended),), Safety.UNSAFE)
        yield Hit(wrong.path, wrong.span, f"{message(wrong)}{LEFT if wrong.is_left else wrong.why}", level, fix=fix)


def message(wrong: WrongInterfaceImport) -> str:
    package, kind = wrong.package, wrong.kind
    if not kind:
        module, _, name = wrong.intended.rpartition(".")
        what = f"`{package}` itself has no `{name}`, its {NAMES[module.rpartition('.')[2]]}s are in `{module}`"
        return f"{what}: the import fails; write `from {module} import {name}`"
    if kind not in NAMES:
        return f"there is no module `{package}.{kind}`: the import raises ModuleNotFoundError; write `{wrong.intended}`"
    if wrong.is_unlisted:
        what = (
            f"`{package}` generates nothing of `{kind}/{base_name(wrong.name)}.{kind}`: the import raises ImportError"
        )
        return f"{what}; list the file in its `rosidl_generate_interfaces`"
    module, _, name = wrong.intended.rpartition(".")
    if wrong.name:
        what = f"`{package}` has no {NAMES[kind]} `{wrong.name}`: the import raises ImportError"
        advice = f"did you mean `from {module} import {name}`?"
    else:
        what = f"`{package}` has no {NAMES[kind]}s: importing `{package}.{kind}` raises ModuleNotFoundError"
        advice = f"write `from {module} import {name}`" if module else f"import from the package with the .{kind} file"
        return f"{what}; {advice}"
    what += ", as soon as this file is run: nothing installs it" if wrong.is_uninstalled else ""
    return f"{what}; {advice}" if module else what
