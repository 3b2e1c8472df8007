"""SET207 file-not-installed."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.setup.share_files import ShareFiles
from ...edits.data_files import widen_glob
from ...example import Example, setup_py
from ...finding import Fix, Hit, Safety, Severity
from ...rule import rule

ENTRY = "        ('share/' + package_name, ['package.xml']),\n"
LAUNCH = "<launch>\n</launch>\n"
FILES = {"launch/robot.launch.xml": LAUNCH, "launch/arm_launch.xml": LAUNCH}


def launch(pattern: str) -> str:
    line = f"        ('share/' + package_name + '/launch', {pattern}),\n"
    return "from glob import glob\n" + setup_py().replace(ENTRY, ENTRY + line)


@rule(
    "SET207",
    "file-not-installed",
    over=ShareFiles,
    severity=Severity.WARNING,
    examples=(
        Example(
            bad={**FILES, "setup.py": launch("«glob('launch/*.launch.xml')»")},
            good={"setup.py": launch("glob('launch/*launch.[pxy][yma]*')")},
            fix=Safety.UNSAFE,
        ),
    ),
)
def file_not_installed(shared: ShareFiles) -> Iterator[Hit]:
    """
    ## What it does
    Finds launch and parameter files that the globs for their folder do not match.
    Other files of the folder are installed: `x_launch.py` is left out by `*.launch.py`, `.yml` by `*.yaml`, and files
    in subfolders by both.

    ## Why is this bad?
    The build is green, the other files are found, and this one "was not found in the share directory".

    ## Fix safety
    A wider glob may install more than is wanted.
    """
    package = shared.package
    for missed in shared.uninstalled_neighbours if package.knows_data_files else ():
        edits = widen_glob(package.setup, missed.glob, missed.path)
        fix = Fix(f"widen the glob so that it finds {missed.path}", edits, Safety.UNSAFE) if edits else None
        folder = missed.path.endswith("/")
        why = "unlike the folders next to it" if folder else f"`{missed.glob.pattern}` finds only its neighbours"
        message = (
            f"`{missed.path}` is not installed, {why}: the build is green, and it is missing in share/{package.name}"
        )
        yield Hit(package.setup.path, missed.glob.span, message, fix=fix)
