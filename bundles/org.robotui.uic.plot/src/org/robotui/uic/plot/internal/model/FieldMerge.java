package org.robotui.uic.plot.internal.model;

import java.util.List;
import org.robotui.uic.plot.internal.trace.Samples;

/** Computes a signal from the samples of its fields, in the order of time. */
final class FieldMerge {
  private FieldMerge() {}

  /** Given the samples of each of the leaves, in their order. */
  static void into(List<Leaf> leaves, List<Samples> fields) {
    int[] at = new int[fields.size()];
    for (int next = earliest(fields, at); next >= 0; next = earliest(fields, at)) {
      Samples field = fields.get(next);
      leaves.get(next).replay(field.time(at[next]), field.value(at[next]));
      at[next]++;
    }
  }

  private static int earliest(List<Samples> fields, int[] at) {
    int best = -1;
    for (int i = 0; i < at.length; i++) {
      boolean more = at[i] < fields.get(i).size();
      if (more && (best < 0 || fields.get(i).time(at[i]) < fields.get(best).time(at[best]))) {
        best = i;
      }
    }
    return best;
  }
}
