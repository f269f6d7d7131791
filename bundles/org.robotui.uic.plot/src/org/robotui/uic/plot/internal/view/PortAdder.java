package org.robotui.uic.plot.internal.view;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import org.eclipse.swt.graphics.Point;
import org.eclipse.swt.widgets.Control;
import org.robotui.api.port.SourceId;
import org.robotui.api.show.Subject;
import org.robotui.ui.control.PopupMenu;
import org.robotui.ui.show.DraggedPorts;

/**
 * Plots ports that come from other views: their fields where these are named or clear, else those that the user
 * chooses. Display thread.
 */
final class PortAdder implements DropZone.Taker {
  /** What it has the view do. */
  interface Plot {
    /** Adds signals, one a line, to an axis. */
    void add(String signals, int axis);

    /** Lets the user choose among all fields of a port. */
    void choose(SourceId port);

    /** Says why something is not done. */
    void refuse(String reason);
  }

  private static final int MOST_ASKED = 24;

  private final Control control;
  private final ChooserPanel.Robot robot;
  private final Plot plot;

  PortAdder(Control control, ChooserPanel.Robot robot, Plot plot) {
    this.control = control;
    this.robot = robot;
    this.plot = plot;
  }

  @Override
  public void signals(String text, int axis) {
    plot.add(text, axis);
  }

  @Override
  public void ports(DraggedPorts ports, int axis, Point at) {
    if (!ports.ruic().equals(robot.ruic())) {
      plot.refuse("this is a plot of " + robot.ruic() + ", and not of " + ports.ruic());
      return;
    }
    List<String> clear = new ArrayList<>();
    List<SourceId> open = new ArrayList<>();
    for (Subject.Stream stream : ports.streams()) {
      List<String> fields = stream.fields().isEmpty() ? robot.numbers(stream.port()) : stream.fields();
      if (!stream.fields().isEmpty() || fields.size() == 1) {
        clear.add(signals(stream.port(), fields));
      } else {
        open.add(stream.port());
      }
    }
    if (!clear.isEmpty()) {
      plot.add(String.join("\n", clear), axis);
    }
    open.stream().findFirst().ifPresent(port -> ask(port, axis, at));
  }

  /** Asks where it was dropped, as far as it is known what there is. */
  private void ask(SourceId port, int axis, Point at) {
    List<String> numbers = robot.numbers(port);
    if (numbers.isEmpty()) {
      plot.choose(port);
      return;
    }
    PopupMenu menu = new PopupMenu(control);
    numbers.stream().limit(MOST_ASKED)
        .forEach(field -> menu.push(field, () -> plot.add(signals(port, List.of(field)), axis)));
    menu.line().push("Choose among all\u2026", () -> plot.choose(port));
    menu.open(control.toDisplay(at));
  }

  static String signals(SourceId port, List<String> fields) {
    return fields.stream().map(field -> port + ":" + field).collect(Collectors.joining("\n"));
  }
}
