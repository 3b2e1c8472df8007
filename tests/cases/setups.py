"""Sentences about setup.py that no example shows: levels, several places in one finding, and silence."""

from __future__ import annotations

from rospkg_cli.example import SETUP_CFG, SETUP_PY, Example, manifest, scripts, setup_py
from rospkg_cli.rules.setup import set001_missing_setup_cfg as set001
from rospkg_cli.rules.setup import set002_wrong_script_dir as set002
from rospkg_cli.rules.setup import set101_entry_point_module_missing as set101
from rospkg_cli.rules.setup import set202_missing_marker as set202
from rospkg_cli.rules.setup import set204_empty_glob as set204
from rospkg_cli.rules.setup import set205_missing_data_file as set205
from rospkg_cli.rules.setup import set207_file_not_installed as set207
from rospkg_cli.rules.setup import set301_missing_init as set301
from rospkg_cli.rules.setup import set302_package_not_installed as set302


def plain(text: str) -> str:
    return text.replace("«", "").replace("»", "")


def python(files: dict[str, str | None]) -> Example:
    return Example(bad={path: text and plain(text) for path, text in files.items()}, good={})


ENTRY = "        ('share/' + package_name, ['package.xml']),\n"
OPTIONS = "options={'install': {'install_scripts': '$base/lib/my_pkg'}},"
MAIN = "def main():\n    print('hello')\n"
NAV = set205.config("('share/' + package_name + '/config', ['config/nva.yaml'])")
GLOBS = "from glob import glob\n" + SETUP_PY.replace(
    ENTRY,
    ENTRY + "".join(f"        ('share/' + package_name + '/urdf/{each}', glob('urdf/{each}/*')),\n" for each in "ab"),
)
URDF = "<robot name='a'/>\n"
ROBOTS = {f"urdf/{each}/{each}.urdf": URDF for each in "abcd"}
SPEECH = {**set301.FILES, "my_pkg/speech/words.py": "GREETING = 'hello'\n"}
LISTED = SETUP_PY.replace(set302.FOUND, "[package_name, 'my_pkg.speech']")
CONFIG = {"config/nav.yaml": "/**:\n  ros__parameters:\n    rate: 2.0\n", "setup.py": setup_py()}
OTHER_NAME = SETUP_PY.replace("package_name = 'my_pkg'", "package_name = 'your_pkg'")

WITH_OPTIONS = setup_py(scripts("a = my_pkg.talker:main"), OPTIONS)
NARROW = set207.launch("glob('launch/*.launch.xml')")

MODELS = "from glob import glob\n" + SETUP_PY.replace(
    ENTRY, ENTRY + "        ('share/' + package_name + '/models/sun', glob('models/sun/model.sdf')),\n"
)
YAML = "from glob import glob\n" + SETUP_PY.replace(
    ENTRY, ENTRY + "        ('share/' + package_name + '/config', glob('config/*.yaml')),\n"
)

SPIN = "import rclpy\n\nrclpy.init()\n"
DRIVER = (
    "class Driver:\n    def init(self, webots_node, properties):\n        self.robot = webots_node.robot\n\n"
    "    def step(self):\n        pass\n"
)
RUNNING = (
    f"{SPIN}rclpy.spin(None)\n",
    f"{SPIN}try:\n    rclpy.spin(None)\nfinally:\n    rclpy.shutdown()\n",
    f"{SPIN}with open('a'):\n    rclpy.spin(None)\n",
    f"{SPIN}while True:\n    rclpy.spin(None)\n",
    "def run():\n    print('hello')\n\n\nrun()\n",
    SPIN,
    f"{SPIN}if __name__ == '__main__':\n    rclpy.spin(None)\n",
    f"{SPIN}def run():\n    rclpy.spin(None)\n",
    "print('hello')\n",
)


STARS = tuple(
    f"from acme_robot import *\n\n\n{more}def {name}():\n    print('hello')\n"
    for name, more in (("maain", ""), ("run", ""), ("maain", "def __getattr__(name):\n    return name\n\n\n"))
)
"""Modules that may have the name from elsewhere: only a slip is told."""


