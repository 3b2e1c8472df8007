"""What a message itself says nothing uses: a fault of it fails for nobody today."""

from __future__ import annotations

from rospkg_cli.example import Example, manifest, scripts, setup_py

from .setups import python
from .shown_fields import code

EAR = "\n\nclass Ear:\n    def hear(self):\n        msg = Status()\n        msg.batery = 1.0\n\n\n"
MADE = f"{EAR}def main():\n    ear = Ear()\n{{}}"
BROKEN = "class Arm:\n    def move(self:\n        pass\n"
STARTED = setup_py(scripts("talker = my_pkg.talker:main"))
USER = {
    "package.xml": manifest("  <depend>the_pkg</depend>\n", name="your_pkg").replace("the_pkg", "my_pkg"),
    "setup.py": setup_py().replace("my_pkg", "your_pkg"),
    "resource/your_pkg": "",
    "your_pkg/__init__.py": "",
    "your_pkg/user.py": "from my_pkg.arm import Arm\n",
}


def in_folder(name: str, files: dict[str, str]) -> dict[str, str]:
    return {f"{name}/{path}": text for path, text in files.items()}


def broken(files: dict[str, str]) -> Example:
    return python({"my_pkg/arm.py": BROKEN, **files})


CASES = {
    "IDL010": (code(MADE.format("")), code(MADE.format("    ear.hear()\n"))),
    "RPK001": (
        broken({}),
        broken({"my_pkg/hand.py": "from my_pkg.arm import Arm\n"}),
        broken({"my_pkg/talker.py": "from my_pkg.arm import Arm\n", "setup.py": STARTED}),
        Example(on="", bad={**in_folder("a", broken({}).bad_files()), **in_folder("b", USER)}, good={}),
    ),
}
