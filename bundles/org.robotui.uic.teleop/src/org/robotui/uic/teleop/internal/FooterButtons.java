package org.robotui.uic.teleop.internal;

import java.util.EnumMap;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import org.eclipse.swt.SWT;
import org.eclipse.swt.graphics.Point;
import org.eclipse.swt.graphics.Rectangle;
import org.eclipse.swt.widgets.Composite;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;
import org.robotui.ui.control.QuietButton;

/** The buttons at the right of the footer; those that do not apply are hidden. Display thread. */
final class FooterButtons {
  private final Map<TeleopFooter.Button, QuietButton> buttons = new EnumMap<>(TeleopFooter.Button.class);
  private int left;

  FooterButtons(Composite parent, Theme theme, Consumer<TeleopFooter.Button> pressed) {
    for (TeleopFooter.Button button : TeleopFooter.Button.values()) {
      QuietButton made = new QuietButton(parent, theme, () -> pressed.accept(button));
      made.setVisible(false);
      buttons.put(button, button.urgent() ? made.fill(Role.ACCENT) : made);
    }
  }

  void show(List<TeleopFooter.Button> shown, String robot, Rectangle footer) {
    buttons.forEach((button, control) -> control.text(button.label(robot)));
    left = footer.x + footer.width - 2 * Theme.STEP;
    shown.forEach(button -> place(buttons.get(button), footer));
    buttons.forEach((button, control) -> control.setVisible(shown.contains(button)));
  }

  /** Where they begin: the room of the sentence ends there. */
  int left() {
    return left;
  }

  private void place(QuietButton button, Rectangle footer) {
    Point size = button.computeSize(SWT.DEFAULT, SWT.DEFAULT);
    left -= size.x;
    button.setBounds(left, footer.y + (footer.height - size.y) / 2, size.x, size.y);
    left -= 2 * Theme.STEP;
  }
}
