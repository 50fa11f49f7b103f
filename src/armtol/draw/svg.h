#ifndef ARMTOL_DRAW_SVG_H
#define ARMTOL_DRAW_SVG_H

#include <stdio.h>

/*
 * A page of SVG 1.1 that reads on light and on dark ground. Places are in pixels from the upper left corner, printed to
 * a tenth, so that the same numbers give the same bytes everywhere. What cannot be written shows in the stream.
 *
 * Classes: of lines s0 (ink), sm (muted), sg (grid), w2, w3; of areas f0, fm, ground, paper (of a picture's own, light
 * on both grounds); of texts f0, fm, small, strong, and halo, which reads on any colour.
 */

/* What comes first; `style` is put behind the page's own. The description is for who does not see the picture. */
void svg_start(FILE *stream, double width, double height, const char *title, const char *description,
               void (*style)(FILE *stream, const void *data), const void *data);
void svg_end(FILE *stream);

/* Room for a place: svg_px(x, &(pixel){""}). */
typedef struct pixel {
    char text[24];
} pixel;

/* To a tenth of a pixel; no -0.0. */
const char *svg_px(double x, pixel *pixel);

/* A text's own characters: XML's are escaped, and what is no UTF-8, or not for XML, is a question mark. */
void svg_put(FILE *stream, const char *text);

void svg_line(FILE *stream, const char *class, double x1, double y1, double x2, double y2);
void svg_box(FILE *stream, const char *class, double x, double y, double width, double height);

/* (x, y) on the base line; anchor is start, middle or end. */
void svg_label(FILE *stream, const char *class, double x, double y, const char *anchor, const char *text);

/* What stands above it all, and a line below that; what is too long for the page is written smaller. */
void svg_title(FILE *stream, double width, const char *title, const char *below);

/* Upwards, about its middle. */
void svg_label_upwards(FILE *stream, const char *class, double x, double y, const char *text);

#endif
