# What a tolerance of the distance between two axes allows of a and d: the report's figure 4.3.

BEGIN {
    # the link that is drawn, and its tolerance, larger than any of a real arm
    A = 4
    D = 3
    R = sqrt(A * A + D * D)
    T = 0.9
    svg(560, 460, "The errors of a and d that a distance tolerance allows", \
        "The plane of a and d. The distance of the axes is r, the root of a squared plus d squared: a circle. " \
        "With the tolerance the pair of a and d may lie anywhere in the ring between the circles of r minus and " \
        "r plus the tolerance. Three errors that reach the outer circle are marked: of a alone, of d alone, and " \
        "of both alike.")
    panel(60, 30, 456, 414)
    x_range(0, 6.6)
    y_range(0, 6.4)
    ring()
    frame_of_panel()
    arrow(at_x(6.4), at_y(0), at_x(6.6), at_y(0), "sm", "m")
    arrow(at_x(0), at_y(6.2), at_x(0), at_y(6.4), "sm", "m")
    label(at_x(6.6) + 6, at_y(0) + 20, "middle", "f0", "a")
    label(at_x(0) - 16, at_y(6.4) + 6, "middle", "f0", "d")
    line(at_x(0), at_y(0), at_x(A), at_y(D), "s0")
    label(at_x(A / 2) - 6, at_y(D / 2) - 8, "end", "f0", "r")
    x_tick(A, "a")
    line(at_x(A), at_y(0), at_x(A), at_y(D), "sm d2")
    line(at_x(0), at_y(D), at_x(A), at_y(D), "sm d2")
    # Eqs (4.14) to (4.16)
    reach(root(A) - A, 0, 1, "a alone, (4.14)")
    reach(0, root(D) - D, 3, "d alone, (4.15)")
    both = (sqrt((A + D) ^ 2 + 2 * (2 * R * T + T * T)) - (A + D)) / 2
    box(at_x(A), at_y(D + both), at_x(A + both) - at_x(A), at_y(D) - at_y(D + both), "s2 d1")
    reach(both, both, 2, "both alike, (4.16)")
    circle(at_x(A), at_y(D), 4, "f0")
    finish()
}

function root(x) {
    return sqrt(x * x + 2 * R * T + T * T)
}

# From (A, D) to the outer circle; Eq. (4.13) is what this figure is about, so it is held against it.
function reach(a, d, colour, text) {
    if (((R + T) ^ 2 - (A + a) ^ 2 - (D + d) ^ 2) ^ 2 > 1e-18) fail("not on the circle: " text)
    arrow(at_x(A), at_y(D), at_x(A + a), at_y(D + d), "s" colour " w2", colour)
    if (d == 0) label(at_x(A + a) + 18, at_y(D) + 6, "start", "small f" colour, text)
    else label(at_x(A + a) + 8, at_y(D + d) - 6, "start", "small f" colour, text)
}

function ring(    i, angle, points, inner, outer, nominal) {
    for (i = 0; i <= 60; i++) {
        angle = i * 3.14159265 / 120
        inner = inner pt(at_x((R - T) * cos(angle)), at_y((R - T) * sin(angle)))
        nominal = nominal pt(at_x(R * cos(angle)), at_y(R * sin(angle)))
    }
    for (i = 60; i >= 0; i--) {
        angle = i * 3.14159265 / 120
        outer = outer pt(at_x((R + T) * cos(angle)), at_y((R + T) * sin(angle)))
    }
    polygon(inner outer, "fb")
    polyline(inner, "sm")
    polyline(outer, "sm")
    polyline(nominal, "s0 d1")
    label(at_x(0.12), at_y(R + T) + 18, "start", "small fm", "r + tolerance")
    label(at_x(0.12), at_y(R - T) + 24, "start", "small fm", "r - tolerance")
    label(at_x(0.12), at_y(R) + 18, "start", "small f0", "r")
}
