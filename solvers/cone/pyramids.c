/* pyramid: the face directions of a K-sided friction pyramid, K = 3..64, without trigonometry.
 *
 * One table holds cos and sin of a quarter of a face's turn, pi/(2K), to 20 digits. Direction k of K, the angle 2 pi k/K, is
 * 4k of these steps out of 4K; reflections in the axes and the diagonal bring it, in integers, to g <= K/2 steps, which is the
 * g-th power of the table's complex number, by repeated squaring. Directions on an axis are therefore exactly 0 and +-1,
 * opposite and mirrored directions have the same digits, and all are right to a few units in the last place.
 */
#ifndef SP__PYRAMID_C
#define SP__PYRAMID_C

#include "../base/config.c"

#if SP__WITH_STONES

#define SP__FACES_MIN 3
#define SP__FACES_MAX 64

#ifdef SP_SMALL
/* cos pi/(2K), sin pi/(2K) by their series, to a rounding or two. */
static void sp__turn_quarter(int32_t K, sp_real d[2])
{
    const sp_real x = (sp_real)1.5707963267948966192 / (sp_real)K;
    sp_real term = 1;
    d[0] = d[1] = 0;
    for (int n = 0; n < 20; n++) {
        d[n % 2] += n & 2 ? -term : term;
        term *= x / (sp_real)(n + 1);
    }
}
#else
/* cos pi/(2K), sin pi/(2K) */
#define SP__TURN(c, s) { (sp_real)(c), (sp_real)(s) }
static const sp_real sp__turn[SP__FACES_MAX - SP__FACES_MIN + 1][2] = {
    SP__TURN(0.86602540378443864676, 0.50000000000000000000),     SP__TURN(0.92387953251128675613, 0.38268343236508977173),
    SP__TURN(0.95105651629515357212, 0.30901699437494742410),     SP__TURN(0.96592582628906828675, 0.25881904510252076235),
    SP__TURN(0.97492791218182360702, 0.22252093395631440429),     SP__TURN(0.98078528040323044913, 0.19509032201612826785),
    SP__TURN(0.98480775301220805937, 0.17364817766693034885),     SP__TURN(0.98768834059513772619, 0.15643446504023086901),
    SP__TURN(0.98982144188093273238, 0.14231483827328514044),     SP__TURN(0.99144486137381041114, 0.13052619222005159155),
    SP__TURN(0.99270887409805399280, 0.12053668025532305335),     SP__TURN(0.99371220989324258353, 0.11196447610330785847),
    SP__TURN(0.99452189536827333692, 0.10452846326765347140),     SP__TURN(0.99518472667219688624, 0.098017140329560601994),
    SP__TURN(0.99573417629503452187, 0.092268359463301995240),     SP__TURN(0.99619469809174553230, 0.087155742747658173558),
    SP__TURN(0.99658449300666984982, 0.082579345472332324600),     SP__TURN(0.99691733373312797620, 0.078459095727844945033),
    SP__TURN(0.99720379718118014823, 0.074730093586424254291),     SP__TURN(0.99745211461025354136, 0.071339183199232340327),
    SP__TURN(0.99766876919053919845, 0.068242413364670975921),     SP__TURN(0.99785892323860350674, 0.065403129230143066815),
    SP__TURN(0.99802672842827156195, 0.062790519529313376076),     SP__TURN(0.99817555422331747084, 0.060378497422286053438),
    SP__TURN(0.99830815827126820805, 0.058144828910475828539),     SP__TURN(0.99842681501781656213, 0.056070447237191788191),
    SP__TURN(0.99853341385112386457, 0.054138908585417526150),     SP__TURN(0.99862953475457387378, 0.052335956242943832722),
    SP__TURN(0.99871650717105280715, 0.050649168838712712279),     SP__TURN(0.99879545620517239271, 0.049067674327418014255),
    SP__TURN(0.99886733918300797666, 0.047581915823742297450),     SP__TURN(0.99893297480237244441, 0.046183458645739591949),
    SP__TURN(0.99899306654131464737, 0.044864830350514925458),     SP__TURN(0.99904822158185776240, 0.043619387365335999782),
    SP__TURN(0.99909896620468147236, 0.042441203196148305878),     SP__TURN(0.99914575838730102919, 0.041324974248813211938),
    SP__TURN(0.99918899817156963770, 0.040265940109415143362),     SP__TURN(0.99922903624072293474, 0.039259815759068609021),
    SP__TURN(0.99926618105081002039, 0.038302733690035348803),     SP__TURN(0.99930070478839855270, 0.037391194276325621096),
    SP__TURN(0.99933284837023937207, 0.036522023057658834968),     SP__TURN(0.99936282565699169131, 0.035692333838980455760),
    SP__TURN(0.99939082701909573001, 0.034899496702500971646),     SP__TURN(0.99941702236617402895, 0.034141110185967895283),
    SP__TURN(0.99944156373025460632, 0.033414977007674570875),     SP__TURN(0.99946458747636564443, 0.032719082821776142064),
    SP__TURN(0.99948621620068786770, 0.032051577571655174234),     SP__TURN(0.99950656036573155700, 0.031410759078128293839),
    SP__TURN(0.99952571971336587467, 0.030795058556170353875),     SP__TURN(0.99954378448953337255, 0.030203027800888846965),
    SP__TURN(0.99956083650879434943, 0.029633327822559740485),     SP__TURN(0.99957695008220057696, 0.029084718743111406889),
    SP__TURN(0.99959219282818922963, 0.028556050793696253848),     SP__TURN(0.99960662638305288551, 0.028046256275868958377),
    SP__TURN(0.99962030702495140574, 0.027554342368161996514),     SP__TURN(0.99963328622328394947, 0.027079384676134495101),
    SP__TURN(0.99964561112345257676, 0.026620521437774766925),     SP__TURN(0.99965732497555728004, 0.026176948307873152611),
    SP__TURN(0.99966846751431309403, 0.025747913654988557094),     SP__TURN(0.99967907529643052121, 0.025332714313187926267),
    SP__TURN(0.99968918200081628415, 0.024930691738072875282),     SP__TURN(0.99969881869620422012, 0.024541228522912288032)
};
#undef SP__TURN

