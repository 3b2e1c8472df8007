"""SET204 empty-glob."""

from __future__ import annotations

import re
from collections.abc import Iterator

from ...checks.setup.share_files import ShareFiles, folder_of
from ...checks.uninstalled_folders import UninstalledFolders
from ...example import Example, setup_py
from ...finding import Hit, Severity
from ...lazy_regex import regex
from ...rule import rule

LAUNCH = "<launch>\n</launch>\n"
ENTRY = "        ('share/' + package_name, ['package.xml']),\n"


def launch(pattern: str) -> str:
    line = f"        ('share/' + package_name + '/launch', {pattern}),\n"
    return "from glob import glob\n" + setup_py().replace(ENTRY, ENTRY + line)


PLACEHOLDER = regex(r"(?:.*/)?(?:place_?holder|git_?keep|keep|empty|readme|todo)\b.*", re.IGNORECASE)
"""Files that keep a folder in git until it holds something."""


@rule(
    "SET204",
    "empty-glob",
    over=ShareFiles,
    severity=Severity.WARNING,
    levels={
        Severity.ERROR: "a launch file, a module or the README refers to the folder",
        Severity.INFO: "the folder is not there, holds no launch files or only a placeholder, and nothing refers to it",
    },
    examples=(
        Example(
            bad={"setup.py": launch("«glob('launch/*.launch.xml')»"), "launch/robot_launch.xml": LAUNCH},
            good={"setup.py": launch("glob('launch/*launch.[pxy][yma]*')")},
        ),
        Example(
            bad={
                "setup.py": launch("«glob('lanch/*launch.xml')»"),
                "launch/robot_launch.xml": LAUNCH,
                "README.md": "Run `ros2 launch my_pkg robot_launch.xml`.\n",
            },
            good={"setup.py": launch("glob('launch/*launch.xml')")},
        ),
        Example(
            bad={"setup.py": launch("«glob('launch/*launch.xml')»")},
            good={"launch/robot_launch.xml": LAUNCH},
        ),
    ),
)
def empty_glob(shared: ShareFiles) -> Iterator[Hit]:
    """
    ## What it does
    Finds a glob in setup.py that matches no file.
    It is left alone where something else installs what is in its folder.

    ## Why is this bad?
    A glob that matches nothing is no error for Python: the build is green, nothing is installed, and `ros2 launch`
    says "file … was not found in the share directory of package …". Often the file is called `robot_launch.py` and the
    pattern is `*.launch.py`; `launch/*launch.[pxy][yma]*` finds both, and XML and YAML too.

    ## When it is quiet
    Where setup.py may write files, where another entry installs files of the folder, where git ignores what the glob
    looks for, and below a submodule that is not checked out. It is an info where neither the package nor one that
    depends on it seems to open what is in the folder, unless that is for launch files.
    """
    files, setup = shared.package.files, shared.package.setup
    for glob in shared.empty_globs if not setup.may_write_files else ():
        folder = folder_of(glob.pattern)
        held = sorted(path for path in files.below(folder) if "/." not in path)
        near = None if held else shared.suggestion(folder)
        if held:
            shown = ", ".join(f"`{path}`" for path in held[:3]) + (", …" if len(held) > 3 else "")
            what = f"the folder holds {shown}"
        else:
            what = f"there is no folder `{folder}`" + (f" (did you mean `{near}`?)" if near else "")
        folder_named = folder if held else near
        level = UninstalledFolders(shared.uses).level(folder_named) if folder_named else "info"
        is_bare = level != "error" and all(map(PLACEHOLDER.fullmatch, held)) and not near
        level = "info" if is_bare else level
        message = f"`{glob.pattern}` matches no file: the build is green and installs nothing; {what}"
        yield Hit(setup.path, glob.span, message, level=Severity(level) if level else None)
