"""What find_python.sh takes, and the one sentence that it says where something is missing."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from pathlib import Path

import pytest

SCRIPT = Path(__file__).parents[2] / "find_python.sh"
REAL_PYTHON = Path(sys.base_prefix, "bin", f"python3.{sys.version_info.minor}")


@pytest.fixture
def machine(tmp_path: Path) -> Path:
    """A folder of programs that is all the script can see: `uname` and two compilers, no Python."""
    place(tmp_path, "uname", 'echo "Linux x86_64"')
    place(tmp_path, "cc", "")
    place(tmp_path, "c++", "")
    return tmp_path


def place(folder: Path, name: str, body: str) -> None:
    """Put a shell script into `folder`."""
    path = folder / name
    path.write_text(f"#!/bin/sh\n{body}\n", encoding="utf-8")
    path.chmod(0o755)


def place_python(folder: Path, name: str, body: str = "") -> None:
    """Put the real Python into `folder` under a name; `body` runs before it."""
    place(folder, name, f'{body}\nexec {REAL_PYTHON} "$@"')


def find(folder: Path, *arguments: str) -> tuple[int, str, list[str]]:
    """Run the script: exit status, what it found, the lines that it complained in."""
    shell = shutil.which("sh") or "/bin/sh"
    kept = {key: os.environ[key] for key in ("LD_LIBRARY_PATH",) if key in os.environ}
    result = subprocess.run(
        [shell, SCRIPT, *arguments],
        env=kept | {"PATH": str(folder)},
        capture_output=True,
        text=True,
        check=False,
    )
    return result.returncode, result.stdout.strip(), result.stderr.splitlines()


def test_the_first_python_that_runs_is_taken(machine: Path) -> None:
    """A shim that is there but does not run is passed over."""
    place(machine, "python3.12", "exit 127")
    place_python(machine, "python3.13")
    place_python(machine, "python3.11")
    assert find(machine) == (0, "python3.13", [])


def test_a_python_without_venv_is_passed_over(machine: Path) -> None:
    """Debian ships Python without its venv: such a one is of no use."""
    place_python(machine, "python3.12", 'case "$2" in *venv*) exit 1;; esac')
    place_python(machine, "python3")
    assert find(machine) == (0, "python3", [])


def test_a_python_of_another_version_is_passed_over(machine: Path) -> None:
    """A Python that says it is too old or too new is not taken."""
    place_python(machine, "python3", 'case "$2" in *version_info*) exit 1;; esac')
    status, found, sentences = find(machine)
    assert (status, found) == (1, "")
    assert sentences[0].startswith("No CPython 3.11, 3.12 or 3.13")


@pytest.mark.parametrize(
    ("missing", "sentence"),
    [("cc", "The compiler cc was not found"), ("c++", "The compiler c++ was not found")],
)
def test_a_missing_compiler_is_one_sentence(machine: Path, missing: str, sentence: str) -> None:
    """The sentence names the compiler that is missing."""
    place_python(machine, "python3")
    (machine / missing).unlink()
    status, found, sentences = find(machine)
    assert (status, found, len(sentences)) == (1, "", 1)
    assert sentences[0].startswith(sentence)


def test_a_missing_python_is_one_sentence(machine: Path) -> None:
    """Without any Python the sentence says which ones would do."""
    status, found, sentences = find(machine)
    assert (status, found, len(sentences)) == (1, "", 1)
    assert sentences[0].startswith("No CPython 3.11, 3.12 or 3.13")


def test_missing_headers_are_one_sentence(machine: Path) -> None:
    """A Python without Python.h cannot build msg_defs, and is named."""
    place_python(machine, "python3", 'case "$2" in *Python.h*) exit 1;; esac')
    status, found, sentences = find(machine)
    assert (status, found, len(sentences)) == (1, "", 1)
    assert sentences[0].startswith("python3 has no header files (Python.h)")


def test_a_given_python_is_taken_or_refused(machine: Path) -> None:
    """PYTHON=... overrides the search, and is not silently replaced by another one."""
    place_python(machine, "python3")
    place_python(machine, "chosen")
    place(machine, "broken", "exit 127")
    assert find(machine, "chosen") == (0, "chosen", [])
    status, found, sentences = find(machine, "broken")
    assert (status, found, len(sentences)) == (1, "", 1)
    assert sentences[0].startswith("PYTHON=broken is not a CPython")


def test_another_machine_is_one_sentence(machine: Path) -> None:
    """Where the wheels do not exist the sentence says so before anything is downloaded."""
    place_python(machine, "python3")
    place(machine, "uname", 'echo "Darwin arm64"')
    status, found, sentences = find(machine)
    assert (status, found, len(sentences)) == (1, "", 1)
    assert "Darwin arm64" in sentences[0]
