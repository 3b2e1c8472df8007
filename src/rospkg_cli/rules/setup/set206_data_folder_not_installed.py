"""SET206 data-folder-not-installed."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.setup.uninstalled_files import UninstalledFiles
from ...checks.uninstalled_folders import UninstalledFolders
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
    return "from glob import glob\n\n" + SETUP_PY.replace(ENTRY, ENTRY + line)


@rule(
    "SET206",
    "data-folder-not-installed",
    over=UninstalledFiles,
    severity=Severity.WARNING,
    levels={
        Severity.ERROR: "code, a launch file or the README opens it in the share directory (RViz goes on without)",
        Severity.INFO: "nothing in the package or the workspace seems to; or the README opens it in the source folder",
    },
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
def data_folder_not_installed(uninstalled: UninstalledFiles) -> Iterator[Hit]:
    """
    ## What it does
    Finds folders of launch files, parameters, robots, worlds or maps that setup.py does not install.
    A folder counts (meshes too) if `data_files` installs nothing in it.

    ## Why is this bad?
    The build is green, and at run time there is "file 'robot.launch.py' was not found in the share directory of package
    'my_pkg'": only what `data_files` names is installed.

    ## When it is quiet
    Where `data_files` can't be evaluated, or setup.py may write files, where a glob names the folder, where git ignores
    its files, where `launch/` holds nothing that launch can load (a program, files for ROS 1), and where a launch file
    or module makes the folder in the share directory and writes them there. Where the README opens them in the source
    folder (`--params-file src/…/config/a.yaml`), code does so there or in a user's home, or pages and scripts start
    launch files by their paths alone (`ros2 launch src/…/a.launch.py`), it is an info. It is one, too, where neither
    the package nor another one of the workspace that names it seems to open the folder or a file in it: they may be
    leftovers, or notes, or copies (`config/a.yaml` opens none in `maps/`). So is a folder that only actions of launch
    files open which are off by default, and which no text turns on (`tune:=true`), one that a script, a container or a
    page copies or mounts into the share directory, and launch files of which each stops at a keyword that Foxy took
    last (`node_executable=`), where neither pages nor names say that they are for it, and nothing opens them. Launch
    files are opened by `ros2 launch`.
    """
    package, shared = uninstalled.package, uninstalled.shared
    setup = package.setup
    if not package.knows_data_files:
        return
    uses = UninstalledFolders(shared.uses)
    for folder in uninstalled.folders:
        files = uninstalled.useful(folder)
        if shared.uses.makes(folder, files):
            continue
        edits = install_folder(setup, package.name, folder, files)
        fix = Fix(f"install {folder}/ into share/{package.name}/{folder}", edits) if edits else None
        message = (
            f"nothing of `{folder}/` is installed (`{files[0]}`{' and others' if files[1:] else ''}): "
            f"{uses.consequence(folder)}; add it to `data_files`"
        )
        level = uses.level(folder)
        yield Hit(setup.path, setup.name_span("data_files"), message, Severity(level) if level else None, fix=fix)
