"""Writes the C code of the module _native: declare.py SOURCE FILE

What is declared is read from the headers, so that it stands nowhere twice. cffi's parser knows no preprocessor: lines that
are the preprocessor's are left out, and the macros that mark the interface.
"""

import re
import sys
from pathlib import Path

import cffi

# A header stands behind those that it needs.
PUBLIC = """interface status errata conventions link transform link_transform link_jacobian twist_transform error_matrix
    column_order bounds machining tool_point loads arm axes craig euler robots solve optimum sphere tool_matrix tool_error
    poses sampler corners question answer budget share_interval verification""".split()
OTHER = ["armtol/tables/arm_model.h", "1987/analysis.h", "1987/program.h", "python/binding.h"]

# What the page asks and Python too (page/wasm/page.h), and what the engine calls back.
MORE = """
int page_open(const char *path);
const char *page_bench(const char *corrected);
const char *armtol_version(void);
extern "Python" bool armtol_python_progress(void *context, uint64_t done, uint64_t total);
"""


def declarations(header: Path) -> str:
    text = re.sub(r"/\*.*?\*/", "", header.read_text(), flags=re.DOTALL)
    text = re.sub(r"\\\n", " ", text)
    text = re.sub(r"^[ \t]*#.*$", "", text, flags=re.MULTILINE)
    return re.sub(r"\bARMTOL_INTERFACE_(BEGIN|END)\b", "", text)


def main(source: Path, written: Path) -> None:
    headers = [source / "include/armtol" / f"{name}.h" for name in PUBLIC] + [source / "src" / name for name in OTHER]
    ffi = cffi.FFI()
    ffi.cdef("\n".join(declarations(header) for header in headers) + MORE)
    includes = ["armtol/armtol.h", "page/wasm/page.h", *OTHER]
    ffi.set_source("armtol._native", "\n".join(f'#include "{name}"' for name in includes))
    ffi.emit_c_code(str(written))


main(Path(sys.argv[1]), Path(sys.argv[2]))
