"""The notebooks run, and are stored without outputs, which could go stale. Code in documents runs."""

import re
import subprocess
import sys
from pathlib import Path

import nbclient
import nbformat
import pytest

SOURCE = Path(__file__).parents[2]
NOTEBOOKS = sorted((SOURCE / "docs/notebooks").glob("*.ipynb"))


@pytest.mark.parametrize("path", NOTEBOOKS, ids=lambda path: path.stem)
def test_a_notebook_runs(path, tmp_path):
    notebook = nbformat.read(path, as_version=4)
    nbformat.validate(notebook)
    code = [cell for cell in notebook.cells if cell.cell_type == "code"]
    assert len(code) > 5
    assert all(cell.outputs == [] and cell.execution_count is None for cell in code)
    nbclient.NotebookClient(notebook, timeout=120, resources={"metadata": {"path": str(tmp_path)}}).execute()
    assert any("image/png" in output.get("data", {}) for cell in code for output in cell.outputs)


def test_there_are_notebooks():
    assert {path.stem for path in NOTEBOOKS} >= {"reproduction", "new-arm", "cluster"}


@pytest.mark.parametrize("page", ["README.md", "docs/python.md"])
def test_code_in_documents_runs(page, tmp_path):
    """Every block, in a process of its own; show() draws to a file."""
    blocks = re.findall(r"^```python\n(.*?)^```", (SOURCE / page).read_text(), re.DOTALL | re.MULTILINE)
    assert blocks
    for number, block in enumerate(blocks):
        code = "import matplotlib; matplotlib.use('Agg')\n" + block
        if "plt" in block:
            code += "\nassert plt.gcf().axes[0].has_data(); plt.savefig('plot.png')\n"
        done = subprocess.run([sys.executable, "-c", code], cwd=tmp_path, capture_output=True, text=True)
        assert done.returncode == 0, f"{page}, block {number}:\n{done.stderr}"
