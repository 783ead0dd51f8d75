/*
 * A scene of EZY as a functional mock-up unit, for model exchange and co-simulation, of FMI 2.0 or 3.0 as `scene.h` says.
 * Licence: MIT OR Apache-2.0.
 *
 * States x are the coordinates q, the velocities v and the first-order states z. In co-simulation a pair of Dormand and Prince of order 5 with
 * step control makes the motion, and each step is projected onto the constraints. In model exchange the importer makes steps; they drift off the
 * constraints, and once by more than DRIFT tolerances the unit asks for event mode and puts the states back.
 */
#include <math.h>
#include <stddef.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "scene.h"
#include "equations.c"

#define N_X (N_Q + N_V + N_Z)
#define N_K (N_V + N_ROWS)
/* Values that an importer reads and writes: t, p, u, x, derivatives of x, multipliers, outputs, event functions. */
#define FIRST_P 1
#define FIRST_U (FIRST_P + N_P)
#define FIRST_X (FIRST_U + N_U)
#define FIRST_DX (FIRST_X + N_X)
#define FIRST_LAMBDA (FIRST_DX + N_X)
#define FIRST_OUTPUT (FIRST_LAMBDA + N_ROWS)
#define FIRST_EVENT (FIRST_OUTPUT + N_OUTPUTS)
#define N_VALUES (FIRST_EVENT + N_EVENTS)

/* Tolerance of the importer by which positions and velocities may leave the constraints in model exchange. */
#define DRIFT 100.0
/* Without a tolerance of the importer. */
#define DEFAULT_TOLERANCE 1e-8
/* Corrections of a position; they converge quadratically. */
#define MAX_CORRECTIONS 20
/* What rounding leaves of a correction, relative to the coordinates. */
#define ROUNDING 1e-14
/* Halvings that find the end of a motion within a step to its last bits. */
#define MAX_HALVINGS 60

enum { OK = 0, WARNING = 1, DISCARD = 2, ERROR = 3 };

/* All that a motion depends on: copied to save it. */
typedef struct {
    double t, p[N_P + 1], u[N_U + 1], x[N_X + 1], c[N_CONSTANTS + 1];
    double dx[N_X + 1], lambda[N_ROWS + 1], output[N_OUTPUTS + 1];
    double tolerance, step, event[N_EVENTS + 1];
    int has_constants, is_evaluated, has_ended;
} State;

typedef struct {
    State state;
    int is_logging;
    void *environment;
    void *log_message;
    char name[128];
} Instance;

static void log_message(Instance *instance, int status, const char *text);

static void failed(Instance *instance, double t, const char *what) {
    char text[512];
    snprintf(text, sizeof text, SCENE_NAME ": %s at t = %.9g s", what, t);
    log_message(instance, ERROR, text);
}

static int is_finite(int n, const double *x) {
    for (int i = 0; i < n; i++)
        if (!isfinite(x[i])) return 0;
    return 1;
}

static void update_constants(State *state) {
    if (state->has_constants) return;
    CALL(constants)(state->p, state->c);
    state->has_constants = 1;
    state->is_evaluated = 0;
}

/* Derivatives of the states and multipliers at (t, x). Returns why there are none, or NULL. */
static const char *evaluate(const Instance *instance, double t, const double *x, double *dx, double *lambda) {
    const double *q = x, *v = x + N_Q, *z = v + N_V, *u = instance->state.u, *c = instance->state.c;
    (void)z, (void)u;
#if N_PIVOTS > 0
    double pivot[N_PIVOTS];
    CALL(pivot)(ARGUMENTS, pivot);
    for (int i = 0; i < N_PIVOTS; i++)
        if (!(pivot[i] > 1)) return "constraints depend on each other, so that accelerations are not determined,";
#endif
    memcpy(dx, v, N_V * sizeof *dx);
    CALL(accelerations)(ARGUMENTS, dx + N_Q, lambda);
#if N_Z > 0
    CALL(state_rates)(ARGUMENTS, dx + N_Q + N_V);
#endif
    return is_finite(N_X, dx) ? NULL : "accelerations are not finite";
}

