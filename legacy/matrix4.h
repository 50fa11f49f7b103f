/*
 * matrix4.h -- 4 x 4 homogeneous transforms
 *
 * A reconstruction, not the listing of 1987: see legacy/README.md.
 */

/* out = a b */
mul4(a, b, out)
float a[4][4], b[4][4], out[4][4];
{
	register int i, j, n;

	for (i = 0; i < 4; i++)
		for (j = 0; j < 4; j++) {
			out[i][j] = 0.;
			for (n = 0; n < 4; n++)
				out[i][j] += (double)a[i][n]*b[n][j];
		}
}

/* out = inverse of the transform m */
inv4(m, out)
float m[4][4], out[4][4];
{
	register int i, j;

	for (i = 0; i < 3; i++) {
		for (j = 0; j < 3; j++)
			out[i][j] = m[j][i];
		out[i][3] = 0.;
		for (j = 0; j < 3; j++)
			out[i][3] += -(double)m[j][i]*m[j][3];
	}
	out[3][0] = 0.;
	out[3][1] = 0.;
	out[3][2] = 0.;
	out[3][3] = 1.;
}

/* out = Trans(x, y, z) */
trans4(x, y, z, out)
double x, y, z;
float out[4][4];
{
	register int i, j;

	for (i = 0; i < 4; i++)
		for (j = 0; j < 4; j++)
			out[i][j] = 0.;
	out[0][0] = 1.;
	out[1][1] = 1.;
	out[2][2] = 1.;
	out[3][3] = 1.;
	out[0][3] = x;
	out[1][3] = y;
	out[2][3] = z;
}

/* out = Trans(x, y, z) Rot(z, a) Rot(y, b) Rot(x, g) */
zyx4(x, y, z, g, b, a, out)
double x, y, z, g, b, a;
float out[4][4];
{
	out[0][0] = cos(a)*cos(b);
	out[0][1] = cos(a)*sin(b)*sin(g) - sin(a)*cos(g);
	out[0][2] = cos(a)*sin(b)*cos(g) + sin(a)*sin(g);
	out[0][3] = x;
	out[1][0] = sin(a)*cos(b);
	out[1][1] = sin(a)*sin(b)*sin(g) + cos(a)*cos(g);
	out[1][2] = sin(a)*sin(b)*cos(g) - cos(a)*sin(g);
	out[1][3] = y;
	out[2][0] = -sin(b);
	out[2][1] = cos(b)*sin(g);
	out[2][2] = cos(b)*cos(g);
	out[2][3] = z;
	out[3][0] = 0.;
	out[3][1] = 0.;
	out[3][2] = 0.;
	out[3][3] = 1.;
}
