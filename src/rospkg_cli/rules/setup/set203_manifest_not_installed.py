"""SET203 manifest-not-installed."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.setup.share_files import ShareFiles
from ...edits.data_files import add_data_entry, share_code
from ...edits.setup_py import quoted
from ...example import SETUP_PY, Example
from ...finding import Fix, Hit, Safety, Severity
from ...rule import rule

LINE = "        ('share/' + package_name, ['package.xml']),\n"
BAD = SETUP_PY.replace(LINE, "").replace("data_files=", "«data_files»=")


@rule(
    "SET203",
    "manifest-not-installed",
    over=ShareFiles,
    severity=Severity.WARNING,
    examples=(Example(bad={"setup.py": BAD}, good={"setup.py": SETUP_PY}, fix=Safety.SAFE),),
)
def manifest_not_installed(shared: ShareFiles) -> Iterator[Hit]:
    """
    ## What it does
    Finds a package whose `data_files` do not install package.xml to `share/<package>`.

    ## Why is this bad?
    `ros2 pkg`, rosdep and the tools that read versions and dependencies of what is installed look there. colcon adds it
    for now and warns that it will not in the future; a Debian package and pip do not.

    ## When it is quiet
    Where `data_files` can't be evaluated, where setup.py may write files, and where it is installed below the name
    in setup.py (SET401).
    """
    package, name = shared.package, shared.package.name
    if not package.knows_data_files or shared.installs_manifest:
        return
    setup = package.setup
    edits = add_data_entry(setup, share_code(setup, name), f"[{quoted(setup, 'package.xml')}]")
    absent = setup.argument("data_files") is None and not shared.installs_marker
    fix = Fix(f"install package.xml into share/{name}", edits) if edits and not absent else None
    message = (
        f"package.xml is not installed into `share/{name}`: colcon still adds it with a warning, Debian packages and "
        f"pip don't; add it to `data_files`"
    )
    yield Hit(setup.path, setup.name_span("data_files"), message, fix=fix)
