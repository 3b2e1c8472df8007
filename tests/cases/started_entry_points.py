"""Entry points of programs that nothing starts beside others, or that Humble takes, and data that a page fetches."""

from __future__ import annotations

from rospkg_cli.example import Example, scripts, setup_py
from rospkg_cli.rules.setup import set205_missing_data_file as set205

NODE = "def main():\n    print('hello')\n"
STARTS = '<launch>\n  <node pkg="my_pkg" exec="talker"/>\n</launch>\n'
FILES = {"my_pkg/talker.py": NODE, "my_pkg/tuner.py": NODE, "launch/a.launch.xml": STARTS}


def beside(entry: str, **pages: str) -> Example:
    setup = setup_py(scripts("talker = my_pkg.talker:main", entry))
    return Example(bad={**FILES, "setup.py": setup, **{f"{name}.md": text for name, text in pages.items()}}, good={})


HUMBLE = "Install ROS 2 Humble.\n"
CASES = {
    "SET101": (beside("tuner = my_pkg.gone:main"),),
    "SET102": (beside("tuner = my_pkg.tuner:mian"),),
    "SET103": (beside("tuner = my_pkg.tuner.main"),),
    "SET104": tuple(beside(f"talker = my_pkg.{each}:main", README=HUMBLE) for each in ("talker", "tuner")),
    "SET205": (
        Example(
            bad={
                "setup.py": set205.config("('share/' + package_name + '/models', ['models/a.pt'])"),
                "README.md": "    wget https://example.org/a.pt -P models/\n",
            },
            good={},
        ),
    ),
}
