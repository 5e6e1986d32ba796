/* A page of SVG in pixels, y downwards, and what stands on it in words. */
#ifndef STONEPACK_HOST_PAGE_H
#define STONEPACK_HOST_PAGE_H

#include <stddef.h>
#include <stdio.h>

#define PAGE_WIDTH  900.0               /* [px] */
#define PAGE_MARGIN 36.0

#define INK_FORCE  "#1d5fa6"
#define INK_WEAK   "#e07b00"
#define INK_MOTION "#b2182b"
#define INK_HINGE  "#6a1b9a"
#define INK_SLIDE  "#00796b"

/* Begin a page of this height, with the pattern `hatch` that supports are filled with; end it by page_end. */
void page_begin(FILE *out, double height);
void page_end(FILE *out);

/* Text inside an element, at most so many characters: markup escaped, bytes that are no UTF-8 shown as '?'. */
void page_text(FILE *out, const char *s, size_t most);

/* 1234.5 with a unit of thousands: "1.23 kN". */
void page_quantity(FILE *out, double x, const char *unit);

/* Begin a line of the legend at x, y; the caller ends it with </text>. */
void page_label(FILE *out, double x, double y);

/* An arrow from a to b. Thin ones are many: they have no light rim. */
void page_arrow(FILE *out, const double a[2], const double b[2], const char *ink, double width, double head);

#endif
