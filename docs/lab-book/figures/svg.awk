# What the figures here are drawn with, read before a figure's own NAME.awk: marks on a page of SVG that reads on
# light and on dark ground. Places are in pixels from the upper left corner. A text that leaves the page or lies
# on another text is an error: a figure that anyone is to read is not made of such.
#
# The classes of a mark, several to one: of lines s0 (ink), sm (muted), sg (grid), sl (a solid part) and s1 to s4
# (four colours that a colour-blind reader tells apart); of areas f0, fm, fb (a band), fl (a solid part), ground and
# f1 to f4; w2, w4, w9 (wide), d1, d2 (dashed), pale; of texts f0 to f4, fm, small and strong.

function fail(what) {
    printf "%s: %s\n", FILENAME, what > "/dev/stderr"
    failed = 1
    exit 1
}

function colours(names, values,    name, value, count, i) {
    count = split(names, name, " ")
    split(values, value, " ")
    for (i = 1; i <= count; i++)
        printf "    .s%s { stroke: %s } .f%s { fill: %s }\n", name[i], value[i], name[i], value[i]
}

# svg WIDTH HEIGHT TITLE DESCRIPTION: what comes first. The description is for who does not see the figure.
function svg(width, height, title, description) {
    page_width = width
    page_height = height
    texts = 0
    printf "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 %d %d\" width=\"%d\" height=\"%d\"", \
        width, height, width, height
    print " role=\"img\" aria-labelledby=\"title desc\">"
    printf "  <title id=\"title\">%s</title>\n  <desc id=\"desc\">%s</desc>\n", escaped(title), escaped(description)
    print "  <style>"
    print "    path, polyline, polygon, circle, rect { fill: none }"
    print "    polyline, path { stroke-linejoin: round; stroke-linecap: round }"
    print "    text { font: 13px sans-serif } .small { font-size: 11px } .strong { font-weight: bold }"
    print "    .w2 { stroke-width: 2 } .w4 { stroke-width: 4.5 } .w9 { stroke-width: 9 }"
    print "    .d1 { stroke-dasharray: 6 4 } .d2 { stroke-dasharray: 2 3 } .pale { stroke-opacity: 0.4 }"
    print "    .ground { fill: #ffffff } .median { stroke: #ffffff; stroke-width: 2 }"
    colours("0 m g b l 1 2 3 4", "#1f2328 #5f6770 #dfe2e6 #cfe8d8 #b4bcc6 #0072b2 #c14f00 #007a5a #93407a")
    print "    @media (prefers-color-scheme: dark) {"
    print "    .ground { fill: #0d1117 } .median { stroke: #0d1117 }"
    colours("0 m g b l 1 2 3 4", "#e6edf3 #9da7b1 #30363d #1d4a38 #4d5661 #58b0e8 #ff9a57 #3fce9f #e79bcb")
    print "    }"
    print "  </style>"
    print "  <rect class=\"ground\" width=\"100%\" height=\"100%\"/>"
}

function finish() {
    print "</svg>"
}

function escaped(text) {
    gsub(/&/, "\\&amp;", text)
    gsub(/</, "\\&lt;", text)
    gsub(/>/, "\\&gt;", text)
    return text
}

# A place to a tenth of a pixel; no -0.0, which not every awk prints.
function px(x,    text) {
    text = sprintf("%.1f", x)
    return text == "-0.0" ? "0.0" : text
}

function pt(x, y) {
    return px(x) "," px(y) " "
}

function line(x1, y1, x2, y2, class) {
    printf "  <path class=\"%s\" d=\"M%s %sL%s %s\"/>\n", class, px(x1), px(y1), px(x2), px(y2)
}

function polyline(points, class) {
    sub(/ $/, "", points)
    printf "  <polyline class=\"%s\" points=\"%s\"/>\n", class, points
}

function polygon(points, class) {
    sub(/ $/, "", points)
    printf "  <polygon class=\"%s\" points=\"%s\"/>\n", class, points
}

function circle(x, y, radius, class) {
    printf "  <circle class=\"%s\" cx=\"%s\" cy=\"%s\" r=\"%s\"/>\n", class, px(x), px(y), px(radius)
}

function box(x, y, width, height, class) {
    printf "  <rect class=\"%s\" x=\"%s\" y=\"%s\" width=\"%s\" height=\"%s\"/>\n", \
        class, px(x), px(y), px(width), px(height)
}

# A line whose head, at (x2, y2), has the colour's number: arrow ... s1 w2, 1
function arrow(x1, y1, x2, y2, class, colour,    length_, ux, uy, head) {
    length_ = sqrt((x2 - x1) ^ 2 + (y2 - y1) ^ 2)
    line(x1, y1, x2, y2, class)
    if (length_ < 4) return
    ux = (x2 - x1) / length_
    uy = (y2 - y1) / length_
    head = length_ < 16 ? length_ / 2 : 8
    polygon(pt(x2 + ux, y2 + uy) pt(x2 - head * ux - 0.4 * head * uy, y2 - head * uy + 0.4 * head * ux) \
        pt(x2 - head * ux + 0.4 * head * uy, y2 - head * uy - 0.4 * head * ux), "f" colour)
}

