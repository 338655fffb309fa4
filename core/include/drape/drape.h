/* Drape: woven cloth as a dynamical system. The C interface of the core: the only header that other parts
 * include.
 *
 * A cloth is opened from a scene file, advanced in time, and read through plain structs that it owns. SI
 * units. One thread at a time may use a cloth; any number of cloths may live in one process.
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
  DRAPE_DISCARD, /* the request was refused; nothing changed */
  DRAPE_ERROR    /* the run left the finite numbers; the state is the last good one */
} drape_status;

typedef enum drape_log_kind {
  DRAPE_LOG_ERROR,
  DRAPE_LOG_WARNING,
  DRAPE_LOG_EVENT,
  DRAPE_LOG_STABILITY
} drape_log_kind;
typedef void drape_log_fn(void* user, drape_log_kind kind, const char* message);

/* What a user may tune while the cloth moves. Names and counts are fixed by the scene. */
typedef struct drape_diagram {
  int count;                /* points after the origin */
  const double* elongation; /* [count] fraction */
  double* force;            /* [count] N on the strip */
} drape_diagram;

typedef struct drape_fabric {
  const char* name;
  double areal_density;              /* kg/m^2 */
  drape_diagram warp, weft, bias;    /* count 0: law off */
  double bending_warp, bending_weft; /* N m per width, before the Poisson factor */
  double poisson;                    /* 1 */
  double compression;                /* 1 */
  double damping;                    /* s, of the springs */
  double friction;                   /* 1, static; the kinetic one keeps its ratio to it */
} drape_fabric;

typedef struct drape_seam_parameters {
  const char* name;
  double close; /* 1: the seam is pulled together from now on, whatever the scene's time for it; else 0 */
} drape_seam_parameters;

typedef struct drape_parameters {
  double damping;                    /* 1/s */
  double gravity[3];                 /* m/s^2 */
  int has_air;                       /* the scene has air; 0: the next two do nothing */
  double air_normal, air_tangential; /* 1 */
  double ramp;                       /* s, parameter_ramp */
  double step_max;                   /* s; fixed after the first step */
  double threads;                    /* that share a step, a whole number; changes no bit; fixed likewise */
  int fabric_count;
  drape_fabric* fabric; /* [fabric_count] */
  int seam_count;
  drape_seam_parameters* seam; /* [seam_count] */
} drape_parameters;

/* What the outside world does with the cloth: where each value is to be at the end of the next drape_advance.
 */
enum { DRAPE_DRIVE_POSITION = 1, DRAPE_DRIVE_VELOCITY = 2 };

typedef struct drape_pin_input {
  const char* name;
  int drive;                  /* bits: which of the values below act */
  int clamp;                  /* the rotation acts too */
  double position[3];         /* m */
  double orientation[4];      /* w, x, y, z: the rotation since the start; any length above 0 */
  double velocity[3];         /* m/s */
  double angular_velocity[3]; /* rad/s */
} drape_pin_input;

typedef struct drape_inputs {
  int has_wind;   /* the scene has air */
  double wind[3]; /* m/s */
  int pin_count;
  drape_pin_input* pin; /* [pin_count] the driven ones */
  int body_count;
  drape_pin_input* body; /* [body_count] those that move; orientations are those in space */
} drape_inputs;

/* What a cloth tells of itself at the present time. */
typedef struct drape_strain {
  double min, max, mean; /* over the threads of one direction; mean weighted by area */
} drape_strain;

typedef struct drape_probe {
  const char* name;
  double position[3], velocity[3]; /* m, m/s */
} drape_probe;

typedef struct drape_pin {
  const char* name;
  double force[3];  /* N on the outside world: impulse over the last drape_advance divided by its length */
  double torque[3]; /* N m likewise, about the pin's present position */
} drape_pin;

typedef struct drape_seam {
  const char* name;
  int pair_count; /* of particles */
  double side[2]; /* m, lengths of its sides before they are sewn */
  double gap_max; /* m */
  double closed;  /* 1 where all of it is sewn and no gap is left, else 0 */
  double length;  /* m, along the middle of both sides */
} drape_seam;

