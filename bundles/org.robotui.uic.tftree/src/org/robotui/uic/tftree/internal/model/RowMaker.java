package org.robotui.uic.tftree.internal.model;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.HashSet;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Set;
import java.util.function.LongToDoubleFunction;
import org.robotui.api.frame.FrameLink;
import org.robotui.data.FrameId;

/** Makes the rows of the tree: those that fit, and those above them. Pure. */
final class RowMaker {
  private RowMaker() {}

  /** All frames in the order of the tree, whatever is asked for. */
  static List<FrameRow> all(Forest forest, Ask ask, double staleAfter, LongToDoubleFunction ages) {
    boolean several = forest.robots().size() > 1;
    Map<FrameId, Integer> depths = new HashMap<>();
    List<FrameRow> rows = new ArrayList<>(forest.size());
    for (FrameId frame : forest.inOrder()) {
      int depth = forest.parent(frame).map(parent -> depths.getOrDefault(parent, -1) + 1).orElse(0);
      depths.put(frame, depth);
      Optional<FrameLink> link = Optional.ofNullable(forest.links().get(frame));
      double age = link.filter(l -> !l.fixed()).map(l -> ages.applyAsDouble(l.receivedNanos())).orElse(0.0);
      boolean open = ask.narrows() || !ask.closed().contains(frame);
      rows.add(FrameRow.of(frame, several ? frame.toString() : frame.name(), depth, link,
          forest.below().getOrDefault(frame, 0), open, age, staleAfter));
    }
    return rows;
  }

  /** Those that are shown. */
  static List<FrameRow> shown(Forest forest, List<FrameRow> all, Ask ask) {
    Set<FrameId> wanted = ask.narrows() ? wanted(forest, all, ask) : forest.below().keySet();
    Set<FrameId> hidden = new HashSet<>();
    List<FrameRow> rows = new ArrayList<>();
    for (FrameRow row : all) {
      if (forest.parent(row.id()).filter(hidden::contains).isPresent()) {
        hidden.add(row.id());
      } else if (wanted.contains(row.id())) {
        rows.add(row);
        if (!row.open()) {
          hidden.add(row.id());
        }
      }
    }
    return List.copyOf(rows);
  }

  private static Set<FrameId> wanted(Forest forest, List<FrameRow> all, Ask ask) {
    Set<FrameId> wanted = new HashSet<>();
    for (FrameRow row : all) {
      if (ask.fits(row)) {
        for (Optional<FrameId> at = Optional.of(row.id()); at.isPresent() && wanted.add(at.get()); at =
            forest.parent(at.get())) {
          // Up to the root, or to one whose way up is in already.
        }
      }
    }
    return wanted;
  }
}
