/* Exercise 10: the Adept's A for case 1 by differences. Compile with: cc -std=c99 -o mine 10.c -lm; run: ./mine 1e-3 */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

enum { LINKS = 6, PARAMETERS = 25 };
enum { THETA, A, D, ALPHA, BETA };

/* theta, a, d, alpha, beta of each link, lengths in mm; set_joints has the thetas of links 1 to 3 */
static double arm[LINKS][5] = {
    {0, 0, 203.2, 0, 0}, {0, 425, 0, 0, 0},    {0, 375, 0, 0, 0},
    {0, 0, 0, 0, 0},     {0, 0, -203.2, 0, 0}, {0, 0, 0, 0, 0},
};

/* The joint values that put the tool at (200, 200, 0), all digits of them */
static void set_joints(void)
{
    const double x = 200, y = 200, inner = arm[1][A], outer = arm[2][A];
    const double elbow = acos((x * x + y * y - inner * inner - outer * outer) / (2 * inner * outer));
    arm[1][THETA] = atan2(y, x) - atan2(outer * sin(elbow), inner + outer * cos(elbow));
    arm[2][THETA] = elbow;
    arm[3][THETA] = -arm[1][THETA] - elbow;
}

/* The parameters in the order of adpta.1: link, and which of its five */
static const int parameter[PARAMETERS][2] = {
    {0, THETA}, {0, D}, {0, A}, {0, ALPHA},
    {1, THETA}, {1, A}, {1, ALPHA}, {1, BETA},
    {2, THETA}, {2, A}, {2, ALPHA}, {2, BETA},
    {3, THETA}, {3, A}, {3, ALPHA}, {3, BETA},
    {4, D}, {4, THETA}, {4, A}, {4, ALPHA}, {4, BETA},
    {5, THETA}, {5, D}, {5, A}, {5, ALPHA},
};

static void multiply(double x[4][4], double y[4][4], double product[4][4])
{
    for (int i = 0; i < 4; i++) {
        for (int j = 0; j < 4; j++) {
            product[i][j] = 0;
            for (int n = 0; n < 4; n++) {
                product[i][j] += x[i][n] * y[n][j];
            }
        }
    }
}

/* The link of Eq. (4.1): Rot(z, theta) Trans(a, 0, d) Rot(x, alpha) Rot(y, beta) */
static void link_of(const double p[5], double t[4][4])
{
    const double ct = cos(p[THETA]), st = sin(p[THETA]), ca = cos(p[ALPHA]), sa = sin(p[ALPHA]);
    const double cb = cos(p[BETA]), sb = sin(p[BETA]);
    double turn[4][4] = {{ct, -st, 0, p[A] * ct}, {st, ct, 0, p[A] * st}, {0, 0, 1, p[D]}, {0, 0, 0, 1}};
    double tilt[4][4] = {{cb, 0, sb, 0}, {sa * sb, ca, -sa * cb, 0}, {-ca * sb, sa, ca * cb, 0}, {0, 0, 0, 1}};
    multiply(turn, tilt, t);
}

/* The tool of the arm whose parameter k is off by so much: columns 0 to 2 the rotation, 3 the place */
static void tool(int k, double off, double t[4][4])
{
    double product[4][4] = {{1, 0, 0, 0}, {0, 1, 0, 0}, {0, 0, 1, 0}, {0, 0, 0, 1}};
    for (int i = 0; i < LINKS; i++) {
        double p[5], next[4][4];
        for (int j = 0; j < 5; j++) {
            p[j] = arm[i][j] + (i == parameter[k][0] && j == parameter[k][1] ? off : 0);
        }
        link_of(p, next);
        multiply(product, next, t);
        for (int j = 0; j < 16; j++) {
            product[j / 4][j % 4] = t[j / 4][j % 4];
        }
    }
}

/* Column k of A: how far the tool moves along x, y, z and turns about x, y, z when parameter k is off by 1 */
static void column_of(int k, double step, double column[6])
{
    /* begin: yours */
    double here[4][4];
    tool(k, 0 * step, here);
    for (int i = 0; i < 6; i++) {
        column[i] = 0 * here[0][0];
    }
    /* end: yours */
}

int main(int argc, char *argv[])
{
    const double step = argc > 1 ? atof(argv[1]) : 1e-3;
    set_joints();
    for (int k = 0; k < PARAMETERS; k++) {
        double column[6];
        column_of(k, step, column);
        for (int i = 0; i < 6; i++) {
            printf("%11.6f%s", column[i], i < 5 ? " " : "\n");
        }
    }
    return 0;
}
