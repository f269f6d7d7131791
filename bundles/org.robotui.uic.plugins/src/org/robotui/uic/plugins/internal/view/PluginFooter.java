package org.robotui.uic.plugins.internal.view;

import org.eclipse.swt.widgets.Composite;
import org.robotui.ui.Face;
import org.robotui.ui.Health;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;
import org.robotui.ui.ask.ControlFirst;
import org.robotui.ui.control.Boxes;
import org.robotui.ui.control.NoticeLine;
import org.robotui.ui.control.QuietButton;
import org.robotui.uic.plugins.internal.model.PluginsLook;

/** The question whether to take over from somebody who drives the robot. Display thread. */
final class PluginFooter {
  private final Composite rule;
  private final Composite root;
  private final NoticeLine words;

  PluginFooter(Composite parent, Theme theme, ControlFirst control, Runnable done) {
    rule = Boxes.rule(parent, theme);
    root = Boxes.bar(parent, theme, 3);
    words = new NoticeLine(root, theme, Face.BODY);
    QuietButton takeOver =
        new QuietButton(root, theme, () -> run(control::takeOver, done)).text("Take over").fill(Role.ACCENT);
    takeOver.setLayoutData(Boxes.middle());
    QuietButton cancel = new QuietButton(root, theme, () -> run(control::leave, done)).text("Cancel");
    cancel.setLayoutData(Boxes.middle());
    Boxes.seen(root, false);
    Boxes.seen(rule, false);
  }

  /** Asks, where there is something to be asked; whether the line came or went. */
  boolean show(PluginsLook look) {
    words.show(Health.WARNING,
        look.question().map(q -> q.holder() + " has control of " + q.robot() + ". Take over?").orElse(""));
    return Boxes.seen(root, look.question().isPresent()) | Boxes.seen(rule, look.question().isPresent());
  }

  private static void run(Runnable action, Runnable done) {
    action.run();
    done.run();
  }
}