static void sp__turn_quarter(int32_t K, sp_real d[2])
{
    d[0] = sp__turn[K - SP__FACES_MIN][0];
    d[1] = sp__turn[K - SP__FACES_MIN][1];
}
#endif

/* d = cos, sin of g pi/(2K), 0 <= g <= K/2. Powers drift off the unit circle by g u/2; one Newton step for 1/|d| undoes it. */
SP__NOINLINE_SMALL static void sp__turn_power(int32_t K, int32_t g, sp_real d[2])
{
    sp__turn_quarter(K, d);
    sp_real c = d[0], s = d[1];
    d[0] = (sp_real)1; d[1] = 0;
    if (g == 0) return;
    for (; g > 0; g /= 2) {
        if (g % 2) {
            const sp_real x = d[0] * c - d[1] * s;
            d[1] = d[0] * s + d[1] * c;
            d[0] = x;
        }
        const sp_real x = (c - s) * (c + s);
        s = 2 * c * s;
        c = x;
    }
    const sp_real off = (((sp_real)1 - d[0] * d[0]) - d[1] * d[1]) / 2;
    d[0] += off * d[0];
    d[1] += off * d[1];
}

/* d = cos, sin of 2 pi k/K, 0 <= k < K. */
static void sp__pyramid_direction(int32_t K, int32_t k, sp_real d[2])
{
    int32_t g = 4 * k;
    const int below = g > 2 * K;
    if (below) g = 4 * K - g;                           /* lower half plane: mirror y */
    const int left = g > K;
    if (left) g = 2 * K - g;                            /* left half: mirror x */
    const int steep = 2 * g > K;
    if (steep) g = K - g;                               /* above the diagonal: swap x and y */
    sp_real t[2];
    if (2 * g == K) t[0] = t[1] = (sp_real)0.70710678118654752440;
    else sp__turn_power(K, g, t);
    d[0] = steep ? t[1] : t[0];
    d[1] = steep ? t[0] : t[1];
    if (left) d[0] = (sp_real)0 - d[0];
    if (below) d[1] = (sp_real)0 - d[1];
}

/* c = cos pi/K, t = tan pi/K: half a face. */
static void sp__pyramid_half(int32_t K, sp_real *c, sp_real *t)
{
    sp_real d[2];
    sp__turn_quarter(K, d);
    *c = (sp_real)1 - 2 * (d[1] * d[1]);
    *t = 2 * d[0] * d[1] / *c;
}

#endif
#endif /* SP__PYRAMID_C */
