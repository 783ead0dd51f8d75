// The driven EzyRoller by a program for this motion alone, as a row of the table of docs/compared.md: the time that is left where nothing is general and nothing is checked.
//
//     g++ -O3 -march=native -o limit tests/compare/limit.cpp && ./limit
//
// Gauss-Legendre collocation with eight nodes, one in each lane of a vector. Equations by hand (Kane's method) in the speed of the rear wheel, the rate of the seat and the angle
// of the bar against it; heading and place are integrals. The number of steps, of sweeps and the degree of the first guess are fixed for a run, and tuned: all are tried, and the
// fastest run is printed for each error. No step is judged.
#include <cmath>
#include <cstdio>
#include <ctime>

constexpr int N = 8;
typedef double Eight __attribute__((vector_size(64)));

// The end at 60 s: tests/answers/ezyroller_driven.json.
const double END[6] = {12.5164726234661983, -22.0786976047170767, -1.06606296267202026, 12.7541827669588862, -22.5187289555973755, 2.12273966732687433};

// Lengths in m, masses in kg, moments of inertia in kg m^2, torque in N m: models/src/vehicles/ezy_roller.rs.
const double a = 0.2, b = 0.6, c = 0.1, d = 0.1, m1 = 46, i1 = 10, m2 = 1, i2 = 0.005, m0 = 2, omega = M_PI;
const double L = a + b, l = c + d, k = m2 * c * c + i2;

// Nodes and weights on [0, 1], and integrals up to the nodes.
struct Method {
    double node[N], weight[N];
    Eight integral[N]; // by columns
    Method() {
        long double x[N], w[N];
        for (int j = 0; j < N; j++) {
            long double t = cosl(M_PIl * (N - j - 0.25L) / (N + 0.5L)), slope = 1;
            for (int it = 0; it < 100; it++) {
                long double p = t, before = 1;
                for (int m = 1; m < N; m++) {
                    long double next = ((2 * m + 1) * t * p - m * before) / (m + 1);
                    before = p, p = next;
                }
                slope = N * (before - t * p) / (1 - t * t);
                t -= p / slope;
            }
            x[j] = t, w[j] = 2 / ((1 - t * t) * slope * slope);
            node[j] = (1 + t) / 2, weight[j] = w[j] / 2;
        }
        // of a Lagrange polynomial: its Legendre coefficients, integrated
        for (int j = 0; j < N; j++)
            for (int i = 0; i < N; i++) {
                long double sum = 0;
                for (int m = 0; m < N; m++) {
                    long double of = (2 * m + 1) * w[j] / 2 * legendre(m, x[j]);
                    sum += of * (m == 0 ? x[i] + 1 : (legendre(m + 1, x[i]) - legendre(m - 1, x[i])) / (2 * m + 1));
                }
                integral[j][i] = sum / 2;
            }
    }
    static long double legendre(int m, long double x) {
        long double p = 1, before = 0;
        for (int i = 0; i < m; i++) {
            long double next = ((2 * i + 1) * x * p - i * before) / (i + 1);
            before = p, p = next;
        }
        return p;
    }
    // from values at the nodes of a step to those of their polynomial of this degree at the nodes of the next, by columns
    void continued(int degree, Eight *to) const {
        for (int j = 0; j < N; j++)
            for (int i = 0; i < N; i++) {
                long double sum = 0;
                for (int m = 0; m <= degree; m++)
                    sum += (2 * m + 1) * (long double)weight[j] * legendre(m, 2 * node[j] - 1) * legendre(m, 2 * node[i] + 1);
                to[j][i] = sum;
            }
    }
};

static inline Eight times(const Eight *matrix, Eight x) {
    Eight even = matrix[0] * x[0], odd = matrix[1] * x[1];
    for (int j = 2; j < N; j += 2) even += matrix[j] * x[j], odd += matrix[j + 1] * x[j + 1];
    return even + odd;
}

static inline double sum(const double *weight, Eight x) {
    double total = 0;
    for (int j = 0; j < N; j++) total += weight[j] * x[j];
    return total;
}

// Polynomials: fdlibm, k_sin.c and k_cos.c (Sun Microsystems, 1993)
static inline void sines(Eight x, Eight &sin, Eight &cos) {
    typedef long long Bits __attribute__((vector_size(64)));
    Eight shifted = x * M_2_PI + 6755399441055744.0, n = shifted - 6755399441055744.0;
    Eight y = ((x - n * 1.5707963267341256) - n * 6.077100506303966e-11) - n * 2.0222662487959506e-21, z = y * y;
    Eight s = ((((1.58969099521155e-10 * z - 2.5050760253406863e-08) * z + 2.7557313707070068e-06) * z - 1.984126982985795e-04) * z + 8.33333333332249e-03) * z - 1.6666666666666632e-01;
    Eight t = ((((-1.1359647557788195e-11 * z + 2.087572321298175e-09) * z - 2.7557314351390663e-07) * z + 2.480158728947673e-05) * z - 1.388888888887411e-03) * z + 4.16666666666666e-02;
    Eight of_sin = y + y * z * s, of_cos = 1 - 0.5 * z + z * z * t;
    Bits q = (Bits)shifted, odd = -(q & 1);
    Bits swapped = ((Bits)of_sin ^ (Bits)of_cos) & odd;
    sin = (Eight)((Bits)of_sin ^ swapped ^ ((q & 2) << 62));
    cos = (Eight)((Bits)of_cos ^ swapped ^ (((q + 1) & 2) << 62));
}

