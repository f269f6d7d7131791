package org.robotui.gl.internal.splat;

import static org.robotui.gl.internal.splat.Facets.CORNERS;

import java.util.Arrays;

/**
 * The triangles of a mesh while some of them are taken out. A corner is a third of a triangle: where it lies, and which
 * way the surface faces there.
 */
final class FacetShape {
  /** Of a triangle's former direction: what turns further would fold the surface. */
  private static final double UPRIGHT = 0.3;

  private final Facets from;
  private final int[] placesOf;
  private final int[] normalsOf;
  private final byte[] colorsOf;
  private final boolean[] outward;
  private final Quadrics quadrics;
  private int count;

  FacetShape(Facets from) {
    this.from = from;
    placesOf = from.placesOf().clone();
    normalsOf = from.normalsOf().clone();
    count = from.count();
    colorsOf = new byte[count];
    outward = new boolean[count];
    for (int triangle = 0; triangle < count; triangle++) {
      colorsOf[triangle] = (byte) from.colorOf(triangle);
      outward[triangle] = from.isOutward(triangle);
    }
    quadrics = new Quadrics(from.placeCount());
    addPlanes();
  }

  private void addPlanes() {
    Stars stars = stars();
    for (int corner = 0; corner < CORNERS * count; corner++) {
      double[] across = across(placesOf[corner], placesOf[next(corner)], placesOf[next(next(corner))]);
      double area = length(across);
      if (area > 0) {
        scale(across, 1 / area);
        quadrics.add(placesOf[corner], across, -dot(across, at(placesOf[corner])), area);
        if (isBorder(stars, corner)) {
          addBorder(placesOf[corner], placesOf[next(corner)], across);
        }
      }
    }
  }

  /** Where a surface or a colour ends, a plane through the edge keeps it where it is. */
  private void addBorder(int a, int b, double... across) {
    double[] edge = minus(at(b), at(a));
    double[] outwards = cross(edge, across);
    double length = length(outwards);
    if (length > 0) {
      scale(outwards, 1 / length);
      quadrics.add(a, outwards, -dot(outwards, at(a)), length * length);
      quadrics.add(b, outwards, -dot(outwards, at(a)), length * length);
    }
  }

  /** Whether the edge that begins with a corner is not one between two triangles of one colour. */
  private boolean isBorder(Stars stars, int corner) {
    int place = placesOf[corner];
    int beside = placesOf[next(corner)];
    int alike = 0;
    int others = 0;
    for (int i = stars.begin(place); i < stars.end(place); i++) {
      int other = stars.corner(i);
      if (other != corner && (placesOf[next(other)] == beside || placesOf[next(next(other))] == beside)) {
        others++;
        alike += colorsOf[other / CORNERS] == colorsOf[corner / CORNERS] ? 1 : 0;
      }
    }
    return others != 1 || alike != 1;
  }

  /** Triangles that are left. */
  int count() {
    return count;
  }

  Stars stars() {
    return new Stars(placesOf, CORNERS * count, from.placeCount());
  }

  int place(int corner) {
    return placesOf[corner];
  }

  /** How far a place would be from the surface that another one stands for; metres. */
  double error(int place, int moved) {
    return quadrics.error(place, from.places(0)[moved], from.places(1)[moved], from.places(2)[moved]);
  }

  double distance(int a, int b) {
    return length(minus(at(a), at(b)));
  }

  /** The cosine between the directions of two corners. */
  double alike(int a, int b) {
    double sum = 0;
    for (int axis = 0; axis < CORNERS; axis++) {
      sum += (double) from.normals(axis)[normalsOf[a]] * from.normals(axis)[normalsOf[b]];
    }
    return sum;
  }

  /** Whether a triangle would still face about the same way with one of its corners elsewhere. */
  boolean staysUpright(int corner, int place) {
    int b = placesOf[next(corner)];
    int c = placesOf[next(next(corner))];
    double[] before = across(placesOf[corner], b, c);
    double[] after = across(place, b, c);
    double both = length(before) * length(after);
    return length(after) > 0 && dot(before, after) >= UPRIGHT * both;
  }

  /** Moves a corner to a place, with the direction of another corner. */
  void move(int corner, int place, int like) {
    placesOf[corner] = place;
    normalsOf[corner] = normalsOf[like];
  }

  void merge(int place, int into) {
    quadrics.merge(into, place);
  }

  /** Forgets the triangles that have become lines. */
  void compact() {
    int left = 0;
    for (int triangle = 0; triangle < count; triangle++) {
      int at = CORNERS * triangle;
      if (placesOf[at] != placesOf[at + 1] && placesOf[at + 1] != placesOf[at + 2]
          && placesOf[at + 2] != placesOf[at]) {
        System.arraycopy(placesOf, at, placesOf, CORNERS * left, CORNERS);
        System.arraycopy(normalsOf, at, normalsOf, CORNERS * left, CORNERS);
        colorsOf[left] = colorsOf[triangle];
        outward[left] = outward[triangle];
        left++;
      }
    }
    count = left;
  }

  /** What is left, with the places and directions that it needs. */
  Facets facets() {
    int[] places = Arrays.copyOf(placesOf, CORNERS * count);
    int[] normals = Arrays.copyOf(normalsOf, CORNERS * count);
    int[] oldPlaces = renumber(places, from.placeCount());
    int[] oldNormals = renumber(normals, from.normalCount());
    float[][] at = new float[CORNERS][];
    float[][] along = new float[CORNERS][];
    for (int axis = 0; axis < CORNERS; axis++) {
      at[axis] = pick(from.places(axis), oldPlaces);
      along[axis] = pick(from.normals(axis), oldNormals);
    }
    return new Facets(at, along, places, normals, Arrays.copyOf(colorsOf, count), Arrays.copyOf(outward, count),
        from.palette());
  }

  /** Numbers what is used from 0 on, in the order of use; answers the old number of each. */
  private static int[] renumber(int[] used, int most) {
    int[] numbers = new int[most];
    int[] old = new int[most];
    int size = 0;
    for (int i = 0; i < used.length; i++) {
      if (numbers[used[i]] == 0) {
        old[size++] = used[i];
        numbers[used[i]] = size;
      }
      used[i] = numbers[used[i]] - 1;
    }
    return Arrays.copyOf(old, size);
  }

  private static float[] pick(float[] values, int... which) {
    float[] picked = new float[which.length];
    for (int i = 0; i < which.length; i++) {
      picked[i] = values[which[i]];
    }
    return picked;
  }

  private static int next(int corner) {
    return corner % CORNERS == CORNERS - 1 ? corner - CORNERS + 1 : corner + 1;
  }

  private double[] at(int place) {
    return new double[]{from.places(0)[place], from.places(1)[place], from.places(2)[place]};
  }

  /** What stands upright on a triangle, as long as twice its area. */
  private double[] across(int a, int b, int c) {
    return cross(minus(at(b), at(a)), minus(at(c), at(a)));
  }

  private static double[] minus(double[] a, double... b) {
    return new double[]{a[0] - b[0], a[1] - b[1], a[2] - b[2]};
  }

  private static double[] cross(double[] a, double... b) {
    return new double[]{a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
  }

  private static double dot(double[] a, double... b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
  }

  private static double length(double... a) {
    return Math.sqrt(dot(a, a));
  }

  private static void scale(double[] a, double by) {
    for (int axis = 0; axis < CORNERS; axis++) {
      a[axis] *= by;
    }
  }
}
