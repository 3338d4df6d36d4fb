/* SPDX-License-Identifier: MIT */
/*
 * What the reference's own files share: vectors in double, triangles in view space, surfaces and lights.
 */
#ifndef GLINT_TESTS_REFERENCE_INTERNAL_H
#define GLINT_TESTS_REFERENCE_INTERNAL_H

#include <math.h>
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "reference.h"

/* The depth buffer's greatest value: a surface on the near plane. */
#define DEPTH_STEPS 65519.0

/* Below this length a sum of unit normals has no direction that double precision could tell. */
#define NORMAL_LEAST 1e-9

/* Lights at whose terminator one surface point may stand, each with and without its specular term; and lights at the
 * edge of whose shadow, each hidden or not. */
#define TERMINATOR_MAX 4
#define SHADOW_MAX 4

typedef struct vector {
    double x, y, z;
} vector;

static inline vector vector_of(double x, double y, double z)
{
    vector v = {x, y, z};
    return v;
}

static inline vector plus(vector a, vector b)
{
    return vector_of(a.x + b.x, a.y + b.y, a.z + b.z);
}

static inline vector minus(vector a, vector b)
{
    return vector_of(a.x - b.x, a.y - b.y, a.z - b.z);
}

static inline vector times(double s, vector v)
{
    return vector_of(s * v.x, s * v.y, s * v.z);
}

