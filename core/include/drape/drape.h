/* Drape: woven cloth as a dynamical system. This is the C interface of the core, and the only header that
 * other parts include.
 *
 * A cloth is opened from a scene file, advanced in time, and read through plain structs that it owns. All
 * values are in SI units. One thread at a time may use a cloth. Any number of cloths may live in one process.
 *
 * Conventions: "1" as a unit means dimensionless; strains and elongations are fractions, not per cent.
 * [count x 3] is the shape of an array, row by row. Every struct and every array that a function returns
 * belongs to the cloth.
 */
#ifndef DRAPE_H
#define DRAPE_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

typedef struct drape_cloth drape_cloth;
typedef struct drape_snapshot drape_snapshot;

typedef enum drape_status {
  DRAPE_OK = 0,
  DRAPE_DISCARD, /* the request was refused; see the function for what it leaves as it was */
  DRAPE_ERROR    /* the run failed: values are not finite, or an interval takes too many steps; the
                    cloth is back in the last good state */
} drape_status;

typedef enum drape_log_kind {
  DRAPE_LOG_ERROR,
  DRAPE_LOG_WARNING,
  DRAPE_LOG_EVENT,
  DRAPE_LOG_STABILITY
} drape_log_kind;
typedef void drape_log_fn(void* user, drape_log_kind kind, const char* message);

/* Parameters: what a user may tune while the cloth moves. The scene fixes names and counts. */

/* Force over elongation of a test strip, as straight segments from the origin through the points. */
typedef struct drape_diagram {
  int count;                /* points after the origin */
  const double* elongation; /* [count] fraction, fixed by the scene */
  double* force;            /* [count] N on the strip */
} drape_diagram;

typedef struct drape_fabric {
  const char* name;
  double areal_density;              /* kg/m^2 */
  drape_diagram warp, weft, bias;    /* count 0: no law in this direction */
  double bending_warp, bending_weft; /* N m: rigidity per width, before the Poisson factor */
  double poisson;                    /* 1, Poisson's ratio in the bending rigidity */
  double compression;                /* 1, slope of the laws below zero over that at zero */
  double damping;                    /* s, damping along the links over their stiffness */
  double friction;                   /* 1, static coefficient; the kinetic one keeps its ratio to it */
} drape_fabric;

typedef struct drape_seam_parameters {
  const char* name;
  double close; /* 1: the seam closes from now on, whatever time the scene sets for it; else 0 */
} drape_seam_parameters;

enum { DRAPE_MODE_DYNAMIC = 1, DRAPE_MODE_FIT = 2 };

typedef struct drape_parameters {
  double damping;                    /* 1/s, damping by mass */
  double gravity[3];                 /* m/s^2 */
  int has_air;                       /* 1: the scene gives the next two; above 0 they act in either case */
  double air_normal, air_tangential; /* 1, drag coefficients */
  double ramp;                       /* s, parameter_ramp: time in which tuned values reach their targets */
  double step_max;                   /* s, upper bound of the time step; fixed after the first step */
  double threads; /* number of threads that share a step, a whole number; results are the same bit for bit;
                     fixed after the first step */
  double mode;    /* DRAPE_MODE_DYNAMIC or DRAPE_MODE_FIT, as the scene has it; no other value is taken */
  int fabric_count;
  drape_fabric* fabric; /* [fabric_count] */
  int seam_count;
  drape_seam_parameters* seam; /* [seam_count] */
} drape_parameters;

/* Inputs: what the outside world does with the cloth. Each value is the one to reach at the end of the next
 * drape_advance. */
enum { DRAPE_DRIVE_POSITION = 1, DRAPE_DRIVE_VELOCITY = 2 };

typedef struct drape_pin_input {
  const char* name;
  int drive;                  /* bits DRAPE_DRIVE_POSITION, DRAPE_DRIVE_VELOCITY: which values act */
  int clamp;                  /* 1: the rotation acts too */
  double position[3];         /* m */
  double orientation[4];      /* w, x, y, z: quaternion of the rotation since the start; any length above 0 */
  double velocity[3];         /* m/s */
  double angular_velocity[3]; /* rad/s */
} drape_pin_input;

typedef struct drape_inputs {
  int has_wind;   /* 1: the scene has air */
  double wind[3]; /* m/s */
  int pin_count;
  drape_pin_input* pin; /* [pin_count] the driven pins */
  int body_count;
  drape_pin_input* body; /* [body_count] the bodies that move; their orientations are relative to space */
} drape_inputs;

/* Outputs: the state of a cloth at the present time. */
typedef struct drape_strain {
  double min, max, mean; /* fraction, over the links of one direction; the mean is weighted by area */
} drape_strain;

