# Of the 66 published numbers, how many change when one erratum alone is corrected.
# data: docs/lab-book/tools/effect --counts

BEGIN { FS = "\t" }
/^#/ { next }
{ name[++rows] = $1; count[rows] = $2; if ($2 > most) most = $2 }

END {
    if (failed) exit 1
    svg(720, 60 + 24 * rows, "How many of the 66 published numbers each erratum changes", \
        "A bar for each erratum: how many of the 66 published numbers change when it alone is corrected. root- " \
        "of-ratio changes most. The number stands behind each bar.")
    panel(150, 10, 680, 10 + 24 * rows)
    x_range(0, most)
    for (k = 1; k <= rows; k++) {
        y = panel_top + 24 * (k - 1)
        label(panel_left - 8, y + 16, "end", "f0", name[k])
        box(panel_left, y + 4, at_x(count[k]) - panel_left, 16, "f1")
        label(at_x(count[k]) + 6, y + 16, "start", "f0", count[k])
    }
    line(panel_left, panel_top, panel_left, panel_bottom, "sm")
    label(panel_left, panel_bottom + 26, "start", "f0", \
        "published numbers that change, of 66, when it alone is corrected")
    finish()
}
