package org.robotui.uic.plot.internal.view;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
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

    /** Shows an axis over a signal. */
    void over(String signal, int axis);

    /** Lets the user choose among all fields of a port. */
    void choose(SourceId port);

    /** Says why something is not done. */
    void refuse(String reason);
  }

  private static final int MOST_ASKED = 24;
  private static final int MOST_PATHS = 4;

  private final Control control;
  private final ChooserPanel.Robot robot;
  private final Plot plot;

  PortAdder(Control control, ChooserPanel.Robot robot, Plot plot) {
    this.control = control;
    this.robot = robot;
    this.plot = plot;
  }

  @Override
  public void signals(String text, DropZone.Place place) {
    if (place.across()) {
      plot.over(text.lines().findFirst().orElse(""), place.axis());
    } else {
      plot.add(text, place.axis());
    }
  }

  @Override
  public void ports(DraggedPorts ports, DropZone.Place place, Point at) {
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
      signals(String.join("\n", clear), place);
    }
    open.stream().findFirst().ifPresent(port -> ask(port, place, at));
  }

  /** Asks where it was dropped, as far as it is known what there is. */
  private void ask(SourceId port, DropZone.Place place, Point at) {
    List<String> numbers = robot.numbers(port);
    if (numbers.isEmpty()) {
      plot.choose(port);
      return;
    }
    PopupMenu menu = new PopupMenu(control);
    paths(port, numbers).forEach((name, signal) -> menu.push(name, () -> plot.add(signal, place.axis())));
    menu.line();
    numbers.stream().limit(MOST_ASKED)
        .forEach(field -> menu.push(field, () -> signals(signals(port, List.of(field)), place)));
    menu.line().push("Choose among all\u2026", () -> plot.choose(port));
    menu.open(control.toDisplay(at));
  }

  /** What moves in a plane: one number over the other, by what it is called. */
  private static Map<String, String> paths(SourceId port, List<String> numbers) {
    Map<String, String> paths = new LinkedHashMap<>();
    numbers.stream().filter(x -> x.equals("x") || x.endsWith(".x")).limit(MOST_PATHS).forEach(x -> {
      String y = x.substring(0, x.length() - 1) + "y";
      if (numbers.contains(y)) {
        paths.put(y + Edits.OVER + x, port + ":" + y + Edits.OVER + port + ":" + x);
      }
    });
    return paths;
  }

  static String signals(SourceId port, List<String> fields) {
    return fields.stream().map(field -> port + ":" + field).collect(Collectors.joining("\n"));
  }
}