# A part of a circle, its angles in rad from the x axis, counter-clockwise as the reader sees it
function arc(x, y, radius, from, to, class,    i, points) {
    for (i = 0; i <= 24; i++)
        points = points pt(x + radius * cos(from + (to - from) * i / 24), y - radius * sin(from + (to - from) * i / 24))
    polyline(points, class)
}

# Marks that differ in shape: a dot, a ring, a square, a triangle.
function mark(kind, x, y, colour) {
    if (kind == 1) circle(x, y, 3, "f" colour)
    else if (kind == 2) box(x - 2.8, y - 2.8, 5.6, 5.6, "f" colour)
    else if (kind == 3) circle(x, y, 5.5, "s" colour " w2")
    else polygon(pt(x, y - 4) pt(x + 3.8, y + 3) pt(x - 3.8, y + 3), "f" colour)
}

# --- texts ----------------------------------------------------------------------------------------

# How wide a text is, about: a letter of more bytes than one counts once.
function width_of(text, class) {
    gsub(/[\200-\277]/, "", text)
    return length(text) * (class ~ /small/ ? 11 : 13) * (class ~ /strong/ ? 0.6 : 0.54)
}

# The box of a text goes to left, right_, top, bottom.
function measure(x, y, anchor, class, text,    em) {
    em = class ~ /small/ ? 11 : 13
    left = anchor == "start" ? x : anchor == "end" ? x - width_of(text, class) : x - width_of(text, class) / 2
    right_ = left + width_of(text, class)
    top = y - 0.8 * em
    bottom = y + 0.15 * em
}

# Is the box free of all texts so far, and on the page?
function is_free(    i) {
    if (left < 0 || right_ > page_width || top < 0 || bottom > page_height) return 0
    for (i = 1; i <= texts; i++)
        if (left < text_right[i] && right_ > text_left[i] && top < text_bottom[i] && bottom > text_top[i]) return 0
    return 1
}

function keep() {
    texts++
    text_left[texts] = left
    text_right[texts] = right_
    text_top[texts] = top
    text_bottom[texts] = bottom
}

# No label_near comes to lie on this line.
function keep_clear(x1, y1, x2, y2,    count, i) {
    count = int(sqrt((x2 - x1) ^ 2 + (y2 - y1) ^ 2) / 6) + 1
    for (i = 0; i <= count; i++) {
        left = x1 + (x2 - x1) * i / count - 3
        top = y1 + (y2 - y1) * i / count - 3
        right_ = left + 6
        bottom = top + 6
        keep()
    }
}

# label X Y start|middle|end CLASS TEXT: (x, y) on the text's base line
function label(x, y, anchor, class, text) {
    measure(x, y, anchor, class, text)
    if (!is_free()) fail("this text lies on another or off the page: " text)
    keep()
    printf "  <text class=\"%s\" x=\"%s\" y=\"%s\" text-anchor=\"%s\">%s</text>\n", \
        class, px(x), px(y), anchor, escaped(text)
}

# Upright or slanting: turned by so many degrees, clockwise. Not held against the others.
function turned_label(x, y, degrees, anchor, class, text) {
    printf "  <text class=\"%s\" transform=\"translate(%s %s) rotate(%d)\" text-anchor=\"%s\">%s</text>\n", \
        class, px(x), px(y), degrees, anchor, escaped(text)
}

# A label in the middle of the first free place near (x, y), beginning in the direction of (dx, dy)
function label_near(x, y, dx, dy, class, text,    away, step, side, angle) {
    for (away = 10; away <= 60; away += 5)
        for (step = 0; step <= 16; step++) {
            side = step % 2 ? (step + 1) / 2 : -step / 2
            angle = atan2(dy, dx) + side * 3.14159265 / 16 * 2
            measure(x + away * 1.1 * cos(angle), y + away * sin(angle) + 4, "middle", class, text)
            if (is_free()) {
                label(x + away * 1.1 * cos(angle), y + away * sin(angle) + 4, "middle", class, text)
                return
            }
        }
    fail("no place for this text: " text)
}

# --- panels with axes -----------------------------------------------------------------------------

function panel(x1, y1, x2, y2) {
    panel_left = x1
    panel_top = y1
    panel_right = x2
    panel_bottom = y2
}

function log10(x) {
    return log(x) / log(10)
}

# The axes' ranges; logarithmic ones are given as they are printed, 0.1 and not -1.
function x_range(min, max, logarithmic) {
    x_log = logarithmic
    x_min = logarithmic ? log10(min) : min
    x_max = logarithmic ? log10(max) : max
}

