"""SET002 wrong-script-dir."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.setup.script_dir import SCRIPT_OPTIONS, ScriptDir
from ...edits.setup_cfg import put_option, replace_value
from ...example import SETUP_CFG, Example, manifest, scripts, setup_py
from ...finding import Fix, Hit, Safety, Severity
from ...rule import rule

NODE = "import rclpy\n\n\ndef main():\n    rclpy.init()\n"
PACKAGE = {
    "package.xml": manifest("  <exec_depend>rclpy</exec_depend>\n"),
    "setup.py": setup_py(scripts("talker = my_pkg.talker:main")),
    "my_pkg/talker.py": NODE,
}
WRONG = "[develop]\nscript_dir=«$base/lib/your_pkg»\n[install]\ninstall_scripts=«$base/lib/your_pkg»\n"
HALF = "«[develop]»\nscript_dir=$base/lib/my_pkg\n"


@rule(
    "SET002",
    "wrong-script-dir",
    over=ScriptDir,
    severity=Severity.ERROR,
    levels={
        Severity.WARNING: "only `[develop]` is wrong, which `colcon build --symlink-install` alone reads, or only "
        "`[install]`, where the repository is built that way",
        Severity.INFO: "they go below `share`, and none runs a node: other packages may start them by their path; or "
        "`[develop] script_dir` alone is missing, for which builds take `install_scripts`",
    },
    examples=(
        Example(bad={**PACKAGE, "setup.cfg": WRONG}, good={"setup.cfg": SETUP_CFG}, fix=Safety.SAFE),
        Example(
            bad={
                **PACKAGE,
                "setup.cfg": SETUP_CFG.replace("install_scripts=$base/lib/my_pkg", "install_scripts=«$base/bin»"),
            },
            good={"setup.cfg": SETUP_CFG},
            fix=Safety.SAFE,
        ),
        Example(bad={**PACKAGE, "setup.cfg": HALF}, good={"setup.cfg": SETUP_CFG}, fix=Safety.SAFE),
    ),
)
def wrong_script_dir(home: ScriptDir) -> Iterator[Hit]:
    """
    ## What it does
    Finds a setup.cfg that does not install executables to `lib/<package>`.
    `[install] install_scripts` is missing, or it or `[develop] script_dir` names another folder of the prefix.

    ## Why is this bad?
    `ros2 run` and launch files look in `lib/<package>` alone. The build is green, and then there is "No executable
    found". A copied setup.cfg that names the package it came from is the usual cause. `[develop]` is read by
    `colcon build --symlink-install`, `[install]` by every other build, and by that one where `[develop]` is missing
    (`set_undefined_options` of setuptools' `easy_install`; measured with setuptools 58 to 82).

    ## When it is quiet
    Where the value is no folder below `$base`, or a deep one (but for those below `share`), and for `$base/bin`, which
    is for command line tools, unless a launch file starts one of them or the other option says `lib/<package>`. Where
    setup.py makes links or has a command of its own that installs scripts (`cmdclass`), neither `bin` nor a missing
    option is reported. Where no executable runs a node, a missing option is none, unless the other one says
    `lib/<package>`. Where `data_files` installs a script of the name of each executable into `lib/<package>`.
    """
    name = home.package.name
    wanted = f"$base/lib/{name}"
    when, level = home.when, Severity.WARNING if home.when else None
    for _, key, value in home.wrong:
        if value is not None:
            message = (
                f"`{key}` puts executables into `{value.text}`{when}: `ros2 run {name} …` and launch files look in "
                f"`lib/{name}`; write `{wanted}`"
            )
            is_apart = "/share/" in value.text and not home.nodes
            safety = Safety.UNSAFE if is_apart else Safety.SAFE
            fix = Fix(f"write `{wanted}`", (replace_value(value, wanted),), safety)
            yield Hit(value.path, value.shown, message, Severity.INFO if is_apart else level, fix=fix)
    missing = [(section, key) for section, key, value in home.wrong if value is None]
    if missing and home.cfg is not None:
        shown = " and ".join(f"`[{section}] {key}`" for section, key in missing)
        is_defaulted = missing == [SCRIPT_OPTIONS[0]]
        message = (
            f"setup.cfg lacks {shown}: `colcon build --symlink-install` takes `install_scripts` for it, so nothing "
            f"fails; `ros2 pkg create` writes both"
            if is_defaulted
            else f"setup.cfg lacks {shown}:{when} executables go to bin/, where `ros2 run {name} …` and launch files "
            f"don't look; set it to `{wanted}`"
        )
        fix = Fix(f"set {shown} to `{wanted}`", put_option(home.cfg, missing, wanted))
        yield Hit(home.cfg.path, home.cfg.span, message, Severity.INFO if is_defaulted else level, fix=fix)
