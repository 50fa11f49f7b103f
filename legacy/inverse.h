/*
 * inverse.h -- the inverse kinematics of both arms
 *
 * [ours inverse] Not of the listing, which calls these two routines and does not print them: the names and the
 * arguments are those of the calls, all else is a guess that gives the 20 joint values of the report's section 5.2 to
 * the last digit. README.md says more.
 */

/* lengths in mm: the listing's constants of both arms under names of our own */
#define ADEPT_BASE (203.2)
#define ADEPT_INNER (425.)
#define ADEPT_OUTER (375.)
#define INTELL_BASE (359.7)
#define INTELL_UPPER (373.4)
#define INTELL_FORE (279.4)
#define INTELL_TOOL (100.)

/* itheta = three angles and a length for a tool at x[0], x[1], x[2] turned by x[3]; tclose is not asked */
invadept(x,tclose,itheta)
float x[4],
	tclose[4],
	itheta[4];
{
	float c;

	c = (ADEPT_INNER*ADEPT_INNER + ADEPT_OUTER*ADEPT_OUTER - (double)x[0]*x[0] - (double)x[1]*x[1])
		/(2*ADEPT_INNER*ADEPT_OUTER);
	itheta[1] = PI - acos(c);
	itheta[0] = atan2(x[1],x[0]) - atan2(ADEPT_OUTER*sin(itheta[1]),ADEPT_INNER + ADEPT_OUTER*cos(itheta[1]));
	itheta[2] = (double)x[3] - itheta[0] - itheta[1];
	itheta[3] = x[2] - ADEPT_BASE;
}

/* itheta = six angles for a tool at x[0], x[1], x[2] with the Euler angles x[3], x[4], x[5] of eulerzyx */
invintell(x,tclose,itheta)
float x[6],
	tclose[6],
	itheta[6];
{
	float t[4][4],
		base[4][4],
		ibase[4][4],
		t06[4][4],
		t60[4][4],
		t56[4][4],
		t65[4][4],
		t05[4][4],
		zero[6],
		alpha,
		q345,
		q34,
		px,
		py,
		qx,
		qy;
	int i;

	for(i=0;i<6;i++) zero[i] = 0.;
	zero[2] = INTELL_BASE;
	eulerzyx(zero,base);
	invtrf(base,ibase);
	eulerzyx(x,t);
	mpynn(ibase,t,t06);
	invtrf(t06,t60);
	solve(t60[1][3],t60[0][3],0.,tclose[5],&itheta[5]);

	/* the last link, divided out: its angle is PI/2, which is short */
	alpha = PI/2;
	transf(0.,alpha,INTELL_TOOL,itheta[5],t56);
	invtrf(t56,t65);
	mpynn(t06,t65,t05);
	solve(t05[1][2],-t05[0][2],0.,tclose[0],&itheta[0]);
	itheta[1] = atan2(cos(itheta[0])*t05[0][2] + sin(itheta[0])*t05[1][2],t05[2][2]);

	/* the sum of the three parallel joints */
	q345 = atan2(-sin(itheta[0])*t05[0][0] + cos(itheta[0])*t05[1][0],
		cos(itheta[0])*cos(itheta[1])*t05[0][0] + sin(itheta[0])*cos(itheta[1])*t05[1][0]
		- sin(itheta[1])*t05[2][0]);

	/* the wrist, in the plane of links 3 and 4 */
	px = cos(itheta[0])*cos(itheta[1])*t06[0][3] + sin(itheta[0])*cos(itheta[1])*t06[1][3]
		- sin(itheta[1])*t06[2][3] - INTELL_TOOL*sin(q345);
	py = -sin(itheta[0])*t06[0][3] + cos(itheta[0])*t06[1][3] + INTELL_TOOL*cos(q345);

	/* the shoulder, seen from frame 5 */
	qx = -(cos(q345)*px + sin(q345)*py);
	qy = sin(q345)*px - cos(q345)*py;
	solve(qx,-qy,(INTELL_UPPER*INTELL_UPPER - INTELL_FORE*INTELL_FORE - (double)qx*qx - (double)qy*qy)
		/(2*INTELL_FORE),tclose[4],&itheta[4]);

	q34 = q345 - itheta[4];
	itheta[2] = atan2(py - INTELL_FORE*sin(q34),px - INTELL_FORE*cos(q34));
	itheta[3] = (double)q345 - itheta[2] - itheta[4];
}
