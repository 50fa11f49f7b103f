"""Writes the C code of the module _native: declare.py SOURCE FILE

What is declared is read from the headers, so that it stands nowhere twice. cffi's parser knows no preprocessor: lines
that are the preprocessor's are left out, and the macros that mark the interface.
"""

import re
import sys
from pathlib import Path

import cffi

HEADERS = ["armtol/armtol.h", "armtol/tables/arm_model.h", "1987/analysis.h", "1987/program.h"]
HEADERS += ["armtol/wish/accuracy.h", "python/binding.h"]

# What the page asks and Python too (page/wasm/page.h), and what the engine calls back.
MORE = """
int page_open(const char *path);
const char *page_bench(const char *corrected);
extern "Python" bool armtol_python_progress(void *context, uint64_t done, uint64_t total);
extern "Python" bool armtol_python_region_progress(void *context, double open, uint64_t boxes);
extern "Python" bool armtol_python_map_progress(void *context, size_t done, size_t total);
"""


def declarations(source: Path, name: str, seen: set[str]) -> str:
    """Those of a header, behind those of the headers that it includes and that were not seen before."""
    path = next((source / folder / name for folder in ("include", "src") if (source / folder / name).exists()), None)
    if path is None or name in seen:
        return ""
    seen.add(name)
    text = path.read_text()
    before = [declarations(source, included, seen) for included in re.findall(r'^#include "(.*)"', text, re.MULTILINE)]
    text = re.sub(r"/\*.*?\*/", "", text, flags=re.DOTALL).replace("\\\n", " ")
    text = re.sub(r"^[ \t]*#.*$", "", text, flags=re.MULTILINE)
    return "".join(before) + re.sub(r"\bARMTOL_INTERFACE_(BEGIN|END)\b", "", text)


def main(source: Path, written: Path) -> None:
    seen: set[str] = set()
    ffi = cffi.FFI()
    ffi.cdef("".join(declarations(source, name, seen) for name in HEADERS) + MORE)
    ffi.set_source("armtol._native", "".join(f'#include "{name}"\n' for name in [*HEADERS, "page/wasm/page.h"]))
    ffi.emit_c_code(str(written))


main(Path(sys.argv[1]), Path(sys.argv[2]))
