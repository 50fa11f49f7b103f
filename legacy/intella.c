/*
 * intella.c -- tolerances for the Intelledex 605T
 *
 * The listing's main and mach, the listing's names and order; the comments are ours: see README.md. It asks for a
 * position, writes the error matrix A of that position and again with distances before angles, asks for tolerances, and
 * writes by how much the parameters, and by how much parts and motors, may be off. mm and radians.
 */

#include <stdio.h>
#include "intelledex.h"
#include "kinematic2.h"
#include "inverse.h"		/* [ours inverse] */

#define OUTPUT "inta.1"
#define OUTPUT2 "intat.1"
#define OUTPUT3 "inttol.1"
#define OUTPUT4 "intmach.1"
#define PI 3.14159		/* a second time: the robot's header has it too */
#define MA0 (0.)
#define MA1 (0.)
#define MA2 (0.)
#define MA3 (373.4)
#define MA4 (279.4)
#define MA5 (0.)
#define MA6 (0.)
#define MA7 (0.)
#define MALPHA0 (0.)
#define MALPHA1 (-PI/2.)
#define MALPHA2 (PI/2.)
#define MALPHA3 (0.)
#define MALPHA4 (0.)
#define MALPHA5 (PI/2.)
#define MALPHA6 (0.)
#define MALPHA7 (0.)
#define MD0 (359.7)
#define MD1 (0.)
#define MD2 (0.)
#define MD3 (0.)
#define MD4 (0.)
#define MD5 (0.)
#define MD6 (0.)
#define MD7 (100.)
#define MBETA0 (0.)
#define MBETA1 (0.)
#define MBETA2 (0.)
#define MBETA3 (0.)
#define MBETA4 (0.)
#define MBETA5 (0.)
#define MBETA6 (0.)
#define MBETA7 (0.)