function y_range(min, max, logarithmic) {
    y_log = logarithmic
    y_min = logarithmic ? log10(min) : min
    y_max = logarithmic ? log10(max) : max
}

function at_x(x) {
    return panel_left + ((x_log ? log10(x) : x) - x_min) / (x_max - x_min) * (panel_right - panel_left)
}

function at_y(y) {
    return panel_bottom - ((y_log ? log10(y) : y) - y_min) / (y_max - y_min) * (panel_bottom - panel_top)
}

function frame_of_panel() {
    line(panel_left, panel_top, panel_left, panel_bottom, "sm")
    line(panel_left, panel_bottom, panel_right, panel_bottom, "sm")
}

function x_tick(x, text) {
    line(at_x(x), panel_bottom, at_x(x), panel_bottom + 4, "sm")
    if (text != "") label(at_x(x), panel_bottom + 18, "middle", "small f0", text)
}

function y_tick(y, text) {
    line(panel_left, at_y(y), panel_right, at_y(y), "sg")
    label(panel_left - 6, at_y(y) + 4, "end", "small f0", text)
}

# A step of 1, 2 or 5 times a power of ten, so that there are about so many
function step_for(span, count,    unit, rest) {
    unit = 10 ^ floor(log10(span / count))
    rest = span / count / unit
    return unit * (rest <= 1.5 ? 1 : rest <= 3.5 ? 2 : rest <= 7.5 ? 5 : 10)
}

function floor(x) {
    return int(x) > x ? int(x) - 1 : int(x)
}

# Ticks of a linear axis of values y, with a format for sprintf
function y_ticks(count, format,    step, k) {
    step = step_for(y_max - y_min, count)
    for (k = floor(y_min / step + 0.999999); k * step <= y_max + step * 1e-6; k++)
        y_tick(k * step, sprintf(format, k * step))
}

function x_ticks(count, format,    step, k) {
    step = step_for(x_max - x_min, count)
    for (k = floor(x_min / step + 0.999999); k * step <= x_max + step * 1e-6; k++)
        x_tick(k * step, sprintf(format, k * step))
}

# What an axis shows
function x_title(text) {
    label((panel_left + panel_right) / 2, panel_bottom + 38, "middle", "f0", text)
}

function y_title(text) {
    turned_label(panel_left - 54, (panel_top + panel_bottom) / 2, -90, "middle", "f0", text)
}

# --- series of steps over the errata -------------------------------------------------------------- series[k]: the
# name of series k of `series_count`; step_value[k, i]: its value behind the i-th of `step_count` errata, whose names
# are step_name[i]. Colour, mark and line all tell the series apart, and where two are equal both are seen: the third
# is a wide, pale line under the fourth.

function line_of(k) {
    return k == 1 ? "s1 w2" : k == 2 ? "s3 w2 d1" : k == 3 ? "s2 w4 pale" : "s4 w2 d2"
}

function mark_of(k, x, y) {
    mark(k == 2 ? 2 : k == 3 ? 3 : k == 4 ? 4 : 1, x, y, k == 1 ? 1 : k == 2 ? 3 : k == 3 ? 2 : 4)
}

function legend_of_series(y,    k, x) {
    for (k = 1; k <= series_count; k++) {
        x = panel_left + 120 * (k - 1)
        line(x, y - 4, x + 30, y - 4, line_of(k))
        mark_of(k, x + 15, y - 4)
        label(x + 38, y, "start", "small f0", series[k])
    }
}

# The ranges of both axes from what is shown
function ranges_of_steps(logarithmic,    k, i, low, high, margin) {
    low = high = step_value[1, 1]
    for (k = 1; k <= series_count; k++)
        for (i = 1; i <= step_count; i++) {
            if (step_value[k, i] + 0 < low + 0) low = step_value[k, i]
            if (step_value[k, i] + 0 > high + 0) high = step_value[k, i]
        }
    margin = logarithmic ? (high / low) ^ 0.06 : 0.06 * (high - low)
    x_range(0.6, step_count + 0.4)
    y_range(logarithmic ? low / margin : low - margin, logarithmic ? high * margin : high + margin, logarithmic)
}

function steps(    k, i, points) {
    for (k = 1; k <= series_count; k++) {
        points = pt(at_x(1), at_y(step_value[k, 1]))
        for (i = 2; i <= step_count; i++)
            points = points pt(at_x(i), at_y(step_value[k, i - 1])) pt(at_x(i), at_y(step_value[k, i]))
        polyline(points, line_of(k))
    }
    for (k = 1; k <= series_count; k++)
        for (i = 1; i <= step_count; i++) mark_of(k, at_x(i), at_y(step_value[k, i]))
    for (i = 1; i <= step_count; i++) line(at_x(i), panel_bottom, at_x(i), panel_bottom + 4, "sm")
}

function names_of_steps(    i) {
    for (i = 1; i <= step_count; i++)
        turned_label(at_x(i) + 4, panel_bottom + 16, -40, "end", "small f0", step_name[i])
}