typedef struct drape_body {
  const char* name;
  double
      force[3]; /* N, of the cloth on the body: impulse over the last drape_advance divided by its length */
  double torque[3]; /* N m likewise, about the body's present origin */
} drape_body;

typedef struct drape_energy { /* J; only with scene.energy */
  double kinetic, stretch, shear, bending, gravity, contact;
  double dissipated, input, balance_error; /* since the start */
} drape_energy;

typedef struct drape_outputs {
  drape_strain strain_warp, strain_weft, strain_bias; /* fraction */
  double tension_max;                                 /* N/m */
  double strain_beyond_test_count;                    /* links past the last point of their diagram */
  double step_size, step_count, step_stability;       /* s, 1, h omega_max / its limit (2) */
  int has_fit;                                        /* scene.mode = "fit" */
  double fit_residual;                                /* 1 */
  int has_energy;
  int has_balance; /* of the energies: not in a fit */
  drape_energy energy;
  int probe_count;
  drape_probe* probe; /* [probe_count] */
  int pin_count;
  drape_pin* pin; /* [pin_count] */
  int seam_count;
  drape_seam* seam; /* [seam_count] */
  int body_count;
  drape_body* body;           /* [body_count] */
  int has_self_contact;       /* cloth touches cloth */
  double contact_count;       /* particles that touch a body, links and cells on its ridges, pairs of cloth */
  double contact_penetration; /* m, the most that one is pressed into the cloth's thickness */
  double contact_pressure;    /* Pa, the largest; of bodies with what stops hold */
  int node_count;             /* particles of all pieces in order, row by row */
  double* node_position;      /* [node_count x 3] m; NULL until first asked for */
  double* node_velocity;      /* [node_count x 3] m/s, synchronous; likewise */
} drape_outputs;

/* A piece as its particles and the cells between them, and as polygons that follow its outline. The corners
 * of the polygons are particles and, where the outline runs between these, points that move with four of them
 * each. The points are counted on from the particles of all pieces: point k of this piece is corner
 * point_first + k. */
typedef struct drape_piece {
  const char* name;
  double cell;    /* b, m */
  int node_first; /* its first particle in drape_outputs.node_position */
  int node_count;
  const double* rest; /* [node_count x 2] m, in the piece's plane */
  int cell_count;
  const int* corner; /* [cell_count x 4] particles, counter-clockwise */
  int point_first;
  int point_count;
  const int* point_node; /* [point_count x 4] particles */
  const double*
      point_weight; /* [point_count x 4] position = sum of weight x particle's position; velocities too */
  int polygon_count;
  const int* polygon_end;    /* [polygon_count] behind its last corner in polygon_corner */
  const int* polygon_corner; /* counter-clockwise */
  int cut_count;             /* of the cells: those that the outline cuts */
  int merged_count;          /* parts too small for a cell of their own, taken over by a neighbour */
  int twin_count; /* of the particles: those that share their place in the plane with another one */
  double area;    /* m^2 */
  int fabric;     /* its place in drape_parameters.fabric */
} drape_piece;

/* Fields over the cloth. Strain and tension of a particle are the means over the links that end at it, by
 * their widths. */
typedef struct drape_fields {
  int node_count;         /* as in drape_outputs */
  const double* strain;   /* [node_count x 3] of warp, weft, bias */
  const double* tension;  /* [node_count x 2] N/m, of warp, weft */
  const double* pressure; /* [node_count] Pa, of contact with bodies */
  const double* area;     /* [node_count] m^2 */
} drape_fields;

typedef enum drape_yarn_direction { DRAPE_WARP, DRAPE_WEFT, DRAPE_BIAS } drape_yarn_direction;
typedef struct drape_elongation {
  drape_strain strain; /* over the links of one direction of a piece */
  double tension_max;  /* N/m; 0 of the bias */
  double limit;        /* strain */
  double beyond;       /* share of the piece's area that is strained beyond the limit */
} drape_elongation;

