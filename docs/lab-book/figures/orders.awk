# Ways to write the inverse kinematics, by how many of the published joint values they give.
# data: docs/lab-book/tools/part 'Configurations by how many' joint-orders --show histogram --format=tsv golden/published.tsv

BEGIN {
    FS = "\t"
    svg(840, 430, "Ways to write the inverse kinematics, by how many published joint values they give", \
        "Two histograms with logarithmic axes. Left: the ways of intella by how many of its 12 joint values " \
        "come out. Right: pairs of a way of intella and one of adpta, by how many of all 20 come out. A bar " \
        "begins at 1, so that its length is the power of ten of its count. Bars of those that give all values " \
        "are hatched and have their count.")
}

/^[0-9]/ { if ($2) single[$1] = $2; if ($4) pairs[$1] = $4 }

function power(count) {
    return count >= 1000000 ? sprintf("%.2f million", count / 1000000) : count
}

function histogram(count, all, title,    n, most, width, x, y, k) {
    for (n in count) if (count[n] > most) most = count[n]
    x_range(-0.7, all + 0.7)
    y_range(1, most * 1.5, 1)
    for (k = 0; k <= y_max; k++) y_tick(10 ^ k, k == 0 ? "1" : k < 4 ? 10 ^ k : "1e" k)
    width = 0.8 * (at_x(1) - at_x(0))
    for (n = 0; n <= all; n++) {
        if (n % 2 == 0) x_tick(n, n)
        if (!(n in count)) continue
        x = at_x(n) - width / 2
        y = at_y(count[n])
        box(x, y, width, panel_bottom - y, n == all ? "f2" : "f1")
    }
    for (y = at_y(count[all]) + 5; y < panel_bottom - 2; y += 6)
        line(at_x(all) - width / 2, y, at_x(all) + width / 2, y, "s0")
    frame_of_panel()
    x_title("joint values right")
    label((panel_left + panel_right) / 2, 24, "middle", "f0 strong", title)
    label(panel_right, 44, "end", "small f2", "all " all ": " power(count[all]))
}

END {
    if (failed) exit 1
    panel(60, 60, 385, 360)
    histogram(single, 12, "intella: ways, of 12 values")
    panel(475, 60, 825, 360)
    histogram(pairs, 20, "both programs: pairs of ways, of 20")
    label(60, 420, "start", "small fm", \
        "The axis begins at 1; a bar's length is its count's power of ten. No bar: none.")
    finish()
}
