"""Prints what the tests beside this file expect of the pairs of known_pairs.h.

Independent of the C++ code: scikit-image's structural_similarity, and FLIP written from the paper
(Andersson et al. 2020) with kernels of two dimensions, where the C++ code has separable ones.
Debian packages: python3-numpy python3-scipy python3-skimage. Not run by the tests.
"""
import numpy as np
from scipy.ndimage import correlate
from skimage.metrics import structural_similarity

W, H = 64, 48
Y, X, C = np.mgrid[0:H, 0:W, 0:3]


def srgb(value):
    return value / 12.92 if value <= 0.04045 else ((value + 0.055) / 1.055) ** 2.4


DECODED = np.array([srgb(v / 255.0) for v in range(256)])

# Primaries of sRGB and D65 as chromaticities: the matrix to XYZ is derived, not copied.
PRIMARIES = np.array([[0.64, 0.33], [0.30, 0.60], [0.15, 0.06]])
WHITE = np.array([0.31271, 0.32902])


def xyz_of(xy):
    return np.array([xy[0] / xy[1], 1.0, (1.0 - xy[0] - xy[1]) / xy[1]])


COLUMNS = np.stack([xyz_of(p) for p in PRIMARIES], axis=1)
TO_XYZ = COLUMNS * np.linalg.solve(COLUMNS, xyz_of(WHITE))


def shares(linear):
    return linear @ TO_XYZ.T / xyz_of(WHITE)


def hunt_lab(linear):
    s = shares(linear)
    delta = 6.0 / 29.0
    f = np.where(s > delta**3, np.cbrt(s), s / (3 * delta**2) + 4.0 / 29.0)
    lightness = 116 * f[..., 1] - 16
    a = 0.01 * lightness * 500 * (f[..., 0] - f[..., 1])
    b = 0.01 * lightness * 200 * (f[..., 1] - f[..., 2])
    return np.stack([lightness, a, b], axis=-1)


def hyab(a, b):
    d = a - b
    return abs(d[..., 0]) + np.sqrt(d[..., 1] ** 2 + d[..., 2] ** 2)


def contrast_kernel(terms, ppd):
    r = int(np.ceil(3 * np.sqrt(0.04 / (2 * np.pi**2)) * ppd))
    y, x = np.mgrid[-r : r + 1, -r : r + 1] / ppd
    k = sum(a * np.sqrt(np.pi / b) * np.exp(-np.pi**2 * (x**2 + y**2) / b) for a, b in terms)
    return k / k.sum()


def feature_kernel(kind, ppd):
    sigma = 0.5 * 0.082 * ppd
    r = int(np.ceil(3 * sigma))
    y, x = np.mgrid[-r : r + 1, -r : r + 1].astype(float)
    k = np.exp(-(x**2 + y**2) / (2 * sigma**2)) * (-x if kind == "edge" else x**2 / sigma**2 - 1)
    return np.where(k > 0, k / k[k > 0].sum(), k / -k[k < 0].sum())


def flip(image, reference, ppd=67.0):
    def opponent(display):
        s = shares(DECODED[display])
        return np.stack([116 * s[..., 1] - 16, 500 * (s[..., 0] - s[..., 1]),
                         200 * (s[..., 1] - s[..., 2])], axis=-1)

    def perceived(seen):
        kernels = [[(1, 0.0047)], [(1, 0.0053)], [(34.1, 0.04), (13.5, 0.025)]]
        seen = np.stack([correlate(seen[..., c], contrast_kernel(kernels[c], ppd), mode="nearest")
                         for c in range(3)], axis=-1)
        y = (seen[..., 0] + 16) / 116
        xyz = np.stack([y + seen[..., 1] / 500, y, y - seen[..., 2] / 200], axis=-1)
        return hunt_lab(np.clip(xyz * xyz_of(WHITE) @ np.linalg.inv(TO_XYZ).T, 0, 1))

    def features(seen, kind):
        y = (seen[..., 0] + 16) / 116
        k = feature_kernel(kind, ppd)
        return np.hypot(correlate(y, k, mode="nearest"), correlate(y, k.T, mode="nearest"))

    a, b = opponent(image), opponent(reference)
    most = hyab(hunt_lab(np.array([0.0, 1.0, 0.0])), hunt_lab(np.array([0.0, 0.0, 1.0]))) ** 0.7
    colour = hyab(perceived(a), perceived(b)) ** 0.7
    knee = 0.4 * most
    colour = np.where(colour < knee, 0.95 / knee * colour,
                      0.95 + (colour - knee) / (most - knee) * 0.05)
    feature = np.maximum(*(abs(features(a, k) - features(b, k)) for k in ("edge", "point")))
    return colour ** (1 - np.sqrt(feature / np.sqrt(2)))


def luma(display):
    return display @ np.array([0.2126, 0.7152, 0.0722])


def report(name, image, reference):
    image, reference = (np.clip(v, 0, 255).astype(np.uint8) for v in (image, reference))
    error = image.astype(float) - reference
    mse = np.mean(error**2)
    mssim = structural_similarity(luma(image), luma(reference), data_range=255.0,
                                  gaussian_weights=True, sigma=1.5, use_sample_covariance=False)
    a, b = DECODED[image], DECODED[reference]
    figures = {"MSE": mse, "NRMSE": np.sqrt(mse) / np.ptp(reference.astype(float)), "MSSIM": mssim,
               "FLIP": np.mean(flip(image, reference)),
               "relMSE": np.mean((a - b) ** 2 / (b**2 + 0.01))}
    print(name, *(f"{k} {v:.8f}" for k, v in figures.items()))


def constant(r, g, b):
    return np.broadcast_to(np.array([r, g, b]), (H, W, 3))


RAMP = (3 * X + 2 * Y + 50 * C) % 256
NOISE = (31 * X + 17 * Y + 11 * C) % 41 - 20
CHECKERS = np.where((X // 8 + Y // 8) % 2 == 0, 220 - 40 * C, 30 + 20 * C)
SHIFTED = np.where(((X + 3) // 8 + Y // 8) % 2 == 0, 220 - 40 * C, 30 + 20 * C)
DOT = np.where((X == 30) & (Y == 20), 255, 128)

if __name__ == "__main__":
    report("noise", RAMP + NOISE, RAMP)
    report("shift", SHIFTED, CHECKERS)
    report("dim", CHECKERS * 3 // 4, CHECKERS)
    report("dot", DOT, constant(128, 128, 128))
    for a, b in [((0, 0, 0), (255, 255, 255)), ((200, 30, 30), (30, 30, 200)),
                 ((100, 100, 100), (110, 110, 110)), ((0, 255, 0), (0, 0, 255))]:
        print(a, b, f"FLIP {np.mean(flip(np.array(constant(*a)), np.array(constant(*b)))):.8f}")
