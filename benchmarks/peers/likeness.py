"""Whether two engines did the same work: by how much what they did may differ."""

# How far an observation may be from the reference's, as a share of it, and besides. Robots that fall do so in other ways in
# each engine.
ALIKE = {
    "walk": {"height_m": (0, 0.005), "distance_m": (0.1, 0.02), "contacts": (0.4, 0), "tracking_rad": (0.3, 0), "lying": (0, 0)},
    "squat": {"height_m": (0, 0.005), "distance_m": (0, 0.02), "contacts": (0.3, 0), "tracking_rad": (0.3, 0.005),
              "lying": (0, 0)},
    "heap": {"height_m": (0.3, 0.02), "contacts": (0.5, 5)},
    "slope": {"height_m": (0, 0.005), "distance_m": (0, 0.02), "contacts": (0.3, 0), "lying": (0, 0)},
}
DEEPEST = {"walk": 3, "squat": 3, "heap": 30, "slope": 3}  # [mm] that bodies may overlap
WIDEST = 1  # [mm] by which joints may come apart


def differences(kind, seen, wanted):
    """Names of what differs from the reference's work by more than it may."""
    found = [key.split("_")[0] for key, (share, more) in ALIKE[kind].items()
             if not abs(seen[key] - wanted[key]) <= share * abs(wanted[key]) + more]
    if seen["depth_mm"] > DEEPEST[kind]:
        found.append("depth")
    if seen["gap_mm"] > WIDEST:
        found.append("gap")
    return found
