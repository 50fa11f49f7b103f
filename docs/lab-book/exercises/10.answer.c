    double more[4][4], less[4][4], now[4][4], turned[3][3];
    tool(k, step, more);
    tool(k, -step, less);
    tool(k, 0, now);
    for (int i = 0; i < 3; i++) {
        column[i] = (more[i][3] - less[i][3]) / (2 * step);
        for (int j = 0; j < 3; j++) {
            turned[i][j] = 0;
            for (int n = 0; n < 3; n++) {
                turned[i][j] += (more[i][n] - less[i][n]) / (2 * step) * now[j][n];
            }
        }
    }
    column[3] = (turned[2][1] - turned[1][2]) / 2;
    column[4] = (turned[0][2] - turned[2][0]) / 2;
    column[5] = (turned[1][0] - turned[0][1]) / 2;
