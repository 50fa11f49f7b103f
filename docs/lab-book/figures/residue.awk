# The Adept's angle tolerance over the first word on the skew diagonal, the second 1 and the third 0.
# data needs cc: docs/lab-book/tools/diagonals --scan

BEGIN {
    FS = "\t"
    svg(840, 680, "The Adept's angle tolerance over the first word on the skew diagonal", \
        "Two panels, for the two cases of adpta: the angle tolerance ggd over the first word on the diagonal, a " \
        "curve, and a band of values that are printed as the report prints them. In case 1 the curve is within " \
        "the band only near the word of a big-endian machine with IEEE numbers, 1.946, and above the band at " \
        "the word of a VAX, 1.571. In case 2 both lie within. Without a residue neither case is within the " \
        "band.")
}

/^#/ { next }
$1 == "published" { published[1] = $3 * 1000; published[2] = $4 * 1000; next }
$1 == "scan" { word[++scanned] = $2; scan[1, scanned] = $3 * 1000; scan[2, scanned] = $4 * 1000; next }
{ word_of_[$1] = $2; at_word[$1, 1] = $3 * 1000; at_word[$1, 2] = $4 * 1000 }

function upright(what, class) {
    if (!(what in word_of_)) fail("no row of " what)
    line(at_x(word_of_[what]), panel_top, at_x(word_of_[what]), panel_bottom, class)
}

# half the last printed digit, in mrad
function show(case_, title,    k, low, high, points, x) {
    low = published[case_] - 0.0005
    high = published[case_] + 0.0005
    for (k = 1; k <= scanned; k++) {
        if (scan[case_, k] < low) low = scan[case_, k]
        if (scan[case_, k] > high) high = scan[case_, k]
    }
    x_range(0, 3)
    y_range(low - 0.0004, high + 0.0004)
    box(panel_left, at_y(published[case_] + 0.0005), panel_right - panel_left, \
        at_y(published[case_] - 0.0005) - at_y(published[case_] + 0.0005), "fb")
    y_ticks(6, "%.4f")
    x_ticks(6, "%.1f")
    frame_of_panel()
    upright("VAX", "sm d1")
    upright("68020", "s2 w2")
    for (k = 1; k <= scanned; k++) points = points pt(at_x(word[k]), at_y(scan[case_, k]))
    polyline(points, "s1 w2")
    mark(3, at_x(word_of_["none"]), at_y(at_word["none", case_]), 4)
    label(at_x(0.06), at_y(at_word["none", case_]) + (case_ == 1 ? 22 : -12), "start", "small f4", \
        "no residue: all three words 0")
    label(at_x(word_of_["VAX"]) - 6, panel_top + 14, "end", "small fm", "VAX")
    label(at_x(word_of_["68020"]) + 6, panel_top + 14, "start", "small f2", "IEEE, big-endian")
    label(at_x(case_ == 1 ? 0.06 : 2.96), at_y(published[case_]) + 4, case_ == 1 ? "start" : "end", "small f3", \
        "printed as published")
    label((panel_left + panel_right) / 2, panel_top - 10, "middle", "f0 strong", title)
    y_title("ggd, mrad")
}

END {
    if (failed) exit 1
    panel(90, 35, 825, 315)
    show(1, "adpta, case 1")
    panel(90, 365, 825, 635)
    show(2, "adpta, case 2")
    label((panel_left + panel_right) / 2, 672, "middle", "f0", "first word on the diagonal")
    finish()
}
