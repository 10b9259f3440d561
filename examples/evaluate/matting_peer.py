"""Alpha by pymatting's closed-form matting, to be compared with ours.

Usage: matting_peer.py IMAGE TRIMAP OUT. Needs Python with pymatting; leaves with status 3 without it.
"""

import sys
import time

try:
    import numpy as np
    import pymatting
    from PIL import Image
except ImportError as error:
    print(f"skipped: {error}", file=sys.stderr)
    sys.exit(3)

if len(sys.argv) != 4:
    sys.exit(__doc__)
image, trimap, out = sys.argv[1:]
picture = np.asarray(Image.open(image).convert("RGB"), dtype=np.float64) / 255
known = Image.open(trimap).convert("L").resize(picture.shape[1::-1], Image.NEAREST)
known = np.asarray(known, dtype=np.float64) / 255
known = np.where(known < 0.25, 0.0, np.where(known > 0.75, 1.0, 0.5))
start = time.perf_counter()
alpha = pymatting.estimate_alpha_cf(picture, known)
print(f"{time.perf_counter() - start:.3f} s")
Image.fromarray((np.clip(alpha, 0, 1) * 255 + 0.5).astype(np.uint8)).save(out)
