/* math.h of the boards: what libc.c has. */
#ifndef BOARD_MATH_H
#define BOARD_MATH_H

#define NAN         __builtin_nanf("")
#define INFINITY    __builtin_inff()
#define HUGE_VAL    __builtin_inf()
#define isfinite(x) ((x) - (x) >= 0)

double sqrt(double x);
float sqrtf(float x);
double hypot(double a, double b);
double fabs(double x);
double fmax(double a, double b);
double fmin(double a, double b);
double floor(double x);
double sin(double x);
double cos(double x);
double tan(double x);
double atan(double x);
double pow(double x, double y);

#endif /* BOARD_MATH_H */
