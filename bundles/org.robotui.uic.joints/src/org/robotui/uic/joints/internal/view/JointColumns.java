package org.robotui.uic.joints.internal.view;

import java.util.ArrayList;
import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.robotui.ui.Health;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;
import org.robotui.ui.control.Column;
import org.robotui.uic.joints.internal.model.JointColumn;
import org.robotui.uic.joints.internal.model.JointRow;
import org.robotui.uic.joints.internal.model.JointsLook;

/**
 * The columns of the table, and when they must be made anew.
 *
 * @param several whether there is a column of sources
 * @param degrees whether angles are in degrees
 * @param unitsUnknown whether the heading must say what figures may be
 */
record JointColumns(boolean several, boolean degrees, boolean unitsUnknown) {
  private static final int FIGURES_WIDTH = 112;
  private static final int POSITION_WIDTH = 150;
  private static final int AGE_WIDTH = 104;
  private static final int ROOM_FOR_RANGE = 430;
  private static final int ROOM_FOR_VELOCITY = 560;
  private static final int ROOM_FOR_SOURCE = 640;
  private static final int ROOM_FOR_AGE = 720;
  private static final double SOURCE_SHARE = 0.8;
  private static final double RANGE_SHARE = 0.9;

  static JointColumns of(JointsLook look) {
    return new JointColumns(look.several(), look.degrees(), look.unitsUnknown());
  }

  /** In the order in which they stand. */
  Map<JointColumn, Column<JointRow>> make(Theme theme) {
    Map<JointColumn, Column<JointRow>> columns = new EnumMap<>(JointColumn.class);
    for (JointColumn column : shown()) {
      columns.put(column, make(column, theme));
    }
    return columns;
  }

  private List<JointColumn> shown() {
    List<JointColumn> shown = new ArrayList<>(List.of(JointColumn.values()));
    if (!several) {
      shown.remove(JointColumn.SOURCE);
    }
    return shown;
  }

  private Column<JointRow> make(JointColumn column, Theme theme) {
    String heading = column.heading(degrees, unitsUnknown);
    return (switch (column) {
      case JOINT -> Column.<JointRow>words(heading, row -> column.text(row, degrees)).dot(JointColumns::health)
          .role(JointColumns::name);
      case SOURCE -> Column.<JointRow>words(heading, row -> column.text(row, degrees)).weight(SOURCE_SHARE)
          .role(Role.DIM).from(ROOM_FOR_SOURCE);
      case RANGE -> Column.<JointRow>words(heading, row -> column.text(row, degrees)).weight(RANGE_SHARE)
          .painted(new RangePainter(theme, degrees)::paint).hint(row -> hint(row, column)).from(ROOM_FOR_RANGE);
      case POSITION -> figures(column, heading).width(POSITION_WIDTH);
      case VELOCITY, EFFORT -> figures(column, heading).width(FIGURES_WIDTH).from(ROOM_FOR_VELOCITY);
      case AGE -> Column.<JointRow>figures(heading, row -> column.text(row, degrees))
          .role(row -> row.stale() ? Role.WARNING : Role.DIM)
          .width(AGE_WIDTH).from(ROOM_FOR_AGE);
    }).order(column.order());
  }

  private Column<JointRow> figures(JointColumn column, String heading) {
    return Column.<JointRow>figures(heading, row -> column.text(row, degrees)).role(row -> figure(row, column));
  }

  private String hint(JointRow row, JointColumn column) {
    return column.text(row, degrees) + (row.span().configured() ? ", configured" : ", as seen by this view");
  }

  private static Health health(JointRow row) {
    return row.stale() ? Health.STALE : row.span().isBeyond(row.joint().position()) ? Health.WARNING : Health.OK;
  }

  private static Role name(JointRow row) {
    return row.stale() ? Role.DIM : Role.TEXT;
  }

  private static Role figure(JointRow row, JointColumn column) {
    boolean beyond = column == JointColumn.POSITION && row.span().isBeyond(row.joint().position());
    return row.stale() || Double.isNaN(value(row, column)) ? Role.DIM : beyond ? Role.WARNING : Role.TEXT;
  }

  private static double value(JointRow row, JointColumn column) {
    return switch (column) {
      case VELOCITY -> row.joint().velocity();
      case EFFORT -> row.joint().effort();
      default -> row.joint().position();
    };
  }

  /** Which column one of these is. */
  static Optional<JointColumn> which(Map<JointColumn, Column<JointRow>> columns, Column<JointRow> column) {
    return columns.entrySet().stream().filter(entry -> entry.getValue() == column).map(Map.Entry::getKey).findFirst();
  }
}