/* [printed] but for what is marked */
main()
{
	float a[8],
		alpha[8],
		d[8],
		delta,
		tol[6],
		tolo[6],
		norm[6],
		mint,
		minr,		/* [reading page] from here to a[2] below the page is missing */
		ad,
		dd,
		gd,
		md,
		td[6],
		ggd[8],
		rd[8],
		x[6],
		theta[8],
		beta[8],
		itheta[6],
		tclose[6],
		check[6],
		t00[4][4],
		tw0[4][4],
		t01[4][4],
		t12[4][4],
		t23[4][4],
		t34[4][4],
		t45[4][4],
		t56[4][4],
		t6t[4][4],
		jw0[6][6],
		j01[6][6],
		j12[6][6],
		j23[6][6],
		j34[6][6],
		j45[6][6],
		j56[6][6],
		j6t[6][6],
		jw1[6][6],
		jw2[6][6],
		jw3[6][6],
		jw4[6][6],
		jw5[6][6],
		jw6[6][6],
		jwt[6][6],
		g0[6][4],
		g1[6][4],
		g2[6][4],
		g3[6][4],
		g4[6][4],
		g5[6][4],
		g6[6][4],
		gt[6][4],
		a0[6][4],
		a1[6][4],
		a2[6][4],
		a3[6][4],
		a4[6][4],
		a5[6][4],
		a6[6][4],
		at[6][4],
		aat[6][32],
		aa[6][32];

	int i,
		j,
		k;

	FILE *file,*fopen();

	a[0] = MA0;
	a[1] = MA1;
	a[2] = MA2;
	a[3] = MA3;
	a[4] = MA4;
	a[5] = MA5;
	a[6] = MA6;
	a[7] = MA7;
	alpha[0] = MALPHA0;
	alpha[1] = MALPHA1;
	alpha[2] = MALPHA2;
	alpha[3] = MALPHA3;
	alpha[4] = MALPHA4;
	alpha[5] = MALPHA5;
	alpha[6] = MALPHA6;
	alpha[7] = MALPHA7;
	d[0] = MD0;
	d[1] = MD1;
	d[2] = MD2;
	d[3] = MD3;
	d[4] = MD4;
	d[5] = MD5;
	d[6] = MD6;
	d[7] = MD7;
	beta[0] = MBETA0;
	beta[1] = MBETA1;
	beta[2] = MBETA2;
	beta[3] = MBETA3;
	beta[4] = MBETA4;
	beta[5] = MBETA5;
	beta[6] = MBETA6;
	beta[7] = MBETA7;

	for(i=0;i<6;i++) tclose[i] = 0.;
	fprintf(stderr,"enter desired position: ");
	fscanf(stdin,"%f %f %f %f %f %f",&x[0],&x[1],&x[2],&x[3],&x[4],&x[5]);
	invintell(x,tclose,itheta);		/* [reading invintell] */
	for(i=0;i<6;i++) fprintf(stderr,"itheta[%d] = %f\n",i,itheta[i]);	/* [reading prompt] */
	intelledex(itheta,t00);
	geulerzyx(t00,check);
	for(i=0;i<6;i++) fprintf(stderr,"check[%d] = %f\n",i,check[i]);
	theta[0] = 0.;
	for(i=0;i<6;i++){
		theta[i+1] = itheta[i];
	}
	theta[7] = PI/2;

	mtransf(a[0],alpha[0],d[0],theta[0],beta[0],tw0);
	mtransf(a[1],alpha[1],d[1],theta[1],beta[1],t01);
	mtransf(a[2],alpha[2],d[2],theta[2],beta[2],t12);
	mtransf(a[3],alpha[3],d[3],theta[3],beta[3],t23);
	mtransf(a[4],alpha[4],d[4],theta[4],beta[4],t34);
	mtransf(a[5],alpha[5],d[5],theta[5],beta[5],t45);
	mtransf(a[6],alpha[6],d[6],theta[6],beta[6],t56);
	mtransf(a[7],alpha[7],d[7],theta[7],beta[7],t6t);

	gnpr(a[0],alpha[0],g0);
	gnpr(a[1],alpha[1],g1);
	gnpr(a[2],alpha[2],g2);
	gppr(alpha[3],d[3],beta[3],g3);
	gppr(alpha[4],d[4],beta[4],g4);
	gnpr(a[5],alpha[5],g5);
	gnpr(a[6],alpha[6],g6);
	gnpr(a[7],alpha[7],gt);

	getj(tw0,jw0);
	getj(t01,j01);
	getj(t12,j12);
	getj(t23,j23);
	getj(t34,j34);
	getj(t45,j45);
	getj(t56,j56);
	getj(t6t,j6t);

	mpy664(jw0,g0,a0);
	mpy666(jw0,j01,jw1);
	mpy664(jw1,g1,a1);
	mpy666(jw1,j12,jw2);
	mpy664(jw2,g2,a2);
	mpy666(jw2,j23,jw3);
	mpy664(jw3,g3,a3);
	mpy666(jw3,j34,jw4);
	mpy664(jw4,g4,a4);
	mpy666(jw4,j45,jw5);
	mpy664(jw5,g5,a5);
	mpy666(jw5,j56,jw6);
	mpy664(jw6,g6,a6);
	mpy666(jw6,j6t,jwt);
	mpy664(jwt,gt,at);

	for(i=0;i<6;i++){
		k=0;
		for(j=0;j<4;j++){
			aa[i][j + 4*k] = a0[i][j];
		}
		k++;
		for(j=0;j<4;j++){
			aa[i][j + 4*k] = a1[i][j];
		}
		k++;
		for(j=0;j<4;j++){
			aa[i][j + 4*k] = a2[i][j];
		}
		k++;
		for(j=0;j<4;j++){
			aa[i][j + 4*k] = a3[i][j];
		}
		k++;
		for(j=0;j<4;j++){
			aa[i][j + 4*k] = a4[i][j];
		}
		k++;
		for(j=0;j<4;j++){
			aa[i][j + 4*k] = a5[i][j];
		}
		k++;
		for(j=0;j<4;j++){
			aa[i][j + 4*k] = a6[i][j];
		}
		k++;
		for(j=0;j<4;j++){
			aa[i][j + 4*k] = at[i][j];
		}
	}

	file = fopen(OUTPUT,"w");
	for(i=0;i<32;i++){
		fprintf(file,"%11.6f %11.6f %11.6f %11.6f %11.6f %11.6f\n",aa[0][i], aa[1][i],aa[2][i],aa[3][i],
			aa[4][i],aa[5][i]);
	}
	fclose(file);

	for(i=0;i<6;i++){
		aat[i][14] = aa[i][0];
		aat[i][6] = aa[i][1];
		aat[i][0] = aa[i][2];
		aat[i][22] = aa[i][3];
		aat[i][15] = aa[i][4];
		aat[i][7] = aa[i][5];
		aat[i][1] = aa[i][6];
		aat[i][23] = aa[i][7];
		aat[i][16] = aa[i][8];
		aat[i][8] = aa[i][9];
		aat[i][2] = aa[i][10];
		aat[i][24] = aa[i][11];
		aat[i][17] = aa[i][12];
		aat[i][9] = aa[i][13];
		aat[i][25] = aa[i][14];
		aat[i][30] = aa[i][15];
		aat[i][18] = aa[i][16];
		aat[i][10] = aa[i][17];
		aat[i][26] = aa[i][18];
		aat[i][31] = aa[i][19];
		aat[i][19] = aa[i][20];
		aat[i][11] = aa[i][21];
		aat[i][3] = aa[i][22];
		aat[i][27] = aa[i][23];
		aat[i][20] = aa[i][24];
		aat[i][12] = aa[i][25];
		aat[i][4] = aa[i][26];
		aat[i][28] = aa[i][27];
		aat[i][21] = aa[i][28];
		aat[i][13] = aa[i][29];
		aat[i][5] = aa[i][30];
		aat[i][29] = aa[i][31];
	}
	file = fopen(OUTPUT2,"w");
	for(i=0;i<32;i++){
		fprintf(file,"%11.6f %11.6f %11.6f %11.6f %11.6f %11.6f\n",aat[0][i], aat[1][i],aat[2][i],aat[3][i],
			aat[4][i],aat[5][i]);
	}
	fclose(file);

	fprintf(stderr,"enter desired position and orientation tolerances: ");
	fscanf(stdin,"%f %f %f %f %f %f",&tol[0],&tol[1],&tol[2],&tol[3],&tol[4],&tol[5]);
	fprintf(stderr,"enter desired delta: ");
	fscanf(stdin,"%f",&delta);
	for(i=0;i<6;i++){
		norm[i] = 0.;
		tolo[i] = tol[i];
	}
	for(i=0;i<6;i++){
		for(j=14;j<32;j++){
			norm[i] += (double)aat[i][j]*aat[i][j];	/* [forced cast] */
		}
		norm[i] = sqrt(norm[i]);
	}
	for(i=0;i<3;i++) tol[i] = tol[i] - delta;
	mint = tol[0]/norm[0];
	for(i=1;i<6;i++){
		if((double)tol[i]/norm[i] < mint) mint = tol[i]/norm[i];	/* [forced cast] */
	}

	for(i=0;i<6;i++) norm[i] = 0.;
	for(i=0;i<3;i++){
		for(j=0;j<14;j++){
			norm[i] += (double)aat[i][j]*aat[i][j];	/* [forced cast] */
		}
		norm[i] = sqrt(norm[i]);
	}
	for(i=0;i<3;i++) tol[i] = delta;
	minr = tol[0]/norm[0];
	for(i=1;i<3;i++){
		if((double)tol[i]/norm[i] < minr) minr = tol[i]/norm[i];	/* [forced cast] */
	}

	/* [reading blanks] the blanks in the labels of both files */
	file = fopen(OUTPUT3,"w");
	fprintf(file,"For the Intelledex 605T\n\n");
	fprintf(file,"with input:\n");
	fprintf(file," x = %11.6f theta[1] = %11.6f\n",x[0],itheta[0]);
	fprintf(file," y = %11.6f theta[2] = %11.6f\n",x[1],itheta[1]);
	fprintf(file," z = %11.6f theta[3] = %11.6f\n",x[2],itheta[2]);
	fprintf(file," g = %11.6f theta[4] = %11.6f\n",x[3],itheta[3]);
	fprintf(file," b = %11.6f theta[5] = %11.6f\n",x[4],itheta[4]);
	fprintf(file," a = %11.6f theta[6] = %11.6f\n\n",x[5],itheta[5]);
	fprintf(file,"A bound on the error in distance parameters = %11.6f\n\n",minr);
	fprintf(file,"A bound on the error in angle parameters = %11.6f\n\n",mint);
	fprintf(file,"for tolerances of:\n");
	fprintf(file," dx = %11.6f\n",tolo[0]);
	fprintf(file," dy = %11.6f\n",tolo[1]);
	fprintf(file," dz = %11.6f\n",tolo[2]);
	fprintf(file," dwx = %11.6f\n",tolo[3]);
	fprintf(file," dwx = %11.6f\n",tolo[4]);
	fprintf(file," dwx = %11.6f\n\n",tolo[5]);
	fprintf(file,"and\n");
	fprintf(file," delta = %11.6f\n",delta);
	fclose(file);

	ad = dd = sqrt(minr/14.);
	gd = md = sqrt(mint/18.);
	for(i=0;i<8;i++){
		mach(ad,dd,a[i],d[i],&rd[i]);
		ggd[i] = gd;
	}
	for(i=0;i<6;i++){
		td[i] = md;
	}
	file = fopen(OUTPUT4,"w");
	fprintf(file,"For the Intelledex 605T\n\n");
	fprintf(file,"machining distance tolerances:\n");
	for(i=0;i<8;i++){
		fprintf(file," rd[%1d] = %11.6f\n",i,rd[i]);	/* [reading width] [reading index] */
	}
	fprintf(file,"\nmachining angle tolerances:\n");
	for(i=0;i<8;i++){
		fprintf(file," ggd[%1d] = %11.6f\n",i,ggd[i]);
	}
	fprintf(file,"\nmotor angle tolerances:\n");
	for(i=0;i<6;i++){
		fprintf(file," td[%1d] = %11.6f\n",i,td[i]);
	}
	exit(0);		/* [ours exit] */
}

/*
 * [printed] *e = the error that a part of lengths c and d may have when c may be off by a and d by b: Eq. (4.32)
 */
mach(a,b,c,d,e)
double a,		/* [forced formals] printed as float, down to d */
	b,
	c,
	d;
float *e;
{
	float dummy;

	dummy = sqrt(c*c + d*d);
	*e = -dummy + sqrt((double)dummy*dummy + 2.*c*a + 2.*d*b + a*a + b*b);	/* [forced cast] */
}
