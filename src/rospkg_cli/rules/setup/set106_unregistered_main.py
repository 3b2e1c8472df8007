"""SET106 unregistered-main."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.setup.python_package import PythonPackage
from ...edits.entry_points import add_entry
from ...example import Example, manifest, scripts, setup_py
from ...finding import Fix, Hit, Safety, Severity
from ...rule import Profile, rule

NODE = "import rclpy\n\n\ndef main():\n    rclpy.init()\n"
FILES = {
    "package.xml": manifest("  <exec_depend>rclpy</exec_depend>\n"),
    "my_pkg/talker.py": NODE,
    "my_pkg/listener.py": NODE.replace("main", "«main»"),
}


@rule(
    "SET106",
    "unregistered-main",
    over=PythonPackage,
    severity=Severity.INFO,
    profile=Profile.PEDANTIC,
    examples=(
        Example(
            bad={**FILES, "setup.py": setup_py(scripts("talker = my_pkg.talker:main"))},
            good={"setup.py": setup_py(scripts("talker = my_pkg.talker:main", "listener = my_pkg.listener:main"))},
            fix=Safety.UNSAFE,
        ),
    ),
)
def unregistered_main(package: PythonPackage) -> Iterator[Hit]:
    """
    ## What it does
    Finds a node with a `main` and no entry point, where all others in its folder have one.

    ## Why is this bad?
    `ros2 run` and launch files can't start it. A new node whose entry point was forgotten looks just so.

    ## When it is quiet
    Where several modules of the folder lack an entry point: then it is the custom of the package.

    ## Fix safety
    It makes an executable of a module that may be there for import only.
    """
    for module, path, main, like in package.unregistered_nodes:
        name = module.rpartition(".")[2]
        edits = add_entry(package.setup, like, f"{name} = {module}:main")
        fix = Fix(f"add `{name} = {module}:main`", edits, Safety.UNSAFE) if edits else None
        message = (
            f"`{path}` has a node and a `main`, but no entry point, unlike the others in its folder: `ros2 run` can't "
            f"start it; add `{name} = {module}:main`"
        )
        yield Hit(path, main, message, fix=fix)
