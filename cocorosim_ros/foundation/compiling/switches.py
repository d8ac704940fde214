"""What the environment may say of the compiler.

COCOROSIM_VECTORS=off: no vectors of our own. What is written for four robots at once goes through one after the other,
by the processor's instructions for single numbers. Results are the same to the bit (test/architecture/test_vectors.py);
the switch is for processors, compilers and doubts that need it.
"""

from __future__ import annotations

import os

from cocorosim_ros.foundation.errors import CocorosimError

_WORDS = {"on": True, "off": False}


def _vectors() -> bool:
    word = os.environ.get("COCOROSIM_VECTORS", "on")
    if word not in _WORDS:
        raise CocorosimError(f"The environment has COCOROSIM_VECTORS={word}; give 'on' or 'off'.")
    return _WORDS[word]


VECTORS = _vectors()