/* Brings dx, multipliers and outputs up to the present state. */
static int refresh(Instance *instance) {
    State *state = &instance->state;
    update_constants(state);
    if (state->is_evaluated) return OK;
    const char *why = evaluate(instance, state->t, state->x, state->dx, state->lambda);
    if (why) {
        failed(instance, state->t, why);
        return ERROR;
    }
#if N_OUTPUTS > 0
    double t = state->t;
    const double *q = state->x, *v = q + N_Q, *z = v + N_V, *u = state->u, *c = state->c;
    (void)z, (void)u;
    CALL(outputs)(ARGUMENTS, state->output);
#endif
    state->is_evaluated = 1;
    return OK;
}

#if N_EVENTS > 0
static void event_functions(const State *state, double *event) {
    double t = state->t;
    const double *q = state->x, *v = q + N_Q, *z = v + N_V, *u = state->u, *c = state->c;
    (void)z, (void)u;
    CALL(events)(ARGUMENTS, event);
}
#endif

/* Whether a condition that ends the scene was met since its functions had the values `before`. */
static int has_ended(const State *state, const double *before) {
#if N_EVENTS > 0
    static const int ends[N_EVENTS] = ENDS;
    double now[N_EVENTS];
    event_functions(state, now);
    for (int i = 0; i < N_EVENTS; i++) {
        int rises = before[i] < 0 && now[i] >= 0, falls = before[i] > 0 && now[i] <= 0;
        if ((rises && (ends[i] & 1)) || (falls && (ends[i] & 2))) return 1;
    }
#else
    (void)state, (void)before;
#endif
    return 0;
}

static void remember_events(State *state) {
#if N_EVENTS > 0
    event_functions(state, state->event);
#else
    (void)state;
#endif
}

#if N_ROWS > 0
static double largest(int n, const double *x) {
    double most = 0;
    for (int i = 0; i < n; i++)
        if (!(fabs(x[i]) <= most)) most = fabs(x[i]);
    return most;
}

#if HAS_DERIVATIVES
/* else the equations have it */
#include "solve.c"
#endif

/* The smallest change in the metric of the masses that removes `residual` of the rows: [M G'; G 0] [change; .] = [0; -residual]. */
static void correction(double t, const State *state, const double *x, const double *residual, double *change) {
    const double *q = x, *v = x + N_Q, *z = v + N_V, *u = state->u, *c = state->c;
    double mass[N_V], jacobian[N_ROWS * N_V], matrix[N_K * N_K] = {0}, solution[N_K] = {0};
    (void)z, (void)u;
    CALL(mass_matrix)(c, mass);
    CALL(velocity_jacobian)(ARGUMENTS, jacobian);
    for (int i = 0; i < N_V; i++) {
        matrix[i * N_K + i] = mass[i];
        for (int j = 0; j < N_ROWS; j++)
            matrix[i * N_K + N_V + j] = matrix[(N_V + j) * N_K + i] = jacobian[j * N_V + i];
    }
    for (int j = 0; j < N_ROWS; j++) solution[N_V + j] = -residual[j];
    ezy_solve(N_K, matrix, solution);
    memcpy(change, solution, N_V * sizeof *change);
}

/* Residuals of all rows: of positions if `of_positions`, with zeros for rows that have none, else of velocities. */
static void residuals(double t, const State *state, const double *x, int of_positions, double *residual) {
    const double *q = x, *v = x + N_Q, *z = v + N_V, *u = state->u, *c = state->c;
    (void)z, (void)u;
    memset(residual, 0, N_ROWS * sizeof *residual);
    if (!of_positions) CALL(velocity_constraint)(ARGUMENTS, residual);
#if N_POSITION_ROWS > 0
    else CALL(position_constraint)(ARGUMENTS, residual);
#endif
}
#endif

/* Puts x back onto the constraints. */
static int project(Instance *instance, double t, double *x) {
#if N_ROWS > 0
    double residual[N_ROWS], change[N_V];
    int i = 0;
    for (; i < MAX_CORRECTIONS && N_POSITION_ROWS > 0; i++) {
        residuals(t, &instance->state, x, 1, residual);
        correction(t, &instance->state, x, residual, change);
        for (int j = 0; j < N_Q; j++) x[j] += change[j];
        if (largest(N_V, change) <= ROUNDING * (1 + largest(N_Q, x))) break;
    }
    residuals(t, &instance->state, x, 0, residual);
    correction(t, &instance->state, x, residual, change);
    for (int j = 0; j < N_V; j++) x[N_Q + j] += change[j];
    if (i < MAX_CORRECTIONS && is_finite(N_X, x)) return OK;
    failed(instance, t, "no position was found that the constraints allow");
    return ERROR;
#else
    (void)instance, (void)t, (void)x;
    return OK;
#endif
}