typedef struct drape_probe {
  const char* name;
  double position[3], velocity[3]; /* m, m/s */
} drape_probe;

typedef struct drape_pin {
  const char* name;
  double force[3];  /* N, on the outside world: impulse in the last drape_advance divided by its length */
  double torque[3]; /* N m, likewise, about the pin's present position */
} drape_pin;

typedef struct drape_seam {
  const char* name;
  int pair_count; /* pairs of particles */
  double side[2]; /* m, lengths of both sides before they are sewn */
  double gap_max; /* m, largest gap between the particles of a pair */
  double closed;  /* 1 where all pairs are sewn and no gap above the tolerance is left, else 0 */
  int due;        /* 1 once it has been told to close, by the scene's time or by its parameter, else 0 */
  double length;  /* m, along the middle line of both sides */
} drape_seam;

typedef struct drape_body {
  const char* name;
  double force[3];  /* N, of the cloth on the body: impulse in the last drape_advance over its length */
  double torque[3]; /* N m, likewise, about the body's present origin */
} drape_body;

typedef struct drape_energy { /* J; only with scene.energy */
  double kinetic, stretch, shear, bending, gravity, contact;
  double dissipated, input, balance_error; /* since the start; only with has_balance */
} drape_energy;

typedef struct drape_outputs {
  drape_strain strain_warp, strain_weft, strain_bias; /* fraction */
  double tension_max;                                 /* N/m, largest tension per width */
  double strain_beyond_test_count;                    /* links beyond the last point of their diagram */
  double step_size, step_count, step_stability;       /* s, 1, h omega_max over its limit (2) */
  int has_fit;                                        /* 1: scene.mode = "fit" */
  double fit_residual;                                /* 1, sum of the unbalanced forces over the load */
  int has_energy;                                     /* 1: scene.energy */
  int has_balance;                                    /* 1: the energy balance is computed; 0 in fit mode */
  drape_energy energy;
  int probe_count;
  drape_probe* probe; /* [probe_count] */
  int pin_count;
  drape_pin* pin; /* [pin_count] */
  int seam_count;
  drape_seam* seam; /* [seam_count] */
  int body_count;
  drape_body* body;           /* [body_count] */
  int has_self_contact;       /* 1: scene.self_contact */
  double contact_count;       /* particles that touch a body, links and cells that touch its sharp features,
                                 and pairs of self contact */
  double contact_penetration; /* m, largest depth by which the cloth's thickness is compressed */
  double contact_pressure;    /* Pa, the largest; on bodies, stop impulses included */
  int node_count;             /* particles of all pieces in order, row by row */
  double* node_position;      /* [node_count x 3] m; NULL until first computed */
  double* node_velocity;      /* [node_count x 3] m/s, at the time of the positions; NULL until computed */
} drape_outputs;

/* A piece in two forms: as particles with the cells between them, and as polygons that follow its outline. A
 * corner of a polygon is a particle or, where the outline runs between particles, a point that moves with
 * four of them. Points are numbered after the particles of all pieces: point k of this piece is corner
 * point_first + k. */
typedef struct drape_piece {
  const char* name;
  double cell;    /* m, cell size b */
  int node_first; /* index of its first particle in drape_outputs.node_position */
  int node_count;
  const double* rest; /* [node_count x 2] m, in the piece's plane */
  int cell_count;
  const int* corner; /* [cell_count x 4] particles, counter-clockwise */
  int point_first;   /* number of the first point, as a corner */
  int point_count;
  const int* point_node;      /* [point_count x 4] particles */
  const double* point_weight; /* [point_count x 4] a point's position is the sum of weight times particle
                                 position; velocities likewise */
  int polygon_count;
  const int* polygon_end;    /* [polygon_count] index in polygon_corner one past the last corner */
  const int* polygon_corner; /* particles and points, counter-clockwise */
  int cut_count;             /* cells that the outline cuts */
  int merged_count;          /* parts too small for a cell of their own, merged into a neighbour */
  int twin_count;            /* particles that share their rest position with another particle */
  double area;               /* m^2 */
  int fabric;                /* index in drape_parameters.fabric */
} drape_piece;

/* Fields over the cloth. Strain and tension of a particle are means over the links that end at it, weighted
 * by link width. */
typedef struct drape_fields {
  int node_count;         /* as in drape_outputs */
  const double* strain;   /* [node_count x 3] fraction; warp, weft, bias */
  const double* tension;  /* [node_count x 2] N/m; warp, weft */
  const double* pressure; /* [node_count] Pa, of contact with bodies */
  const double* area;     /* [node_count] m^2 */
} drape_fields;

