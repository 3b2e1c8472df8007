"""Permissions that a pattern of install(DIRECTORY) gives to what it fits (CMK105)."""

from __future__ import annotations

from .idioms_of_cmake import package

SCRIPT = {"scripts/talker.py": "#!/usr/bin/env python3\nimport rclpy\n\nif __name__ == '__main__':\n    rclpy.init()\n"}
FOLDER = 'install(DIRECTORY scripts/ DESTINATION lib/my_pkg {} "*.py" PERMISSIONS OWNER_READ {})\n'

CASES = {
    "CMK105": (
        package(FOLDER.format("FILES_MATCHING PATTERN", "OWNER_EXECUTE"), SCRIPT),
        package(FOLDER.format("FILES_MATCHING PATTERN", "WORLD_READ"), SCRIPT),
        package(FOLDER.format("PATTERN", "OWNER_EXECUTE").replace("*.py", "*.sh"), SCRIPT),
    ),
}
