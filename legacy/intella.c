/*
 * intella.c -- tolerances for the Intelledex 605T
 *
 * After the program of T. J. Hahn, Berkeley, May 1987.  A reconstruction,
 * not the listing: see legacy/README.md.
 */

#include <stdio.h>
#include <math.h>
#include "matrix4.h"
#include "kinematic.h"
#include "kinematic2.h"
#include "intelledex.h"

#define NP	32		/* parameters */
#define ND	14		/* of these, distances */

/* links in the order of Eq. (4.1); 0 is the base, 7 the tool */

#define A0	0.		/* npr */
#define AL0	0.
#define D0	359.7
#define TH0	0.
#define A1	0.		/* npr */
#define AL1	-PI/2
#define D1	0.
#define A2	0.		/* npr */
#define AL2	PI/2
#define D2	0.
#define A3	373.4		/* ppr */
#define AL3	0.
#define D3	0.
#define A4	279.4		/* ppr */
#define AL4	0.
#define D4	0.
#define A5	0.		/* npr */
#define AL5	PI/2
#define D5	0.
#define A6	0.		/* npr */
#define AL6	0.
#define D6	0.
#define A7	0.		/* npr */
#define AL7	0.
#define D7	100.
#define TH7	PI/2
#define BETA	0.

float x, y, z, g, b, a;			/* what is wished */
float itheta[6], check[6];
float m0[4][4], m1[4][4], m2[4][4], m3[4][4];
float m4[4][4], m5[4][4], m6[4][4], m7[4][4];
float G0[6][4], G1[6][4], G2[6][4], G3[6][4];
float G4[6][4], G5[6][4], G6[6][4], G7[6][4];
float J0[6][6], J1[6][6], J2[6][6], J3[6][6];
float J4[6][6], J5[6][6], J6[6][6], J7[6][6];
float W1[6][6], W2[6][6], W3[6][6], W4[6][6], W5[6][6], W6[6][6], W7[6][6];
float B0[6][4], B1[6][4], B2[6][4], B3[6][4];
float B4[6][4], B5[6][4], B6[6][4], B7[6][4];
float A[NP][6], AT[NP][6];
float e[6], delta;
float abnd, dbnd;
float ad, dd, ag;
float rd[8], ggd[8], td[6];

/* distances before angles */
int order[NP] = {
	2, 6, 10, 22, 26, 30,				/* a beside d */
	1, 5, 9, 13, 17, 21, 25, 29,			/* d, or a */
	0, 4, 8, 12, 16, 20, 24, 28,			/* theta */
	3, 7, 11, 14, 18, 23, 27, 31,			/* alpha */
	15, 19						/* beta */
};

