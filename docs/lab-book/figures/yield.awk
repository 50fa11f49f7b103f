# How far the tools of arms are off that are built to the published and to the corrected tolerances.
# data: docs/lab-book/tools/part 'Largest linear component' yield --format=tsv golden/published.tsv

BEGIN {
    FS = "\t"
    svg(840, 400, "How far the tools of arms are off, built to the published and to the corrected tolerances", \
        "A row for each case and set of tolerances, on a logarithmic axis of the largest linear component of " \
        "the tool's error: a box from 10 to 90 percent of the arms with the median, a line from 90 to 99 " \
        "percent, a dot for the worst arm drawn. A dashed line marks the 0.5 mm that were asked for. The " \
        "published tolerances lie mostly beyond it, the corrected ones all within.")
    panel(160, 30, 815, 330)
    x_range(0.02, 10, 1)
    split("0.02 0.05 0.1 0.2 0.5 1 2 5 10", tick, " ")
    for (k = 1; k <= 9; k++) x_tick(tick[k] + 0, tick[k])
    line(panel_left, panel_bottom, panel_right, panel_bottom, "sm")
    # all four cases ask for it
    line(at_x(0.5), panel_top, at_x(0.5), panel_bottom, "s0 d1")
    label(at_x(0.5), panel_top - 8, "middle", "small f0", "asked for")
    rows = 0
}

$2 ~ /^[0-9.]+$/ {
    y = panel_top + 37.5 * rows++ + 19
    colour = $1 ~ /published/ ? 2 : 1
    label(panel_left - 8, y + 4, "end", colour == 2 ? "f2" : "f1", $1)
    box(at_x($2), y - 10, at_x($4) - at_x($2), 20, "f" colour)
    line(at_x($4), y, at_x($5), y, "w2 s" colour)
    line(at_x($5), y - 5, at_x($5), y + 5, "w2 s" colour)
    line(at_x($3), y - 10, at_x($3), y + 10, "median")
    mark(colour == 2 ? 1 : 4, at_x($6), y, colour)
}

END {
    if (failed) exit 1
    label((panel_left + panel_right) / 2, 368, "middle", "f0", "largest linear component of the tool's error, mm")
    label((panel_left + panel_right) / 2, 388, "middle", "small fm", \
        "box: 10 to 90 % of arms, with the median; line: to 99 %; mark: the worst drawn")
    finish()
}
