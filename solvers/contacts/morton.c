/* morton: a curve that visits boxes so that neighbours along it are near each other.                      [Morton 1966] */
#ifndef SP__CONTACTS_MORTON_C
#define SP__CONTACTS_MORTON_C

#include "touch.c"

#if !SP__WITH_SMALL

/* Every third bit from bit 0. */
static uint32_t sp__every_third_bit(uint32_t x)
{
    x = (x | x << 16) & UINT32_C(0x030000ff);
    x = (x | x << 8) & UINT32_C(0x0300f00f);
    x = (x | x << 4) & UINT32_C(0x030c30c3);
    return (x | x << 2) & UINT32_C(0x09249249);
}

/* Place on the curve of the middle of a box in that of everything, 1024 steps a side. */
static uint32_t sp__morton(const sp_real lo[3], const sp_real hi[3], const sp_real all_lo[3], const sp_real all_hi[3])
{
    uint32_t code = 0;
    for (int c = 0; c < 3; c++) {
        const sp_real wide = all_hi[c] - all_lo[c], at = (lo[c] - all_lo[c]) / 2 + (hi[c] - all_lo[c]) / 2;
        const uint32_t step = wide > 0 ? (uint32_t)(int32_t)(1023 * (at / wide)) : 0;
        code |= sp__every_third_bit(step < 1023 ? step : 1023) << c;
    }
    return code;
}

static int sp__code_before(const void *what, int32_t i, int32_t j)
{
    const uint32_t *code = what;
    return code[i] != code[j] ? code[i] < code[j] : i < j;
}

#endif

#endif /* SP__CONTACTS_MORTON_C */
