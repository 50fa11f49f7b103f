# Reads the nine words of skew, then the assembler of adpta.c (gcc for a 68020, -O0 -fverbose-asm), and prints what
# legacy/frames promises. Goes through main's call of the last gnpr, gnpr, main's call of the first getj and getj, one
# instruction after the other, and keeps who wrote each word last. Places are in bytes from S, main's stack pointer
# between two calls.

function fail(what) {
    printf "frames: the assembler is not as expected: %s\n", what > "/dev/stderr"
    exit 1
}

# "20(%fp),-(%sp)", "%d0,-32(%fp)" or "%fp,#-8": the offset.
function number_in(text) {
    sub(/\(%fp\).*/, "", text)
    sub(/.*[,#]/, "", text)
    return text + 0
}

# What -fverbose-asm calls the operands, behind the bar: "| alpha," or "| _5, n2".
function names_of(n,    text) {
    text = line[n]
    sub(/^[^|]*\|[ \t]*/, "", text)
    return text
}

function first_name(n,    text) {
    text = names_of(n)
    sub(/,.*/, "", text)
    return text
}

function last_name(n,    text) {
    text = names_of(n)
    sub(/.*, */, "", text)
    return text
}

function push(text) {
    sp -= 4
    note[side, sp] = text
}

function next_routine(n) {
    while (opcode[n] != "jsr") n++
    return operand[n]
}

# "move.l 20(%fp),-(%sp) | kalpha," in gnpr: the two halves of a double, the upper at the lower place
function passed_on(n,    offset) {
    offset = number_in(operand[n])
    return sprintf("%s, %s half, as passed to %s", first_name(n), offset % 8 ? "lower" : "upper", next_routine(n))
}

function step(n) {
    if (opcode[n] == "link.w") {
        push("saved frame pointer")
        fp = sp
        sp += number_in(operand[n])
    } else if (operand[n] ~ /^%d[0-9],-\(%sp\)$/)
        push("saved register " substr(operand[n], 2, 2))
    else if (operand[n] ~ /^[0-9]+\(%fp\),-\(%sp\)$/)
        push(passed_on(n))
    else if (opcode[n] == "fmove.s" && operand[n] ~ /\(%fp\),%fp[0-9]$/)
        source[last_name(n)] = first_name(n)
    else if (opcode[n] == "fmove.d" && operand[n] ~ /-\(%sp\)$/) {
        push(source[first_name(n)] ", lower half, as passed to " next_routine(n))
        push(source[first_name(n)] ", upper half, as passed to " next_routine(n))
    }
    else if (opcode[n] == "jsr") {
        note[side, sp - 4] = "return address of " operand[n]
        last_called[side] = operand[n]
    }
    else if (opcode[n] == "addq.l" && operand[n] ~ /,%sp$/)
        sp += substr(operand[n], 2)
    else if (operand[n] ~ /^(%[df]p?[0-9],)?-[0-9]+\(%fp\)$/)
        note[side, fp + number_in(operand[n])] = last_name(n)
}

# The arguments that main pushes for the call at line n, the first pushed first.
function call(n, arguments,    count, names, i) {
    sp = 0
    count = split(arguments, names, "|")
    for (i = 1; i <= count; i++) push(names[i])
    push("return address of " operand[n])
}

# How many words main pushes for the call at line n.
function pushes_before(n,    count) {
    count = 0
    for (n--; opcode[n] != "jsr" && operand[n] !~ /%sp$/; n--)
        if (opcode[n] == "move.l" && operand[n] ~ /-\(%sp\)$/ || opcode[n] == "pea") count++
    return count
}

function walk(routine,    n) {
    for (n = first[routine]; opcode[n] != "unlk" && opcode[n] != "rts"; n++) step(n)
}

# Below the arguments of the last call lies what the called routine had, which is not followed.
function left_at(place) {
    return note["gnpr", place] ? note["gnpr", place] : "left by " last_called["gnpr"]
}

function word_at(place) {
    return place < base + 36 ? word[(place - base) / 4] : ""
}

FNR == NR { word[$1] = $2; next }

{ line[FNR] = $0; opcode[FNR] = $1; operand[FNR] = $2 }
/^[a-z0-9]+:/ { routine = substr($1, 1, length($1) - 1); first[routine] = FNR + 1 }
routine == "main" && $1 == "jsr" && $2 == "gnpr" { gnpr = FNR }
routine == "main" && $1 == "jsr" && $2 == "getj" && !getj { getj = FNR }

END {
    if (!gnpr || !getj) fail("no call of gnpr and getj in main")
    if (pushes_before(gnpr) != 5 || pushes_before(getj) != 2) fail("the arguments of gnpr or getj")
    side = "gnpr"
    call(gnpr, "argument out|argument kalpha, lower half|argument kalpha, upper half|" \
               "argument ka, lower half|argument ka, upper half")
    walk("gnpr")
    side = "getj"
    call(getj, "argument out|argument in")
    walk("getj")
    for (place = -4; place >= -200; place -= 4) if (note["getj", place] == "skew[0][1]") base = place - 4
    if (!base || word[0] == "") fail("skew")
    for (i = 0; i < 9; i++)
        if (!note["getj", base + 4 * i]) note["getj", base + 4 * i] = sprintf("skew[%d][%d], never set", i / 3, i % 3)
    for (place = -4; place >= base; place -= 4)
        printf "%d\t%s\t%s\t%s\n", place, left_at(place), note["getj", place], word_at(place)
}
