"""Names that nothing binds, in code that few starts come to, or none."""

from __future__ import annotations

from .undefined_names import talker

BEHIND = (
    "import rclpy\n\n\ndef main():\n    while rclpy.ok():\n        print('a')\n    print(modes)\n",
    "def main(speed=1):\n    while speed and input():\n        print('a')\n    print(modes)\n",
    "def main():\n    while not input.is_shutdown():\n        print('a')\n    print(modes)\n",
    "def main():\n    while input.ok() and not input.wait_for_service(1.0):\n        print('a')\n    print(modes)\n",
    "def main(speed=1):\n    while not input.wait_for_service(1.0) or speed:\n        print('a')\n    print(modes)\n",
    "import rclpy\n\n\ndef main():\n    rclpy.spin()\n    print(modes)\n",
)

CASES = {"DEP117": tuple(map(talker, BEHIND))}
