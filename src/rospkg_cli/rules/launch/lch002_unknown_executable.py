"""LCH002 unknown-executable."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.launch.node_executables import ExecutableUse, NodeExecutables
from ...example import SETUP_PY_FOR_ALL, Example, manifest
from ...finding import Edit, Fix, Hit, Safety, Severity
from ...rule import rule

SETUP = SETUP_PY_FOR_ALL.replace(
    "    license=", "    entry_points={'console_scripts': ['talker = my_pkg.talker:main']},\n    license="
)
BAD = """\
<launch>
  <node pkg="my_pkg" exec="«taker»"/>
</launch>
"""
FILES = {
    "setup.py": SETUP,
    "my_pkg/talker.py": "def main():\n    pass\n",
    "package.xml": manifest(),
    "launch/a.launch.xml": BAD,
}


@rule(
    "LCH002",
    "unknown-executable",
    over=NodeExecutables,
    severity=Severity.ERROR,
    examples=(
        Example(
            bad=FILES,
            good={"launch/a.launch.xml": BAD.replace("«taker»", "talker")},
            fix=Safety.UNSAFE,
        ),
    ),
)
def unknown_executable(started: NodeExecutables) -> Iterator[Hit]:
    """
    ## What it does
    Finds nodes in launch files whose executable nothing installs.
    The node is of this package, or of another package of the workspace, and is neither a console_script nor a target or
    script that CMake installs. Packages whose executables are not all known are left alone, and launch files of tests
    that CMake does not run.

    ## Why is this bad?
    The launch stops with "executable 'taker' not found on the libexec directory".

    ## Fix safety
    The name is replaced by the only similar one; another program may be right.
    """
    for node in started.unknown_executables():
        suggestion = node.suggestion
        there = ", ".join(f"`{name}`" for name in sorted(node.facts.executables)[:8]) or "no executable at all"
        hint = f"did you mean `{suggestion}`?" if suggestion else f"it installs {there}"
        message = (
            f'`{node.facts.name}` installs no executable `{node.executable}`: the launch stops with "executable '
            f"'{node.executable}' not found on the libexec directory\"; {hint}"
        )
        yield Hit(node.path, node.span, message, fix=rename(node, suggestion))


def rename(node: ExecutableUse, suggestion: str | None) -> Fix | None:
    if suggestion is None or not node.plain:
        return None
    return Fix(f"start `{suggestion}`", (Edit(node.path, node.span, suggestion),), Safety.UNSAFE)
