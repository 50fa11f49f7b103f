/*
 * adpta.c -- tolerances for the Adept AdeptOne
 *
 * After the program of T. J. Hahn, Berkeley, May 1987.  A reconstruction,
 * not the listing: see legacy/README.md.
 */

#include <stdio.h>
#include <math.h>
#include "matrix4.h"
#include "kinematic.h"
#include "kinematic2.h"
#include "adept.h"

#define NP	25		/* parameters */
#define ND	9		/* of these, distances */

/* links in the order of Eq. (4.1); 0 is the base, 5 the tool */

#define A0	0.		/* npr */
#define AL0	0.
#define D0	203.2
#define TH0	PI
#define A1	0.		/* ppr */
#define AL1	0.
#define D1	0.
#define A2	425.		/* ppr */
#define AL2	0.
#define D2	0.
#define A3	375.		/* ppr */
#define AL3	0.
#define D3	0.
#define A4	0.		/* ppp */
#define AL4	0.
#define TH4	0.
#define A5	0.		/* npr */
#define AL5	PI/2
#define D5	0.
#define TH5	PI
#define BETA	0.

float x, y, z, t;			/* what is wished */
float itheta[4], check[4];
float m0[4][4], m1[4][4], m2[4][4], m3[4][4], m4[4][4], m5[4][4];
float G0[6][4], G1[6][4], G2[6][4], G3[6][4], G4[6][5], G5[6][4];
float J0[6][6], J1[6][6], J2[6][6], J3[6][6], J4[6][6], J5[6][6];
float W1[6][6], W2[6][6], W3[6][6], W4[6][6], W5[6][6];
float B0[6][4], B1[6][4], B2[6][4], B3[6][4], B4[6][5], B5[6][4];
float A[NP][6], AT[NP][6];
float e[6], delta;
float abnd, dbnd;
float ad, dd, ag;
float rd[6], ggd[6], td[4];

/* distances before angles */
int order[NP] = {
	2, 18, 23,					/* a beside d */
	1, 5, 9, 13, 16, 22,				/* d, or a */
	0, 4, 8, 12, 17, 21,				/* theta */
	3, 6, 10, 14, 19, 24,				/* alpha */
	7, 11, 15, 20					/* beta */
};

