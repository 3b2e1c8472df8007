"""SET206 data-folder-not-installed."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.setup.share_files import ShareFiles
from ...edits.data_files import install_folder
from ...example import SETUP_PY, Example
from ...finding import Fix, Hit, Safety, Severity
from ...rule import rule

FILES = {
    "launch/robot.launch.xml": "<launch>\n</launch>\n",
    "README.md": "Run `ros2 launch my_pkg robot.launch.xml`.\n",
}
YAML = {"config/nav.yaml": "/**:\n  ros__parameters:\n    rate: 2.0\n"}
ENTRY = "        ('share/' + package_name, ['package.xml']),\n"
MARKED = SETUP_PY.replace("data_files=", "«data_files»=")


def good(folder: str, pattern: str) -> str:
    line = f"        ('share/' + package_name + '/{folder}', glob('{pattern}')),\n"
    return "from glob import glob\n" + SETUP_PY.replace(ENTRY, ENTRY + line)


@rule(
    "SET206",
    "data-folder-not-installed",
    over=ShareFiles,
    severity=Severity.WARNING,
    levels={Severity.ERROR: "a launch file, a module or the README refers to the folder"},
    examples=(
        Example(
            bad={**FILES, "setup.py": MARKED},
            good={"setup.py": good("launch", "launch/*launch.[pxy][yma]*")},
            fix=Safety.SAFE,
        ),
        Example(
            bad={**YAML, "setup.py": MARKED},
            good={"setup.py": good("config", "config/*.yaml")},
            fix=Safety.SAFE,
        ),
    ),
)
def data_folder_not_installed(shared: ShareFiles) -> Iterator[Hit]:
    """
    ## What it does
    Finds folders of launch files, parameters, robots, worlds or maps that setup.py does not install.
    A folder counts (meshes too) if `data_files` installs nothing in it.

    ## Why is this bad?
    The build is green, and at run time there is "file 'robot.launch.py' was not found in the share directory of package
    'my_pkg'": only what `data_files` names is installed.
    """
    package = shared.package
    setup = package.setup
    if not package.knows_data_files:
        return
    for folder in shared.uninstalled_runtime_folders:
        files = shared.useful(folder)
        edits = install_folder(setup, package.name, folder, files)
        fix = Fix(f"install {folder}/ into share/{package.name}/{folder}", edits) if edits else None
        start = f"`ros2 launch {package.name} …`" if folder == "launch" else "what opens it in the share directory"
        message = (
            f"nothing of `{folder}/` is installed (`{files[0]}`{' and others' if files[1:] else ''}): the build is "
            f"green, and {start} does not find it; add it to `data_files`"
        )
        level = Severity.ERROR if shared.refers_to(folder) else None
        yield Hit(setup.path, setup.name_span("data_files"), message, level=level, fix=fix)
