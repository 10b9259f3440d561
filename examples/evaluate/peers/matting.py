"""Alpha by pymatting, to be compared with ours.

Usage: matting.py IMAGE TRIMAP OUT [METHOD] [SECONDS]; METHOD is cf (closed form, the default), knn, lbdm or rw.
Prints one line of JSON. Leaves with status 3 where pymatting, numpy or pillow is not installed.
"""

import sys

from common import absent, answer, fastest

try:
    import numpy as np
    import pymatting
    from PIL import Image
except ImportError as error:
    absent(error)

if not 4 <= len(sys.argv) <= 6:
    sys.exit(__doc__)
image, trimap, out, method, within = (sys.argv[1:] + ["cf", "0"][len(sys.argv) - 4 :])[:5]
estimate = getattr(pymatting, f"estimate_alpha_{method}")
picture = np.asarray(Image.open(image).convert("RGB"), dtype=np.float64) / 255
known = Image.open(trimap).convert("L").resize(picture.shape[1::-1], Image.NEAREST)
known = np.asarray(known, dtype=np.float64) / 255
known = np.where(known < 0.25, 0.0, np.where(known > 0.75, 1.0, 0.5))
seconds, alpha, used = fastest(float(within), lambda: estimate(picture, known))
Image.fromarray((np.clip(alpha, 0, 1) * 255 + 0.5).astype(np.uint8)).save(out)
answer(seconds=seconds, peak_bytes=used)
