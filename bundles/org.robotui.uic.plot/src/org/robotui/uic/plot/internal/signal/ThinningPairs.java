package org.robotui.uic.plot.internal.signal;

import java.util.Arrays;

/**
 * Keeps of so many pairs in a row those that lie furthest to each side, in the order of time, so that a curve looks the
 * same from afar. Breaks stay. One thread.
 */
public final class ThinningPairs implements PairSink {
  /** How many are kept of so many in a row, at most: the furthest to the left, right, top and bottom. */
  public static final int KEPT = 4;

  private final int every;
  private final PairSink out;
  private final Pair[] furthest = new Pair[KEPT];
  private int count;

  private record Pair(long time, double x, double y) {}

  /** Of no more than four pairs in a row all are kept. */
  public ThinningPairs(int every, PairSink out) {
    this.every = every;
    this.out = out;
  }

  @Override
  public void accept(long time, double x, double y) {
    if (every <= KEPT) {
      out.accept(time, x, y);
    } else if (Double.isFinite(x) && Double.isFinite(y)) {
      note(new Pair(time, x, y));
    } else {
      flush();
      out.accept(time, x, y);
    }
  }

  private void note(Pair pair) {
    if (count == 0) {
      Arrays.fill(furthest, pair);
    }
    furthest[0] = pair.x < furthest[0].x ? pair : furthest[0];
    furthest[1] = pair.x > furthest[1].x ? pair : furthest[1];
    furthest[2] = pair.y < furthest[2].y ? pair : furthest[2];
    furthest[3] = pair.y > furthest[3].y ? pair : furthest[3];
    count++;
    if (count == every) {
      flush();
    }
  }

  /** Gives what waits: the end. */
  public void flush() {
    if (count > 0) {
      count = 0;
      Arrays.stream(furthest).distinct().sorted((a, b) -> Long.compare(a.time, b.time))
          .forEach(pair -> out.accept(pair.time, pair.x, pair.y));
    }
  }
}
