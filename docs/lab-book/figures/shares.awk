# What one length and one angle may be off, on the walk from 1987 to all corrected.
# data: docs/lab-book/tools/shares

BEGIN {
    FS = "\t"
    svg(840, 640, "The tolerances of one length and one angle on the walk from 1987 to all errata corrected", \
        "Two panels with logarithmic axes over the errata, which are corrected one after the other: above the " \
        "tolerance of the base's length in mm, below that of an angle in rad. Four stepped lines each, for the " \
        "two cases of intella and of adpta. All fall steeply at root-of-ratio and hardly move elsewhere.")
}

/^#/ { next }
$1 != series[series_count] { series[++series_count] = $1; i = 0 }
{ step_name[++i] = $2; length_share[series_count, i] = $3; angle_share[series_count, i] = $4; step_count = i }

# Ticks at such multiples of the powers of ten
function log_ticks(factors, format,    k, n, count, factor) {
    count = split(factors, factor, " ")
    for (k = floor(y_min); k <= y_max; k++)
        for (n = 1; n <= count; n++)
            if (log10(factor[n]) + k >= y_min && log10(factor[n]) + k <= y_max)
                y_tick(factor[n] * 10 ^ k, sprintf(format, factor[n] * 10 ^ k))
}

function show(value, factors, format,    key) {
    for (key in value) step_value[key] = value[key]
    ranges_of_steps(1)
    log_ticks(factors, format)
    frame_of_panel()
    steps()
}

END {
    if (failed) exit 1
    panel(90, 45, 825, 265)
    legend_of_series(24)
    show(length_share, "1 1.5 2 3 5", "%.3f")
    y_title("rd[0], mm")
    panel(90, 295, 825, 515)
    show(angle_share, "1 3", "%.4f")
    y_title("ggd[0], rad")
    names_of_steps()
    label(760, 625, "end", "f0", "corrected so far")
    finish()
}