/* How far x is off the constraints. */
static double drift(const State *state) {
#if N_ROWS > 0
    double residual[N_ROWS];
    residuals(state->t, state, state->x, 1, residual);
    double of_positions = largest(N_ROWS, residual);
    residuals(state->t, state, state->x, 0, residual);
    return fmax(of_positions, largest(N_ROWS, residual));
#else
    (void)state;
    return 0;
#endif
}

/* One try of a step of length h from the present state: end in `x`; returns the error over the tolerance, infinite where `why` says that there
 * are no accelerations on the way. */
static double attempt(const Instance *instance, double h, double *x, const char **why) {
    /* Dormand and Prince, J. Comp. Appl. Math. 6 (1980): order 5 with an estimate of order 4 */
    static const double nodes[7] = {0, 1. / 5, 3. / 10, 4. / 5, 8. / 9, 1, 1};
    static const double stages[7][6] = {
        {0},
        {1. / 5},
        {3. / 40, 9. / 40},
        {44. / 45, -56. / 15, 32. / 9},
        {19372. / 6561, -25360. / 2187, 64448. / 6561, -212. / 729},
        {9017. / 3168, -355. / 33, 46732. / 5247, 49. / 176, -5103. / 18656},
        {35. / 384, 0, 500. / 1113, 125. / 192, -2187. / 6784, 11. / 84},
    };
    static const double errors[7] = {71. / 57600, 0, -71. / 16695, 71. / 1920, -17253. / 339200, 22. / 525, -1. / 40};
    const State *state = &instance->state;
    double k[7][N_X + 1], lambda[N_ROWS + 1];
    for (int stage = 0; stage < 7; stage++) {
        for (int i = 0; i < N_X; i++) {
            double sum = 0;
            for (int j = 0; j < stage; j++) sum += stages[stage][j] * k[j][i];
            x[i] = state->x[i] + h * sum;
        }
        *why = evaluate(instance, state->t + nodes[stage] * h, x, k[stage], lambda);
        if (*why) return INFINITY;
    }
    double most = 0;
    for (int i = 0; i < N_X; i++) {
        double sum = 0;
        for (int j = 0; j < 7; j++) sum += errors[j] * k[j][i];
        double scaled = fabs(h * sum) / (state->tolerance * (1 + fmax(fabs(x[i]), fabs(state->x[i]))));
        if (!(scaled <= most)) most = scaled;
    }
    return most;
}

/* Steps of co-simulation from the present state to t = end, or to where the scene ends. */
static int integrate(Instance *instance, double end) {
    State *state = &instance->state;
    const char *why = NULL;
    update_constants(state);
    while (state->t < end && !state->has_ended) {
        double x[N_X + 1], left = end - state->t;
        double h = state->step > 0 && state->step < left ? state->step : left;
        int is_last = h == left;
        if (!(state->t + h > state->t)) {
            failed(instance, state->t, why ? why : "the tolerance asks for steps below the rounding of t; give a larger one");
            return ERROR;
        }
        double error = attempt(instance, h, x, &why);
        double factor = error > 0 ? 0.9 * pow(error, -0.2) : 5;
        factor = factor > 5 ? 5 : factor < 0.2 ? 0.2 : factor;
        if (!(error <= 1)) {
            state->step = h * (isfinite(error) ? factor : 0.1);
            continue;
        }
        State before = *state;
        if (!is_last || factor < 1) state->step = h * factor;
        memcpy(state->x, x, N_X * sizeof *x);
        state->t = is_last ? end : state->t + h;
        if (project(instance, state->t, state->x) != OK) return ERROR;
        if (has_ended(state, before.event)) {
            /* the shortest step that has the end within it */
            double low = 0, high = h;
            for (int i = 0; i < MAX_HALVINGS; i++) {
                double middle = low + (high - low) / 2;
                *state = before;
                if (!isfinite(attempt(instance, middle, x, &why))) {
                    failed(instance, state->t, why ? why : "the error of a step is not finite");
                    return ERROR;
                }
                memcpy(state->x, x, N_X * sizeof *x);
                state->t += middle;
                if (project(instance, state->t, state->x) != OK) return ERROR;
                if (has_ended(state, before.event)) high = middle;
                else low = middle;
            }
            state->has_ended = 1;
        }
        remember_events(state);
        state->is_evaluated = 0;
    }
    return OK;
}

