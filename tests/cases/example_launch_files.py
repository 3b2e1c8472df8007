"""Launch files that are examples by their names, which people copy into a package of their own (CMK101)."""

from __future__ import annotations

from .idioms_of_cmake import package

LAUNCH = "def generate_launch_description():\n    return None\n"
STARTED = {"README.md": "Run `ros2 launch my_pkg arm-example.launch.py`.\n"}

CASES = {
    "CMK101": (
        package("", {"launch/arm-example.launch.py": LAUNCH}),
        package("", {"launch/arm-example.launch.py": LAUNCH, **STARTED}),
        package("", {"launch/arm-example.launch.py": LAUNCH, "launch/arm.launch.py": LAUNCH}),
        package("", {"launch/counterexamples.launch.py": LAUNCH}),
    ),
}
