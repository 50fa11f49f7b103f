/*
 * kinematic2.h -- the error model: link transforms with beta, the matrices
 * G and J of a link, products, bounds
 *
 * A reconstruction, not the listing of 1987: see legacy/README.md.
 * In an error vector (vx, vy, vz, wx, wy, wz) the v's come first.
 */

/* SKEW and SHOW are not of 1987 */
#ifndef SKEW
#define SKEW
#endif
#ifndef SHOW
#define SHOW(matrix)
#endif

/*
 * link transform, Eq. (4.2):
 * Rot(z, theta) Trans(a, 0, d) Rot(x, alpha) Rot(y, beta)
 */
mtransf(a, alpha, d, theta, beta, out)
double a, alpha, d, theta, beta;
float out[4][4];
{
	float n1, n2, n3, n4, n5, n6;

	n1 = cos(alpha);
	n2 = sin(alpha);
	n3 = cos(theta);
	n4 = sin(theta);
	n5 = cos(beta);
	n6 = sin(beta);
	out[0][0] = (double)n3*n5 - (double)n4*n2*n6;
	out[0][1] = -(double)n4*n1;
	out[0][2] = (double)n3*n6 + (double)n4*n2*n5;
	out[0][3] = a*n3;
	out[1][0] = (double)n4*n5 + (double)n3*n2*n6;
	out[1][1] = (double)n3*n1;
	out[1][2] = (double)n4*n6 - (double)n4*n2*n5;
	out[1][3] = a*n4;
	out[2][0] = -(double)n1*n6;
	out[2][1] = n2;
	out[2][2] = (double)n1*n5;
	out[2][3] = d;
	out[3][0] = 0.;
	out[3][1] = 0.;
	out[3][2] = 0.;
	out[3][3] = 1.;
}

/* G of a non-parallel revolute joint: theta, d, a, alpha */
gnpr(a, alpha, g)
double a, alpha;
float g[6][4];
{
	register int i, j;
	float n1, n2;

	for (i = 0; i < 6; i++)
		for (j = 0; j < 4; j++)
			g[i][j] = 0.;
	n1 = cos(alpha);
	n2 = sin(alpha);
	g[0][2] = 1.;
	g[1][0] = a*n1;
	g[1][1] = n2;
	g[2][0] = -a*n2;
	g[2][1] = n1;
	g[3][3] = 1.;
	g[4][0] = n2;
	g[5][0] = n1;
}

/* G of a non-parallel prismatic joint: theta, d, alpha */
gnpp(alpha, g)
double alpha;
float g[6][3];
{
	register int i, j;
	float n1, n2;

	for (i = 0; i < 6; i++)
		for (j = 0; j < 3; j++)
			g[i][j] = 0.;
	n1 = cos(alpha);
	n2 = sin(alpha);
	g[1][1] = n2;
	g[2][1] = n1;
	g[3][2] = 1.;
	g[4][0] = n2;
	g[5][0] = n1;
}

/* G of a parallel revolute joint: theta, a, alpha, beta */
gppr(alpha, d, beta, g)
double alpha, d, beta;
float g[6][4];
{
	register int i, j;
	float n1, n2, n3, n4;

	for (i = 0; i < 6; i++)
		for (j = 0; j < 4; j++)
			g[i][j] = 0.;
	n1 = cos(alpha);
	n2 = sin(alpha);
	n3 = cos(beta);
	n4 = sin(beta);
	g[0][0] = -d*n2*n4;
	g[0][1] = n3;
	g[1][0] = d*n1;
	g[2][0] = -d*n2*n3;
	g[2][1] = -n4;
	g[3][0] = (double)n1*n4;
	g[3][2] = n3;
	g[4][0] = n2;
	g[4][3] = -1.;
	g[5][0] = (double)n1*n3;
	g[5][2] = -n4;
}

/* G of a parallel prismatic joint: d, theta, a, alpha, beta */
gppp(a, alpha, beta, g)
double a, alpha, beta;
float g[6][5];
{
	register int i, j;
	float n1, n2, n3, n4;

	for (i = 0; i < 6; i++)
		for (j = 0; j < 5; j++)
			g[i][j] = 0.;
	n1 = cos(alpha);
	n2 = sin(alpha);
	n3 = cos(beta);
	n4 = sin(beta);
	g[0][0] = (double)n1*n4;
	g[0][1] = -alpha*n2*n4;
	g[0][2] = n3;
	g[1][0] = n2;
	g[1][1] = alpha*n1;
	g[2][0] = (double)n1*n3;
	g[2][1] = -alpha*n2*n3;
	g[2][2] = -n4;
	g[3][1] = (double)n1*n4;
	g[3][3] = n3;
	g[4][1] = n2;
	g[4][4] = -1.;
	g[5][1] = (double)n1*n3;
	g[5][3] = -n4;
}

