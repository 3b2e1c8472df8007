"""Modules that only modules import which nothing starts, and scripts among the programs that can't be started."""

from __future__ import annotations

from rospkg_cli.example import Example, scripts, setup_py
from rospkg_cli.rules.setup.set302_package_not_installed import FOUND

from .left_files import OPENS

TALKER = "def main():\n    pass\n"
STARTS = setup_py(scripts("talker = my_pkg.talker:main"))
INNER = STARTS.replace(FOUND, "[package_name]")
COMPUTED = STARTS.replace("'talker = my_pkg.talker:main'", "f'talker = {package_name}.talker:main'")
PROGRAMS = STARTS.replace(
    "        ('share/' + package_name, ['package.xml']),\n",
    "        ('share/' + package_name, ['package.xml']),\n        ('lib/' + package_name, ['scripts/export.py']),\n",
)
COMMENTED = """\
from launch import LaunchDescription


def generate_launch_description():
    {}
    return LaunchDescription([])
"""


def python(setup: str = STARTS, **files: str) -> Example:
    named = {f"{name.replace('__', '/')}.py": text for name, text in files.items()}
    return Example(bad={"setup.py": setup, "my_pkg/talker.py": TALKER, "photos/a.png": "", **named}, good={})


def idle(setup: str = STARTS, **files: str) -> Example:
    """Return a module with a path that a window imports, which nothing starts but what is in `files`."""
    return python(setup, my_pkg__camera=OPENS, my_pkg__window="from my_pkg.camera import IMAGES\n", **files)


def program(setup: str = PROGRAMS, **files: str) -> Example:
    return python(setup, scripts__export=OPENS, **files)


CASES = {
    "DEP118": (
        idle(),
        idle(my_pkg__start="from my_pkg.window import IMAGES\n"),
        idle(my_pkg__talker=f"from my_pkg.window import IMAGES\n\n\n{TALKER}"),
        idle(my_pkg__start="from my_pkg.window import IMAGES\n", test__test_start="from my_pkg import start\n"),
        idle(COMPUTED, my_pkg__talker=f"from my_pkg.window import IMAGES\n\n\n{TALKER}"),
        python(COMPUTED, my_pkg__talker=f"{OPENS}\n\n{TALKER}"),
        python(
            INNER,
            my_pkg__inner__camera=OPENS,
            my_pkg__window="from .inner.camera import IMAGES\n",
        ),
        python(
            INNER,
            my_pkg__inner__camera=OPENS,
            my_pkg__window="from .inner.camera import IMAGES\n",
            my_pkg__talker=f"from .window import IMAGES\n\n\n{TALKER}",
        ),
        python(my_pkg__camera=f"import my_pkg.window\n{OPENS}", my_pkg__window="import my_pkg.camera\n"),
        program(),
        program(launch__a_launch=COMMENTED.format("# cmd=['python3', 'export.py']")),
        program(launch__a_launch=COMMENTED.format("run(['python3', 'export.py'])")),
        program(PROGRAMS.replace("    zip_safe", "    scripts=['scripts/export.py'],\n    zip_safe")),
    ),
}
