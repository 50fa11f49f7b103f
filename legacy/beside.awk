# Prints two of the tables of legacy/frames beside each other, and what a third, of another layout, has otherwise than
# the first. Its exit status is 1 where in the third the words that getj never sets lie on others than in the first:
# what is said of them then no longer holds.

function short(text) {
    sub(/argument /, "arg. ", text)
    sub(/, lower half/, " low", text)
    sub(/, upper half/, " high", text)
    sub(/, as passed to/, " for", text)
    sub(/, never set/, " *", text)
    sub(/return address of/, "return of", text)
    sub(/saved frame pointer/, "frame pointer", text)
    sub(/saved register/, "register", text)
    return text
}

function side(table, place) {
    return sprintf("%-19s | %-14s | %-8s", left[table, place], has[table, place], word[table, place])
}

BEGIN { FS = "\t" }

FNR == 1 { table++ }

{
    left[table, $1] = short($2)
    has[table, $1] = short($3)
    word[table, $1] = $4
    if (table < 3 && $1 < lowest) lowest = $1
}

function row(place, text) {
    sub(/[ |]+$/, "", text)
    printf "  S - %-3d| %s\n", -place, text
}

END {
    printf "  %-7s| %-47s || %s\n", "", "gcc -O0, as declared here (double, register)",
        "gcc -O0, declared as printed (float, int)"
    for (place = -4; place >= lowest; place -= 4)
        row(place, side(1, place) " || " side(2, place))
    print ""
    print "Worked out from the declarations, not run: a compiler like pcc, which has the locals in the order in which"
    print "they are declared and passes floats as doubles, has in the same places the same, but for these:"
    print ""
    for (place = -4; place >= lowest; place -= 4) {
        if (!((3, place) in left)) continue
        if (left[3, place] != left[1, place] || has[3, place] != has[1, place]) {
            row(place, side(3, place))
            if ((has[3, place] has[1, place]) ~ /\*/) moved = 1
        } else if (has[3, place] ~ /\*/) {
            name = has[3, place]
            sub(/ .*/, "", name)
            diagonal = diagonal (words++ ? ", " : "") name " on " left[3, place]
        }
    }
    if (moved || words != 3) {
        print "beside: the unset words do not lie where gcc has them" > "/dev/stderr"
        exit 1
    }
    print ""
    print "So the diagonal lies on the same three words: " diagonal "."
}