static inline double dot(vector a, vector b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

/* cross(b, a) is exactly -cross(a, b), in double too: the edge functions of neighbours rely on it. */
static inline vector cross(vector a, vector b)
{
    return vector_of(a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x);
}

static inline double length(vector v)
{
    return sqrt(dot(v, v));
}

/* The zero vector stays zero. */
static inline vector unit(vector v)
{
    double l = length(v);
    return l > 0.0 ? times(1.0 / l, v) : v;
}

typedef struct picture {
    int size[2];
    bool bilinear, clamped[2];
    double *rgb; /* 3 a texel; NULL: no texture */
} picture;

typedef struct surface {
    picture texture;
    double ambient[3]; /* r_a, and what of I_a comes from everywhere, times it */
    double sky[3], ground[3];
    double diffuse[3], specular[3], emission[3], mirror[3];
    double exponent;
    bool blinn;
    bool casts, takes; /* shadows */
    int sides;
    double transmission, grazing[3]; /* the first is in ambient .. emission already */
    bool grazes;
    double wire_width, wire[3]; /* px; 0: none */
} surface;

typedef struct lamp {
    bool has_place; /* all but directional */
    bool is_spot;
    vector toward;         /* directional: s; spot: against the axis of its cone */
    vector position;       /* all but directional */
    bool is_area, is_ball; /* extended: a panel, unless it is a ball */
    vector edge[2];
    double radius;
    bool casts; /* shadows */
    double colour[3];
    double k[3], unit, range;    /* attenuation; range 0: none */
    double cos_inner, cos_outer; /* of a spot's cones */
} lamp;

/* The map of the environment. */
typedef struct surroundings {
    int side; /* 0: none */
    double (*texel)[3];
} surroundings;

/* A point of a triangle on the screen. What is linear on the screen is carried along when polygons are cut. */
typedef struct corner {
    double x, y;      /* px */
    double inverse_z; /* 1 / Z */
    double share[3];  /* b_i / Z, b_i perspective-correct */
    double linear[3]; /* weights of the corners' colours in Gouraud shading */
} corner;

/* Edge i of a triangle runs from corner i to corner i + 1. This number stands for the edge at the near plane. */
#define NEAR_EDGE 3
#define POLYGON_MAX 4

typedef struct triangle {
    int32_t object;
    int16_t model[3][3]; /* positions in the mesh: triangles that share two of them are neighbours */
    vector world[3];
    vector normal[3]; /* unit, in world space; the face normal for a stored zero; zero only if that is zero too */
    double texcoord[3][2];
    vector face;    /* unit, outwards, in world space; zero for a triangle without area */
    vector edge[3]; /* P_j x P_k, opposite corner i, signed so that all are >= 0 inside */
    vector plane;   /* Z = height / (plane . d) on the ray of direction d */
    double height;
    bool front;                 /* is drawn: turns its outside to the eye, or both sides count */
    bool away;                  /* turns its inside to the eye */
    bool thin;                  /* rounding the corners could turn it around */
    bool sealed[NEAR_EDGE + 1]; /* a neighbour that can be drawn lies beyond the edge */
    int corner_count;           /* of the polygon in front of the near plane; 0 or 3..POLYGON_MAX */
    corner corners[POLYGON_MAX];
    int label[POLYGON_MAX];      /* which edge runs from corners[k] to the next */
    double line[POLYGON_MAX][3]; /* signed distance of that edge, positive inside: l[0] x + l[1] y + l[2] */
    double corner_colour[3][3];  /* Gouraud, clamped; of a textured surface what the texture colours, */
    double corner_plain[3][3];   /* and what it does not */
    double flat_colour[3];       /* flat */
    double flat_plain[3];
    bool has_terminator; /* Gouraud, flat: a corner or the centroid stands on one */
} triangle;

/* A pixel's centre in or near a triangle. */
typedef struct meeting {
    int32_t triangle;
    int32_t next; /* of the same pixel, -1: none */
    uint8_t inside;
    uint8_t near_edges; /* bit `label` for each edge within e */
} meeting;

/* What a meeting is worth when a pixel is settled. */
typedef struct contender {
    int32_t triangle;
    bool inside;
    uint8_t near_edges;
    int group;
    bool must; /* its group must cover the pixel */
    bool candidate;
    double depth_low, depth_high; /* 65519 near / Z: low is far */
} contender;

/* A surface that lets light through, at a pixel. */
typedef struct layer {
    contender surface;
    corner hit;      /* at the pixel's centre, or the point nearest to it */
    double depth;    /* as those of contenders */
    bool there;      /* it covers the centre, and nothing opaque is nearer */
    bool doubtful;   /* that may be otherwise */
    bool either_way; /* so may its order and that of the one before it */
} layer;

struct reference_detail {
    int width, height, shading;
    reference_options options;
    vector eye, right, down, forward;
    double focal; /* f in px */
    double near_z;
    double background[3];
    vector up;                         /* of the hemisphere */
    surroundings around;               /* what mirrors show */
    double fog[3], fog_begin, fog_end; /* equal: none */
    int32_t triangle_count;
    triangle *triangles;
    int surface_count;
    bool has_layers;   /* some surface lets light through */
    surface *surfaces; /* one an object */
    int lamp_count;
    lamp *lamps;
    struct shadow_tree *shadows;
    int32_t *first; /* meeting of each pixel, -1: none */
    meeting *meetings;
    int32_t meeting_count, meeting_room;
    contender *contenders; /* room for twice the pixel with the most meetings: opaque ones, and layers */
    layer *layers;
    int contender_room;
};

/* view.c */
int view_load(reference_detail *d, const glint_scene *scene, char *error, size_t error_bytes);
vector view_ray(const reference_detail *d, double x, double y);

/* seal.c: finds the neighbours of every triangle. 0, or -1 without memory. */
int seal_edges(reference_detail *d);

/* meet.c */
int meet_all(reference_detail *d);
/* The triangle cut to the square of half width e around (x, y): at most MEET_REGION_MAX points in each part. */
#define MEET_REGION_MAX (2 * (POLYGON_MAX + 4))
int meet_region(const triangle *t, double x, double y, double e, corner region[MEET_REGION_MAX]);
/* The point of the triangle's outline that is nearest to (x, y). */
corner meet_nearest(const triangle *t, double x, double y);
/* The point of the triangle's surface on the ray through (x, y), which is inside it. */
corner meet_hit(const reference_detail *d, const triangle *t, double x, double y);

/* contest.c: fills d->contenders for a pixel with its opaque surfaces, in drawing order, and returns their number;
 * *front is the index of the one that is seen (-1: the background), *mask its edge and depth bits, *background whether
 * that may show. */
int contest(reference_detail *d, int x, int y, int *front, uint8_t *mask, bool *background);
/* Groups contenders and finds the groups that must cover the pixel. */
void contest_groups(const reference_detail *d, contender *c, int count);
/* The range of a contender's depths within e. */
void contest_depths(const reference_detail *d, contender *c, double x, double y);

/* layers.c: what a pixel is seen through, far to near, after contest() for it. Returns the number. */
int layers_at(const reference_detail *d, int x, int y, int opaque, int front, bool background, layer *list);
/* Lays them over the colour behind. *rounding, in codes, grows by what the rounding of each pixel behind makes. Returns
 * whether any of them is in doubt. */
bool layers_show(const reference_detail *d, const layer *list, int count, double rgb[3], double *rounding);
/* The same of a range of colours, in all the ways that are in doubt. */
void layers_range(const reference_detail *d, const layer *list, int count, int x, int y, reference_candidate *range);

/* lamp.c */
void lamp_load(lamp *out, const glint_light *in);
/* s at the point; false where the light stands on it. */
bool lamp_toward(const lamp *l, vector point, vector *s);
/* What of the light's intensity arrives there: a_j b_j. */
double lamp_factor(const lamp *l, vector point, vector s);

/* around.c */
/* 0, or -1 without memory. */
int around_load(surroundings *out, const glint_environment *in);
/* E in a direction of any length but 0. */
void around_colour(const surroundings *around, vector direction, double rgb[3]);

/* area.c */
typedef struct area_mean {
    double diffuse, specular; /* attenuation included; to be multiplied by light and reflectance */
} area_mean;
area_mean area_light(const lamp *l, const surface *f, vector point, vector normal, vector c);

/* texture.c */
/* 0, or -1 without memory. */
int picture_load(picture *out, const glint_texture *in);
void picture_at(const picture *p, const double uv[2], double rgb[3]);
/* Bounds of the colours over a box. */
void picture_range(const picture *p, const double low[2], const double high[2], double least[3], double most[3]);

/* shade.c */
/* max(0, r.c)^alpha, or with Blinn's h. */
double shade_highlight(const surface *f, vector n, vector s, vector c);
/* What the place of a surface point does not decide for good: the specular terms of lights at whose terminator it
 * stands, and lights at the edge of whose shadow. Each is there when its bit of `on` is set, terminators first. */
typedef struct undecided {
    int terminator[TERMINATOR_MAX], shadow[SHADOW_MAX];
    int terminator_count, shadow_count;
    unsigned on;
} undecided;
/* The lights at whose terminator (point, normal) stands. Returns their number, at most TERMINATOR_MAX. */
int shade_terminators(const reference_detail *d, const surface *f, vector point, vector normal,
                      int lights[TERMINATOR_MAX]);
/* The model, the texture's colour being `texel`; NULL: 1. `on`: the triangle that shadows fall on; NULL: there are
 * none.
 */
void shade_point(const reference_detail *d, const surface *f, const triangle *on, vector point, vector normal,
                 const undecided *u, const double *texel, double rgb[3]);
void shade_triangle(const reference_detail *d, triangle *t);
/* The colour of a triangle at a point of its screen polygon. variant: see shade_variants(); -1: the model's own. texel:
 * the texture's colour there, NULL: as it is. */
void shade_corner(const reference_detail *d, const triangle *t, const corner *where, const corner *anchor, int variant,
                  const double *texel, double rgb[3]);
/* Is a place on the screen on the triangle's wire, or so near to its border that rounding may decide? */
typedef enum wire_state { WIRE_OFF = 0, WIRE_ON = 1, WIRE_DOUBTFUL = 2 } wire_state;
wire_state shade_wire(const reference_detail *d, const triangle *t, double x, double y);
/* The same with the wire there or not, of a surface that may let light through: its own light, and how much passes of
 * what is behind. */
void shade_layer(const reference_detail *d, const triangle *t, const corner *where, const corner *anchor, int variant,
                 bool wire, const double *texel, double rgb[3], double *through);
/* The range of the texture's colours over points of the polygon, and as much beyond them as options.texels says. False:
 * there is no texture. */
bool shade_texels(const reference_detail *d, const triangle *t, const corner *points, int count, double least[3],
                  double most[3]);
/* Does the texture's colour there depend on how vertices and texture coordinates are rounded? See reference.h. */
bool shade_texel_contested(const reference_detail *d, const triangle *t, const corner *hit);
/* In how many ways specular terms and lights may be there or not: 1 where no terminator and no shadow's edge is near.
 * *mask gets REFERENCE_TERMINATOR and REFERENCE_SHADOW; it may be NULL. */
int shade_variants(const reference_detail *d, const triangle *t, const corner *anchor, uint8_t *mask);

/* shadow.c */
/* 0, or -1 without memory. */
int shadow_load(reference_detail *d);
void shadow_free(struct shadow_tree *tree);
/* Does something stand between the light and a point of the triangle? */
bool shadow_hides(const reference_detail *d, const triangle *t, vector point, int light);
/* Is an edge of the light's shadow so near that the library may be on its other side? */
bool shadow_contested(const reference_detail *d, const triangle *t, const corner *at, int light);

#endif