/* The values that do not come from an importer. */
static int initialize(Instance *instance) {
    State *state = &instance->state;
    update_constants(state);
    if (project(instance, state->t, state->x) != OK) return ERROR;
    remember_events(state);
    state->is_evaluated = 0;
    return refresh(instance);
}

static void reset(Instance *instance) {
    State *state = &instance->state;
    memset(state, 0, sizeof *state);
    state->tolerance = DEFAULT_TOLERANCE;
    state->t = START_TIME;
#if N_P > 0
    for (int i = 0; i < N_P; i++) state->p[i] = CALL(list_of_parameters)[i].value;
#endif
#if N_U > 0
    for (int i = 0; i < N_U; i++) state->u[i] = CALL(list_of_inputs)[i].value;
#endif
    for (int i = 0; i < N_Q; i++) state->x[i] = CALL(list_of_coordinates)[i].value;
    for (int i = 0; i < N_V; i++) state->x[N_Q + i] = CALL(list_of_velocities)[i].value;
#if N_Z > 0
    for (int i = 0; i < N_Z; i++) state->x[N_Q + N_V + i] = CALL(list_of_states)[i].value;
#endif
}

/* A tolerance below rounding is lifted to it. */
static void set_tolerance(Instance *instance, double tolerance) {
    const double least = 1e-13;
    instance->state.tolerance = tolerance >= least ? tolerance : least;
}

static int get_values(Instance *instance, const unsigned *references, size_t n, double *values) {
    State *state = &instance->state;
    for (size_t i = 0; i < n; i++) {
        unsigned of = references[i];
        if (of >= FIRST_DX && refresh(instance) != OK) return ERROR;
        if (of >= N_VALUES) {
            failed(instance, state->t, "a value that the unit does not have was asked for");
            return ERROR;
        }
#if N_EVENTS > 0
        if (of >= FIRST_EVENT) {
            double event[N_EVENTS];
            event_functions(state, event);
            values[i] = event[of - FIRST_EVENT];
            continue;
        }
#endif
        values[i] = of >= FIRST_OUTPUT   ? state->output[of - FIRST_OUTPUT]
                    : of >= FIRST_LAMBDA ? state->lambda[of - FIRST_LAMBDA]
                    : of >= FIRST_DX     ? state->dx[of - FIRST_DX]
                    : of >= FIRST_X      ? state->x[of - FIRST_X]
                    : of >= FIRST_U      ? state->u[of - FIRST_U]
                    : of >= FIRST_P      ? state->p[of - FIRST_P]
                                         : state->t;
    }
    return OK;
}

static int set_values(Instance *instance, const unsigned *references, size_t n, const double *values) {
    State *state = &instance->state;
    for (size_t i = 0; i < n; i++) {
        unsigned of = references[i];
        if (of < FIRST_P || of >= FIRST_DX || !isfinite(values[i])) {
            failed(instance, state->t, "a value that is not a parameter, an input or a state, or no finite number, was set");
            return ERROR;
        }
        double *place = of >= FIRST_X   ? &state->x[of - FIRST_X]
                        : of >= FIRST_U ? &state->u[of - FIRST_U]
                                        : &state->p[of - FIRST_P];
        if (of < FIRST_U) state->has_constants = 0;
        *place = values[i];
    }
    state->is_evaluated = 0;
    return OK;
}