/* The particles of both sides of a seam, side by side. */
typedef struct drape_seam_lines {
  int pair_count;
  int loop;            /* the last pair is followed by the first */
  const double *a, *b; /* [pair_count x 3] m */
} drape_seam_lines;

/* A body's mesh at its present pose. */
typedef struct drape_surface {
  const char* name;
  int moves;
  int point_count;
  const double* point; /* [point_count x 3] m */
  int triangle_count;
  const int* corner; /* [triangle_count x 3] counter-clockwise from outside */
} drape_surface;

/* Reads, checks and assembles a scene. On faulty input: NULL, and one DRAPE_LOG_ERROR message per problem.
 * The log function is kept for the cloth's life; NULL for none. */
drape_cloth* drape_open(const char* scene_file, drape_log_fn* log, void* user);
void drape_close(drape_cloth*);

/* Scene facts. The text is the scene with every file it names folded in, but for the meshes of bodies; a
 * scene file of that text, with the meshes beside it, gives the same cloth. */
const char* drape_scene_name(const drape_cloth*);
const char* drape_scene_text(const drape_cloth*);
double drape_duration(const drape_cloth*);      /* s, scene.duration */
double drape_communication(const drape_cloth*); /* s, scene.communication */
/* The files that the text names: where each is now, and by what name it must lie beside the text. */
int drape_file_count(const drape_cloth*);
const char* drape_file_path(const drape_cloth*, int index);
const char* drape_file_name(const drape_cloth*, int index);
int drape_piece_count(const drape_cloth*);
drape_piece drape_piece_at(drape_cloth*, int index);

/* Parameters: write into the returned struct (it and its arrays keep their addresses for the cloth's life),
 * then commit. A commit checks all of them (single values and their combinations); on DRAPE_DISCARD each
 * problem has been logged, what is at fault (a value, a diagram, or a fabric that leaves no step to make)
 * again holds the values in force, and the rest has been taken. drape_advance commits by itself. */
drape_parameters* drape_parameters_of(drape_cloth*);
drape_status drape_commit(drape_cloth*);

/* Inputs: write into the returned struct (it and its arrays keep their addresses for the cloth's life); the
 * next drape_advance goes there, from where they are. Rates are the values' time derivatives at the beginning
 * of the next advance: the value reached is value + length x rate; they are 0 again once it has been made.
 * drape_inputs_start, before the first advance: the wind written so far is the one of the start (else the
 * scene's). */
drape_inputs* drape_inputs_of(drape_cloth*);
void drape_inputs_start(drape_cloth*);
drape_inputs* drape_input_rates_of(drape_cloth*);

/* True once a cloth in fit mode is at rest: it stays. */
int drape_at_rest(const drape_cloth*);

/* Moves the clock to the start time (s). Before the first step only. */
drape_status drape_start(drape_cloth*, double time);
double drape_time(const drape_cloth*);

/* Advances by `length` > 0 seconds, at most 1e9 communication intervals. */
drape_status drape_advance(drape_cloth*, double length);

/* True where the last advance was refused because the step limit had fallen below the scene's step: it would
 * be again. */
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

/* What pictures and reports show of the present state; made anew each time, valid until the next call of the
 * same. A limit below 0 is the last tested elongation of the direction, infinite where it has no law. */
const drape_fields* drape_fields_at(drape_cloth*);
drape_elongation drape_elongation_of(drape_cloth*, int piece, drape_yarn_direction along, double limit);
drape_seam_lines drape_seam_lines_at(drape_cloth*, int seam);
drape_surface drape_surface_at(drape_cloth*, int body);

/* The step limit at the present state, without the safety factor (s), and the name of the link that sets it.
 */
double drape_step_limit(drape_cloth*, const char** set_by);

/* Copies of the whole state (motion, clock, parameters in force and written, inputs). drape_save reuses
 * `into` unless it is NULL. */
drape_snapshot* drape_save(drape_cloth*, drape_snapshot* into);
void drape_restore(drape_cloth*, const drape_snapshot*);
void drape_snapshot_free(drape_snapshot*);

const char* drape_version(void);

#ifdef __cplusplus
}
#endif
#endif
