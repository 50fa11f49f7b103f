# Why nearly parallel axes need a fifth parameter: what the report's figures 4.1 and 4.2 show.
# data: docs/lab-book/tools/common-normal

BEGIN {
    FS = "\t"
    svg(840, 430, "Two nearly parallel axes, with four parameters and with five", \
        "Left: when the second axis tilts a little, the two axes meet far away, and the frame of the link jumps " \
        "to that place. Middle: with beta, a rotation about y, the frame stays where it is. Right: how far the " \
        "frame jumps for the Adept's inner link, over the tilt, on logarithmic axes: the smaller the tilt, the " \
        "farther. At the report's tolerance and at the corrected one the distance is marked.")
    # drawn much larger than a tilt of a real arm
    TILT = 13 * 3.14159265 / 180
    A = 70
    drawing(60, "four parameters", 0)
    drawing(330, "five parameters", 1)
}

# Axis i - 1 upright at x, axis i at a distance A from it, tilted away at the top; the plane of both.
function drawing(x, title, with_beta,    y, foot) {
    y = 100
    foot = y + A / sin(TILT) * cos(TILT)
    label(x + 60, 30, "middle", "f0 strong", title)
    line(x, 60, x, 400, "s0")
    label(x, 54, "middle", "small f0", "axis i - 1")
    line(x + A - (foot - y + 12) * sin(TILT) / cos(TILT), foot + 12, x + A + 40 * sin(TILT) / cos(TILT), y - 40, "s0")
    label(x + A + 24, 54, "middle", "small f0", "axis i")
    line(x + A, 66, x + A, 250, "sm d1")
    line(x, y, x + A, y, "sm d2")
    label(x + A / 2, y - 6, "middle", "small fm", "a")
    if (with_beta) {
        frame(x + A, y)
        arc(x + A, y, 72, -3.14159265 / 2, -3.14159265 / 2 - TILT, "s2")
        label(x + A - 9, y + 86, "middle", "f2", "β")
        label(x + A + 14, y + 42, "start", "small f0", "frame i stays here;")
        label(x + A + 14, y + 58, "start", "small f0", "z is turned by β")
        label(x + A + 14, y + 74, "start", "small f0", "about y")
    } else {
        circle(x + A, y, 4, "s0")
        label(x + A + 14, y + 5, "start", "small fm", "frame i was here")
        label(x + 38, y + 250, "start", "small f0", "it jumps to where")
        label(x + 38, y + 266, "start", "small f0", "the axes meet, and x")
        label(x + 38, y + 282, "start", "small f0", "points out of the page")
        circle(x, foot, 7, "s1 w2")
        circle(x, foot, 2.5, "f1")
        line(x - 24, y, x - 24, foot, "s2")
        line(x - 28, y, x - 20, y, "s2")
        line(x - 28, foot, x - 20, foot, "s2")
        label(x - 32, (y + foot) / 2, "end", "f2", "d")
    }
}

# x and z turned by the tilt about y, which points into the page
function frame(x, y) {
    arrow(x, y, x + 46 * cos(TILT), y + 46 * sin(TILT), "s1 w2 d1", 1)
    arrow(x, y, x + 46 * sin(TILT), y - 46 * cos(TILT), "s2 w2", 2)
    label(x + 52, y + 26, "start", "small f1", "x")
    label(x + 22, y - 28, "start", "small f2", "z")
    circle(x, y, 4, "f0")
}

/^#/ { next }
$1 == "tilt" { tilt[++tilts] = $2; distance[tilts] = $3; next }
{ name[++marks] = $1; mark_tilt[marks] = $2; mark_distance[marks] = $3 }

# 1000 m and more in km
function far(metres) {
    return metres >= 1000 ? sprintf("%.1f km", metres / 1000) : sprintf("%.0f m", metres)
}

END {
    if (failed) exit 1
    panel(610, 70, 815, 350)
    x_range(1e-5, 1e-1, 1)
    y_range(1, 1e5, 1)
    for (k = 0; k <= 5; k++) y_tick(10 ^ k, k < 3 ? 10 ^ k " m" : 10 ^ (k - 3) " km")
    for (k = -5; k <= -1; k += 2) x_tick(10 ^ k, k == -5 ? "0.00001" : 10 ^ k)
    frame_of_panel()
    label(712, 30, "middle", "f0 strong", "how far the frame jumps")
    label(712, 48, "middle", "small fm", "Adept, inner link, a = 425 mm")
    label(712, 388, "middle", "f0", "tilt, rad")
    for (k = 1; k <= tilts; k++) points = points pt(at_x(tilt[k]), at_y(distance[k]))
    polyline(points, "s2 w2")
    for (k = 1; k <= marks; k++) {
        mark(k == 1 ? 1 : 3, at_x(mark_tilt[k]), at_y(mark_distance[k]), 1)
        label(at_x(mark_tilt[k]) + (k == 1 ? -9 : 9), at_y(mark_distance[k]) + (k == 1 ? 13 : -5), \
            k == 1 ? "end" : "start", "small f1", name[k] ": " far(mark_distance[k]))
    }
    finish()
}
