"""Whether the solution in an exported condensed.npz, as numpy reads it, is one of its own problem: prints the largest violation, relative."""
import given

try:
    import numpy
except ModuleNotFoundError as absent:
    given.missing(absent.name)

with numpy.load(given.file(__doc__)) as arrays:
    S, B, f, g, A, u, p = (arrays[name] for name in "SBfgAup")
force, approach = A * p, B @ u
imbalance = abs(S @ u + B.T @ force - f).max() / force.max()
penetration = (approach - g).max() / abs(approach).max()
open_and_pressed = abs(g - approach)[p > 0].max() / abs(approach).max()
print(max(imbalance, penetration, open_and_pressed, -p.min() / p.max()))
