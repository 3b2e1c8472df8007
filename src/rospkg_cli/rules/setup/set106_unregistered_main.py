"""SET106 unregistered-main."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.setup.unregistered_nodes import UnregisteredNodes
from ...edits.entry_points import add_script
from ...example import Example, manifest, scripts, setup_py
from ...finding import Fix, Hit, Safety, Severity
from ...rule import rule

NODE = "import rclpy\n\n\ndef main():\n    rclpy.init()\n\n\nif __name__ == '__main__':\n    main()\n"
FILES = {
    "package.xml": manifest("  <exec_depend>rclpy</exec_depend>\n"),
    "my_pkg/talker.py": NODE,
    "my_pkg/listener.py": NODE.replace("def main", "def «main»"),
}


@rule(
    "SET106",
    "unregistered-main",
    over=UnregisteredNodes,
    severity=Severity.INFO,
    examples=(
        Example(
            bad={**FILES, "setup.py": setup_py(scripts("talker = my_pkg.talker:main"))},
            good={"setup.py": setup_py(scripts("talker = my_pkg.talker:main", "listener = my_pkg.listener:main"))},
            fix=Safety.UNSAFE,
        ),
    ),
)
def unregistered_main(nodes: UnregisteredNodes) -> Iterator[Hit]:
    """
    ## What it does
    Finds nodes with a `main` and no entry point, in a package that starts others, or none at all.

    ## Why is this bad?
    `ros2 run` and launch files can't start it. A new node whose entry point was forgotten looks just so.

    ## When it is quiet
    Where entry points can't be evaluated or are misspelt (SET103, SET310), in packages that extend a command line tool,
    where another module imports it, or a README or another file names it, and where a launch file starts an executable
    of its name (LCH002 reports that it is not there). It is an info: many such nodes are variants of those that have an
    entry point, run as scripts, or left over.

    ## Fix safety
    It makes an executable of a module that may be there for import only.
    """
    for node in nodes.found():
        name = node.module.rpartition(".")[2]
        entry = f"{name} = {node.module}:main"
        setup = nodes.package.setup
        is_module = all(part.isidentifier() for part in node.module.split("."))
        edits = add_script(setup, nodes.scripts, entry) if nodes.scripts is not None and is_module else ()
        fix = Fix(f"add `{entry}`", edits, Safety.UNSAFE) if edits else None
        message = f"`{node.path}` has a node and a `main`, but no entry point: `ros2 run` can't start it; add `{entry}`"
        yield Hit(node.path, node.main, message, fix=fix)
