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
UNREACHED = (
    "def main():\n    raise NotImplementedError\n    print(modes)\n",
    "def main():\n    if input():\n        return\n        print(modes)\n    for each in 'ab':\n        continue\n"
    "        print(mode)\n",
    "def main():\n    if False:\n        print(modes)\n",
    "DEBUG = False\n\n\ndef main():\n    if DEBUG:\n        print(modes)\n",
    "import os\n\n\ndef main():\n    return print\n    os.environment()\n",
    "class Talker:\n    def __init__(self):\n        raise NotImplementedError\n\n        def say():\n"
    "            print(self.words)\n\n\ndef main():\n    Talker()\n",
)

CASES = {"DEP117": tuple(map(talker, (*BEHIND, *UNREACHED)))}
