# The bounds on the walk from 1987 to all corrected, one erratum at a time.
# data: reproduce --walk --format=tsv golden/published.tsv

BEGIN {
    FS = "\t"
    svg(840, 640, "The bounds on the walk from 1987 to all errata corrected", \
        "Two panels over the errata, which are corrected one after the other: above the bound for lengths in " \
        "mm, below the bound for angles in rad. Four stepped lines each, for the two cases of intella and of " \
        "adpta. Most errata change nothing here. The page below the figure has every number.")
}

/^# / { series[++series_count] = substr($1, 3); sub(/, case /, "-", series[series_count]); i = 0; next }
$2 ~ /^[0-9]/ {
    step_name[++i] = $1
    length_bound[series_count, i] = $2
    angle_bound[series_count, i] = $3
    step_count = i
}

function show(value, format,    key) {
    for (key in value) step_value[key] = value[key]
    ranges_of_steps(0)
    y_ticks(6, format)
    frame_of_panel()
    steps()
}

END {
    if (failed) exit 1
    panel(90, 45, 825, 265)
    legend_of_series(24)
    show(length_bound, "%.3f")
    y_title("distance bound, mm")
    panel(90, 295, 825, 515)
    show(angle_bound, "%.4f")
    y_title("angle bound, rad")
    names_of_steps()
    label(760, 625, "end", "f0", "corrected so far")
    finish()
}