typedef enum drape_yarn_direction { DRAPE_WARP, DRAPE_WEFT, DRAPE_BIAS } drape_yarn_direction;
typedef struct drape_elongation {
  drape_strain strain; /* over the links of one direction of a piece */
  double tension_max;  /* N/m; 0 for the bias direction */
  double limit;        /* strain, fraction */
  double beyond;       /* fraction of the piece's area whose strain exceeds the limit */
} drape_elongation;

/* The particles of a seam's two sides, pair by pair. */
typedef struct drape_seam_lines {
  int pair_count;
  int loop;            /* 1: the seam is closed in a ring, the first pair follows the last */
  const double *a, *b; /* [pair_count x 3] m, positions on either side */
} drape_seam_lines;

/* A body's mesh at its present pose. */
typedef struct drape_surface {
  const char* name;
  int moves; /* 1: its pose is an input */
  int point_count;
  const double* point; /* [point_count x 3] m */
  int triangle_count;
  const int* corner; /* [triangle_count x 3] counter-clockwise from outside */
} drape_surface;

/* Reads, checks and assembles a scene. On invalid input it returns NULL and logs one DRAPE_LOG_ERROR message
 * per problem. The cloth uses the log function for its whole life; NULL: no log. */
drape_cloth* drape_open(const char* scene_file, drape_log_fn* log, void* user);
void drape_close(drape_cloth*);

/* Scene facts. The scene text contains every file that the scene names, except the meshes of bodies. Saved as
 * a scene file, with the meshes in the same folder, it gives the same cloth. */
const char* drape_scene_name(const drape_cloth*);
const char* drape_scene_text(const drape_cloth*);
typedef struct drape_about {
  const char *description, *author, *version, *copyright, *license; /* of the scene; "" where it has none */
} drape_about;
drape_about drape_scene_about(const drape_cloth*);
double drape_duration(const drape_cloth*);      /* s, scene.duration */
double drape_communication(const drape_cloth*); /* s, scene.communication */
/* The files that the scene text names, 0 <= index < drape_file_count: the present path of each, and the name
 * it must have next to the text. */
int drape_file_count(const drape_cloth*);
const char* drape_file_path(const drape_cloth*, int index);
const char* drape_file_name(const drape_cloth*, int index);
/* 0 <= index < drape_piece_count. The arrays keep their addresses for the cloth's life. */
int drape_piece_count(const drape_cloth*);
drape_piece drape_piece_at(drape_cloth*, int index);

/* Parameters: write into the returned struct, then commit. The struct and its arrays keep their addresses for
 * the cloth's life. A commit checks all values, one by one and in combination. DRAPE_DISCARD: each problem
 * has been logged; every invalid part (a value, a diagram, or a fabric for which no time step is possible) is
 * reset to the values in force, and the rest is applied. drape_advance commits by itself. */
drape_parameters* drape_parameters_of(drape_cloth*);
drape_status drape_commit(drape_cloth*);

/* Inputs: write into the returned struct, which with its arrays keeps its address for the cloth's life. The
 * next drape_advance moves from the present values to the written ones. Rates are the time derivatives of the
 * values at the beginning of the next advance: the value reached is value + length x rate. A completed
 * advance sets the rates to 0. drape_inputs_start, before the first advance: the wind written so far becomes
 * the wind at the start; without that call it is the scene's. */
drape_inputs* drape_inputs_of(drape_cloth*);
void drape_inputs_start(drape_cloth*);
drape_inputs* drape_input_rates_of(drape_cloth*);

/* 1 once a cloth in fit mode has reached its equilibrium, where it stays; else 0. */
int drape_at_rest(const drape_cloth*);

/* What the energy guard has missed so far. 0 where it does not watch: in wind and fits, with bodies,
 * self-contact or rigid links. */
typedef struct drape_unaccounted {
  double energy; /* J, at the time where it was largest: gained, or lost where negative */
  double
      largest; /* J, the largest energy of the cloth by then: kinetic, elastic, change of gravity's, work */
  double time; /* s */
  double allowed; /* 1, share of the largest energy */
} drape_unaccounted;
drape_unaccounted drape_energy_unaccounted(drape_cloth*);

/* Sets the clock to the start time, s. Only before the first step. */
drape_status drape_start(drape_cloth*, double time);
double drape_time(const drape_cloth*); /* s */

/* Advances the cloth by `length` seconds: above 0, finite, at most 1e9 communication intervals.
 * DRAPE_DISCARD: the length, a parameter or an input is invalid (invalid values are reset, as by
 * drape_commit), or the step limit fell below the scene's fixed step; time has not advanced. DRAPE_ERROR: the
 * run failed, and the cloth is back in the state before the call. Each problem has been logged. */
