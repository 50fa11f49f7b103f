# What a tolerance of the angle between two axes allows: the report's figures 4.4 and 4.5.

BEGIN {
    PI_ = 3.14159265
    # drawn much larger than any tolerance
    GAMMA = 24 * PI_ / 180
    PHI = 32 * PI_ / 180
    svg(840, 420, "The cone of axes that an angle tolerance allows", \
        "Left: a cone about the nominal axis, its half angle the tolerance gamma. The true axis lies within. " \
        "Right: the cone cut square to the nominal axis, one unit from its tip. The cut is a circle with the " \
        "tangent of gamma as radius. An axis on the rim, at the angle phi from the direction of alpha, has " \
        "tangents of its angle errors alpha and beta that are the coordinates of its point. Where both errors " \
        "are to be equal the point is at 45 degrees.")
    cone(210, 345, 235)
    cut(610, 205, 140)
    finish()
}

# Tip at (x, y), the cut at a height above it; the rim is seen as an ellipse.
function cone(x, y, height,    radius, flat, i, points) {
    radius = height * sin(GAMMA) / cos(GAMMA)
    flat = 0.32
    label(x, 30, "middle", "f0 strong", "the axes that γ allows")
    for (i = 0; i <= 72; i++)
        points = points pt(x + radius * cos(i * PI_ / 36), y - height - flat * radius * sin(i * PI_ / 36))
    polygon(points, "fb")
    polygon(points, "sm")
    line(x, y, x - radius, y - height, "sm")
    line(x, y, x + radius, y - height, "sm")
    line(x, y, x, y - height - 55, "s0 d1")
    label(x + 10, y - height - 44, "start", "f0", "z, nominal")
    rim_x = x + radius * cos(PHI)
    rim_y = y - height + flat * radius * sin(PHI)
    arrow(x, y, rim_x, rim_y, "s2 w2", 2)
    label(rim_x + 22, rim_y + 22, "start", "f2", "a true axis")
    arc(x, y, 120, PI_ / 2, PI_ / 2 - GAMMA, "s1 w2")
    label(x + 20, y - 126, "middle", "f1", "γ")
    circle(x, y, 3.5, "f0")
}

function cut(x, y, radius,    px_phi, py_phi, half) {
    label(x, 30, "middle", "f0 strong", "the cut at height 1")
    circle(x, y, radius, "fb")
    circle(x, y, radius, "sm")
    arrow(x - radius - 20, y, x + radius + 40, y, "s0", 0)
    arrow(x, y + radius + 20, x, y - radius - 20, "s0", 0)
    label(x + radius + 42, y + 20, "middle", "f0", "tan α")
    label(x + 34, y - radius - 12, "middle", "f0", "tan β")
    px_phi = x + radius * cos(PHI)
    py_phi = y - radius * sin(PHI)
    line(px_phi, py_phi, px_phi, y, "s2 d1")
    line(px_phi, py_phi, x, py_phi, "s2 d1")
    arrow(x, y, px_phi, py_phi, "s2 w2", 2)
    arc(x, y, 44, 0, PHI, "s2")
    label(x + 54, y - 12, "start", "f2", "φ")
    turned_label(x + radius * 0.55 * cos(PHI) - 6, y - radius * 0.55 * sin(PHI) - 8, -PHI * 180 / PI_, \
        "middle", "f2", "tan γ")
    label(px_phi + 8, py_phi - 6, "start", "f2", "P")
    label(x, y + radius + 62, "middle", "small f2", "P: tan α = tan γ cos φ, tan β = tan γ sin φ")
    half = radius / sqrt(2)
    polygon(pt(x - half, y - half) pt(x + half, y - half) pt(x + half, y + half) pt(x - half, y + half), "s1 w2")
    mark(2, x + half, y - half, 1)
    label(x - 8, y + half - 10, "end", "small f1", "equal shares")
    label(x, y + radius + 42, "middle", "small f1", "tan α = tan β = tan γ / √2")
}
