# The sphere of the bound, the cube in it and the largest box, in two dimensions: the Adept's first two motors.
# data: docs/lab-book/tools/two-columns

BEGIN {
    FS = "\t"
    svg(880, 500, "Sphere, cube in it and largest box, for two parameters", \
        "The plane of two errors, of the motors 1 and 2 of the Adept. Two pairs of parallel lines bound the " \
        "errors that keep the tool within its accuracy: a parallelogram. The largest circle in it about the " \
        "middle has the bound r as radius. The square in the circle has half a side of r over the root of 2: " \
        "each parameter's share. The largest box in the parallelogram, sides parallel to the axes, is longer in " \
        "theta 1 and shorter in theta 2. Half a side of the root of r over 2, as the programs have it, is far " \
        "outside of the figure.")
}

/^#/ { next }
{ rows++; name[rows] = $1; e[rows] = $2; p[rows] = $3; q[rows] = $4 }

# Rows k and l at the ends s and t of their tolerances: where the two lines cross
function corner(k, l, s, t,    det) {
    det = p[k] * q[l] - p[l] * q[k]
    corner_x = (s * e[k] * q[l] - t * e[l] * q[k]) / det
    corner_y = (t * e[l] * p[k] - s * e[k] * p[l]) / det
}

# How far the second may go where the first goes as far as x
function room(x,    k, y, least) {
    least = 1e9
    for (k = 1; k <= rows; k++) {
        y = (e[k] - size(p[k]) * x) / size(q[k])
        if (y < least) least = y
    }
    return least
}

function size(x) {
    return x < 0 ? -x : x
}

# A box about the middle
function centred(x, y, class) {
    polygon(pt(at_x(-x), at_y(-y)) pt(at_x(x), at_y(-y)) pt(at_x(x), at_y(y)) pt(at_x(-x), at_y(y)), class)
}

# Beside the upper line of row k, where it is nearest to the middle
function name_line(k,    up, square) {
    square = p[k] ^ 2 + q[k] ^ 2
    up = q[k] < 0 ? -e[k] / square : e[k] / square
    label(at_x(up * p[k]) + (up * p[k] < 0 ? -10 : 10), at_y(up * q[k]) - 6, up * p[k] < 0 ? "end" : "start", \
        "small f0", "|" name[k] "| = " e[k] / 1000 " mm")
}

END {
    if (failed) exit 1
    if (rows != 2) fail("two rows were expected")
    r = 1e9
    for (k = 1; k <= rows; k++) {
        bound = e[k] / sqrt(p[k] ^ 2 + q[k] ^ 2)
        if (bound < r) { r = bound; least = k }
    }
    share = r / sqrt(2)
    for (i = 1; i < 20000; i++) {
        x = i * 2e-3 / 20000
        if (room(x) > 0 && x * room(x) > best) { best = x * room(x); box_x = x; box_y = room(x) }
    }
    panel(70, 20, 530, 480)
    x_range(-2.1, 2.1)
    y_range(-2.1, 2.1)
    # in mrad
    r *= 1000; share *= 1000; box_x *= 1000; box_y *= 1000
    for (k = 1; k <= rows; k++) e[k] *= 1000
    for (i = 0; i < 4; i++) {
        corner(1, 2, i == 0 || i == 3 ? 1 : -1, i < 2 ? 1 : -1)
        points = points pt(at_x(corner_x), at_y(corner_y))
    }
    polygon(points, "fb")
    polygon(points, "sm")
    arrow(at_x(-2.1), at_y(0), at_x(2.1), at_y(0), "sm", "m")
    arrow(at_x(0), at_y(-2.1), at_x(0), at_y(2.1), "sm", "m")
    for (i = -2; i <= 2; i++)
        if (i) {
            line(at_x(i), at_y(0), at_x(i), at_y(0) + 4, "sm")
            line(at_x(0) - 4, at_y(i), at_x(0), at_y(i), "sm")
        }
    label(at_x(2), at_y(0) + 17, "middle", "small fm", "2")
    label(at_x(0) - 7, at_y(2) + 4, "end", "small fm", "2")
    label(at_x(2.1) + 12, at_y(0) + 44, "end", "f0", "θ1, mrad")
    label(at_x(0) + 8, at_y(2.1) + 8, "start", "f0", "θ2, mrad")
    circle(at_x(0), at_y(0), at_x(r) - at_x(0), "s1 w2")
    centred(share, share, "s2 w2")
    centred(box_x, box_y, "s3 w2 d1")
    line(at_x(0), at_y(0), at_x(share), at_y(share), "s1 d2 w2")
    label(at_x(share / 2) - 4, at_y(share / 2) - 8, "end", "f1", "r")
    for (k = 1; k <= rows; k++) name_line(k)
    legend(1, "s1 w2", "f1", sprintf("the sphere: r = %.4f mrad", r), \
        "r = min (e - δ) / |row|, here that of " name[least])
    legend(2, "s2 w2", "f2", sprintf("the cube in it: r / √2 = %.4f mrad each", share), "its corners lie on the circle")
    legend(3, "s3 w2 d1", "f3", sprintf("the largest box: %.4f and %.4f mrad", box_x, box_y), \
        sprintf("its area is %.2f times the cube's", box_x * box_y / share ^ 2))
    legend(4, "sm", "fm", "the region |A x| ≤ e - δ", "the errors that are allowed, worst case")
    label(550, 330, "start", "f0", "√(r / 2), as programmed in 1987:")
    programmed = sqrt(r / 1000 / 2) * 1000
    label(550, 350, "start", "f0", sprintf("%.1f mrad each, %.0f times r / √2,", programmed, programmed / share))
    label(550, 370, "start", "f0", "far outside of this figure")
    finish()
}

function legend(n, stroke, fill, text, more,    y) {
    y = 60 + 58 * (n - 1)
    line(550, y - 4, 576, y - 4, stroke)
    label(584, y, "start", "small " fill " strong", text)
    label(584, y + 17, "start", "small fm", more)
}
