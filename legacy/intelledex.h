/*
 * intelledex.h -- kinematics of the Intelledex 605T
 *
 * A reconstruction, not the listing of 1987: see legacy/README.md.
 */

/* lengths in mm */
#define BASE	359.7		/* base to shoulder */
#define UARM	373.4		/* upper arm */
#define FARM	279.4		/* forearm */
#define TOOL	100.		/* wrist to tool */

#define CLOSE	0.		/* where an angle has two solutions */

float T[4][4], Tb[4][4], Tbi[4][4];
float T06[4][4], T60[4][4], T05[4][4];
float L1[4][4], L2[4][4], L3[4][4], L4[4][4], L5[4][4], L6[4][4], L6i[4][4];
float P1[4][4], P2[4][4], P3[4][4], P4[4][4], P5[4][4];

/* joint values q for the transform t, base to tool */
invkin(t, q)
float t[4][4], q[6];
{
	float q345, q34, px, py, qx, qy;

	trans4(0., 0., BASE, Tb);
	inv4(Tb, Tbi);
	mul4(Tbi, t, T06);
	inv4(T06, T60);
	q[5] = solve(T60[1][3], T60[0][3], 0., CLOSE);

	link4(0., PI/2, TOOL, q[5], L6);
	inv4(L6, L6i);
	mul4(T06, L6i, T05);
	q[0] = solve(T05[1][2], -T05[0][2], 0., CLOSE);
	q[1] = atan2(cos(q[0])*T05[0][2] + sin(q[0])*T05[1][2], T05[2][2]);

	q345 = atan2(-sin(q[0])*T05[0][0] + cos(q[0])*T05[1][0],
		cos(q[0])*cos(q[1])*T05[0][0] + sin(q[0])*cos(q[1])*T05[1][0]
		- sin(q[1])*T05[2][0]);

	/* the wrist, in the plane of links 3 and 4 */
	px = cos(q[0])*cos(q[1])*T06[0][3] + sin(q[0])*cos(q[1])*T06[1][3]
		- sin(q[1])*T06[2][3] - TOOL*sin(q345);
	py = -sin(q[0])*T06[0][3] + cos(q[0])*T06[1][3] + TOOL*cos(q345);

	/* the shoulder, seen from frame 5 */
	qx = -(cos(q345)*px + sin(q345)*py);
	qy = sin(q345)*px - cos(q345)*py;
	q[4] = solve(qx, -qy,
		(UARM*UARM - FARM*FARM - (double)qx*qx - (double)qy*qy)/(2*FARM), CLOSE);

	q34 = (double)q345 - q[4];
	q[2] = atan2(py - FARM*sin(q34), px - FARM*cos(q34));
	q[3] = (double)q345 - q[2] - q[4];
}

/* transform t of the joint values q, base to tool */
fwdkin(q, t)
float q[6], t[4][4];
{
	trans4(0., 0., BASE, Tb);
	link4(0., 0., 0., q[0], L1);
	link4(0., -PI/2, 0., q[1], L2);
	link4(0., PI/2, 0., q[2], L3);
	link4(UARM, 0., 0., q[3], L4);
	link4(FARM, 0., 0., q[4], L5);
	link4(0., PI/2, TOOL, q[5], L6);
	mul4(Tb, L1, P1);
	mul4(P1, L2, P2);
	mul4(P2, L3, P3);
	mul4(P3, L4, P4);
	mul4(P4, L5, P5);
	mul4(P5, L6, t);
}
