/* random: a double whose every operation is rounded up or down by chance, in proportion to what is lost.    [Parker 1997, MCA]
 * Put before battery.c: c++ -x c++ -std=gnu++20 -fpermissive -w -DSP_REAL_OTHER -include random.hpp. SEED: which sample. */
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <cstring>
#include <type_traits>

struct sreal;
static inline double sreal_round(long double x);

struct sreal {
    double v;
    sreal() = default;
    template <class T, class = typename std::enable_if<std::is_arithmetic<T>::value>::type> constexpr sreal(T x) : v((double)x) { }
    template <class T, class = typename std::enable_if<std::is_arithmetic<T>::value>::type> explicit constexpr operator T() const { return (T)v; }
    sreal &operator+=(sreal b) { v = sreal_round((long double)v + b.v); return *this; }
    sreal &operator-=(sreal b) { v = sreal_round((long double)v - b.v); return *this; }
    sreal &operator*=(sreal b) { v = sreal_round((long double)v * b.v); return *this; }
    sreal &operator/=(sreal b) { v = sreal_round((long double)v / b.v); return *this; }
    friend sreal operator+(sreal a, sreal b) { return a += b; }
    friend sreal operator-(sreal a, sreal b) { return a -= b; }
    friend sreal operator*(sreal a, sreal b) { return a *= b; }
    friend sreal operator/(sreal a, sreal b) { return a /= b; }
    friend sreal operator-(sreal a) { a.v = -a.v; return a; }
    friend bool operator<(sreal a, sreal b) { return a.v < b.v; }
    friend bool operator>(sreal a, sreal b) { return a.v > b.v; }
    friend bool operator<=(sreal a, sreal b) { return a.v <= b.v; }
    friend bool operator>=(sreal a, sreal b) { return a.v >= b.v; }
    friend bool operator==(sreal a, sreal b) { return a.v == b.v; }
    friend bool operator!=(sreal a, sreal b) { return a.v != b.v; }
};

static uint64_t sreal_state = 0x9e3779b97f4a7c15u ^ (0x2545f4914f6cdd1du * (std::getenv("SEED") ? std::strtoull(std::getenv("SEED"), 0, 10) + 1 : 1));

static inline uint64_t sreal_chance()
{
    uint64_t &state = sreal_state;
    state ^= state >> 12; state ^= state << 25; state ^= state >> 27;
    return state * 2685821657736338717u;
}

/* x lies between two doubles: the farther one with the chance of its nearness. */
static inline double sreal_round(long double x)
{
    const double near = (double)x;
    const long double lost = x - near;
    if (lost == 0 || !(lost - lost == 0)) return near;
    const int away = (lost > 0) == (near > 0);              /* the other neighbour has the larger size */
    uint64_t bits;
    double far;
    std::memcpy(&bits, &near, sizeof bits);
    bits = near == 0 ? 1 | (uint64_t)(lost < 0) << 63 : away ? bits + 1 : bits - 1;
    std::memcpy(&far, &bits, sizeof far);
    const long double chance = (long double)(int64_t)(sreal_chance() >> 11) * 0x1p-53L;
    return chance * std::fabs((long double)far - near) < std::fabs(lost) ? far : near;
}

static inline sreal sreal_sqrt(sreal x) { return sreal(sreal_round(sqrtl((long double)x.v))); }

typedef sreal sp_real;
#define SP_EPSILON 1.1102230246251565e-16
#define SP_SQRT(x) sreal_sqrt(x)
#define new made                                        /* files of the program, which are C, call things so */
