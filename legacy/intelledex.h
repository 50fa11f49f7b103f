/*
 * intelledex.h -- forward kinematics of the Intelledex 605T in Craig's order, for the check in the dialogue
 *
 * The listing's routine under its name; the comments are ours: see README.md.
 */

#include <stdio.h>

#include <math.h>

#include "kinematic.h"

#define PI (3.14159)
#define A0 (0.)
#define A1 (0.)
#define A2 (0.)
#define A3 (373.4)
#define A4 (279.4)
#define A5 (0.)
#define ALPHA0 (0.)
#define ALPHA1 (-PI/2.)
#define ALPHA2 (PI/2.)
#define ALPHA3 (0.)
#define ALPHA4 (0.)
#define ALPHA5 (PI/2.)
#define D0 (359.7)
#define D1 (0.)
#define D2 (0.)
#define D3 (0.)
#define D4 (0.)
#define D5 (0.)
#define D6 (100.)

/* [printed] tw6 = the transform, base to tool, of six angles */
intelledex(itheta,tw6)
float itheta[6],
	tw6[4][4];
{
	float a[6],
		alpha[6],
		d[6],
		tw0[4][4],
		t01[4][4],
		t12[4][4],
		t23[4][4],
		t34[4][4],
		t45[4][4],
		t56[4][4],
		tw1[4][4],
		tw2[4][4],
		tw3[4][4],
		tw4[4][4],
		tw5[4][4];

	int i,
		j;

	a[0] = A0;
	a[1] = A1;
	a[2] = A2;
	a[3] = A3;
	a[4] = A4;
	a[5] = A5;
	alpha[0] = ALPHA0;
	alpha[1] = ALPHA1;
	alpha[2] = ALPHA2;
	alpha[3] = ALPHA3;
	alpha[4] = ALPHA4;
	alpha[5] = ALPHA5;
	d[0] = D1;
	d[1] = D2;
	d[2] = D3;
	d[3] = D4;
	d[4] = D5;
	d[5] = D6;

	for(i=0;i<4;i++){
		for(j=0;j<4;j++){
			tw0[i][j] = 0.;
		}
		tw0[i][i] = 1.;
	}
	tw0[2][3] = D0;
	transf(a[0],alpha[0],d[0],itheta[0],t01);
	transf(a[1],alpha[1],d[1],itheta[1],t12);
	transf(a[2],alpha[2],d[2],itheta[2],t23);
	transf(a[3],alpha[3],-d[3],itheta[3],t34);	/* [reading minus] here and below */
	transf(a[4],alpha[4],-d[4],itheta[4],t45);
	transf(a[5],alpha[5],d[5],itheta[5],t56);

	mpynn(tw0,t01,tw1);
	mpynn(tw1,t12,tw2);
	mpynn(tw2,t23,tw3);
	mpynn(tw3,t34,tw4);
	mpynn(tw4,t45,tw5);
	mpynn(tw5,t56,tw6);
}
