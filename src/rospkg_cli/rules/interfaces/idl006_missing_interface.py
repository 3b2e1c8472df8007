"""IDL006 missing-interface."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.interfaces.rosidl_targets import RosidlTargets
from ...example import INTERFACES_CMAKE, Example
from ...finding import Hit, Severity
from ...rule import rule

LISTED = '"srv/SetMode.srv"'
RENAMED = '"srv/SetMode.srv"\n  «"srv/SetModes.srv"»'


@rule(
    "IDL006",
    "missing-interface",
    over=RosidlTargets,
    severity=Severity.ERROR,
    examples=(
        Example(
            on="interfaces",
            bad={
                "CMakeLists.txt": INTERFACES_CMAKE.replace(
                    '"srv/SetMode.srv"', '«"srv/SetModes.srv"»\n  "srv/SetMode.srv"'
                )
            },
            good={"CMakeLists.txt": INTERFACES_CMAKE},
        ),
    ),
)
def missing_interface(generated: RosidlTargets) -> Iterator[Hit]:
    """
    ## What it does
    Finds files that `rosidl_generate_interfaces` lists and that do not exist.

    ## Why is this bad?
    CMake stops: "the passed file … doesn't exist relative to the CMAKE_CURRENT_SOURCE_DIR".

    ## When it is quiet
    Where a command writes the file, or a program is run in its folder; where a .gitignore names it; below a submodule
    that is not checked out; and under a condition that can't be evaluated. It is an info in a folder of a course whose
    page has people copy its files into a package of `ros2 pkg create`.
    """
    for listed in generated.missing():
        renamed = generated.renamed.get(listed.path or "")
        hint = f" (did you mean `{renamed}`?)" if renamed else ""
        message = (
            f"`{listed.path}` does not exist{hint}: `rosidl_generate_interfaces` stops CMake; name an existing file"
        )
        yield Hit(listed.word.path, listed.word.span, message)
