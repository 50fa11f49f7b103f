# Reads kinematic2.h and prints what legacy/frames promises, for a compiler that lays a frame out as pcc, the portable C
# compiler of Bell Labs and Berkeley, is known to: arguments pushed from the last to the first, a float as a double;
# then return address and frame pointer; then the locals in the order in which they are declared, from the frame pointer
# down. Nothing is saved below, for gnpr and getj as printed have no register variables. That the compiler of 1987
# was one of that family is not known.

function fail(what) {
    printf "in-order: %s: not as expected: %s\n", FILENAME, what > "/dev/stderr"
    failed = 1
    exit 1
}

function put(text) {
    sp -= 4
    note[routine, sp] = text
}

function put_double(text) {
    put(text ", lower half")
    put(text ", upper half")
}

# the elements of "skew[3][3]", the last first, for the stack grows down
function put_array(text,    name, rows, columns, i, k) {
    name = text
    sub(/\[.*/, "", name)
    match(text, /\[[0-9]+\]/)
    rows = substr(text, RSTART + 1, RLENGTH - 2)
    columns = substr(text, RSTART + RLENGTH + 1) + 0
    for (i = rows - 1; i >= 0; i--)
        for (k = columns - 1; k >= 0; k--) put(sprintf("%s[%d][%d]", name, i, k))
}

function lay_out(    names, count, i) {
    sp = 0
    count = split(arguments, names, ",")
    for (i = count; i >= 1; i--)
        if (is_double[names[i]]) put_double("argument " names[i])
        else put("argument " names[i])
    put("return address of " routine)
    put("saved frame pointer")
    for (i = 1; i <= locals; i++)
        if (local[i] ~ /\[/) put_array(local[i])
        else put(local[i])
}

# A declaration may take several lines, a name on each; comments are gone by now.
function declare(text,    name) {
    if (text ~ /(float|double|int) /) type = text
    name = text
    sub(/.* /, "", name)
    sub(/[,;]/, "", name)
    if (!inside) is_double[name] = type ~ /double/
    else local[++locals] = name
}

{
    gsub(/\/\*.*\*\//, "")
    gsub(/^[ \t]+|[ \t]+$/, "")
}

/^(gnpr|getj)\(.*\)$/ {
    routine = arguments = $0
    sub(/\(.*/, "", routine)
    sub(/.*\(/, "", arguments)
    sub(/\)/, "", arguments)
    locals = inside = 0
    split("", is_double)
    next
}
routine && $0 == "{" { inside = 1; next }
routine && inside && $0 == "" {
    lay_out()
    depth[routine] = sp
    in_body = routine
    routine = ""
    next
}
routine { declare($0) }

# The last routine that gnpr calls, and what it is passed, lie below the locals.
in_body == "gnpr" && match($0, /(sin|cos)\([a-z]+\)/) { called = substr($0, RSTART, RLENGTH) }
/^}/ { in_body = "" }

END {
    if (failed) exit 1
    if (!depth["gnpr"] || !depth["getj"] || !called) fail("gnpr or getj")
    passed = called
    sub(/.*\(/, "", passed)
    sub(/\)/, "", passed)
    sub(/\(.*/, "", called)
    routine = "gnpr"
    sp = depth["gnpr"]
    put(passed ", lower half, as passed to " called)
    put(passed ", upper half, as passed to " called)
    for (place = -4; note["getj", place] !~ /^skew\[0\]\[0\]/ && place >= -200; place -= 4) ;
    for (i = 0; i < 9; i += 4) note["getj", place + 4 * i] = note["getj", place + 4 * i] ", never set"
    base = place
    for (place = -4; place >= base; place -= 4)
        printf "%d\t%s\t%s\t\n", place, note["gnpr", place], note["getj", place]
}
