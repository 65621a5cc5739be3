"""The environment's map, and the same surface of light as Mitsuba reads it."""
import mitsuba as mi
import numpy as np


def read_map(path, largest):
    image = np.array(mi.Bitmap(str(path)).convert(mi.Bitmap.PixelFormat.RGB, mi.Struct.Type.Float32), dtype=np.float64)
    return np.minimum(image, largest)


def for_mitsuba(image):
    """Mitsuba puts row j of h at v = j / (h - 1), we put it at (j + 1/2) / h; on 2 h + 1 rows both
    bilinear surfaces are the same one. Texel i of w is at (i + 1/2) / w for both, and its u is ours
    less a quarter: on 3 w columns ours are among its texels' centres."""
    h, w = image.shape[:2]
    rows = np.clip(np.arange(2 * h + 1) / 2 - 0.5, 0, h - 1)
    columns = (np.arange(3 * w) + 0.5) / 3 - 0.5 + w / 4
    r0, c0 = np.floor(rows).astype(int), np.floor(columns).astype(int)
    r1 = np.minimum(r0 + 1, h - 1)
    fr, fc = (rows - r0)[:, None, None], (columns - c0)[None, :, None]
    upper = image[r0][:, c0 % w] * (1 - fc) + image[r0][:, (c0 + 1) % w] * fc
    lower = image[r1][:, c0 % w] * (1 - fc) + image[r1][:, (c0 + 1) % w] * fc
    return (upper * (1 - fr) + lower * fr).astype(np.float32)
