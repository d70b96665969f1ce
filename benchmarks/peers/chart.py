def draw(d, f): pass
