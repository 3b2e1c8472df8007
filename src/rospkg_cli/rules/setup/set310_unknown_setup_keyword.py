"""SET310 unknown-setup-keyword."""

from __future__ import annotations

from collections.abc import Iterator

from ...example import SETUP_PY, Example, scripts, setup_py
from ...finding import Edit, Fix, Hit, Safety, Severity
from ...package.setup.entry_point import EntryPoint
from ...package.setup.misspelt_names import SCRIPTS, MisspeltArgument, intended_group
from ...package.setup.setup_py import SetupPy
from ...ros.setup_keywords import BUILDS
from ...rule import rule
from ...source import Span

MODULE = {"my_pkg/talker.py": "def main():\n    print('hello')\n"}
GOOD = setup_py(scripts("talker = my_pkg.talker:main"))


@rule(
    "SET310",
    "unknown-setup-keyword",
    over=SetupPy,
    severity=Severity.ERROR,
    levels={Severity.INFO: "it only describes the package"},
    examples=(
        Example(
            bad={**MODULE, "setup.py": GOOD.replace("entry_points=", "«entry_point»=")},
            good={"setup.py": GOOD},
            fix=Safety.UNSAFE,
        ),
        Example(
            bad={**MODULE, "setup.py": GOOD.replace("'console_scripts'", "'«console_script»'")},
            good={"setup.py": GOOD},
            fix=Safety.UNSAFE,
        ),
        Example(
            bad={"setup.py": SETUP_PY.replace("maintainer=", "«maintaner»=")},
            good={"setup.py": SETUP_PY},
            fix=Safety.UNSAFE,
        ),
    ),
)
def unknown_setup_keyword(setup: SetupPy) -> Iterator[Hit]:
    """
    ## What it does
    Finds misspelt arguments of `setup()`, and misspelt groups of `entry_points`.

    ## Why is this bad?
    The build is green: setuptools passes over an argument that it does not know with a warning ("Unknown distribution
    option"), and takes any group. Then there is no executable, or nothing is installed.

    ## When it is quiet
    Where the name is near none that setuptools knows, or the one that it is near to is given as well: plugins of
    setuptools add arguments of their own, and any package may define a group.

    ## Fix safety
    The intended name is a guess.
    """
    for each in setup.misspelt_arguments:
        yield from misspelt_argument(setup, each)
    groups: dict[str, EntryPoint] = {}
    for entry in setup.entry_points:
        groups.setdefault(entry.group, entry)
    for group, entry in groups.items():
        if entry.intended_group and entry.intended_group not in groups:
            yield misspelt_group(setup, group, entry)


def misspelt_argument(setup: SetupPy, each: MisspeltArgument) -> Iterator[Hit]:
    name, intended, start = each.argument.name, each.intended, each.argument.span.start
    span = Span(start, start + len(name)) if setup.source.slice(each.argument.span).startswith(name) else setup.span
    group = name if name in SCRIPTS else intended_group(name)
    if group:
        message = f"setup() takes no `{name}`: no executable is made; write `entry_points={{'{group}': […]}}`"
        yield Hit(setup.path, span, message)
        return
    what = BUILDS.get(intended, "")
    message = f"setup() takes no `{name}`: {what or 'it is passed over'}; write `{intended}`"
    edits = (Edit(setup.path, span, intended),) if span != setup.span else ()
    fix = Fix(f"write `{intended}`", edits, Safety.UNSAFE) if edits else None
    yield Hit(setup.path, span, message, None if what else Severity.INFO, fix=fix)


def misspelt_group(setup: SetupPy, group: str, entry: EntryPoint) -> Hit:
    intended = entry.intended_group
    span = setup.group_spans.get(group)
    message = f"`{group}` is no group that makes executables: none is installed; write `{intended}`"
    if span is None:
        return Hit(entry.path, entry.span, message)
    fix = Fix(f"write `{intended}`", (Edit(setup.path, span, intended),), Safety.UNSAFE)
    return Hit(setup.path, span, message, fix=fix)
