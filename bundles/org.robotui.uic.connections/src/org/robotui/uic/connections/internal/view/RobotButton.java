package org.robotui.uic.connections.internal.view;

import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import org.eclipse.swt.widgets.Composite;
import org.robotui.ui.Theme;
import org.robotui.ui.control.PopupMenu;
import org.robotui.ui.control.QuietButton;

/** Chooses one robot or all, in a menu. Display thread. */
final class RobotButton {
  private static final String ALL = "All robots";

  private final QuietButton button;
  private final Consumer<String> chosen;
  private List<String> names = List.of();
  private Optional<String> robot = Optional.empty();

  RobotButton(Composite parent, Theme theme, Consumer<String> chosen) {
    this.chosen = chosen;
    button = new QuietButton(parent, theme, this::open).text(label()).hint("Lists all robots or one");
  }

  QuietButton button() {
    return button;
  }

  /** True where the room it takes has changed. */
  boolean show(List<String> all, Optional<String> one) {
    names = all;
    if (robot.equals(one)) {
      return false;
    }
    robot = one;
    button.text(label()).checked(one.isPresent());
    return true;
  }

  private String label() {
    return robot.orElse(ALL) + " \u25be";
  }

  private void open() {
    PopupMenu menu = new PopupMenu(button).radio(ALL, robot.isEmpty(), () -> chosen.accept(""));
    names.forEach(name -> menu.radio(name, robot.filter(name::equals).isPresent(), () -> chosen.accept(name)));
    menu.openBelow(button);
  }
}
