#include "armtol/draw/svg.h"

#include <stdbool.h>
#include <stddef.h>
#include <string.h>

static const char page_style[] =
    "    path, polyline, circle { fill: none }\n"
    "    polyline, path { stroke-linejoin: round; stroke-linecap: round }\n"
    "    text { font: 13px sans-serif } .small { font-size: 11px } .strong { font-weight: bold; font-size: 15px }\n"
    "    .halo { fill: #111; stroke: #fff; stroke-width: 3px; stroke-linejoin: round; paint-order: stroke }\n"
    "    .w2 { stroke-width: 2 } .w3 { stroke-width: 3 } .paper { fill: #fff }\n"
    "    .ground { fill: #ffffff } .s0 { stroke: #1f2328 } .sm { stroke: #5f6770 } .sg { stroke: #dfe2e6 }\n"
    "    .f0 { fill: #1f2328 } .fm { fill: #5f6770 }\n";

static const char dark_style[] =
    "    @media (prefers-color-scheme: dark) {\n"
    "    .ground { fill: #0d1117 } .s0 { stroke: #e6edf3 } .sm { stroke: #9da7b1 } .sg { stroke: #30363d }\n"
    "    .f0 { fill: #e6edf3 } .fm { fill: #9da7b1 }\n"
    "    }\n";

const char *svg_px(double x, pixel *pixel)
{
    snprintf(pixel->text, sizeof pixel->text, "%.1f", x);
    if (strcmp(pixel->text, "-0.0") == 0) {
        strcpy(pixel->text, "0.0");
    }
    return pixel->text;
}

/* The length of the UTF-8 that begins here; 0 where none does, or one that XML has no place for. */
static size_t length_of(const unsigned char *at)
{
    static const unsigned least[] = {0, 0, 0x80, 0x800, 0x10000};
    const size_t length = at[0] < 0x80 ? 1 : at[0] >> 5 == 6 ? 2 : at[0] >> 4 == 14 ? 3 : at[0] >> 3 == 30 ? 4 : 0;
    if (length <= 1) {
        return at[0] >= ' ' && at[0] != 0x7f ? length : 0;
    }
    unsigned code = at[0] & (0xffu >> (length + 1));
    for (size_t i = 1; i < length; i++) {
        if (at[i] >> 6 != 2) {
            return 0;
        }
        code = code << 6 | (at[i] & 0x3fu);
    }
    const bool fine = code >= least[length] && code <= 0x10ffff && code >> 11 != 0x1b && (code & 0xfffe) != 0xfffe &&
                      code >= 0xa0;
    return fine ? length : 0;
}

static const char *entity_of(unsigned char c)
{
    return c == '&' ? "&amp;" : c == '<' ? "&lt;" : c == '>' ? "&gt;" : c == '"' ? "&quot;" : NULL;
}

void svg_put(FILE *stream, const char *text)
{
    for (const unsigned char *at = (const unsigned char *)text; *at != '\0';) {
        const size_t length = length_of(at);
        const char *entity = entity_of(*at);
        if (entity != NULL) {
            fputs(entity, stream);
        } else if (length == 0) {
            fputc('?', stream);
        } else {
            fwrite(at, 1, length, stream);
        }
        at += length > 0 ? length : 1;
    }
}

void svg_start(FILE *stream, double width, double height, const char *title, const char *description,
               void (*style)(FILE *stream, const void *data), const void *data)
{
    fprintf(stream, "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 %.0f %.0f\" width=\"%.0f\" "
                    "height=\"%.0f\" role=\"img\" aria-labelledby=\"title desc\">\n  <title id=\"title\">",
            width, height, width, height);
    svg_put(stream, title);
    fputs("</title>\n  <desc id=\"desc\">", stream);
    svg_put(stream, description);
    fputs("</desc>\n  <style>\n", stream);
    fputs(page_style, stream);
    style(stream, data);
    fputs(dark_style, stream);
    fputs("  </style>\n  <rect class=\"ground\" width=\"100%\" height=\"100%\"/>\n", stream);
}

void svg_end(FILE *stream)
{
    fputs("</svg>\n", stream);
}

void svg_line(FILE *stream, const char *class, double x1, double y1, double x2, double y2)
{
    fprintf(stream, "  <path class=\"%s\" d=\"M%s %sL%s %s\"/>\n", class, svg_px(x1, &(pixel){""}),
            svg_px(y1, &(pixel){""}),
            svg_px(x2, &(pixel){""}), svg_px(y2, &(pixel){""}));
}

void svg_box(FILE *stream, const char *class, double x, double y, double width, double height)
{
    fprintf(stream, "  <rect class=\"%s\" x=\"%s\" y=\"%s\" width=\"%s\" height=\"%s\"/>\n", class,
            svg_px(x, &(pixel){""}),
            svg_px(y, &(pixel){""}), svg_px(width, &(pixel){""}), svg_px(height, &(pixel){""}));
}

static void put_text(FILE *stream, const char *text)
{
    svg_put(stream, text);
    fputs("</text>\n", stream);
}

void svg_label(FILE *stream, const char *class, double x, double y, const char *anchor, const char *text)
{
    fprintf(stream, "  <text class=\"%s\" x=\"%s\" y=\"%s\" text-anchor=\"%s\">", class, svg_px(x, &(pixel){""}),
            svg_px(y, &(pixel){""}), anchor);
    put_text(stream, text);
}

/* In characters, of which each but the first byte of UTF-8 is none. */
static size_t count_characters(const char *text)
{
    size_t n = 0;
    for (; *text != '\0'; text++) {
        n += ((unsigned char)*text & 0xc0) != 0x80;
    }
    return n;
}

static void put_line(FILE *stream, const char *class, double y, double width, double size, double letter,
                     const char *text)
{
    enum { BESIDE = 20 };
    fprintf(stream, "  <text class=\"%s\" x=\"%d\" y=\"%s\"", class, BESIDE, svg_px(y, &(pixel){""}));
    if (letter * (double)count_characters(text) > width - 2 * BESIDE) {
        const double share = (width - 2 * BESIDE) / (letter * (double)count_characters(text));
        fprintf(stream, " style=\"font-size: %spx\"", svg_px(size * share, &(pixel){""}));
    }
    fputc('>', stream);
    put_text(stream, text);
}

void svg_title(FILE *stream, double width, const char *title, const char *below)
{
    put_line(stream, "strong f0", 28, width, 15, 9.2, title);
    put_line(stream, "small fm", 47, width, 11, 6.3, below);
}

void svg_label_upwards(FILE *stream, const char *class, double x, double y, const char *text)
{
    fprintf(stream, "  <text class=\"%s\" transform=\"translate(%s %s) rotate(-90)\" text-anchor=\"middle\">", class,
            svg_px(x, &(pixel){""}), svg_px(y, &(pixel){""}));
    put_text(stream, text);
}
