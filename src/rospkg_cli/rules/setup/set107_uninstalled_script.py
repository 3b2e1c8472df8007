"""SET107 uninstalled-script."""

from __future__ import annotations

import posixpath
from collections.abc import Iterator

from ...checks.setup.uninstalled_scripts import UninstalledScripts
from ...example import SETUP_PY, Example, manifest, scripts, setup_py
from ...finding import Hit, Severity
from ...rule import rule

NODE = "import rclpy\n\n\ndef «main»():\n    rclpy.init()\n\n\nif __name__ == '__main__':\n    main()\n"


@rule(
    "SET107",
    "uninstalled-script",
    over=UninstalledScripts,
    severity=Severity.INFO,
    examples=(
        Example(
            bad={
                "package.xml": manifest("  <exec_depend>rclpy</exec_depend>\n"),
                "setup.py": SETUP_PY,
                "scripts/talker.py": NODE,
            },
            good={
                "setup.py": setup_py(scripts("talker = my_pkg.talker:main")),
                "scripts/talker.py": None,
                "my_pkg/talker.py": NODE.replace("«", "").replace("»", ""),
            },
        ),
    ),
)
def uninstalled_script(scripts: UninstalledScripts) -> Iterator[Hit]:
    """
    ## What it does
    Finds nodes next to the Python package, in `scripts/` and its like, that setup.py does not install.

    ## Why is this bad?
    The build is green, and `ros2 run` finds nothing: of an ament_python package only the modules of `packages` are
    installed, and only entry points become executables.

    ## When it is quiet
    Where a README or another file names the script, where git ignores it, where it does not start itself, and where
    setup.py may write files or can't be evaluated. It is an info: many such scripts are there for the developers alone.
    """
    package = scripts.package.name
    for path, span in scripts.found():
        stem = posixpath.splitext(posixpath.basename(path))[0]
        message = (
            f"`{path}` is a node that setup.py does not install: `ros2 run {package} {stem}` does not find it; move it "
            f"to `{package}/` and give it an entry point"
        )
        yield Hit(path, span, message)
