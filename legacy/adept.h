/*
 * adept.h -- kinematics of the Adept AdeptOne
 *
 * A reconstruction, not the listing of 1987: see legacy/README.md.
 */

/* lengths in mm */
#define BASE	203.2		/* base to arm */
#define INNER	425.		/* inner link */
#define OUTER	375.		/* outer link */

float T[4][4], Tb[4][4];
float L1[4][4], L2[4][4], L3[4][4], L4[4][4];
float P1[4][4], P2[4][4], P3[4][4];

/* joint values q for a tool at x, y, z turned by t */
invkin(x, y, z, t, q)
double x, y, z, t;
float q[4];
{
	float c;

	c = (INNER*INNER + OUTER*OUTER - x*x - y*y)/(2*INNER*OUTER);
	q[1] = PI - acos(c);
	q[0] = atan2(y, x) - atan2(OUTER*sin(q[1]), INNER + OUTER*cos(q[1]));
	q[2] = t - q[0] - q[1];
	q[3] = z - BASE;
}

/* transform t of the joint values q, base to tool */
fwdkin(q, t)
float q[4], t[4][4];
{
	trans4(0., 0., BASE, Tb);
	link4(0., 0., 0., q[0], L1);
	link4(INNER, 0., 0., q[1], L2);
	link4(OUTER, 0., 0., q[2], L3);
	link4(0., 0., q[3], 0., L4);
	mul4(Tb, L1, P1);
	mul4(P1, L2, P2);
	mul4(P2, L3, P3);
	mul4(P3, L4, t);
}
