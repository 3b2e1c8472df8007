"""SET207 file-not-installed."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from ...checks.setup.left_out_files import left_out
from ...checks.setup.uninstalled_files import UninstalledFiles, UninstalledNeighbour
from ...edits.data_files import widen_glob
from ...example import Example, setup_py
from ...finding import Fix, Hit, Related, Safety, Severity
from ...rule import rule
from ...source import Span

ENTRY = "        ('share/' + package_name, ['package.xml']),\n"
LAUNCH = "<launch>\n</launch>\n"
FILES = {
    "launch/robot.launch.xml": LAUNCH,
    "launch/arm_launch.xml": LAUNCH,
    "README.md": "Run `ros2 launch my_pkg arm_launch.xml`.\n",
}


def launch(pattern: str) -> str:
    line = f"        ('share/' + package_name + '/launch', {pattern}),\n"
    return "from glob import glob\n" + setup_py().replace(ENTRY, ENTRY + line)


@rule(
    "SET207",
    "file-not-installed",
    over=UninstalledFiles,
    severity=Severity.WARNING,
    levels={Severity.INFO: "where nothing here opens them in the package's share directory"},
    examples=(
        Example(
            bad={**FILES, "setup.py": launch("«glob('launch/*.launch.xml')»")},
            good={"setup.py": launch("glob('launch/*launch.[pxy][yma]*')")},
            fix=Safety.UNSAFE,
        ),
    ),
)
def file_not_installed(uninstalled: UninstalledFiles) -> Iterator[Hit]:
    """
    ## What it does
    Finds launch and parameter files that the globs for their folder do not match.
    Other files of the folder are installed: `x_launch.py` is left out by `*.launch.py`, `.yml` by `*.yaml`, and files
    in subfolders by both. Where all launch files of a folder but one are listed by their names, it finds that one.

    ## Why is this bad?
    The build is green, the other files are found, and this one "was not found in the share directory".

    ## When it is quiet
    Where `data_files` can't be evaluated, where setup.py may write files, for files that git ignores, and for those of
    other kinds than the folder is for, and those that are laid aside (`old/`). All files that one glob misses are one
    finding. It is a warning where a launch file, code, a robot or YAML of the workspace opens one of them in the share
    directory of the package (`get_package_share_directory('my_pkg')` joined with its name,
    `$(find-pkg-share my_pkg)/…`, `package://my_pkg/…`) or next to a robot or a map, where another launch file includes
    it, and where a page or a script starts it by `ros2 launch my_pkg …`. Elsewhere it is an info: in comments, in paths
    to the source or to the share directory of another package, and for empty files.

    ## Fix safety
    A wider glob may install more than is wanted.
    """
    package = uninstalled.package
    for path, listed in left_out(uninstalled):
        start = f"`{path}` is not installed, but the others of its folder are"
        fails = f"`ros2 launch {package.name} {path.rpartition('/')[2]}` does not find it"
        message = f"{start}: {fails}; add it here, or remove it"
        level = None if uninstalled.shared.opened.opens(path) else Severity.INFO
        yield Hit(listed.setup_text.path, listed.setup_text.shown, message, level)
    groups: dict[tuple[Span, bool], list[UninstalledNeighbour]] = {}
    for missed in uninstalled.neighbours if package.knows_data_files else ():
        groups.setdefault((missed.glob.span, missed.path.endswith("/")), []).append(missed)
    for (span, is_folder), group in groups.items():
        first, *others = sorted(group, key=lambda each: not uninstalled.is_wanted(each))
        edits = widen_glob(package.setup, first.glob, first.path)
        fix = Fix(f"widen the glob so that it finds {first.path}", edits, Safety.UNSAFE) if edits else None
        why = "unlike the folders next to it" if is_folder else f"`{first.glob.pattern}` finds only its neighbours"
        shown = f"`{first.path}`" + (f" and {len(others)} more are" if others else " is")
        message = (
            f"{shown} not installed, {why}: the build is green, and share/{package.name} lacks "
            f"{'them' if others else 'it'}; add {'a glob' if is_folder else 'them' if others else 'it'} to `data_files`"
        )
        related = tuple(Related(place, Span(0, 0), "not installed either") for place in places(uninstalled, others))
        level = None if uninstalled.is_wanted(first) else Severity.INFO
        yield Hit(package.setup.path, span, message, level, related=related, fix=fix)


def places(uninstalled: UninstalledFiles, missed: Sequence[UninstalledNeighbour]) -> Iterator[str]:
    """Yield a file for each that is missed: of a folder the first of its files."""
    for each in missed:
        yield next(iter(uninstalled.useful(each.path.rstrip("/"))), each.path) if each.path.endswith("/") else each.path
