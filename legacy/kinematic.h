/*
 * kinematic.h -- what the kinematics of both arms need
 *
 * A reconstruction, not the listing of 1987: see legacy/README.md.
 */

#define PI 3.14159

/*
 * link transform in Craig's order:
 * Rot(x, alpha) Trans(a, 0, 0) Rot(z, theta) Trans(0, 0, d)
 */
link4(a, alpha, d, theta, out)
double a, alpha, d, theta;
float out[4][4];
{
	float al;

	al = alpha;
	out[0][0] = cos(theta);
	out[0][1] = -sin(theta);
	out[0][2] = 0.;
	out[0][3] = a;
	out[1][0] = sin(theta)*cos(al);
	out[1][1] = cos(theta)*cos(al);
	out[1][2] = -sin(al);
	out[1][3] = -sin(al)*d;
	out[2][0] = sin(theta)*sin(al);
	out[2][1] = cos(theta)*sin(al);
	out[2][2] = cos(al);
	out[2][3] = cos(al)*d;
	out[3][0] = 0.;
	out[3][1] = 0.;
	out[3][2] = 0.;
	out[3][3] = 1.;
}

/*
 * the theta with  px cos(theta) + py sin(theta) = d,
 * of the two the one closer to close
 */
double solve(px, py, d, close)
double px, py, d, close;
{
	float s, t1, t2;

	if (d == 0.)
		return(atan2(px, -py));
	s = sqrt(py*py + px*px - d*d);
	t1 = atan2(px, -py) - atan2(d, s);
	t2 = atan2(px, -py) - atan2(d, -s);
	if (fabs(t1 - close) <= fabs(t2 - close))
		return(t1);
	return(t2);
}
