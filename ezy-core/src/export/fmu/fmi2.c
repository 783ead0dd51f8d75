/* The functions of FMI 2.0.4, https://fmi-standard.org; types as its headers name them. Licence: MIT OR Apache-2.0. */

typedef unsigned fmi2ValueReference;
typedef double fmi2Real;
typedef int fmi2Integer;
typedef int fmi2Boolean;
typedef const char *fmi2String;
typedef char fmi2Byte;
typedef int fmi2Status;

typedef struct {
    void (*logger)(void *environment, fmi2String name, fmi2Status status, fmi2String category, fmi2String message, ...);
    void *(*allocateMemory)(size_t n, size_t size);
    void (*freeMemory)(void *place);
    void (*stepFinished)(void *environment, fmi2Status status);
    void *componentEnvironment;
} fmi2CallbackFunctions;

typedef struct {
    fmi2Boolean newDiscreteStatesNeeded, terminateSimulation, nominalsOfContinuousStatesChanged, valuesOfContinuousStatesChanged;
    fmi2Boolean nextEventTimeDefined;
    fmi2Real nextEventTime;
} fmi2EventInfo;

static void log_message(Instance *instance, int status, const char *text) {
    const fmi2CallbackFunctions *functions = instance->log_message;
    const char *category = status == ERROR ? "logStatusError" : "logStatusWarning";
    if (functions && functions->logger)
        functions->logger(functions->componentEnvironment, instance->name, status, category, "%s", text);
}