/*
 * J of a transform:	R  S R
 *			0   R
 */
getj(m, out)
float m[4][4], out[6][6];
{
	SKEW float skew[3][3];
	register int i, j, n;

	skew[0][1] = -m[2][3];
	skew[0][2] = m[1][3];
	skew[1][0] = m[2][3];
	skew[1][2] = -m[0][3];
	skew[2][0] = -m[1][3];
	skew[2][1] = m[0][3];
	for (i = 0; i < 3; i++)
		for (j = 0; j < 3; j++) {
			out[i][j] = m[i][j];
			out[i+3][j] = 0.;
			out[i+3][j+3] = m[i][j];
			out[i][j+3] = 0.;
			for (n = 0; n < 3; n++)
				out[i][j+3] += (double)skew[i][n]*m[n][j];
		}
	SHOW(skew)
}

/* out = a b, 6 x 6 by 6 x 6 */
mul66(a, b, out)
float a[6][6], b[6][6], out[6][6];
{
	register int i, j, n;

	for (i = 0; i < 6; i++)
		for (j = 0; j < 6; j++) {
			out[i][j] = 0.;
			for (n = 0; n < 6; n++)
				out[i][j] += (double)a[i][n]*b[n][j];
		}
}

/* out = a b, 6 x 6 by 6 x 4 */
mul64(a, b, out)
float a[6][6], b[6][4], out[6][4];
{
	register int i, j, n;

	for (i = 0; i < 6; i++)
		for (j = 0; j < 4; j++) {
			out[i][j] = 0.;
			for (n = 0; n < 6; n++)
				out[i][j] += (double)a[i][n]*b[n][j];
		}
}

/* out = a b, 6 x 6 by 6 x 5 */
mul65(a, b, out)
float a[6][6], b[6][5], out[6][5];
{
	register int i, j, n;

	for (i = 0; i < 6; i++)
		for (j = 0; j < 5; j++) {
			out[i][j] = 0.;
			for (n = 0; n < 6; n++)
				out[i][j] += (double)a[i][n]*b[n][j];
		}
}

/* the columns of a link into A; A is kept a parameter a row */
put4(b, a)
float b[6][4], a[][6];
{
	register int i, j;

	for (j = 0; j < 4; j++)
		for (i = 0; i < 6; i++)
			a[j][i] = b[i][j];
}

put5(b, a)
float b[6][5], a[][6];
{
	register int i, j;

	for (j = 0; j < 5; j++)
		for (i = 0; i < 6; i++)
			a[j][i] = b[i][j];
}

/* parameters of A into the order of tab */
sort6(a, tab, np, out)
float a[][6], out[][6];
int tab[], np;
{
	register int i, j;

	for (j = 0; j < np; j++)
		for (i = 0; i < 6; i++)
			out[j][i] = a[tab[j]][i];
}

/* write np parameters, one a line */
put6(fp, a, np)
FILE *fp;
float a[][6];
int np;
{
	register int j;

	for (j = 0; j < np; j++)
		fprintf(fp, "%11.6f %11.6f %11.6f %11.6f %11.6f %11.6f\n",
			a[j][0], a[j][1], a[j][2], a[j][3], a[j][4], a[j][5]);
}

/* length of row i, parameters n1 to n2-1 */
double norm6(a, i, n1, n2)
float a[][6];
int i, n1, n2;
{
	register int j;
	float sum;

	sum = 0.;
	for (j = n1; j < n2; j++)
		sum += (double)a[j][i]*a[j][i];
	return(sqrt(sum));
}

/* bound on the angle errors, Eqs. (4.25) to (4.28) */
double abound(a, n1, n2, e, delta)
float a[][6], e[];
int n1, n2;
double delta;
{
	register int i;
	float norm, b, min;

	for (i = 0; i < 6; i++) {
		norm = norm6(a, i, n1, n2);
		if (i < 3)
			b = (e[i] - delta)/norm;
		else
			b = (double)e[i]/norm;
		if (i == 0 || b < min)
			min = b;
	}
	return(min);
}

/* bound on the distance errors, Eq. (4.31) */
double dbound(a, n1, n2, delta)
float a[][6];
int n1, n2;
double delta;
{
	register int i;
	float norm, b, min;

	for (i = 0; i < 3; i++) {
		norm = norm6(a, i, n1, n2);
		b = delta/norm;
		if (i == 0 || b < min)
			min = b;
	}
	return(min);
}

/* machining tolerance of a link, Eq. (4.32) */
double mach(a, d, ad, dd)
double a, d, ad, dd;
{
	float h;

	h = sqrt(a*a + d*d);
	return(-h + sqrt((double)h*h + 2*a*ad + 2*d*dd + ad*ad + dd*dd));
}
