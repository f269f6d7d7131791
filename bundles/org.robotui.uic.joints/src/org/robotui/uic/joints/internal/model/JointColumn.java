package org.robotui.uic.joints.internal.model;

import java.util.Comparator;
import java.util.function.ToDoubleFunction;
import org.robotui.ui.Figures;
import org.robotui.ui.control.NaturalOrder;

/** The columns of the table. */
public enum JointColumn {
  /** Its name. */
  JOINT,
  /** Which port it comes from; only where there are several. */
  SOURCE,
  /** Where it is. */
  POSITION,
  /** Where it is within its range. */
  RANGE,
  /** How fast it moves. */
  VELOCITY,
  /** How hard it pushes. */
  EFFORT,
  /** How old that is. */
  AGE;

  /** The heading; it says what figures without a unit are. */
  public String heading(boolean degrees, boolean unitsUnknown) {
    return switch (this) {
      case JOINT -> "Joint";
      case SOURCE -> "Source";
      case POSITION -> !unitsUnknown ? "Position" : degrees ? "Position, \u00b0 if rotary" : "Position, rad or m";
      case RANGE -> "Range";
      case VELOCITY -> "Velocity";
      case EFFORT -> "Effort";
      case AGE -> "Age";
    };
  }

  /** What stands in a cell. */
  public String text(JointRow row, boolean degrees) {
    return switch (this) {
      case JOINT -> row.joint().name();
      case SOURCE -> row.source().toString();
      case POSITION -> row.unit().position(row.joint().position(), degrees);
      case VELOCITY -> row.unit().velocity(row.joint().velocity(), degrees);
      case EFFORT -> row.unit().effort(row.joint().effort());
      case RANGE -> range(row, degrees);
      case AGE -> (row.stale() ? "stale " : "") + Figures.age(row.ageSeconds());
    };
  }

  private static String range(JointRow row, boolean degrees) {
    return row.span().isKnown()
        ? row.unit().position(row.span().min(), degrees) + " \u2026 " + row.unit().position(row.span().max(), degrees)
        : Figures.UNKNOWN;
  }

  /** The order of a column, upwards; what is unknown comes first and so last when turned round. */
  public Comparator<JointRow> order() {
    return switch (this) {
      case JOINT -> Comparator.comparing(row -> row.joint().name(), NaturalOrder.ORDER);
      case SOURCE -> Comparator.comparing(row -> row.source().toString(), NaturalOrder.ORDER);
      case POSITION -> by(row -> row.joint().position());
      case RANGE -> by(JointRow::share);
      case VELOCITY -> by(row -> row.joint().velocity());
      case EFFORT -> by(row -> row.joint().effort());
      case AGE -> by(JointRow::ageSeconds);
    };
  }

  private static Comparator<JointRow> by(ToDoubleFunction<JointRow> value) {
    return Comparator.comparingDouble(row -> {
      double known = value.applyAsDouble(row);
      return Double.isNaN(known) ? Double.NEGATIVE_INFINITY : known;
    });
  }
}
