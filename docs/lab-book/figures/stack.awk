# The stack of the Adept's program: the frame of the last gnpr, and that of the first getj over it.
# data: docs/lab-book/tools/lay-frames

BEGIN {
    FS = "\t"
    svg(820, 470, "The frame of gnpr and the frame of getj on the same piece of the stack", \
        "Two columns of words of four bytes, at the same places below S, the stack pointer of main. Left what " \
        "gnpr has left behind, right what getj has there. skew[2][2] lies on the upper half of the argument ka, " \
        "which is 0. skew[1][1] lies on the local variable n2, the sine of alpha, which is 1. skew[0][0] lies " \
        "on the upper half of alpha as it was passed to sin.")
    HEIGHT = 24
    FIRST = 76
    label(205, 28, "middle", "f0 strong", "gnpr(ka, kalpha, out)")
    label(205, 46, "middle", "small fm", "for the tool: the last call before getj")
    label(675, 28, "middle", "f0 strong", "getj(in, out)")
    label(675, 46, "middle", "small fm", "for the base: the next call")
    label(420, 46, "middle", "small fm", "word left there")
}

/^#/ { next }

{
    y = FIRST + HEIGHT * rows++
    diagonal = $4 ~ /skew\[0\]\[0\]|skew\[1\]\[1\]|skew\[2\]\[2\]/
    if (diagonal) {
        box(70, y, 270, HEIGHT, "fb")
        box(540, y, 270, HEIGHT, "fb")
        found++
    }
    box(70, y, 270, HEIGHT, "sm")
    box(540, y, 270, HEIGHT, "sm")
    label(60, y + 16, "end", "small fm", "S - " $1)
    label(205, y + 16, "middle", diagonal ? "f0 strong" : "f0", $2)
    label(675, y + 16, "middle", diagonal ? "f0 strong" : "f0", diagonal ? $4 ", never set" : $4)
    if (diagonal) {
        arrow(345, y + HEIGHT / 2, 375, y + HEIGHT / 2, "s2 w2", 2)
        label(420, y + 16, "middle", "f2 strong", $3)
        arrow(465, y + HEIGHT / 2, 532, y + HEIGHT / 2, "s2 w2", 2)
    } else if ($3 != "") label(420, y + 16, "middle", "small fm", $3)
}

END {
    if (failed) exit 1
    if (found != 3) fail("the diagonal is not in these frames")
    y = FIRST + HEIGHT * rows
    label(420, y + 22, "middle", "small fm", "the stack grows down; words without a value are addresses or counters")
    arrow(12, FIRST + HEIGHT * rows - 60, 12, FIRST + HEIGHT * rows + 16, "sm", "m")
    finish()
}
