"""Modules that `data_files` puts beside the programs: scripts of their own that nothing starts."""

from __future__ import annotations

from rospkg_cli.example import Example, scripts, setup_py

from .setups import ENTRY, python

CHAT = "#!/usr/bin/env python3\n\n\ndef chat():\n    print(words)\n\n\nif __name__ == '__main__':\n    chat()\n"
BESIDE = "        ('lib/' + package_name, ['my_pkg/chat.py']),\n"
SETUP = setup_py(scripts("talker = my_pkg.talker:main"))
MAIN = "def main(): ...\n"


def beside(talker: str = MAIN, page: str = "", setup: str = SETUP.replace(ENTRY, ENTRY + BESIDE)) -> Example:
    return python({"setup.py": setup, "my_pkg/talker.py": talker, "my_pkg/chat.py": CHAT, "README.md": page})


CASES = {
    "DEP117": (
        beside(),
        beside("from my_pkg.chat import chat\n\n\ndef main():\n    chat()\n"),
        beside(f"# from my_pkg.chat import chat\n{MAIN}"),
        beside(page="Run `ros2 run my_pkg chat.py`.\n"),
        beside(setup=SETUP.replace("zip_safe=True,", "zip_safe=True,\n    scripts=['my_pkg/chat.py'],")),
    ),
}