def started(*modules: str) -> Example:
    """Two entry points of one package: a module that is missing, and others."""
    entries = [f"node{number} = my_pkg.{module}:main" for number, module in enumerate(modules)]
    return python({"setup.py": setup_py(scripts(*entries)), "my_pkg/follow_display.py": MAIN})


STARTS_IT: dict[str, str | None] = {"launch/a.launch.xml": '<launch><node pkg="my_pkg" exec="talker"/></launch>\n'}


def handles(line: str) -> str:
    """A setup.py that does something after setup()."""
    return f"import os\n{set002.PACKAGE['setup.py']}{line}\n"


def commanded(commands: str) -> str:
    return set002.PACKAGE["setup.py"].replace("    license=", f"    cmdclass={commands},\n    license=")


CASES = {
    "SET001": (python({**set001.missing_setup_cfg.examples[0].bad, "setup.py": WITH_OPTIONS}),),
    "SET002": (
        python({**set002.PACKAGE, "setup.cfg": set002.HALF, "setup.py": WITH_OPTIONS}),
        *(python({**set002.PACKAGE, "my_pkg/talker.py": MAIN, "setup.cfg": cfg})
          for cfg in (set002.HALF, set002.HALF.replace("lib/my_pkg", "bin"))),
        *(
            python({**set002.PACKAGE, "setup.cfg": cfg, "setup.py": handles(line)})
            for cfg in (set002.HALF, set002.WRONG, set002.WRONG.replace("lib/your_pkg", "bin", 1).replace("your", "my"))
            for line in ("os.symlink('../../bin/talker', 'talker')", "os.path.exists('talker')")
        ),
        *(
            python({**set002.PACKAGE, "setup.cfg": set002.HALF, "setup.py": commanded(commands)})
            for commands in ("{'install': Mine}", "{'build_py': Mine}", "mine()")
        ),
        *(
            python({**set002.PACKAGE, "setup.cfg": set002.WRONG.replace("lib/your_pkg", folder)})
            for folder in ("lib", "scripts", "bin", "lib/my_pkg/tools", "$x", "lib/my_pkg/", "share/my_pkg/scripts")
        ),
        python({**set002.PACKAGE, "my_pkg/talker.py": MAIN, "setup.cfg": set002.WRONG.replace("lib", "share")}),
        python({**set002.PACKAGE, "setup.cfg": set002.WRONG.replace("lib/your_pkg", "bin"), **STARTS_IT}),
        python({**set002.PACKAGE, "setup.cfg": set002.WRONG.replace("$base/lib/your_pkg", "/usr/bin"), **STARTS_IT}),
    ),
    "SET003": (python({"setup.cfg": "[tool:pytest]\njunit-family=xunit2\n[develop]\nscript-dir=$base/lib/my_pkg\n"}),),
    "SET101": (
        python({"setup.py": setup_py(scripts("talker = my_pkg.talker:main")),
                "build.sh": "python3 gen.py > my_pkg/talker.py\n"}),
        started("display"),
        started("display_follow"),
        started("display_follow", "follow_display"),
        python({**set101.entry_point_module_missing.examples[0].bad, ".gitignore": "my_pkg/taker.py\n"}),
        python({**set101.entry_point_module_missing.examples[0].bad, ".gitignore": "my_pkg/talker.py\n"}),
        python({**set101.entry_point_module_missing.examples[0].bad, ".gitmodules": "path = my_pkg/taker.py\n"}),
        *(
            python({"setup.py": setup_py(scripts("talker = talker.Talker:main")), "my_pkg/talker.py": MAIN, **more})
            for more in ({}, {"package.xml": manifest("  <exec_depend>talker</exec_depend>\n")})
        ),
    ),
    "SET102": tuple(
        python({"setup.py": setup_py(scripts("talker = my_pkg.talker:main")), "my_pkg/talker.py": text})
        for text in (*RUNNING, DRIVER, DRIVER.replace("step", "steps"), *STARS, "")
    ),
    "SET105": tuple(
        python({"setup.py": setup_py(scripts(f"talker = my_pkg{each}:main")), "my_pkg/__init__.py": MAIN})
        for each in ("", ".__init__")
    ),
    "SET103": tuple(
        python({"setup.py": setup_py(scripts("talker = my_pkg.talker")), "my_pkg/talker.py": text}) for text in RUNNING
    ),
    "SET202": (
        python({"setup.py": OTHER_NAME}),
        python({"setup.py": OTHER_NAME, "resource/my_pkg": None}),
        python({"setup.py": set202.BAD.replace("'resource/' + package_name", "'resource/old'")}),
    ),
    "SET204": (
        python({"setup.py": set204.launch("glob('models/*.onnx')"), ".gitignore": "*.onnx\n"}),
        python({"setup.py": set204.launch("glob('models/*.onnx')"), ".gitmodules": "\tpath = models\n"}),
        *(python({"setup.py": set204.launch("glob('models/*.onnx')"), f"models/{name}": ""})
          for name in ("placeholder.txt", "README.md", "replaced.txt", "Empty")),
    ),
    "SET205": (
        python({"setup.py": NAV, ".gitignore": "nva.yaml\n"}),
        python({"setup.py": NAV, ".gitmodules": "[submodule \"c\"]\n\tpath = config\n"}),
        python({"setup.py": NAV, ".gitignore": "nav.yaml\n"}),
    ),
    "SET208": (
        python({**CONFIG, "setup.py": SETUP_PY.replace("package_name, ['package.xml'", "'x', ['config/nav.yaml'")}),
    ),
    "SET206": (
        python(CONFIG),
        python({**CONFIG, ".gitignore": "/config/\n"}),
        *(python({**CONFIG, "setup.py": "import os\n" + SETUP_PY.replace("'share/' + package_name", share)})
          for share in ("f'share/{package_name}'", "os.path.join('share', package_name)")),
        python({**CONFIG, "README.md": "`--params-file src/my_pkg/config/nav.yaml`\n"}),
        python({**CONFIG, "my_pkg/a.py": "get_package_share_directory('my_pkg') + '/config/nav.yaml'\n"}),
    ),
    "SET207": (
        python({**{f"my_pkg/{each}.py": "def generate_launch_description(): ...\n" for each in "abc"},
                "launch/a.launch.py": "A = 1\n", "launch/b.launch.py": "B = 1\n", "launch/c.launch.py": "",
                "setup.py": set207.launch("['launch/a.launch.py', 'launch/b.launch.py']")}),
        python({**{f"my_pkg/{each}.py": "def generate_launch_description(): ...\n" for each in "abc"},
                "my_pkg/d.py": "A = 1\n", "setup.py": set207.launch("['my_pkg/a.py', 'my_pkg/c.py']")}),
        python({**set207.FILES, "launch/b_launch.xml": set207.LAUNCH, "setup.py": NARROW}),
        python({**set207.FILES, ".gitignore": "arm_launch.xml\n", "setup.py": NARROW}),
        python({**ROBOTS, "setup.py": GLOBS}),
        python({**CONFIG, "config/view.rviz": "Panels: []\n", "setup.py": YAML}),
        *(
            python({**CONFIG, "config/view.rviz": "Panels: []\n", "setup.py": YAML, "my_pkg/a.py": f"A = '{path}'\n"})
            for path in ("/home/ada/ws/view.rviz", "~/view.rviz", "rviz/view.rviz", "view.rviz")
        ),
        *(python({**CONFIG, path: CONFIG["config/nav.yaml"], "setup.py": YAML})
          for path in ("config/old/a.yaml", "config/new/a.yaml")),
        *(python({**CONFIG, "config/new/a.yaml": "a: 1\n", "setup.py": YAML, "my_pkg/a.py": f"A = {text}\n"})
          for text in ("'config/new/a.yaml'", "'new'", "'newer'", "'a.yaml'")),
        *(python({"models/sun/model.sdf": "<sdf/>\n", path: "<sdf/>\n", "setup.py": MODELS})
          for path in ("models/sun/model-1_2.sdf", "models/sun/sun.sdf")),
        *(python({**{f"launch/{each}.launch.xml": set207.LAUNCH for each in here},
                  "setup.py": set207.launch(str([f"launch/{each}.launch.xml" for each in listed])), **more})
          for here, listed, more in (
              ("abc", "ab", {}),
              ("ab", "a", {}),
              ("abcd", "ab", {}),
              ("abc", "abc", {}),
              ("abc", "ab", {"launch/a.launch.xml": '<launch><include file="c.launch.xml"/></launch>\n'}),
              ("abc", "ab", {".gitignore": "c.launch.xml\n"}),
          )),
    ),
    "SET209": (
        python({"setup.py": setup_py().replace(ENTRY, ENTRY + ENTRY)}),
    ),
    "SET301": (
        python({**SPEECH, "my_pkg/speech/init.py": ""}),
        python({**SPEECH, "my_pkg/speech/__init_.py": ""}),
        python({**SPEECH, "my_pkg/speech/initial.py": ""}),
        python({**SPEECH, ".gitignore": "__init__.py\n"}),
        python({"my_pkg/old/words.py": "A = 1\n"}),
        python({**SPEECH, "setup.py": SETUP_PY.replace(set302.FOUND, "[package_name]")}),
        python({**SPEECH, "setup.py": LISTED}),
        *(
            python({"my_pkg/tests/__init__.py": "", f"my_pkg/{at}/words.py": "A = 1\n",
                    "my_pkg/tests/conftest.py": f"from my_pkg.{at.replace('/', '.')}.words import A\n"})
            for at in ("tests/etc", "etc")
        ),
    ),
    "SET302": (
        python({"setup.py": LISTED}),
        python({"setup.py": LISTED, ".gitignore": "my_pkg/speech\n"}),
        python({"setup.py": set302.NONE}),
        *(python({"my_pkg/talker.py": MAIN, "setup.py": set302.NONE, **files}) for files in (
            {"resource/my_pkg": None, "pyproject.toml": "[project]\nname = 'my_pkg'\n"},
            {"resource/my_pkg": None},
            {"my_pkg/__init__.py": None},
            {"setup.cfg": SETUP_CFG + "[options]\npackages = my_pkg\n"},
            *({"setup.py": set302.NONE.replace("zip_safe", f"{each}\n    zip_safe")} for each in (
                "package=['my_pkg'],", "py_modules=['my_pkg.talker'],", "ext_modules=[None],",
                "packages=[],", scripts("talker = my_pkg.talker:main"))),
        )),
    ),
    "SET307": tuple(
        python({"setup.py": None, "pyproject.toml": f"[tool.poetry]\nname = 'my_pkg'\n\n[tool.{table}]\na = ['a']\n"})
        for table in ("poetry.scripts", "colcon-poetry-ros.data-files")
    ),
    "SET308": tuple(
        python({"setup.py": start + SETUP_PY.replace("    name=package_name,\n", f"    name=package_name,\n{lines}")})
        for start, lines in (
            ("", "    py_modules=glob.glob('a/*.py'),\n"),
            ("", "    py_modules=[os.path.join('a', 'b')],\n"),
            ("import os\n\n", "    py_modules=[os.path.joint('a', 'b')],\n"),
            ("import os\n\n\ndef found():\n    return os.listdirs('a')\n\n\n", ""),
            ("import sys\n\n", "    py_modules=[os.path.join('a', 'b')],\n"),
            ("import ast\n\n", "    py_modules=[os.path.join('a', 'b')],\n"),
            ("def found():\n    return os.listdir('a')\n\n\n", ""),
            ("found = lambda: listed('a')\n", ""),
            ("from a import *\n", "    py_modules=[os.path.join('a', 'b')],\n"),
            ("", "    py_modules=[os],\n"),
            ("", "    py_modules=[json.loads('[]'), json.loads('[]')],\n"),
        )
    ),
    "SET403": (
        python({"setup.py": SETUP_PY.replace("Drives my robot", "TODO: Package description")
                .replace("license='Apache-2.0'", "license='TODO: License declaration'")}),
        python({"package.xml": manifest().replace("<license>Apache-2.0", "<license>Ask us first")}),
        python({"package.xml": manifest().replace("<license>Apache-2.0", "<license>MIT")}),
    ),
    "SET401": (
        python({"setup.py": SETUP_PY.replace("name=package_name", "name='your_pkg'")}),
        python({"setup.py": OTHER_NAME}),
    ),
}  # fmt: skip
