package org.robotui.uic.jointcontrol.internal.model;

import java.util.Comparator;
import java.util.Optional;

/**
 * How joints are sorted inside their chains.
 *
 * @param column by which column; none is from base to tip
 * @param descending the other way round
 */
public record Sorting(Optional<JointColumn> column, boolean descending) {
  /** As the chain has them. */
  public static final Sorting CHAIN = new Sorting(Optional.empty(), false);

  /** After a click on a heading: up, down, and as the chain has them. */
  public Sorting clicked(JointColumn heading) {
    if (!column.equals(Optional.of(heading))) {
      return new Sorting(Optional.of(heading), false);
    }
    return descending ? CHAIN : new Sorting(column, true);
  }

  /** Empty where nothing is to be sorted. */
  Optional<Comparator<JointRow>> order() {
    return column.map(c -> descending ? c.order().reversed() : c.order());
  }
}
