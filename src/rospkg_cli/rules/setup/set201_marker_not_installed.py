"""SET201 marker-not-installed."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.setup.share_files import ShareFiles
from ...edits.data_files import install_marker
from ...example import SETUP_PY, Example
from ...finding import Fix, Hit, Safety, Severity
from ...rule import rule

LINE = "        ('share/ament_index/resource_index/packages', ['resource/' + package_name]),\n"
MANIFEST = "        ('share/' + package_name, ['package.xml']),\n"
BAD = SETUP_PY.replace(LINE, "").replace("data_files=", "«data_files»=")
COPIED = SETUP_PY.replace("['resource/' + package_name]", "['«resource/your_pkg»']")


@rule(
    "SET201",
    "marker-not-installed",
    over=ShareFiles,
    severity=Severity.WARNING,
    examples=(
        Example(
            bad={"setup.py": BAD},
            good={"setup.py": SETUP_PY.replace(LINE + MANIFEST, MANIFEST + LINE)},
            fix=Safety.SAFE,
        ),
        Example(
            bad={"setup.py": COPIED, "resource/your_pkg": ""},
            good={"setup.py": SETUP_PY.replace("'resource/' + package_name", "'resource/my_pkg'")},
            fix=Safety.SAFE,
        ),
    ),
)
def marker_not_installed(shared: ShareFiles) -> Iterator[Hit]:
    """
    ## What it does
    Finds a package whose `data_files` do not install its ament index marker.
    It is `resource/<package>`. A marker that is installed under another name is found as well.

    ## Why is this bad?
    The index is how `ros2 run`, `ros2 launch` and `get_package_share_directory` find a package: "package not found".
    colcon adds a missing marker for now and warns that it will not in the future; a Debian package and pip do not.

    ## When it is quiet
    Where `data_files` can't be evaluated, where setup.py may write files, and where the marker of the name in
    setup.py is installed (SET401 reports that name).
    """
    package, name = shared.package, shared.package.name
    if not package.knows_data_files or shared.installs_marker:
        return
    wrong = next(iter(shared.markers), None)
    operations = install_marker(package.setup, name, wrong, absent=not package.files.exists(f"resource/{name}"))
    fix = Fix(f"install resource/{name}", operations) if operations else None
    if wrong is not None:
        message = (
            f"the marker is installed as `{wrong.setup_text.text}`: colcon adds `{name}` with a warning; of a Debian "
            f"package `ros2 run {name}` finds nothing; install `resource/{name}`"
        )
        yield Hit(wrong.setup_text.path, wrong.setup_text.shown, message, fix=fix)
        return
    message = (
        f"the marker `resource/{name}` is not installed: colcon adds it with a warning, but of a Debian package "
        f"`ros2 run {name}` finds nothing; add it to `data_files`"
    )
    yield Hit(package.setup.path, package.setup.name_span("data_files"), message, fix=fix)
