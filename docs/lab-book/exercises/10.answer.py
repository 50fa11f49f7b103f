    more, less, now = (tool(link, which, off) for off in (step, -step, 0))
    moved = [[(more[i][j] - less[i][j]) / (2 * step) for j in range(4)] for i in range(3)]
    turned = [[sum(moved[i][n] * now[j][n] for n in range(3)) for j in range(3)] for i in range(3)]
    return [moved[0][3], moved[1][3], moved[2][3], (turned[2][1] - turned[1][2]) / 2,
            (turned[0][2] - turned[2][0]) / 2, (turned[1][0] - turned[0][1]) / 2]
