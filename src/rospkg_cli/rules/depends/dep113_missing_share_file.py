"""DEP113 missing-share-file."""

from __future__ import annotations

from collections.abc import Iterator

from ...checks.other_places import goes_elsewhere, how_to_find_it
from ...checks.share_lookups import ShareLookups
from ...example import SETUP_PY, Example, manifest
from ...finding import Hit, Severity
from ...rule import rule

MODULE = """\
from ament_index_python.packages import get_package_share_path

with open({}) as names:
    print(names.read())
"""
NEEDS = {"package.xml": manifest("  <exec_depend>ament_index_python</exec_depend>\n")}
ENTRY = "        ('share/' + package_name, ['package.xml']),\n"
INSTALLED = SETUP_PY.replace(ENTRY, ENTRY + "        ('share/' + package_name + '/names', ['names/people.txt']),\n")
OPENS = "get_package_share_path('my_pkg') / 'names' / '{}.txt'"
PEOPLE = {**NEEDS, "names/people.txt": "Ada\n", "my_pkg/talker.py": MODULE.format(f"«{OPENS.format('people')}»")}


@rule(
    "DEP113",
    "missing-share-file",
    over=ShareLookups,
    severity=Severity.ERROR,
    levels={
        Severity.WARNING: "C++ names it, the package does not have it, or the path counts in a branch or for what is "
        "not given alone, or is opened in a `try`",
        Severity.INFO: "nothing starts or imports the module, leads to the function, or reads the variable of the "
        "path, it stands behind `rclpy.spin`, a parameter that nothing sets turns it off, or it is in a test that "
        "`colcon test` does not run",
    },
    examples=(
        Example(bad={**PEOPLE, "setup.py": SETUP_PY}, good={"setup.py": INSTALLED}),
        Example(
            bad={**PEOPLE, "setup.py": INSTALLED, "my_pkg/talker.py": MODULE.format(f"«{OPENS.format('poeple')}»")},
            good={"my_pkg/talker.py": MODULE.format(OPENS.format("people"))},
        ),
    ),
)
def missing_share_file(lookups: ShareLookups) -> Iterator[Hit]:
    """
    ## What it does
    Finds files in a share directory that Python modules and C++ name and that no rule installs there.
    It follows `get_package_share_directory` and its like, joined with literal parts, and folders of the package too, in
    C++ also where a variable is put behind the folder. Where a file is installed at another path, the message says so.

    ## Why is this bad?
    The build is green, and opening the file raises FileNotFoundError, or fails in C++.

    ## When it is quiet
    Where neither the package has the file nor installs one of a near name: the code may write it. Where the file
    asks whether something exists; where the installed files are not all known; for what CMK101, CMK111 and SET206
    to SET208 tell about; in files that nothing installs, and under a condition that never holds on Linux.
    A path that is put into a variable of a function or a member, which nothing reads, is an info, and so is one in a
    function that no program leads to, behind `rclpy.spin`, or behind a condition on a parameter (of C++, on a constant,
    too) that does not hold by default, where nothing in the repository sets it. What counts where nothing else is
    given, as the value of a parameter or an option, is a warning, like what is in a branch or in a `try` that goes on
    without the file.
    """
    for found in lookups.missing.found():
        if found.goes_to:
            start, hint = (tell(found.package, found.file, found.goes_to) for tell in (goes_elsewhere, how_to_find_it))
            message = f"{start}: this does not find it; {hint}"
        elif found.is_here:
            message = f"`{found.file}` is not installed: this does not find it in share/{found.package}; install it"
        else:
            message = f"`{found.package}` installs no file `{found.file}`; did you mean `{found.near}`?"
        is_certain = found.is_here and found.path.endswith(".py") and lookups.is_run(found.path)
        level = None if is_certain and not lookups.is_softened(found.path, found.span) else Severity.WARNING
        if lookups.is_never_run(found.path):
            level, message = Severity.INFO, f"{message}; `colcon test` does not run this file today"
        elif lookups.is_left(found.path):
            level, message = Severity.INFO, f"{message}; nothing starts or imports this module"
        elif lookups.unread and lookups.unread.has(found.path, found.span):
            level, message = Severity.INFO, f"{message}; nothing reads the variable"
        elif why := lookups.why_seldom(found.path, found.span):
            level, message = Severity.INFO, f"{message}{why}"
        yield Hit(found.path, found.span, message, level)
