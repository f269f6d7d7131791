package org.robotui.gl.internal.splat;

import static org.robotui.gl.internal.splat.Facets.CORNERS;

import java.util.Arrays;
import java.util.function.BooleanSupplier;

/**
 * Makes a mesh of fewer triangles that looks the same from as far as its tolerance is less than half a pixel: places
 * are merged into neighbours as long as the surface stays within the tolerance. Places and directions are those of the
 * mesh, none is new; triangles of one colour stay together.
 */
final class FacetReducer {
  private static final int MOST_PASSES = 40;
  /** Passes that merge fewer of the places are not worth their time. */
  private static final double WORTH = 0.005;
  /**
   * How much a direction may change that light falls on, for the length of the edge that goes: 60 degrees within the
   * tolerance, 15 within fifteen times of it.
   */
  private static final double BEND = 2;

  private final double tolerance;
  private final FacetShape shape;
  private final int[] nearest;
  private final double[] cost;
  private final boolean[] busy;
  private Stars stars;

  private FacetReducer(Facets facets, double tolerance) {
    this.tolerance = tolerance;
    shape = new FacetShape(facets);
    nearest = new int[facets.placeCount()];
    cost = new double[facets.placeCount()];
    busy = new boolean[facets.placeCount()];
    stars = shape.stars();
  }

  /**
   * Takes a second or two for a hundred thousand triangles.
   *
   * @param facets stay as they are
   * @param tolerance by which the surface may move; metres
   * @param givenUp asked between passes: whether nobody waits for it
   * @return fewer facets, or the same
   */
  static Facets reduced(Facets facets, double tolerance, BooleanSupplier givenUp) {
    FacetReducer reducer = new FacetReducer(facets, tolerance);
    boolean worth = true;
    for (int pass = 0; pass < MOST_PASSES && worth && !givenUp.getAsBoolean(); pass++) {
      worth = reducer.pass() > WORTH * reducer.shape.count();
    }
    return reducer.shape.facets();
  }

  /** Merges places that have nothing to do with each other, the cheapest first; answers how many. */
  private int pass() {
    long[] order = new long[nearest.length];
    int found = 0;
    for (int place = 0; place < nearest.length; place++) {
      if (findNearest(place)) {
        order[found++] = (long) Float.floatToRawIntBits((float) cost[place]) << Integer.SIZE | place;
      }
    }
    Arrays.sort(order, 0, found);
    Arrays.fill(busy, false);
    int merged = 0;
    for (int i = 0; i < found; i++) {
      merged += merge((int) order[i]) ? 1 : 0;
    }
    shape.compact();
    stars = shape.stars();
    return merged;
  }

  /** Looks for the neighbour with which a place is merged at the least cost; answers whether there is one. */
  private boolean findNearest(int place) {
    cost[place] = Double.POSITIVE_INFINITY;
    for (int i = stars.begin(place); i < stars.end(place); i++) {
      tryNeighbour(place, shape.place(next(stars.corner(i))));
      tryNeighbour(place, shape.place(next(next(stars.corner(i)))));
    }
    return cost[place] <= tolerance;
  }

  private void tryNeighbour(int place, int neighbour) {
    double error = shape.error(place, neighbour);
    if (error < cost[place] && error <= tolerance) {
      double bent = Math.max(error, bend(place, neighbour));
      if (bent < cost[place] && bent <= tolerance && staysUpright(place, neighbour)) {
        cost[place] = bent;
        nearest[place] = neighbour;
      }
    }
  }

  /** What becomes visible by other light; metres of the surface that would be as visible. */
  private double bend(int place, int neighbour) {
    double length = shape.distance(place, neighbour);
    double worst = 0;
    for (int i = stars.begin(place); i < stars.end(place) && worst * length / BEND <= tolerance; i++) {
      int corner = stars.corner(i);
      if (!has(corner, neighbour)) {
        worst = Math.max(worst, 1 - shape.alike(corner, bestNormal(corner, neighbour)));
      }
    }
    return worst * length / BEND;
  }

  /** Whether no triangle is turned over or becomes a line. */
  private boolean staysUpright(int place, int neighbour) {
    boolean upright = true;
    for (int i = stars.begin(place); i < stars.end(place) && upright; i++) {
      int corner = stars.corner(i);
      upright = has(corner, neighbour) || shape.staysUpright(corner, neighbour);
    }
    return upright;
  }

  private boolean has(int corner, int place) {
    return shape.place(next(corner)) == place || shape.place(next(next(corner))) == place;
  }

  /** Of the corners at a place the one whose direction is most like that of a corner. */
  private int bestNormal(int corner, int place) {
    int best = stars.corner(stars.begin(place));
    double most = shape.alike(corner, best);
    for (int i = stars.begin(place) + 1; i < stars.end(place); i++) {
      double alike = shape.alike(corner, stars.corner(i));
      if (alike > most) {
        most = alike;
        best = stars.corner(i);
      }
    }
    return best;
  }

  /** Nothing is merged whose surroundings have changed in this pass. */
  private boolean merge(int place) {
    int into = nearest[place];
    if (isBusy(place) || isBusy(into)) {
      return false;
    }
    occupy(place);
    for (int i = stars.begin(place); i < stars.end(place); i++) {
      shape.move(stars.corner(i), into, bestNormal(stars.corner(i), into));
    }
    shape.merge(place, into);
    return true;
  }

  private boolean isBusy(int place) {
    boolean found = busy[place];
    for (int i = stars.begin(place); i < stars.end(place) && !found; i++) {
      found = busy[shape.place(next(stars.corner(i)))] || busy[shape.place(next(next(stars.corner(i))))];
    }
    return found;
  }

  private void occupy(int place) {
    busy[place] = true;
    for (int i = stars.begin(place); i < stars.end(place); i++) {
      busy[shape.place(next(stars.corner(i)))] = true;
      busy[shape.place(next(next(stars.corner(i))))] = true;
    }
  }

  private static int next(int corner) {
    return corner % CORNERS == CORNERS - 1 ? corner - CORNERS + 1 : corner + 1;
  }
}
