package org.robotui.uic.plot.internal.view;

import java.util.List;
import java.util.Optional;
import org.eclipse.swt.graphics.Rectangle;
import org.robotui.uic.plot.internal.model.TraceView;
import org.robotui.uic.plot.internal.model.ValueSpan;

/** Makes both scales of a curve as large where both have the same unit, so that a path is not distorted. Pure. */
record EqualScales(ValueSpan left, ValueSpan across) {
  /** The same scales, one of them with more room at both ends. */
  static EqualScales of(ValueSpan left, ValueSpan across, Rectangle plot) {
    double fine = Math.max(left.length() / Math.max(1, plot.height), across.length() / Math.max(1, plot.width));
    return new EqualScales(left.lengthened(fine * Math.max(1, plot.height)),
        across.lengthened(fine * Math.max(1, plot.width)));
  }

  /** Whether all that is drawn by the left scale has the unit of what it is drawn over. */
  static boolean wanted(List<TraceView> traces) {
    List<TraceView> drawn = traces.stream().filter(t -> t.drawn() && !t.spec().right()).toList();
    Optional<String> unit = drawn.stream().flatMap(t -> t.over().stream()).map(over -> over.unit()).findFirst();
    return unit.filter(known -> !known.isEmpty() && drawn.stream().allMatch(t -> t.unit().equals(known))).isPresent();
  }
}
