package org.robotui.uic.postures.internal.view;

import org.eclipse.swt.widgets.Composite;
import org.robotui.ui.Face;
import org.robotui.ui.Health;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;
import org.robotui.ui.ask.ControlFirst;
import org.robotui.ui.control.Boxes;
import org.robotui.ui.control.NoticeLine;
import org.robotui.ui.control.QuietButton;
import org.robotui.uic.postures.internal.model.PosturesLook;

/** The line below the postures: what is said, or the question whether to take over. Display thread. */
final class AnswerLine {
  private final Composite root;
  private final NoticeLine words;
  private final QuietButton takeOver;
  private final QuietButton cancel;

  AnswerLine(Composite parent, Theme theme, ControlFirst control, Runnable done) {
    Boxes.rule(parent, theme);
    root = Boxes.bar(parent, theme, 3);
    words = new NoticeLine(root, theme, Face.BODY);
    takeOver = button(theme, control::takeOver, done).text("Take over").fill(Role.ACCENT);
    cancel = button(theme, control::leave, done).text("Cancel");
    Boxes.seen(takeOver, false);
    Boxes.seen(cancel, false);
  }

  private QuietButton button(Theme theme, Runnable action, Runnable done) {
    QuietButton made = new QuietButton(root, theme, () -> {
      action.run();
      done.run();
    });
    made.setLayoutData(Boxes.middle());
    return made;
  }

  void show(PosturesLook look) {
    boolean asked = look.question().isPresent();
    if (asked) {
      words.show(Health.WARNING, look.question().map(q -> q.holder() + " has control of " + q.robot()
          + ". Take over?").orElse(""));
    } else if (look.words().isEmpty()) {
      words.show(Health.NONE, look.lines().isEmpty() ? "" : look.blocked().orElse(""));
    } else {
      words.show(look.health(), look.words());
    }
    if (Boxes.seen(takeOver, asked) | Boxes.seen(cancel, asked)) {
      root.layout();
    }
  }

  String words() {
    return words.words();
  }
}