struct Slopes {
    Eight u, w, beta;
};

// Speed of the rear wheel, rate of the seat, angle of the bar against the seat; by Kane's method
static inline Slopes slopes(Eight u, Eight w, Eight beta, Eight torque) {
    Eight s, co;
    sines(beta, s, co);
    Eight bar = (u * s - L * w * co) / l, rate = bar - w, along = u * co + L * w * s;
    Eight p = c * bar * bar - rate * l * bar, e = torque + k * rate * along / l - m2 * c * along * bar;
    Eight m11 = m1 + m2 * co * co + k / l / l * s * s, m12 = (m2 - k / l / l) * L * s * co;
    Eight m22 = m1 * a * a + i1 + m2 * L * L * s * s + k / l / l * L * L * co * co;
    Eight r1 = m1 * a * w * w - m2 * p * co - s / l * e;
    Eight r2 = torque + L / l * co * e - m1 * a * u * w - m2 * L * p * s;
    Eight inverse = 1 / (m11 * m22 - m12 * m12);
    return {(m22 * r1 - m12 * r2) * inverse, (m11 * r2 - m12 * r1) * inverse, rate};
}

// The error of a coordinate at the end, at most. Not to be inlined: repeated runs would be one.
__attribute__((noipa)) static double run(const Method &method, int n, int n_sweeps, const Eight *continued) {
    double h = 60.0 / n, u = 0, w = 0, beta = M_PI, theta = 0, x = 0, y = 0;
    Eight node;
    for (int j = 0; j < N; j++) node[j] = method.node[j];
    Slopes f = {};
    for (int step = 0; step < n; step++) {
        Eight torque, s, co;
        sines(omega * (step * h + h * node), s, co);
        torque = m0 * co;
        f = {times(continued, f.u), times(continued, f.w), times(continued, f.beta)};
        if (step == 0) f = Slopes{};
        Eight at_u, at_w;
        for (int sweep = 0; sweep < n_sweeps + (step == 0 ? 20 : 0); sweep++) {
            at_u = u + h * times(method.integral, f.u), at_w = w + h * times(method.integral, f.w);
            f = slopes(at_u, at_w, beta + h * times(method.integral, f.beta), torque);
        }
        at_u = u + h * times(method.integral, f.u), at_w = w + h * times(method.integral, f.w);
        sines(theta + h * times(method.integral, at_w), s, co);
        x += h * sum(method.weight, at_u * co - a * at_w * s), y += h * sum(method.weight, at_u * s + a * at_w * co);
        theta += h * sum(method.weight, at_w);
        u += h * sum(method.weight, f.u), w += h * sum(method.weight, f.w), beta += h * sum(method.weight, f.beta);
    }
    if (!std::isfinite(x + y)) return INFINITY;
    double psi = theta + beta;
    double end[6] = {x, y, theta, x + b * cos(theta) + d * cos(psi), y + b * sin(theta) + d * sin(psi), psi}, error = 0;
    for (int i = 0; i < 6; i++) error = fmax(error, fabs(end[i] - END[i]));
    return error;
}

int main() {
    Method method;
    const double errors[] = {1e-4, 1e-6, 1e-9, 1e-11, 1e-12};
    double best[5], least = INFINITY;
    for (double &time : best) time = INFINITY;
    for (int degree = 2; degree < N; degree++) {
        Eight continued[N];
        method.continued(degree, continued);
        for (int n = 50; n <= 400; n += 5)
            for (int n_sweeps = 2; n_sweeps <= 14; n_sweeps++) {
                double error = run(method, n, n_sweeps, continued);
                if (error > errors[0]) continue;
                least = fmin(least, error);
                double time = INFINITY;
                for (int i = 0; i < 5; i++) {
                    clock_t start = clock();
                    for (int j = 0; j < 4; j++) run(method, n, n_sweeps, continued);
                    time = fmin(time, double(clock() - start) / CLOCKS_PER_SEC / 4);
                }
                for (int i = 0; i < 5; i++)
                    if (error <= errors[i]) best[i] = fmin(best[i], time);
            }
    }
    printf("%-32s%-10s", "this motion alone, C++", "by hand");
    for (double time : best) printf("%10.3f", time * 1e3);
    printf("%16.1e\n", least);
}
