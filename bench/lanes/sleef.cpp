// RK4, h = 0.01, on double pendulums with m = I = c = d = 1, g = 9.8 and no friction, in absolute angles: AVX-512
// intrinsics with the sines and cosines of SLEEF. Constants are folded by hand, multiplications and additions are fused.
#include <immintrin.h>
#include <sleef.h>

namespace {

typedef __m512d V;

struct State {
  V a, b, u, v;  // angles, rates
};

inline V k(double x) { return _mm512_set1_pd(x); }
inline V mul(V a, V b) { return _mm512_mul_pd(a, b); }
inline V fma(V a, V b, V c) { return _mm512_fmadd_pd(a, b, c); }

// Sine and cosine with errors up to 1.0 and 3.5 ulps.
inline Sleef___m512d_2 sincos10(V x) { return Sleef_sincosd8_u10(x); }
inline Sleef___m512d_2 sincos35(V x) { return Sleef_sincosd8_u35(x); }
typedef Sleef___m512d_2 Sincos(V);

// Right-hand side of GROUPS groups of eight lanes, interleaved to hide latencies.
template <Sincos *SINCOS, int GROUPS>
inline __attribute__((always_inline)) void rhs(const State (&x)[GROUPS], State (&f)[GROUPS]) {
  for (int g = 0; g < GROUPS; g++) {
    const Sleef___m512d_2 p = SINCOS(x[g].a), q = SINCOS(x[g].b);
    const V m12 = fma(p.y, q.y, mul(p.x, q.x));
    const V turn = _mm512_fmsub_pd(p.x, q.y, mul(p.y, q.x));
    // The mass matrix is [3, m12; m12, 2].
    const V f1 = fma(mul(turn, x[g].v), x[g].v, mul(k(19.6), p.x));
    const V f2 = _mm512_fmsub_pd(mul(turn, x[g].u), x[g].u, mul(k(9.8), q.x));
    const V inverse = _mm512_div_pd(k(1), _mm512_fnmadd_pd(m12, m12, k(6)));
    f[g].a = x[g].u;
    f[g].b = x[g].v;
    f[g].u = mul(_mm512_fnmsub_pd(k(2), f1, mul(m12, f2)), inverse);
    f[g].v = mul(fma(k(3), f2, mul(m12, f1)), inverse);
  }
}

inline State plus(const State &x, V h, const State &f) {
  return {fma(h, f.a, x.a), fma(h, f.b, x.b), fma(h, f.u, x.u), fma(h, f.v, x.v)};
}

// Integrates `count` trajectories, a multiple of 8 GROUPS.
template <Sincos *SINCOS, int GROUPS>
void solve(const double (*starts)[4], double (*ends)[4], long count) {
  const V whole = k(0.01), half = k(0.005), third = k(0.01 / 3), sixth = k(0.01 / 6);
  const __m512i every = _mm512_setr_epi64(0, 4, 8, 12, 16, 20, 24, 28);
  for (long i = 0; i < count; i += 8 * GROUPS) {
    State x[GROUPS], y[GROUPS], f[GROUPS], sum[GROUPS];
    for (int g = 0; g < GROUPS; g++) {
      const double *from = starts[i + 8 * g];
      x[g] = {_mm512_i64gather_pd(every, from, 8), _mm512_i64gather_pd(every, from + 1, 8),
              _mm512_i64gather_pd(every, from + 2, 8), _mm512_i64gather_pd(every, from + 3, 8)};
    }
    for (int step = 0; step < 1000; step++) {
      rhs<SINCOS, GROUPS>(x, f);
      for (int g = 0; g < GROUPS; g++) sum[g] = plus(x[g], sixth, f[g]), y[g] = plus(x[g], half, f[g]);
      rhs<SINCOS, GROUPS>(y, f);
      for (int g = 0; g < GROUPS; g++) sum[g] = plus(sum[g], third, f[g]), y[g] = plus(x[g], half, f[g]);
      rhs<SINCOS, GROUPS>(y, f);
      for (int g = 0; g < GROUPS; g++) sum[g] = plus(sum[g], third, f[g]), y[g] = plus(x[g], whole, f[g]);
      rhs<SINCOS, GROUPS>(y, f);
      for (int g = 0; g < GROUPS; g++) x[g] = plus(sum[g], sixth, f[g]);
    }
    for (int g = 0; g < GROUPS; g++) {
      double *to = ends[i + 8 * g];
      _mm512_i64scatter_pd(to, every, x[g].a, 8);
      _mm512_i64scatter_pd(to + 1, every, x[g].b, 8);
      _mm512_i64scatter_pd(to + 2, every, x[g].u, 8);
      _mm512_i64scatter_pd(to + 3, every, x[g].v, 8);
    }
  }
}

}  // namespace

#define FUNCTION(ulp, groups)                                                                       \
  extern "C" __attribute__((visibility("default"))) void sleef_u##ulp##_##groups(                   \
      const double(*starts)[4], double(*ends)[4], long count) {                                     \
    solve<sincos##ulp, groups>(starts, ends, count);                                                \
  }
FUNCTION(10, 1)
FUNCTION(10, 2)
FUNCTION(10, 4)
FUNCTION(35, 1)
FUNCTION(35, 2)
FUNCTION(35, 4)
