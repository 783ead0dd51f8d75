/* The functions of FMI 3.0, https://fmi-standard.org; types as its headers name them. Licence: MIT OR Apache-2.0. */

#include <stdbool.h>
#include <stdint.h>

typedef uint32_t fmi3ValueReference;
typedef int fmi3Status;
typedef const char *fmi3String;
typedef void (*fmi3LogMessageCallback)(void *environment, fmi3Status status, fmi3String category, fmi3String message);

static void log_message(Instance *instance, int status, const char *text) {
    fmi3LogMessageCallback logger;
    memcpy(&logger, &instance->log_message, sizeof logger);
    if (logger) logger(instance->environment, status, status == ERROR ? "logStatusError" : "logStatusWarning", text);
}

/* A function that the unit has no use for. */
#define NOT_THERE(name, ...) \
    EXPORTED fmi3Status name(void *of, __VA_ARGS__) { return failed(of, ((Instance *)of)->state.t, #name " is not supported"), ERROR; }
/* Values of types that the unit has none of: no value is fine. */
#define NO_VALUES(name, type) \
    EXPORTED fmi3Status name(void *of, const fmi3ValueReference *references, size_t n, type *values, size_t n_values) { \
        (void)references, (void)values, (void)n_values; \
        return n == 0 ? OK : (failed(of, ((Instance *)of)->state.t, #name ": all values of the unit are Float64"), ERROR); \
    }

EXPORTED const char *fmi3GetVersion(void) { return "3.0"; }

EXPORTED fmi3Status fmi3SetDebugLogging(void *of, bool is_on, size_t n, const fmi3String *categories) {
    (void)n, (void)categories;
    ((Instance *)of)->is_logging = is_on;
    return OK;
}

static void *instantiate3(fmi3String name, fmi3String token, void *environment, fmi3LogMessageCallback logger, bool is_logging) {
    void *callback;
    memcpy(&callback, &logger, sizeof callback);
    return instantiate(name, token, environment, callback, is_logging);
}

EXPORTED void *fmi3InstantiateModelExchange(fmi3String name, fmi3String token, fmi3String resources, bool is_visible, bool is_logging,
                                            void *environment, fmi3LogMessageCallback logger) {
    (void)resources, (void)is_visible;
    return instantiate3(name, token, environment, logger, is_logging);
}

EXPORTED void *fmi3InstantiateCoSimulation(fmi3String name, fmi3String token, fmi3String resources, bool is_visible, bool is_logging,
                                           bool has_event_mode, bool may_return_early, const fmi3ValueReference *intermediate,
                                           size_t n_intermediate, void *environment, fmi3LogMessageCallback logger, void *update) {
    (void)resources, (void)is_visible, (void)has_event_mode, (void)may_return_early, (void)intermediate, (void)n_intermediate, (void)update;
    return instantiate3(name, token, environment, logger, is_logging);
}

EXPORTED void *fmi3InstantiateScheduledExecution(fmi3String name, fmi3String token, fmi3String resources, bool is_visible, bool is_logging,
                                                 void *environment, fmi3LogMessageCallback logger, void *clock, void *lock, void *unlock) {
    (void)name, (void)token, (void)resources, (void)is_visible, (void)is_logging, (void)clock, (void)lock, (void)unlock;
    if (logger) logger(environment, ERROR, "logStatusError", SCENE_NAME ": the unit has no scheduled execution");
    return NULL;
}

EXPORTED void fmi3FreeInstance(void *of) { free(of); }

EXPORTED fmi3Status fmi3EnterInitializationMode(void *of, bool has_tolerance, double tolerance, double start, bool has_stop, double stop) {
    (void)has_stop, (void)stop;
    if (has_tolerance) set_tolerance(of, tolerance);
    ((Instance *)of)->state.t = start;
    return OK;
}
EXPORTED fmi3Status fmi3ExitInitializationMode(void *of) { return initialize(of); }
EXPORTED fmi3Status fmi3Terminate(void *of) { return (void)of, OK; }
EXPORTED fmi3Status fmi3Reset(void *of) { return reset(of), OK; }
EXPORTED fmi3Status fmi3EnterConfigurationMode(void *of) { return (void)of, OK; }
EXPORTED fmi3Status fmi3ExitConfigurationMode(void *of) { return (void)of, OK; }

EXPORTED fmi3Status fmi3GetFloat64(void *of, const fmi3ValueReference *references, size_t n, double *values, size_t n_values) {
    return n_values == n ? get_values(of, references, n, values) : ERROR;
}
EXPORTED fmi3Status fmi3SetFloat64(void *of, const fmi3ValueReference *references, size_t n, const double *values, size_t n_values) {
    return n_values == n ? set_values(of, references, n, values) : ERROR;
}
NO_VALUES(fmi3GetFloat32, float)
NO_VALUES(fmi3GetInt8, int8_t)
NO_VALUES(fmi3GetUInt8, uint8_t)
NO_VALUES(fmi3GetInt16, int16_t)
NO_VALUES(fmi3GetUInt16, uint16_t)
NO_VALUES(fmi3GetInt32, int32_t)
NO_VALUES(fmi3GetUInt32, uint32_t)
NO_VALUES(fmi3GetInt64, int64_t)
NO_VALUES(fmi3GetUInt64, uint64_t)
NO_VALUES(fmi3GetBoolean, bool)
NO_VALUES(fmi3GetString, fmi3String)
NO_VALUES(fmi3SetFloat32, const float)
NO_VALUES(fmi3SetInt8, const int8_t)
NO_VALUES(fmi3SetUInt8, const uint8_t)
NO_VALUES(fmi3SetInt16, const int16_t)
NO_VALUES(fmi3SetUInt16, const uint16_t)
NO_VALUES(fmi3SetInt32, const int32_t)
NO_VALUES(fmi3SetUInt32, const uint32_t)
NO_VALUES(fmi3SetInt64, const int64_t)
NO_VALUES(fmi3SetUInt64, const uint64_t)
NO_VALUES(fmi3SetBoolean, const bool)
NO_VALUES(fmi3SetString, const fmi3String)
NOT_THERE(fmi3GetBinary, const fmi3ValueReference *a, size_t b, size_t *c, const uint8_t **d, size_t e)
NOT_THERE(fmi3SetBinary, const fmi3ValueReference *a, size_t b, const size_t *c, const uint8_t *const *d, size_t e)
NOT_THERE(fmi3GetClock, const fmi3ValueReference *a, size_t b, bool *c)
NOT_THERE(fmi3SetClock, const fmi3ValueReference *a, size_t b, const bool *c)
NOT_THERE(fmi3GetIntervalDecimal, const fmi3ValueReference *a, size_t b, double *c, int *d)
NOT_THERE(fmi3GetIntervalFraction, const fmi3ValueReference *a, size_t b, uint64_t *c, uint64_t *d, int *e)
NOT_THERE(fmi3GetShiftDecimal, const fmi3ValueReference *a, size_t b, double *c)
NOT_THERE(fmi3GetShiftFraction, const fmi3ValueReference *a, size_t b, uint64_t *c, uint64_t *d)
NOT_THERE(fmi3SetIntervalDecimal, const fmi3ValueReference *a, size_t b, const double *c)
NOT_THERE(fmi3SetIntervalFraction, const fmi3ValueReference *a, size_t b, const uint64_t *c, const uint64_t *d)
NOT_THERE(fmi3SetShiftDecimal, const fmi3ValueReference *a, size_t b, const double *c)
NOT_THERE(fmi3SetShiftFraction, const fmi3ValueReference *a, size_t b, const uint64_t *c, const uint64_t *d)
NOT_THERE(fmi3GetNumberOfVariableDependencies, fmi3ValueReference a, size_t *b)
NOT_THERE(fmi3GetVariableDependencies, fmi3ValueReference a, size_t *b, fmi3ValueReference *c, size_t *d, int *e, size_t f)
NOT_THERE(fmi3ActivateModelPartition, fmi3ValueReference a, double b)
NOT_THERE(fmi3GetOutputDerivatives, const fmi3ValueReference *a, size_t b, const int32_t *c, double *d, size_t e)
NOT_THERE(fmi3GetAdjointDerivative, const fmi3ValueReference *a, size_t b, const fmi3ValueReference *c, size_t d, const double *e, size_t f,
          double *g, size_t h)

EXPORTED fmi3Status fmi3GetFMUState(void *of, void **saved) {
    if (!*saved) *saved = malloc(sizeof(State));
    if (!*saved) return ERROR;
    memcpy(*saved, &((Instance *)of)->state, sizeof(State));
    return OK;
}
EXPORTED fmi3Status fmi3SetFMUState(void *of, void *saved) {
    memcpy(&((Instance *)of)->state, saved, sizeof(State));
    return OK;
}
EXPORTED fmi3Status fmi3FreeFMUState(void *of, void **saved) {
    (void)of;
    if (saved) free(*saved), *saved = NULL;
    return OK;
}
EXPORTED fmi3Status fmi3SerializedFMUStateSize(void *of, void *saved, size_t *size) {
    (void)of, (void)saved;
    *size = sizeof(State);
    return OK;
}
EXPORTED fmi3Status fmi3SerializeFMUState(void *of, void *saved, uint8_t *bytes, size_t size) {
    if (size < sizeof(State)) return failed(of, 0, "too few bytes for a saved state"), ERROR;
    memcpy(bytes, saved, sizeof(State));
    return OK;
}
EXPORTED fmi3Status fmi3DeserializeFMUState(void *of, const uint8_t *bytes, size_t size, void **saved) {
    if (size != sizeof(State)) return failed(of, 0, "these bytes are not a state of this unit"), ERROR;
    if (!*saved) *saved = malloc(sizeof(State));
    if (!*saved) return ERROR;
    memcpy(*saved, bytes, sizeof(State));
    return OK;
}

EXPORTED fmi3Status fmi3GetDirectionalDerivative(void *of, const fmi3ValueReference *unknowns, size_t n_unknowns, const fmi3ValueReference *knowns,
                                                 size_t n_knowns, const double *seeds, size_t n_seeds, double *changes, size_t n_changes) {
    if (n_seeds != n_knowns || n_changes != n_unknowns) return ERROR;
    return directional_derivative(of, unknowns, n_unknowns, knowns, n_knowns, seeds, changes);
}

EXPORTED fmi3Status fmi3EnterEventMode(void *of) { return (void)of, OK; }
EXPORTED fmi3Status fmi3EvaluateDiscreteStates(void *of) { return (void)of, OK; }
EXPORTED fmi3Status fmi3UpdateDiscreteStates(void *of, bool *needs_update, bool *ends, bool *nominals_changed, bool *states_changed,
                                             bool *has_next, double *next) {
    int is_over = 0, has_moved = 0, status = update_discrete(of, &is_over, &has_moved);
    *needs_update = *nominals_changed = *has_next = false;
    *next = 0;
    *ends = is_over;
    *states_changed = has_moved;
    return status;
}

/* Model exchange. */

EXPORTED fmi3Status fmi3EnterContinuousTimeMode(void *of) { return (void)of, OK; }
EXPORTED fmi3Status fmi3CompletedIntegratorStep(void *of, bool no_return, bool *event_mode, bool *ends) {
    (void)no_return;
    *ends = false;
    *event_mode = is_astray(of);
    return OK;
}
EXPORTED fmi3Status fmi3SetTime(void *of, double t) { return set_time(of, t), OK; }
EXPORTED fmi3Status fmi3SetContinuousStates(void *of, const double *x, size_t n) { return set_states(of, x, n); }
EXPORTED fmi3Status fmi3GetContinuousStateDerivatives(void *of, double *dx, size_t n) { return get_derivatives(of, dx, n); }
EXPORTED fmi3Status fmi3GetEventIndicators(void *of, double *values, size_t n) { return get_events(of, values, n); }
EXPORTED fmi3Status fmi3GetContinuousStates(void *of, double *x, size_t n) { return get_states(of, x, n); }
EXPORTED fmi3Status fmi3GetNominalsOfContinuousStates(void *of, double *x, size_t n) {
    (void)of;
    for (size_t i = 0; i < n; i++) x[i] = 1;
    return OK;
}
EXPORTED fmi3Status fmi3GetNumberOfEventIndicators(void *of, size_t *n) { return (void)of, *n = N_EVENTS, OK; }
EXPORTED fmi3Status fmi3GetNumberOfContinuousStates(void *of, size_t *n) { return (void)of, *n = N_X, OK; }

/* Co-simulation. */

EXPORTED fmi3Status fmi3EnterStepMode(void *of) { return (void)of, OK; }
EXPORTED fmi3Status fmi3DoStep(void *of, double t, double step, bool no_return, bool *needs_event, bool *ends, bool *is_early, double *reached) {
    (void)no_return;
    Instance *instance = of;
    set_time(instance, t);
    int status = integrate(instance, t + step);
    *needs_event = *is_early = false;
    *ends = instance->state.has_ended;
    *reached = instance->state.t;
    return status;
}