/* A function that the unit has no use for. */
#define NOT_THERE(name, ...) \
    EXPORTED fmi2Status name(void *of, __VA_ARGS__) { return failed(of, ((Instance *)of)->state.t, #name " is not supported"), ERROR; }
/* Values of types that the unit has none of: no value is fine. */
#define NO_VALUES(name, type) \
    EXPORTED fmi2Status name(void *of, const fmi2ValueReference *references, size_t n, type *values) { \
        (void)references, (void)values; \
        return n == 0 ? OK : (failed(of, ((Instance *)of)->state.t, #name ": all values of the unit are real"), ERROR); \
    }

EXPORTED const char *fmi2GetTypesPlatform(void) { return "default"; }
EXPORTED const char *fmi2GetVersion(void) { return "2.0"; }

EXPORTED fmi2Status fmi2SetDebugLogging(void *of, fmi2Boolean is_on, size_t n, const fmi2String *categories) {
    (void)n, (void)categories;
    ((Instance *)of)->is_logging = is_on;
    return OK;
}

EXPORTED void *fmi2Instantiate(fmi2String name, int kind, fmi2String token, fmi2String resources,
                               const fmi2CallbackFunctions *functions, fmi2Boolean is_visible, fmi2Boolean is_logging) {
    (void)kind, (void)resources, (void)is_visible;
    return instantiate(name, token, NULL, (void *)functions, is_logging);
}

EXPORTED void fmi2FreeInstance(void *of) { free(of); }

EXPORTED fmi2Status fmi2SetupExperiment(void *of, fmi2Boolean has_tolerance, fmi2Real tolerance, fmi2Real start, fmi2Boolean has_stop, fmi2Real stop) {
    (void)has_stop, (void)stop;
    if (has_tolerance) set_tolerance(of, tolerance);
    ((Instance *)of)->state.t = start;
    return OK;
}

EXPORTED fmi2Status fmi2EnterInitializationMode(void *of) { return (void)of, OK; }
EXPORTED fmi2Status fmi2ExitInitializationMode(void *of) { return initialize(of); }
EXPORTED fmi2Status fmi2Terminate(void *of) { return (void)of, OK; }
EXPORTED fmi2Status fmi2Reset(void *of) { return reset(of), OK; }

EXPORTED fmi2Status fmi2GetReal(void *of, const fmi2ValueReference *references, size_t n, fmi2Real *values) {
    return get_values(of, references, n, values);
}
EXPORTED fmi2Status fmi2SetReal(void *of, const fmi2ValueReference *references, size_t n, const fmi2Real *values) {
    return set_values(of, references, n, values);
}
NO_VALUES(fmi2GetInteger, fmi2Integer)
NO_VALUES(fmi2GetBoolean, fmi2Boolean)
NO_VALUES(fmi2GetString, fmi2String)
NO_VALUES(fmi2SetInteger, const fmi2Integer)
NO_VALUES(fmi2SetBoolean, const fmi2Boolean)
NO_VALUES(fmi2SetString, const fmi2String)

EXPORTED fmi2Status fmi2GetFMUstate(void *of, void **saved) {
    if (!*saved) *saved = malloc(sizeof(State));
    if (!*saved) return ERROR;
    memcpy(*saved, &((Instance *)of)->state, sizeof(State));
    return OK;
}
EXPORTED fmi2Status fmi2SetFMUstate(void *of, void *saved) {
    memcpy(&((Instance *)of)->state, saved, sizeof(State));
    return OK;
}
EXPORTED fmi2Status fmi2FreeFMUstate(void *of, void **saved) {
    (void)of;
    if (saved) free(*saved), *saved = NULL;
    return OK;
}
EXPORTED fmi2Status fmi2SerializedFMUstateSize(void *of, void *saved, size_t *size) {
    (void)of, (void)saved;
    *size = sizeof(State);
    return OK;
}
EXPORTED fmi2Status fmi2SerializeFMUstate(void *of, void *saved, fmi2Byte *bytes, size_t size) {
    if (size < sizeof(State)) return failed(of, 0, "too few bytes for a saved state"), ERROR;
    memcpy(bytes, saved, sizeof(State));
    return OK;
}
EXPORTED fmi2Status fmi2DeSerializeFMUstate(void *of, const fmi2Byte *bytes, size_t size, void **saved) {
    if (size != sizeof(State)) return failed(of, 0, "these bytes are not a state of this unit"), ERROR;
    if (!*saved) *saved = malloc(sizeof(State));
    if (!*saved) return ERROR;
    memcpy(*saved, bytes, sizeof(State));
    return OK;
}

EXPORTED fmi2Status fmi2GetDirectionalDerivative(void *of, const fmi2ValueReference *unknowns, size_t n_unknowns,
                                                 const fmi2ValueReference *knowns, size_t n_knowns, const fmi2Real *seeds, fmi2Real *changes) {
    return directional_derivative(of, unknowns, n_unknowns, knowns, n_knowns, seeds, changes);
}

/* Model exchange. */

EXPORTED fmi2Status fmi2EnterEventMode(void *of) { return (void)of, OK; }

EXPORTED fmi2Status fmi2NewDiscreteStates(void *of, fmi2EventInfo *info) {
    memset(info, 0, sizeof *info);
    return update_discrete(of, &info->terminateSimulation, &info->valuesOfContinuousStatesChanged);
}

EXPORTED fmi2Status fmi2EnterContinuousTimeMode(void *of) { return (void)of, OK; }

EXPORTED fmi2Status fmi2CompletedIntegratorStep(void *of, fmi2Boolean no_return, fmi2Boolean *event_mode, fmi2Boolean *ends) {
    (void)no_return;
    *ends = 0;
    *event_mode = is_astray(of);
    return OK;
}

EXPORTED fmi2Status fmi2SetTime(void *of, fmi2Real t) { return set_time(of, t), OK; }
EXPORTED fmi2Status fmi2SetContinuousStates(void *of, const fmi2Real *x, size_t n) { return set_states(of, x, n); }
EXPORTED fmi2Status fmi2GetDerivatives(void *of, fmi2Real *dx, size_t n) { return get_derivatives(of, dx, n); }
EXPORTED fmi2Status fmi2GetEventIndicators(void *of, fmi2Real *values, size_t n) { return get_events(of, values, n); }
EXPORTED fmi2Status fmi2GetContinuousStates(void *of, fmi2Real *x, size_t n) { return get_states(of, x, n); }
EXPORTED fmi2Status fmi2GetNominalsOfContinuousStates(void *of, fmi2Real *x, size_t n) {
    (void)of;
    for (size_t i = 0; i < n; i++) x[i] = 1;
    return OK;
}

/* Co-simulation. */

NOT_THERE(fmi2SetRealInputDerivatives, const fmi2ValueReference *a, size_t b, const fmi2Integer *c, const fmi2Real *d)
NOT_THERE(fmi2GetRealOutputDerivatives, const fmi2ValueReference *a, size_t b, const fmi2Integer *c, fmi2Real *d)

EXPORTED fmi2Status fmi2DoStep(void *of, fmi2Real t, fmi2Real step, fmi2Boolean no_return) {
    (void)no_return;
    Instance *instance = of;
    set_time(instance, t);
    if (integrate(instance, t + step) != OK) return ERROR;
    return instance->state.has_ended ? DISCARD : OK;
}
EXPORTED fmi2Status fmi2CancelStep(void *of) { return failed(of, ((Instance *)of)->state.t, "steps cannot be cancelled"), ERROR; }

EXPORTED fmi2Status fmi2GetRealStatus(void *of, int kind, fmi2Real *value) {
    *value = ((Instance *)of)->state.t;
    return kind == 2 ? OK : DISCARD;
}
EXPORTED fmi2Status fmi2GetBooleanStatus(void *of, int kind, fmi2Boolean *value) {
    *value = ((Instance *)of)->state.has_ended;
    return kind == 3 ? OK : DISCARD;
}
EXPORTED fmi2Status fmi2GetStatus(void *of, int kind, fmi2Status *value) { return (void)of, (void)kind, *value = OK, DISCARD; }
EXPORTED fmi2Status fmi2GetIntegerStatus(void *of, int kind, fmi2Integer *value) { return (void)of, (void)kind, *value = 0, DISCARD; }
EXPORTED fmi2Status fmi2GetStringStatus(void *of, int kind, fmi2String *value) { return (void)of, (void)kind, *value = "", DISCARD; }