main()
{
	FILE *fp;

	fprintf(stderr, "enter desired position: ");
	scanf("%f", &x);
	scanf("%f", &y);
	scanf("%f", &z);
	scanf("%f", &g);
	scanf("%f", &b);
	scanf("%f", &a);

	zyx4(x, y, z, g, b, a, T);
	invkin(T, itheta);
	fprintf(stderr, "itheta[0] = %f\n", itheta[0]);
	fprintf(stderr, "itheta[1] = %f\n", itheta[1]);
	fprintf(stderr, "itheta[2] = %f\n", itheta[2]);
	fprintf(stderr, "itheta[3] = %f\n", itheta[3]);
	fprintf(stderr, "itheta[4] = %f\n", itheta[4]);
	fprintf(stderr, "itheta[5] = %f\n", itheta[5]);

	fwdkin(itheta, T);
	check[0] = T[0][3];
	check[1] = T[1][3];
	check[2] = T[2][3];
	check[3] = atan2(T[2][1], T[2][2]);
	check[4] = atan2(-T[2][0], sqrt((double)T[0][0]*T[0][0] + (double)T[1][0]*T[1][0]));
	check[5] = atan2(T[1][0], T[0][0]);
	fprintf(stderr, "check[0] = %f\n", check[0]);
	fprintf(stderr, "check[1] = %f\n", check[1]);
	fprintf(stderr, "check[2] = %f\n", check[2]);
	fprintf(stderr, "check[3] = %f\n", check[3]);
	fprintf(stderr, "check[4] = %f\n", check[4]);
	fprintf(stderr, "check[5] = %f\n", check[5]);

	mtransf(A0, AL0, D0, TH0, BETA, m0);
	mtransf(A1, AL1, D1, itheta[0], BETA, m1);
	mtransf(A2, AL2, D2, itheta[1], BETA, m2);
	mtransf(A3, AL3, D3, itheta[2], BETA, m3);
	mtransf(A4, AL4, D4, itheta[3], BETA, m4);
	mtransf(A5, AL5, D5, itheta[4], BETA, m5);
	mtransf(A6, AL6, D6, itheta[5], BETA, m6);
	mtransf(A7, AL7, D7, TH7, BETA, m7);

	gnpr(A0, AL0, G0);
	gnpr(A1, AL1, G1);
	gnpr(A2, AL2, G2);
	gppr(AL3, D3, BETA, G3);
	gppr(AL4, D4, BETA, G4);
	gnpr(A5, AL5, G5);
	gnpr(A6, AL6, G6);
	gnpr(A7, AL7, G7);

	getj(m0, J0);
	getj(m1, J1);
	getj(m2, J2);
	getj(m3, J3);
	getj(m4, J4);
	getj(m5, J5);
	getj(m6, J6);
	getj(m7, J7);

	mul64(J0, G0, B0);
	mul66(J0, J1, W1);
	mul64(W1, G1, B1);
	mul66(W1, J2, W2);
	mul64(W2, G2, B2);
	mul66(W2, J3, W3);
	mul64(W3, G3, B3);
	mul66(W3, J4, W4);
	mul64(W4, G4, B4);
	mul66(W4, J5, W5);
	mul64(W5, G5, B5);
	mul66(W5, J6, W6);
	mul64(W6, G6, B6);
	mul66(W6, J7, W7);
	mul64(W7, G7, B7);

	put4(B0, A);
	put4(B1, A+4);
	put4(B2, A+8);
	put4(B3, A+12);
	put4(B4, A+16);
	put4(B5, A+20);
	put4(B6, A+24);
	put4(B7, A+28);

	fp = fopen("inta.1", "w");
	put6(fp, A, NP);
	fclose(fp);

	sort6(A, order, NP, AT);
	fp = fopen("intat.1", "w");
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

	fp = fopen("inttol.1", "w");
	fprintf(fp, "For the Intelledex 605T\n\n");
	fprintf(fp, "with input:\n");
	fprintf(fp, " x = %11.6f theta[1] = %11.6f\n", x, itheta[0]);
	fprintf(fp, " y = %11.6f theta[2] = %11.6f\n", y, itheta[1]);
	fprintf(fp, " z = %11.6f theta[3] = %11.6f\n", z, itheta[2]);
	fprintf(fp, " g = %11.6f theta[4] = %11.6f\n", g, itheta[3]);
	fprintf(fp, " b = %11.6f theta[5] = %11.6f\n", b, itheta[4]);
	fprintf(fp, " a = %11.6f theta[6] = %11.6f\n", a, itheta[5]);
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
	rd[4] = mach(A4, D4, ad, dd);
	rd[5] = mach(A5, D5, ad, dd);
	rd[6] = mach(A6, D6, ad, dd);
	rd[7] = mach(A7, D7, ad, dd);
	ggd[0] = ag;
	ggd[1] = ag;
	ggd[2] = ag;
	ggd[3] = ag;
	ggd[4] = ag;
	ggd[5] = ag;
	ggd[6] = ag;
	ggd[7] = ag;
	td[0] = ag;
	td[1] = ag;
	td[2] = ag;
	td[3] = ag;
	td[4] = ag;
	td[5] = ag;

	fp = fopen("intmach.1", "w");
	fprintf(fp, "For the Intelledex 605T\n\n");
	fprintf(fp, "machining distance tolerances:\n");
	fprintf(fp, " rd[0] = %11.6f\n", rd[0]);
	fprintf(fp, " rd[1] = %11.6f\n", rd[1]);
	fprintf(fp, " rd[2] = %11.6f\n", rd[2]);
	fprintf(fp, " rd[3] = %11.6f\n", rd[3]);
	fprintf(fp, " rd[4] = %11.6f\n", rd[4]);
	fprintf(fp, " rd[5] = %11.6f\n", rd[5]);
	fprintf(fp, " rd[6] = %11.6f\n", rd[6]);
	fprintf(fp, " rd[7] = %11.6f\n", rd[7]);
	fprintf(fp, "\nmachining angle tolerances:\n");
	fprintf(fp, " ggd[0] = %11.6f\n", ggd[0]);
	fprintf(fp, " ggd[1] = %11.6f\n", ggd[1]);
	fprintf(fp, " ggd[2] = %11.6f\n", ggd[2]);
	fprintf(fp, " ggd[3] = %11.6f\n", ggd[3]);
	fprintf(fp, " ggd[4] = %11.6f\n", ggd[4]);
	fprintf(fp, " ggd[5] = %11.6f\n", ggd[5]);
	fprintf(fp, " ggd[6] = %11.6f\n", ggd[6]);
	fprintf(fp, " ggd[7] = %11.6f\n", ggd[7]);
	fprintf(fp, "\nmotor angle tolerances:\n");
	fprintf(fp, " td[0] = %11.6f\n", td[0]);
	fprintf(fp, " td[1] = %11.6f\n", td[1]);
	fprintf(fp, " td[2] = %11.6f\n", td[2]);
	fprintf(fp, " td[3] = %11.6f\n", td[3]);
	fprintf(fp, " td[4] = %11.6f\n", td[4]);
	fprintf(fp, " td[5] = %11.6f\n", td[5]);
	fclose(fp);
	exit(0);
}
