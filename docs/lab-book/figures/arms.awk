# Both arms with the frames of their links at the report's two positions: what its figures 5.2 and 5.4 show.
# data: docs/lab-book/tools/skeletons

BEGIN {
    FS = "\t"
    ARROW = 95
    SCALE = 0.53
    # the direction of the view: turned about z, then looked at from above
    turn["intelledex605t"] = 12 * 3.14159265 / 180
    turn["adeptone"] = 25 * 3.14159265 / 180
    RISE = 22 * 3.14159265 / 180
    title["intelledex605t"] = "Intelledex 605T"
    title["adeptone"] = "Adept AdeptOne"
    base_x["intelledex605t", 1] = base_x["adeptone", 1] = 130
    base_x["intelledex605t", 2] = base_x["adeptone", 2] = 690
    floor_y["intelledex605t"] = 280
    floor_y["adeptone"] = 600
    svg(840, 720, "Both arms and the frames of their links at the report's two positions", \
        "Four drawings of chains of links, the Intelledex above and the Adept below, position 1 left and " \
        "position 2 right. Each link's frame is drawn as an x axis and a z axis. The Intelledex has frames 0, 1 " \
        "and 2 at the shoulder, 3 at the elbow, 4, 5 and 6 at the wrist, and the tool's frame 100 mm before it. " \
        "The Adept has frame 0 on its column, 1 at the elbow, 2 and 3 above the tool, 4 and the tool's frame at " \
        "the tool. All z axes of the Adept are upright.")
}

# Where a point of space is on the page
function project_x(x, y, z) {
    return origin_x + SCALE * (x * cos(turn[arm]) - y * sin(turn[arm]))
}

function project_y(x, y, z) {
    return origin_y - SCALE * ((x * sin(turn[arm]) + y * cos(turn[arm])) * sin(RISE) + z * cos(RISE))
}

function space_line(x1, y1, z1, x2, y2, z2, class) {
    line(project_x(x1, y1, z1), project_y(x1, y1, z1), project_x(x2, y2, z2), project_y(x2, y2, z2), class)
}

function keep_clear_in_space(from, to) {
    keep_clear(project_x(px_[from], py_[from], pz_[from]), project_y(px_[from], py_[from], pz_[from]), \
        project_x(px_[to], py_[to], pz_[to]), project_y(px_[to], py_[to], pz_[to]))
}

# Axes that begin at one place and point the same way are one arrow with several names: axes[key] for the names.
function note_axis(kind, name, direction,    key, n) {
    key = kind SUBSEP $4 SUBSEP $5 SUBSEP $6 SUBSEP direction
    if (!(key in names)) {
        n = ++axes
        key_of[n] = key
        axis_kind[n] = kind
        for (i = 0; i < 3; i++) {
            axis_from[n, i] = $(4 + i)
            axis_to[n, i] = $(4 + i) + (name == "w" ? 0.8 : 1) * ARROW * $((kind == "x" ? 7 : 10) + i)
        }
        names[key] = kind name
    } else names[key] = names[key] ", " kind name
}

function nearest(x) {
    return floor(x + 0.5)
}

# All arrows first, then their names, so that every name keeps clear of the others
function draw_axes(    n, x1, y1, x2, y2) {
    for (n = 1; n <= axes; n++) {
        x1[n] = project_x(axis_from[n, 0], axis_from[n, 1], axis_from[n, 2])
        y1[n] = project_y(axis_from[n, 0], axis_from[n, 1], axis_from[n, 2])
        x2[n] = project_x(axis_to[n, 0], axis_to[n, 1], axis_to[n, 2])
        y2[n] = project_y(axis_to[n, 0], axis_to[n, 1], axis_to[n, 2])
        arrow(x1[n], y1[n], x2[n], y2[n], axis_kind[n] == "x" ? "s1 d1 w2" : "s2 w2", axis_kind[n] == "x" ? 1 : 2)
        keep_clear(x1[n], y1[n], x2[n], y2[n])
    }
    for (n = 1; n <= axes; n++)
        label_near(x2[n], y2[n], x2[n] - x1[n], y2[n] - y1[n], "small " (axis_kind[n] == "x" ? "f1" : "f2"), \
            names[key_of[n]])
}

function draw(    n, k) {
    origin_x = base_x[arm, position]
    origin_y = floor_y[arm]
    for (n = 2; n <= points; n++) {
        space_line(px_[n - 1], py_[n - 1], 0, px_[n], py_[n], 0, "sg w4")
        space_line(px_[n - 1], py_[n - 1], pz_[n - 1], px_[n], py_[n], pz_[n], "sl w9")
    }
    space_line(px_[points], py_[points], pz_[points], px_[points], py_[points], 0, "sm d2")
    for (n = 2; n <= points; n++) keep_clear_in_space(n - 1, n)
    for (n = 1; n <= points; n++)
        circle(project_x(px_[n], py_[n], pz_[n]), project_y(px_[n], py_[n], pz_[n]), 3.5, "f0")
    draw_axes()
    label(position == 1 ? 30 : 450, origin_y + 40, "start", "f0 strong", \
        sprintf("%s, tool at (%d, %d, %d)", title[arm], \
            nearest(px_[points]), nearest(py_[points]), nearest(pz_[points])))
    for (k in names) delete names[k]
    axes = 0
    points = 0
}

/^#/ { next }
points && (arm != $1 || position != $2) { draw() }
{
    arm = $1
    position = $2
    points++
    px_[points] = $4
    py_[points] = $5
    pz_[points] = $6
    note_axis("z", $3, $10 SUBSEP $11 SUBSEP $12)
    note_axis("x", $3, $7 SUBSEP $8 SUBSEP $9)
}
END {
    if (failed) exit 1
    draw()
    label(30, 680, "start", "f2", "z axes: the axis of joint i is the z axis of frame i - 1")
    label(30, 702, "start", "f1", "x axes (dashed); y completes each frame; w: world, t: tool")
    label(450, 680, "start", "fm", "wide: the links; wide and pale: their shadow")
    label(450, 702, "start", "fm", "on the floor, z = 0")
    finish()
}
