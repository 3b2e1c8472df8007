"""SET306 ros-package-in-install-requires."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.setup.install_requires import InstallRequires
from ...edits.setup_py import remove_item
from ...example import Example, setup_py
from ...finding import Fix, Hit, Safety, Severity
from ...rule import rule

GOOD = setup_py()
BAD = GOOD.replace("install_requires=['setuptools']", "install_requires=['setuptools', '«std_msgs»']")


@rule(
    "SET306",
    "ros-package-in-install-requires",
    over=InstallRequires,
    severity=Severity.INFO,
    examples=(Example(bad={"setup.py": BAD}, good={"setup.py": GOOD}, fix=Safety.UNSAFE),),
)
def ros_package_in_install_requires(requirements: InstallRequires) -> Iterator[Hit]:
    """
    ## What it does
    Finds ROS packages without Python modules in `install_requires`.
    They are interfaces, and packages of the workspace that CMake builds without Python.

    ## Why is this bad?
    `install_requires` names what pip installs from PyPI, where no ROS package is: outside of a sourced ROS,
    `pip install .` ends with "No matching distribution found for std_msgs". colcon and rosdep do not read it, nor do
    the executables of any supported distribution: those of Foxy and before ended with "DistributionNotFound: The
    'std_msgs' distribution was not found". Dependencies on ROS packages belong in package.xml.

    ## When it is quiet
    For packages with Python modules, and for names that are neither a package of the workspace nor end in `_msgs`.

    ## Fix safety
    Only the entry is removed; whether package.xml declares the package is another question.
    """
    for said, name in requirements.ros_requirements:
        edits = remove_item(requirements.package.setup, "install_requires", said)
        fix = Fix(f"remove `{name}` from install_requires", edits, Safety.UNSAFE) if edits else None
        message = (
            f"`{name}` is not on PyPI, and neither colcon nor rosdep reads this list; remove it here, and declare it "
            f"in package.xml as `<exec_depend>{name}</exec_depend>`"
        )
        yield Hit(said.path, said.shown, message, fix=fix)
