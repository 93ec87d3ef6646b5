"""The scenes that are solved, by name."""

if __name__ == "__main__":
    raise SystemExit("usage: cargo run --release -p contact-vv-live, which imports this module")

import hertz_models
import pin_models

CASES = {
    "cylinder": hertz_models.cylinder,
    "truncated-hertz": hertz_models.truncated_hertz,
    "pin-rod": pin_models.pin_rod,
    "pin-plate": pin_models.pin_plate,
}


def model(scene, level):
    """The model of a scene on the mesh of a level."""
    if scene["case"] not in CASES:
        raise ValueError(f"case {scene['case']!r}: use one of {', '.join(CASES)}")
    return CASES[scene["case"]](scene, level)
