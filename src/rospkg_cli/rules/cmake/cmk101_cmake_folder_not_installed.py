"""CMK101 cmake-folder-not-installed."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from ...checks.cmake.commented_installs import CommentedInstalls
from ...checks.cmake.idle_packages import idle_programs
from ...checks.cmake.launch_file_installs import LaunchFileInstalls
from ...checks.cmake.share_folders import RuntimeFolders
from ...checks.opened_in_share import OpenedInShare
from ...checks.uninstalled_folders import UninstalledFolders
from ...edits.cmake_install import install_folder
from ...example import CMAKE, Example
from ...finding import Fix, Hit, Safety, Severity
from ...package.install_table import InstalledFile
from ...rule import rule

LAUNCH = {
    "launch/robot.launch.xml": "<launch>\n</launch>\n",
    "README.md": "Run `ros2 launch my_pkg robot.launch.xml`.\n",
}
MESHES = {"meshes/base.stl": "solid base\n", "rviz/robot.rviz": "Panels: []\n"}
INSTALL = "install(DIRECTORY launch\n  DESTINATION share/${PROJECT_NAME}\n)\n"
ONE = CMAKE.replace("ament_package", "install(DIRECTORY meshes DESTINATION share/${PROJECT_NAME})\nament_package")


@rule(
    "CMK101",
    "cmake-folder-not-installed",
    over=RuntimeFolders,
    severity=Severity.WARNING,
    levels={
        Severity.ERROR: "code, a launch file or the README opens it in the share directory (RViz goes on without)",
        Severity.INFO: "nothing in the package or the workspace seems to; or the README opens it in the source folder; "
        "or it is one launch file next to others, which no page or script starts; or a comment installs it, and "
        "nothing here opens it",
    },
    examples=(
        Example(
            bad={**LAUNCH, "CMakeLists.txt": CMAKE.replace("ament_package()", "«ament_package()»")},
            good={"CMakeLists.txt": CMAKE.replace("ament_package", f"\n{INSTALL}\nament_package")},
            on="ament_cmake",
            fix=Safety.SAFE,
        ),
        Example(
            bad={**MESHES, "CMakeLists.txt": ONE.replace("install(", "«install(").replace("NAME})", "NAME})»")},
            good={"CMakeLists.txt": ONE.replace("meshes", "meshes rviz")},
            on="ament_cmake",
            fix=Safety.SAFE,
        ),
    ),
)
def cmake_folder_not_installed(folders: RuntimeFolders) -> Iterator[Hit]:
    """
    ## What it does
    Finds folders of launch files, parameters, robots, worlds or maps that CMake does not install.
    A folder counts (meshes too) if nothing in it is installed, and launch files that are all installed elsewhere; and
    one launch file, where a rule lists all others of its folder; and programs in scripts/ or the like, where the
    package installs nothing at all.

    ## Why is this bad?
    The build is green, and at run time there is "file 'robot.launch.py' was not found in the share directory of package
    'my_pkg'": only what `install()` names is installed.

    ## When it is quiet
    Where a launch file or module makes the folder in the share directory and writes all its files there. Where
    `launch/` holds nothing that launch can load (a program, files for ROS 1). Where install rules can't be evaluated
    (what the build makes hides only its destination), where a macro of another package is called, which may install
    files, where another command names the folder, and where git ignores its files. Where the README opens them in the
    source folder (`--params-file src/…/config/a.yaml`), code does so there or in somebody's home, or pages and scripts
    start launch files by their paths alone (`ros2 launch src/…/a.launch.py`), it is an info. It is one, too, where
    neither the package nor another one of the workspace that names it seems to open the folder or a file in it: they
    may be leftovers, or notes, or copies (`config/a.yaml` opens none in `maps/`). So is a folder that only actions of
    launch files open which are off by default, and which no text turns on (`tune:=true`), one that a script, a
    container or a page copies or mounts into the share directory, and launch files of which each stops at a keyword
    that Foxy took last (`node_executable=`), where neither pages nor names say that they are for it, and nothing opens
    them. Launch files are opened by `ros2 launch`, but for those whose names all say `example` or `template`, which
    people copy, and for a folder that an `install()` in a comment names, where no package opens it and the README does
    not start it.
    """
    package, place = folders.package, folders.insertion_call
    if not package.is_ament or place is None:
        return
    name = package.facts.name
    launch_files = LaunchFileInstalls(folders)
    if row := launch_files.misplaced():
        into = (
            f"`{row.source}` is installed as `{row.destination}`: `ros2 launch {name} …` looks in `share/{name}` alone"
        )
        yield Hit(row.path, row.span, f"{into}; write `DESTINATION share/${{PROJECT_NAME}}`")
    for path, row in launch_files.left_out():
        yield left_out(name, path, row, is_started=OpenedInShare(folders.uses).is_started(path.rpartition("/")[2]))
    if programs := idle_programs(package, folders.table):
        yield Hit(place.path, place.command.span, not_run(name, programs), Severity.INFO)
    uses = UninstalledFolders(folders.uses)
    for folder in folders.uninstalled():
        files = folders.useful(folder)
        if folders.uses.makes(folder, files):
            continue
        fix = Fix(f"install {folder}/ into share/{name}/{folder}", (install_folder(package.cmake, folder),))
        message = (
            f"nothing of `{folder}/` is installed (`{files[0]}`{' and others' if files[1:] else ''}): "
            f"{uses.consequence(folder)}; add `{folder}` to an `install(DIRECTORY …)`"
        )
        level = uses.level(folder)
        is_left_out = CommentedInstalls(package.cmake).has_folder(folder) and not uses.may_be_opened(folder)
        if level is None and is_left_out:
            level, message = "info", f"{message}; a comment of {place.path} installs it"
        yield Hit(place.path, place.command.span, message, Severity(level) if level else None, fix=fix)


def left_out(name: str, path: str, row: InstalledFile, *, is_started: bool) -> Hit:
    file = path.rpartition("/")[2]
    what = f"`{path}` is not installed, but the others of its folder are"
    message = f"{what}: `ros2 launch {name} {file}` does not find it; add it here, or remove it"
    why = "" if is_started else "; nothing here starts it"
    return Hit(row.path, row.span, message + why, None if is_started else Severity.INFO)


def not_run(name: str, programs: Sequence[str]) -> str:
    folder = programs[0].partition("/")[0]
    some = f"nothing of `{folder}/` is installed (`{programs[0]}`{' and others' if programs[1:] else ''})"
    todo = f"add `install(PROGRAMS … DESTINATION lib/${{PROJECT_NAME}})` if `ros2 run {name} …` is to find them"
    return f"{some}, nor anything else of `{name}`; {todo}"
