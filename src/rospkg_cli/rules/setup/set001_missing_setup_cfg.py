"""SET001 missing-setup-cfg."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.setup.script_dir import ScriptDir
from ...edits.setup_cfg import new_setup_cfg
from ...example import SETUP_CFG, Example, manifest, scripts, setup_py
from ...finding import Fix, Hit, Safety, Severity
from ...rule import rule

NODE = "import rclpy\n\n\ndef main():\n    rclpy.init()\n"
DECLARED = manifest("  <exec_depend>rclpy</exec_depend>\n")


@rule(
    "SET001",
    "missing-setup-cfg",
    over=ScriptDir,
    severity=Severity.ERROR,
    levels={Severity.INFO: "no executable runs a node: a command line tool may well want bin/"},
    examples=(
        Example(
            bad={
                "package.xml": DECLARED,
                "setup.py": setup_py(scripts("«talker = my_pkg.talker:main»")),
                "setup.cfg": None,
                "my_pkg/talker.py": NODE,
            },
            good={"setup.cfg": SETUP_CFG},
            fix=Safety.SAFE,
        ),
        Example(
            bad={
                "setup.py": setup_py(scripts("«convert = my_pkg.convert:main»")),
                "setup.cfg": None,
                "my_pkg/convert.py": "def main():\n    print('converted')\n",
            },
            good={"setup.cfg": SETUP_CFG},
        ),
    ),
)
def missing_setup_cfg(home: ScriptDir) -> Iterator[Hit]:
    """
    ## What it does
    Finds a package with executables and no setup.cfg.

    ## Why is this bad?
    Without `install_scripts` setuptools puts executables into `bin/`. `ros2 run` and launch files look in
    `lib/<package>` and say "No executable found" or "libexec directory … does not exist", although the build
    was green.

    ## When it is quiet
    Where setup() itself sets `options` for the scripts, and for an executable if `data_files` also installs an
    executable script of the same name into `lib/<package>`: it is found there. Where no executable runs a
    node, as far as its module and the launch files of the workspace show, it is an info.

    ## References
    https://docs.ros.org/en/rolling/How-To-Guides/Developing-a-ROS-2-Package.html
    """
    package = home.package
    if home.is_configured or not home.executables:
        return
    entry = (home.nodes or home.executables)[0]
    message = (
        f"there is no setup.cfg: `{entry.name}` goes to bin/, where `ros2 run {package.name} {entry.name}` and launch "
        f"files don't look; write one with `$base/lib/{package.name}`"
    )
    if home.nodes:
        fix = Fix(f"write setup.cfg with `$base/lib/{package.name}`", (new_setup_cfg(package.name),))
        yield Hit(entry.path, entry.span, message, fix=fix)
    else:
        yield Hit(entry.path, entry.span, message, level=Severity.INFO)
