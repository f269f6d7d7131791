package org.robotui.workbench.internal.dock;

import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;

/**
 * Which actions stand in the line above a view: all where there is room. Else the widest go first, which are those with
 * words in place of a sign, and of equal ones the last.
 *
 * @param seen which of them stand there, in order
 * @param others which do not
 */
record ActionRow(List<Integer> seen, List<Integer> others) {
  ActionRow {
    seen = List.copyOf(seen);
    others = List.copyOf(others);
  }

  /**
   * Chooses.
   *
   * @param widths of all actions
   * @param room for all of them together
   */
  static ActionRow of(int[] widths, int room) {
    boolean[] out = new boolean[widths.length];
    for (int taken = Arrays.stream(widths).sum(); taken > room && widest(widths, out) >= 0;) {
      int next = widest(widths, out);
      out[next] = true;
      taken -= widths[next];
    }
    return new ActionRow(those(out, false), those(out, true));
  }

  private static int widest(int[] widths, boolean[] out) {
    int best = -1;
    for (int i = 0; i < widths.length; i++) {
      best = !out[i] && (best < 0 || widths[i] >= widths[best]) ? i : best;
    }
    return best;
  }

  private static List<Integer> those(boolean[] out, boolean wanted) {
    return IntStream.range(0, out.length).filter(i -> out[i] == wanted).boxed().toList();
  }
}
