"""The package's types, as mypy --strict sees them, and what it has of a package's parts."""

import importlib.metadata
import importlib.resources
import subprocess
import sys

import armtol


def test_mypy_has_nothing_to_say(tmp_path):
    user = tmp_path / "user.py"
    user.write_text(
        "import armtol\n"
        "arm: armtol.Arm = armtol.Arm.builtin('panda')\n"
        "answer: armtol.Answer = arm.allocate([0.0] * 7, [0.1] * 3 + [None] * 3, weights={'motors': 2})\n"
        "share: float = answer.verify(10, progress=lambda done, total: True).share_95[0]\n"
        "wrong: str = answer.tolerances\n"
    )
    mypy = [sys.executable, "-m", "mypy", "--strict", "--cache-dir", str(tmp_path / "cache")]
    package = subprocess.run([*mypy, "-p", "armtol"], capture_output=True, text=True, cwd=tmp_path)
    assert package.returncode == 0, package.stdout
    found = subprocess.run([*mypy, str(user)], capture_output=True, text=True, cwd=tmp_path)
    assert [line for line in found.stdout.splitlines() if "error" in line and "user.py:5" not in line] == [
        "Found 1 error in 1 file (checked 1 source file)"
    ]


def test_the_version_is_that_of_the_library(source):
    assert armtol.__version__ == importlib.metadata.version("armtol")
    assert f"project(armtol VERSION {armtol.__version__} " in (source / "CMakeLists.txt").read_text()


def test_everything_public_is_described():
    for name in armtol.__all__:
        thing = getattr(armtol, name)
        assert thing.__doc__, name
        for key, value in vars(thing).items() if isinstance(thing, type) else ():
            if callable(value) and not key.startswith("_"):
                assert value.__doc__, f"{name}.{key}"


def test_what_the_package_has():
    names = {path.name for path in importlib.resources.files("armtol").iterdir()}
    assert {"py.typed", "published.tsv", "_native.pyi"} <= names
