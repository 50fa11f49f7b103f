/*
 * adept.h -- forward kinematics of the Adept AdeptOne in Craig's order, for the check in the dialogue
 *
 * The listing's routine under its name; the comments are ours: see README.md.
 */

#include <stdio.h>

#include <math.h>

#include "kinematic.h"

#define PI (3.14159)
#define A0 (0.)
#define A1 (425.)
#define A2 (375.)
#define A3 (0.)
#define ALPHA0 (0.)
#define ALPHA1 (0.)
#define ALPHA2 (0.)
#define ALPHA3 (0.)
#define D0 (203.2)		/* [reading point] */
#define D1 (0.)
#define D2 (0.)
#define D3 (0.)
#define THETA4 (0.)

/*
 * [printed] tw4 = the transform, base to tool, of three angles and a length. The comment in the listing names the
 * Intelledex here.
 */
adept(itheta,tw4)
float itheta[4],
	tw4[4][4];
{
	float a[4],
		alpha[4],
		d[4],
		dummy,
		tw0[4][4],
		t01[4][4],
		t12[4][4],
		t23[4][4],
		t34[4][4],
		tw1[4][4],
		tw2[4][4],
		tw3[4][4];

	int i,
		j;

	a[0] = A0;
	a[1] = A1;
	a[2] = A2;
	a[3] = A3;
	alpha[0] = ALPHA0;
	alpha[1] = ALPHA1;
	alpha[2] = ALPHA2;
	alpha[3] = ALPHA3;
	d[0] = D1;
	d[1] = D2;
	d[2] = D3;
	d[3] = itheta[3];
	dummy = THETA4;

	for(i=0;i<4;i++){
		for(j=0;j<4;j++){
			tw0[i][j] = 0.;
		}
		tw0[i][i] = 1.;
	}
	tw0[2][3] = D0;
	transf(a[0],alpha[0],d[0],itheta[0],t01);
	transf(a[1],alpha[1],-d[1],itheta[1],t12);	/* [reading minus] */
	transf(a[2],alpha[2],d[2],itheta[2],t23);
	transf(a[3],alpha[3],d[3],dummy,t34);

	mpynn(tw0,t01,tw1);
	mpynn(tw1,t12,tw2);
	mpynn(tw2,t23,tw3);
	mpynn(tw3,t34,tw4);
}		/* [reading end] */
