"""L-Py: a ternary tree, derived and interpreted.

Usage: lpy.py STEPS SECONDS
Prints one line of JSON: seconds of both, of the derivation alone, modules of the last word. Leaves with status 3 where
L-Py is not installed. It is given out through conda only, so this is written by its manual and was not run here.
"""

import sys
import time

from common import absent, answer, fastest

try:
    from openalea.lpy import Lsystem
except ImportError as error:
    absent(error)

# The same system as in src/peers/lpy.rs; `_` sets the width of the branch.
CODE = """
Axiom: A(1, 1)
derivation length: {steps}
production:
A(l, w) --> _(w) F(l) [&(45) A(l*0.7, w*0.6)] /(120) [&(45) A(l*0.7, w*0.6)] /(120) [&(45) A(l*0.7, w*0.6)]
endlsystem
"""


def work():
    global derive_seconds
    system = Lsystem()
    system.setCode(CODE.format(steps=steps))
    start = time.perf_counter()
    word = system.derive()
    derive_seconds = min(derive_seconds, time.perf_counter() - start)
    system.sceneInterpretation(word)
    return word


steps, within = int(sys.argv[1]), float(sys.argv[2])
derive_seconds = float("inf")
seconds, word, used = fastest(within, work)
answer(seconds=seconds, derive_seconds=derive_seconds, modules=len(word), peak_bytes=used)
