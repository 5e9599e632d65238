"""The programs of the guide run."""

import re
import subprocess
import sys
from pathlib import Path

import pytest

FOLDER = Path(__file__).resolve().parents[2]
PAGES = [FOLDER / "docs/guide/python.md", FOLDER / "python/README.md"]
PROGRAM = re.compile(r"^```python\n(.*?)^```$", re.DOTALL | re.MULTILINE)
PROGRAMS = [pytest.param(text, id=f"{page.stem}-{number}") for page in PAGES if page.exists() for number, text in enumerate(PROGRAM.findall(page.read_text("utf-8")))]


@pytest.mark.skipif(not PROGRAMS, reason="the guide is not beside the tests")
@pytest.mark.parametrize("program", PROGRAMS)
def test_a_program_of_the_guide_runs(program, tmp_path):
    if "gymnasium" in program:
        pytest.importorskip("gymnasium")
    (tmp_path / "program.py").write_text(program, "utf-8")
    run = subprocess.run([sys.executable, "program.py"], cwd=tmp_path, capture_output=True, text=True, timeout=300)
    assert run.returncode == 0, run.stderr
