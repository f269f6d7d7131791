package org.robotui.sim.internal.camera;

import java.util.List;
import org.robotui.sim.internal.world.RaySpan;
import org.robotui.sim.internal.world.Solid;

/** The solids along one ray, from the farthest to the nearest. Reused for each column of a picture. */
final class Hits {
  private static final int MOST = 64;

  private final RaySpan span = new RaySpan();
  private final Solid[] solids = new Solid[MOST];
  private final double[] enters = new double[MOST];
  private final double[] exits = new double[MOST];
  private final int[] edges = new int[MOST];
  private int count;

  void collect(List<Solid> all, double ox, double oy, double dx, double dy) {
    count = 0;
    for (int i = 0; i < all.size() && count < MOST; i++) {
      if (all.get(i).clip(ox, oy, dx, dy, span) && span.edge() >= 0) {
        insert(all.get(i));
      }
    }
  }

  private void insert(Solid solid) {
    int at = count++;
    while (at > 0 && enters[at - 1] < span.enter()) {
      copy(at - 1, at);
      at--;
    }
    solids[at] = solid;
    enters[at] = span.enter();
    exits[at] = span.exit();
    edges[at] = span.edge();
  }

  private void copy(int from, int to) {
    solids[to] = solids[from];
    enters[to] = enters[from];
    exits[to] = exits[from];
    edges[to] = edges[from];
  }

  /** The index of the farthest hit behind which nothing can be seen: everything before it is hidden. */
  int firstVisible(double fullHeight) {
    for (int i = count - 1; i >= 0; i--) {
      if (solids[i].bottom() <= 0 && solids[i].top() >= fullHeight) {
        return i;
      }
    }
    return 0;
  }

  int count() {
    return count;
  }

  Solid solid(int i) {
    return solids[i];
  }

  double enter(int i) {
    return enters[i];
  }

  double exit(int i) {
    return exits[i];
  }

  int edge(int i) {
    return edges[i];
  }
}
