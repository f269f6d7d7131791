package org.robotui.uic.jointcontrol.internal.view;

import java.util.Optional;
import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.Rectangle;
import org.eclipse.swt.widgets.Control;
import org.eclipse.swt.widgets.Event;
import org.robotui.ui.control.RowList;
import org.robotui.uic.jointcontrol.internal.model.Aim;
import org.robotui.uic.jointcontrol.internal.model.ChainHead;
import org.robotui.uic.jointcontrol.internal.model.Grid;
import org.robotui.uic.jointcontrol.internal.model.JointColumn;
import org.robotui.uic.jointcontrol.internal.model.JointDriver;
import org.robotui.uic.jointcontrol.internal.model.JointLine;
import org.robotui.uic.jointcontrol.internal.model.JointRow;

/** Mouse and keys in the table on the way to the driver. Display thread. */
final class TableHands {
  /**
   * A key that repeats may come as pairs of release and press; a release counts when no press follows within this time.
   */
  private static final int SETTLE_MILLIS = 40;
  private static final double COARSE = 10;
  /** How far beside the middle of a knob it is still gripped, points. */
  private static final int REACH = 10;

  /** What else can be done there. */
  interface Deeds {
    boolean drivable();

    boolean jogging();

    Grid grid();

    void fold(ChainHead head);

    void edit(JointRow row, String first);

    void changed();
  }

  private final RowList<JointLine> list;
  private final JointDriver driver;
  private final Deeds deeds;
  private Optional<JointRow> dragged = Optional.empty();
  private int grip;
  private Optional<Integer> held = Optional.empty();
  private long presses;

  TableHands(RowList<JointLine> list, JointDriver driver, Deeds deeds) {
    this.list = list;
    this.driver = driver;
    this.deeds = deeds;
  }

  void listen() {
    Control control = list.control();
    control.addListener(SWT.MouseDown, this::down);
    control.addListener(SWT.MouseMove, this::move);
    control.addListener(SWT.MouseUp, e -> up());
    control.addListener(SWT.KeyDown, this::key);
    control.addListener(SWT.KeyUp, this::released);
    control.addListener(SWT.FocusOut, e -> forget());
    list.onOpen(this::open);
  }

  /** What is held is seen no more. */
  private void forget() {
    dragged = Optional.empty();
    held = Optional.empty();
    driver.letGo();
  }

  private void down(Event event) {
    Optional<JointLine> line = lineAt(event.y);
    if (event.button != 1 || line.isEmpty()) {
      return;
    }
    switch (line.get()) {
      case ChainHead head -> deeds.fold(head);
      case JointRow row -> {
        dragged = deeds.drivable() ? deeds.grid().find(JointColumn.RANGE).flatMap(place -> grip(row, place, event.x))
            : Optional.empty();
        if (deeds.jogging()) {
          drag(event);
        }
      }
    }
  }

  /**
   * A joint that goes to its target without a hand is taken by its knob alone, where the hand grips it: a press beside
   * it selects, and moves nothing. One that moves only while held may be pressed anywhere on its bar.
   */
  private Optional<JointRow> grip(JointRow row, Grid.Place place, int x) {
    if (deeds.jogging()) {
      grip = 0;
      return x >= place.left() && x < place.left() + place.width() ? Optional.of(row) : Optional.empty();
    }
    double position = row.aim().map(Aim::goal).orElse(row.state().measured().position());
    grip = x - RangeBar.x(place.left(), place.width(), row.span().share(position));
    return !Double.isNaN(position) && Math.abs(grip) <= REACH ? Optional.of(row) : Optional.empty();
  }

  private void move(Event event) {
    // A press elsewhere may have swallowed the release: the button's own state decides.
    if (dragged.isPresent() && (event.stateMask & SWT.BUTTON1) == 0) {
      up();
    }
    drag(event);
  }

  private void up() {
    if (dragged.isPresent()) {
      dragged = Optional.empty();
      driver.letGo();
      deeds.changed();
    }
  }

  private void drag(Event event) {
    if (!deeds.drivable()) {
      dragged = Optional.empty();
    }
    dragged.ifPresent(row -> deeds.grid().find(JointColumn.RANGE).ifPresent(place -> {
      driver.goal(row.name(), row.span().at(RangeBar.share(place.left(), place.width(), event.x - grip)));
      deeds.changed();
    }));
  }

  private Optional<JointLine> lineAt(int y) {
    return list.visible(1).stream().filter(line -> list.bounds(line.key()).filter(at -> within(at, y)).isPresent())
        .findFirst();
  }

  private static boolean within(Rectangle at, int y) {
    return y >= at.y && y < at.y + at.height;
  }

  private void open(JointLine line) {
    switch (line) {
      case ChainHead head -> {}
      case JointRow row -> edit(row, "");
    }
  }

  private void edit(JointRow row, String first) {
    if (deeds.drivable()) {
      deeds.edit(row, first);
    }
  }

  private void key(Event event) {
    if ((event.stateMask & (SWT.CTRL | SWT.ALT | SWT.COMMAND)) != 0) {
      return;
    }
    presses++;
    switch (event.keyCode) {
      case ' ' -> stop();
      case SWT.ESC -> escape();
      case SWT.ARROW_LEFT -> arrow(event, -1);
      case SWT.ARROW_RIGHT -> arrow(event, 1);
      default -> typed(event);
    }
  }

  private void stop() {
    driver.stop();
    deeds.changed();
  }

  private void escape() {
    driver.cancel();
    if (deeds.drivable()) {
      driver.giveBack();
    }
    deeds.changed();
  }

  private void arrow(Event event, int direction) {
    list.selected().stream().findFirst().ifPresent(line -> {
      switch (line) {
        case ChainHead head -> foldBy(head, direction > 0);
        case JointRow row -> arrow(row, direction * ((event.stateMask & SWT.SHIFT) != 0 ? COARSE : 1), event.keyCode);
      }
    });
  }

  private void foldBy(ChainHead head, boolean open) {
    if (head.open() != open) {
      deeds.fold(head);
    }
  }

  private void arrow(JointRow row, double steps, int key) {
    if (!deeds.drivable()) {
      return;
    }
    if (deeds.jogging()) {
      held = Optional.of(key);
      driver.goal(row.name(), steps > 0 ? row.span().upper() : row.span().lower());
    } else {
      driver.nudge(row.name(), steps * row.measure().fine());
    }
    deeds.changed();
  }

  private void released(Event event) {
    if (held.filter(key -> key == event.keyCode).isPresent()) {
      long before = presses;
      list.control().getDisplay().timerExec(SETTLE_MILLIS, () -> settle(before));
    }
  }

  private void settle(long before) {
    if (presses == before && held.isPresent()) {
      held = Optional.empty();
      driver.letGo();
    }
  }

  private void typed(Event event) {
    boolean begins = Character.isDigit(event.character) || event.character == '-' || event.character == '.';
    if (begins) {
      list.selected().stream().findFirst().filter(JointRow.class::isInstance)
          .ifPresent(line -> edit((JointRow) line, String.valueOf(event.character)));
    }
  }
}
