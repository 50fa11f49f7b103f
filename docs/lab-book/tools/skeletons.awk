# Reads an arm's table, as armtol --show prints it, and prints the frames behind its links: see skeletons. joints has
# the joint values, asked where the tool is to be.

function row(name,    j, text) {
    text = arm "\t" position "\t" name
    for (j = 0; j < 3; j++) text = text sprintf("\t%.4f", t[j, 3])
    for (j = 0; j < 3; j++) text = text sprintf("\t%.6f", t[j, 0])
    for (j = 0; j < 3; j++) text = text sprintf("\t%.6f", t[j, 2])
    gsub(/-0\.0+\t/, "0.000000\t", text)
    print text
}

# t times the link of Eq. (4.1), beta 0: each row of t in turn
function place(a, alpha, d, theta,    i, x, y, z) {
    for (i = 0; i < 3; i++) {
        x = t[i, 0] * cos(theta) + t[i, 1] * sin(theta)
        y = -t[i, 0] * sin(theta) + t[i, 1] * cos(theta)
        z = t[i, 2]
        t[i, 0] = x
        t[i, 1] = y * cos(alpha) + z * sin(alpha)
        t[i, 2] = -y * sin(alpha) + z * cos(alpha)
        t[i, 3] += a * x + d * z
    }
}

BEGIN {
    FS = " *, *"
    split(joints, joint, " ")
    for (i = 0; i < 3; i++) t[i, i] = 1
    row("w")
}

/^(npr|npp|ppr|ppp),/ {
    if (links) row(links - 1)
    links++
    value = $2 == "fixed" ? 0 : joint[++joints_used]
    place($3, $4, $5 + ($2 == "d" ? value : 0), $6 + ($2 == "theta" ? value : 0))
}

# The last row is the tool's: its frame has a letter.
END {
    row("t")
    split(asked, target, " ")
    for (i = 0; i < 3; i++)
        if ((t[i, 3] - target[i + 1]) ^ 2 > 0.01 ^ 2) {
            printf "skeletons: %s: the tool is off: %s, not %s\n", arm, t[i, 3], target[i + 1] > "/dev/stderr"
            exit 1
        }
}
