package org.robotui.uic.team.internal.view;

import java.util.Comparator;
import java.util.List;
import java.util.function.Function;
import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.GC;
import org.eclipse.swt.graphics.Rectangle;
import org.robotui.ui.Face;
import org.robotui.ui.Figures;
import org.robotui.ui.Health;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;
import org.robotui.ui.control.Column;
import org.robotui.ui.control.NaturalOrder;
import org.robotui.ui.control.RowWords;
import org.robotui.uic.team.internal.model.Activity;
import org.robotui.uic.team.internal.model.TeamRow;

/** The columns of the table. */
final class TeamColumns {
  private static final double LOW = 0.2;
  private static final double EMPTY = 0.1;
  private static final int DISC = 10;
  private static final int NAME_LEFT = DISC + 2 * Theme.STEP;
  private static final int BATTERY_WIDTH = 76;
  private static final int BAR_WIDTH = 20;
  private static final int PLACE_WIDTH = 124;
  private static final int AGE_WIDTH = 70;
  private static final int FRAMEWORK_WIDTH = 70;
  private static final double NAME_SHARE = 0.7;
  private static final double STATE_SHARE = 1.5;
  private static final double TASK_SHARE = 1.5;
  private static final double LINK_SHARE = 0.9;
  private static final int ROOM_FOR_TASK = 430;
  private static final int ROOM_FOR_PLACE = 540;
  private static final int ROOM_FOR_AGE = 700;
  private static final int ROOM_FOR_LINK = 780;
  private static final int ROOM_FOR_FRAMEWORK = 860;

  private final Theme theme;
  private final RowWords words;

  TeamColumns(Theme theme) {
    this.theme = theme;
    this.words = new RowWords(theme);
  }

  List<Column<TeamRow>> all() {
    return List.of(
        Column.words("Robot", TeamRow::robot).weight(NAME_SHARE).painted(this::name).order(by(TeamRow::robot)),
        Column.words("State", TeamRow::state).weight(STATE_SHARE).dot(r -> r.doing().health()).role(TeamColumns::state)
            .hint(TeamRow::why)
            .order(Comparator.comparing(TeamRow::doing)),
        Column.figures("Battery", TeamRow::battery).width(BATTERY_WIDTH).painted(this::battery).hint(TeamRow::battery)
            .order(Comparator.comparingDouble(TeamRow::charge)),
        Column.words("Task", TeamRow::task).weight(TASK_SHARE).role(TeamColumns::task).from(ROOM_FOR_TASK)
            .order(by(TeamRow::task)),
        Column.figures("Position", TeamColumns::place).width(PLACE_WIDTH).role(TeamColumns::placeRole)
            .hint(r -> r.place().isEmpty() ? "" : "x, y in metres, in " + r.frame())
            .from(ROOM_FOR_PLACE).order(Comparator.comparingDouble(r -> r.place().map(p -> p.x()).orElse(Double.NaN))),
        Column.words("Link", TeamRow::link).weight(LINK_SHARE).dot(TeamRow::linkHealth).role(Role.DIM)
            .hint(TeamRow::linkText).from(ROOM_FOR_LINK)
            .order(Comparator.comparing(TeamRow::linkHealth).thenComparing(TeamRow::link)),
        Column.words("By", TeamRow::framework).width(FRAMEWORK_WIDTH).role(Role.DIM)
            .hint(r -> "speaks " + r.framework()).from(ROOM_FOR_FRAMEWORK)
            .order(by(TeamRow::framework)),
        Column.figures("Age", TeamColumns::age).width(AGE_WIDTH).role(TeamColumns::ageRole).from(ROOM_FOR_AGE)
            .order(Comparator.comparingDouble(TeamRow::age)));
  }

  private static Comparator<TeamRow> by(Function<TeamRow, String> text) {
    return Comparator.comparing(text, NaturalOrder.ORDER);
  }

  private static Role state(TeamRow row) {
    Health health = row.doing().health();
    return row.doing() == Activity.STANDING ? Role.DIM : health == Health.OK ? Role.TEXT : health.role();
  }

  private static Role task(TeamRow row) {
    return row.taskHealth() == Health.WARNING ? Role.WARNING : Role.DIM;
  }

  private static String place(TeamRow row) {
    return row.place().map(p -> Figures.fixed(p.x(), 2) + "  " + Figures.fixed(p.y(), 2)).orElse(Figures.UNKNOWN);
  }

  /** Where it was last, where that is not known any more. */
  private static Role placeRole(TeamRow row) {
    return row.doing() == Activity.LOST || row.doing() == Activity.SILENT || row.doing() == Activity.STALE ? Role.DIM
        : Role.TEXT;
  }

  private static String age(TeamRow row) {
    return Double.isNaN(row.age()) ? Figures.UNKNOWN : Figures.age(row.age());
  }

  private static Role ageRole(TeamRow row) {
    return row.doing() == Activity.STALE || row.doing() == Activity.SILENT ? Role.WARNING : Role.DIM;
  }

  /** The name behind a disc in the robot's colour, as on the map. */
  private void name(GC gc, Rectangle at, TeamRow row) {
    gc.setAntialias(SWT.ON);
    gc.setBackground(theme.traces().get(row.number() % theme.traces().size()));
    gc.fillOval(at.x, at.y + (at.height - DISC) / 2, DISC, DISC);
    words.text(gc, at, NAME_LEFT, at.width - NAME_LEFT, row.robot(), Face.BODY_STRONG, Role.TEXT);
  }

  private void battery(GC gc, Rectangle at, TeamRow row) {
    Role role = row.charge() < EMPTY ? Role.BAD : row.charge() < LOW ? Role.WARNING : Role.GOOD;
    Role figure = role == Role.GOOD ? Role.DIM : role;
    words.right(gc, at, BAR_WIDTH, at.width - BAR_WIDTH, row.battery().isEmpty() ? Figures.UNKNOWN : row.battery(),
        figure);
    if (!Double.isNaN(row.charge())) {
      Rectangle bar = new Rectangle(at.x, at.y + at.height / 2 - 3, BAR_WIDTH, 6);
      gc.setBackground(theme.dark() ? theme.color(Role.GROUND) : theme.color(Role.LINE));
      gc.fillRectangle(bar);
      gc.setBackground(theme.color(role));
      gc.fillRectangle(bar.x, bar.y, (int) Math.round(bar.width * row.charge()), bar.height);
    }
  }
}