drape_status drape_advance(drape_cloth*, double length);

/* 1 where the last drape_commit or drape_advance did what was asked, but took a value that may surprise: a
 * tuned value that shortens the time step by more than ten times, or an orientation of length 0, which is
 * kept as it was. Each has been logged as a DRAPE_LOG_WARNING. Else 0. */
int drape_surprised(const drape_cloth*);

/* 1 where the last advance was refused because the step limit had fallen below the scene's fixed step. The
 * same advance would be refused again. Else 0. */
int drape_step_above_limit(const drape_cloth*);

/* Bits of a mask: groups of outputs. Velocities and energies need the forces of the present time, which cost
 * about as much as one step. Positions cost next to nothing. */
enum {
  DRAPE_OUT_POSITION = 1,       /* positions of probes; seams */
  DRAPE_OUT_VELOCITY = 2,       /* velocities of probes; loads of pins and of bodies */
  DRAPE_OUT_STRAIN = 4,         /* strains, tension, time step, contact summary, residual of a fit */
  DRAPE_OUT_ENERGY = 8,         /* energies, where the scene asks for them */
  DRAPE_OUT_SCALARS = 15,       /* all of the above: everything but the node arrays */
  DRAPE_OUT_NODE_POSITION = 16, /* node_position */
  DRAPE_OUT_NODE_VELOCITY = 32, /* node_velocity */
  DRAPE_OUT_ALL = 63
};

/* The outputs at the present time. Only the groups in `mask` are computed; the others keep what they held.
 * The values are valid until the next call that takes a non-const cloth; the struct and its arrays keep their
 * addresses for the cloth's life. Reading outputs never changes the motion. */
const drape_outputs* drape_get_outputs(drape_cloth*, int mask);

/* The present state for pictures and reports, computed at each call and valid until the next call of the same
 * function. A limit below 0 stands for the last tested elongation of the direction, infinite where the
 * direction has no law. */
const drape_fields* drape_fields_at(drape_cloth*);
drape_elongation drape_elongation_of(drape_cloth*, int piece, drape_yarn_direction along, double limit);
drape_seam_lines drape_seam_lines_at(drape_cloth*, int index);
drape_surface drape_surface_at(drape_cloth*, int index);

/* The step limit at the present state, s, without the safety factor. `set_by`, unless NULL, receives the name
 * of the link that sets the limit. */
double drape_step_limit(drape_cloth*, const char** set_by);

/* How far a long advance has come. A function that is set here is called in drape_advance, by its thread,
 * before each communication interval. It may call drape_progress_of, and nothing else of this cloth. NULL:
 * none. */
typedef struct drape_progress {
  double time;        /* s */
  double step_size;   /* s, present time step */
  const char* set_by; /* the link, or node near a body, that sets the step; "" in a fit, whose step stays */
  double residual;    /* 1, of a fit, as last computed; 0 before */
  int seams_open;     /* seams that have been told to close and have not closed */
} drape_progress;
typedef void drape_interval_fn(void* user);
void drape_on_interval(drape_cloth*, drape_interval_fn*, void* user);
drape_progress drape_progress_of(drape_cloth*); /* costs a pass over all links */

/* Copies of the whole state: motion, clock, parameters in force and written, inputs. drape_save reuses `into`
 * unless it is NULL. */
drape_snapshot* drape_save(drape_cloth*, drape_snapshot* into);
void drape_restore(drape_cloth*, const drape_snapshot*);
void drape_snapshot_free(drape_snapshot*);

/* A copy as bytes, for a file or another process. `c` is the cloth that made the copy or that is to take it,
 * opened from the same scene with the same meshes. drape_snapshot_write fills drape_snapshot_size bytes.
 * drape_snapshot_read returns a new copy for drape_restore. Bytes that are cut, damaged, or of another scene
 * or layout give NULL and one DRAPE_LOG_ERROR message; the cloth stays as it was. A caller's own bytes can be
 * attached to a copy, and travel with it. Run on from there, a cloth moves with the same bits as if it had
 * never stopped. */
size_t drape_snapshot_size(const drape_snapshot*);
void drape_snapshot_write(drape_cloth* c, const drape_snapshot*, void* bytes);
drape_snapshot* drape_snapshot_read(drape_cloth* c, const void* bytes, size_t size);
void drape_snapshot_attach(drape_snapshot*, const void* bytes, size_t size);
const void* drape_snapshot_attached(const drape_snapshot*, size_t* size);

const char* drape_version(void);

#ifdef __cplusplus
}
#endif
#endif