main()
{
	FILE *fp;

	fprintf(stderr, "enter desired position: ");
	scanf("%f", &x);
	scanf("%f", &y);
	scanf("%f", &z);
	scanf("%f", &t);

	invkin(x, y, z, t, itheta);
	fprintf(stderr, "itheta[0] = %f\n", itheta[0]);
	fprintf(stderr, "itheta[1] = %f\n", itheta[1]);
	fprintf(stderr, "itheta[2] = %f\n", itheta[2]);
	fprintf(stderr, "itheta[3] = %f\n", itheta[3]);

	fwdkin(itheta, T);
	check[0] = T[0][3];
	check[1] = T[1][3];
	check[2] = T[2][3];
	check[3] = atan2(T[1][0], T[0][0]);
	fprintf(stderr, "check[0] = %f\n", check[0]);
	fprintf(stderr, "check[1] = %f\n", check[1]);
	fprintf(stderr, "check[2] = %f\n", check[2]);
	fprintf(stderr, "check[3] = %f\n", check[3]);

	mtransf(A0, AL0, D0, TH0, BETA, m0);
	mtransf(A1, AL1, D1, itheta[0], BETA, m1);
	mtransf(A2, AL2, D2, itheta[1], BETA, m2);
	mtransf(A3, AL3, D3, itheta[2], BETA, m3);
	mtransf(A4, AL4, itheta[3], TH4, BETA, m4);
	mtransf(A5, AL5, D5, TH5, BETA, m5);

	gnpr(A0, AL0, G0);
	gppr(AL1, D1, BETA, G1);
	gppr(AL2, D2, BETA, G2);
	gppr(AL3, D3, BETA, G3);
	gppp(A4, AL4, BETA, G4);
	gnpr(A5, AL5, G5);

	getj(m0, J0);
	getj(m1, J1);
	getj(m2, J2);
	getj(m3, J3);
	getj(m4, J4);
	getj(m5, J5);

	mul64(J0, G0, B0);
	mul66(J0, J1, W1);
	mul64(W1, G1, B1);
	mul66(W1, J2, W2);
	mul64(W2, G2, B2);
	mul66(W2, J3, W3);
	mul64(W3, G3, B3);
	mul66(W3, J4, W4);
	mul65(W4, G4, B4);
	mul66(W4, J5, W5);
	mul64(W5, G5, B5);

	put4(B0, A);
	put4(B1, A+4);
	put4(B2, A+8);
	put4(B3, A+12);
	put5(B4, A+16);
	put4(B5, A+21);

	fp = fopen("adpta.1", "w");
	put6(fp, A, NP);
	fclose(fp);

	sort6(A, order, NP, AT);
	fp = fopen("adptat.1", "w");
	put6(fp, AT, NP);
	fclose(fp);

	fprintf(stderr, "enter desired position and orientation tolerances: ");
	scanf("%f", &e[0]);
	scanf("%f", &e[1]);
	scanf("%f", &e[2]);
	scanf("%f", &e[3]);
	scanf("%f", &e[4]);
	scanf("%f", &e[5]);
	fprintf(stderr, "enter desired delta: ");
	scanf("%f", &delta);

	abnd = abound(AT, ND, NP, e, delta);
	dbnd = dbound(AT, 0, ND, delta);

	fp = fopen("adpttol.1", "w");
	fprintf(fp, "For the Adept AdeptOne\n\n");
	fprintf(fp, "with input:\n");
	fprintf(fp, " x = %11.6f theta[1] = %11.6f\n", x, itheta[0]);
	fprintf(fp, " y = %11.6f theta[2] = %11.6f\n", y, itheta[1]);
	fprintf(fp, " z = %11.6f theta[3] = %11.6f\n", z, itheta[2]);
	fprintf(fp, " t = %11.6f d[4] = %11.6f\n", t, itheta[3]);
	fprintf(fp, "\nA bound on the error in distance parameters = %11.6f\n", dbnd);
	fprintf(fp, "\nA bound on the error in angle parameters = %11.6f\n", abnd);
	fprintf(fp, "\nfor tolerances of:\n");
	fprintf(fp, " dx = %11.6f\n", e[0]);
	fprintf(fp, " dy = %11.6f\n", e[1]);
	fprintf(fp, " dz = %11.6f\n", e[2]);
	fprintf(fp, " dwx = %11.6f\n", e[3]);
	fprintf(fp, " dwx = %11.6f\n", e[4]);
	fprintf(fp, " dwx = %11.6f\n", e[5]);
	fprintf(fp, "\nand\n delta = %11.6f\n", delta);
	fclose(fp);

	ad = sqrt(dbnd/14.);
	dd = sqrt(dbnd/14.);
	ag = sqrt(abnd/18.);
	rd[0] = mach(A0, D0, ad, dd);
	rd[1] = mach(A1, D1, ad, dd);
	rd[2] = mach(A2, D2, ad, dd);
	rd[3] = mach(A3, D3, ad, dd);
	rd[4] = mach(A4, itheta[3], ad, dd);
	rd[5] = mach(A5, D5, ad, dd);
	ggd[0] = ag;
	ggd[1] = ag;
	ggd[2] = ag;
	ggd[3] = ag;
	ggd[4] = ag;
	ggd[5] = ag;
	td[0] = ag;
	td[1] = ag;
	td[2] = ag;
	td[3] = rd[4];

	fp = fopen("adptmach.1", "w");
	fprintf(fp, "For the Adept AdeptOne\n\n");
	fprintf(fp, "machining distance tolerances:\n");
	fprintf(fp, " rd[0] = %11.6f\n", rd[0]);
	fprintf(fp, " rd[1] = %11.6f\n", rd[1]);
	fprintf(fp, " rd[2] = %11.6f\n", rd[2]);
	fprintf(fp, " rd[3] = %11.6f\n", rd[3]);
	fprintf(fp, " rd[4] = %11.6f\n", rd[4]);
	fprintf(fp, " rd[5] = %11.6f\n", rd[5]);
	fprintf(fp, "\nmachining angle tolerances:\n");
	fprintf(fp, " ggd[0] = %11.6f\n", ggd[0]);
	fprintf(fp, " ggd[1] = %11.6f\n", ggd[1]);
	fprintf(fp, " ggd[2] = %11.6f\n", ggd[2]);
	fprintf(fp, " ggd[3] = %11.6f\n", ggd[3]);
	fprintf(fp, " ggd[4] = %11.6f\n", ggd[4]);
	fprintf(fp, " ggd[5] = %11.6f\n", ggd[5]);
	fprintf(fp, "\nmotor angle tolerances:\n");
	fprintf(fp, " td[0] = %11.6f\n", td[0]);
	fprintf(fp, " td[1] = %11.6f\n", td[1]);
	fprintf(fp, " td[2] = %11.6f\n", td[2]);
	fprintf(fp, " td[3] = %11.6f\n", td[3]);
	fclose(fp);
	exit(0);
}