/* What the derivatives of states, and outputs, change by when inputs and states change by seeds. */
static int directional_derivative(Instance *instance, const unsigned *unknowns, size_t n_unknowns, const unsigned *knowns,
                                  size_t n_knowns, const double *seeds, double *changes) {
#if HAS_DERIVATIVES
    State *state = &instance->state;
    double t = state->t, du[N_U + 1] = {0}, dx[N_X + 1] = {0};
    double change_of_a[N_V + 1], change_of_lambda[N_ROWS + 1], change_of_z[N_Z + 1], change_of_output[N_OUTPUTS + 1];
    update_constants(state);
    const double *q = state->x, *v = q + N_Q, *z = v + N_V, *u = state->u, *c = state->c;
    const double *dq = dx, *dv = dx + N_Q, *dz = dv + N_V;
    (void)z, (void)u, (void)dz, (void)du;
    for (size_t i = 0; i < n_knowns; i++) {
        if (knowns[i] >= FIRST_X && knowns[i] < FIRST_DX) dx[knowns[i] - FIRST_X] = seeds[i];
        else if (knowns[i] >= FIRST_U && knowns[i] < FIRST_X) du[knowns[i] - FIRST_U] = seeds[i];
        else return ERROR;
    }
    CALL(derivatives)(ARGUMENTS, SEEDS, change_of_a, change_of_lambda, change_of_z, change_of_output);
    for (size_t i = 0; i < n_unknowns; i++) {
        unsigned of = unknowns[i];
        if (of < FIRST_DX || of >= FIRST_EVENT) return ERROR;
        changes[i] = of >= FIRST_OUTPUT               ? change_of_output[of - FIRST_OUTPUT]
                     : of >= FIRST_LAMBDA             ? change_of_lambda[of - FIRST_LAMBDA]
                     : of >= FIRST_DX + N_Q + N_V     ? change_of_z[of - FIRST_DX - N_Q - N_V]
                     : of >= FIRST_DX + N_Q           ? change_of_a[of - FIRST_DX - N_Q]
                                                      : dv[of - FIRST_DX];
    }
    return OK;
#else
    (void)instance, (void)unknowns, (void)n_unknowns, (void)knowns, (void)n_knowns, (void)seeds, (void)changes;
    return ERROR;
#endif
}

static Instance *instantiate(const char *name, const char *token, void *environment, void *logger, int is_logging) {
    Instance *instance = calloc(1, sizeof *instance);
    if (!instance) return NULL;
    instance->environment = environment;
    instance->log_message = logger;
    instance->is_logging = is_logging;
    snprintf(instance->name, sizeof instance->name, "%s", name ? name : "");
    reset(instance);
    if (token && strcmp(token, TOKEN) == 0) return instance;
    failed(instance, 0, "the token of modelDescription.xml is not that of the library: unpack the unit anew");
    free(instance);
    return NULL;
}

static void set_time(Instance *instance, double t) {
    if (t == instance->state.t) return;
    instance->state.t = t;
    instance->state.is_evaluated = 0;
}

static int set_states(Instance *instance, const double *x, size_t n) {
    if (n != N_X || !is_finite(N_X, x)) {
        failed(instance, instance->state.t, "states that are not finite, or too few, were set");
        return ERROR;
    }
    memcpy(instance->state.x, x, N_X * sizeof *x);
    instance->state.is_evaluated = 0;
    return OK;
}

static int get_states(Instance *instance, double *x, size_t n) {
    if (n != N_X) return ERROR;
    memcpy(x, instance->state.x, N_X * sizeof *x);
    return OK;
}

static int get_derivatives(Instance *instance, double *dx, size_t n) {
    if (n != N_X || refresh(instance) != OK) return ERROR;
    memcpy(dx, instance->state.dx, N_X * sizeof *dx);
    return OK;
}

static int get_events(Instance *instance, double *event, size_t n) {
    if (n != N_EVENTS) return ERROR;
#if N_EVENTS > 0
    update_constants(&instance->state);
    event_functions(&instance->state, event);
#else
    (void)instance, (void)event;
#endif
    return OK;
}

/* Whether the states have drifted off the constraints, so that event mode is to put them back. */
static int is_astray(Instance *instance) {
    return drift(&instance->state) > DRIFT * instance->state.tolerance;
}

/* Event mode: whether the scene ends, and states on the constraints. */
static int update_discrete(Instance *instance, int *ends, int *has_moved) {
    State *state = &instance->state;
    update_constants(state);
    *ends = has_ended(state, state->event);
    *has_moved = is_astray(instance);
    if (*has_moved && project(instance, state->t, state->x) != OK) return ERROR;
    state->is_evaluated = 0;
    remember_events(state);
    return OK;
}

#if defined _WIN32
#define EXPORTED __declspec(dllexport)
#else
#define EXPORTED __attribute__((visibility("default")))
#endif

#if FMI == 2
#include "fmi2.c"
#else
#include "fmi3.c"
#endif
