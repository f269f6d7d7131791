package org.robotui.uic.parameters.internal.view;

import org.eclipse.swt.widgets.Composite;
import org.robotui.ui.Face;
import org.robotui.ui.Health;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;
import org.robotui.ui.control.Boxes;
import org.robotui.ui.control.NoticeLine;
import org.robotui.ui.control.QuietButton;
import org.robotui.uic.parameters.internal.model.ParametersModel;
import org.robotui.uic.parameters.internal.model.ParametersViewState;

/**
 * The line below: what became of the last change, a way back, and the question whether to take over. Display thread.
 */
final class ParameterFooter {
  private final Composite rule;
  private final Composite root;
  private final NoticeLine words;
  private final QuietButton takeOver;
  private final QuietButton cancel;
  private final QuietButton undo;
  private final QuietButton defaults;

  ParameterFooter(Composite parent, Theme theme, ParametersModel model) {
    rule = Boxes.rule(parent, theme);
    root = Boxes.bar(parent, theme, 5);
    words = new NoticeLine(root, theme, Face.BODY);
    takeOver =
        button(new QuietButton(root, theme, () -> model.control().takeOver()).text("Take over").fill(Role.ACCENT));
    cancel = button(new QuietButton(root, theme, () -> model.control().leave()).text("Cancel"));
    undo = button(new QuietButton(root, theme, model::undo).text("Undo"));
    defaults = button(
        new QuietButton(root, theme, () -> model.tuner().ifPresent(tuner -> tuner.restore())).text("All defaults")
            .hint("Sets all settings of the program to their defaults"));
  }

  /** Shows it; whether the line came or went. */
  boolean show(ParametersViewState look) {
    boolean asking = look.question().isPresent();
    boolean tuned =
        look.tuning() && look.panel().filter(p -> p.knobs().stream().anyMatch(k -> !k.isDefault())).isPresent();
    boolean undone = !look.tuning() && !look.undo().isEmpty();
    if (asking) {
      words.show(Health.WARNING,
          look.question().map(q -> q.holder() + " has control of " + q.robot() + ". Take over?").orElse(""));
    } else {
      words.show(look.told().health(), look.told().text());
    }
    undo.hint("Sets " + look.undo() + " back (Ctrl+Z)");
    boolean changed = Boxes.seen(takeOver, asking) | Boxes.seen(cancel, asking) | Boxes.seen(undo, undone && !asking)
        | Boxes.seen(defaults, tuned && !asking);
    if (changed) {
      root.layout();
    }
    boolean wanted = asking || tuned || undone || !look.told().text().isEmpty();
    return Boxes.seen(root, wanted) | Boxes.seen(rule, wanted);
  }

  private static QuietButton button(QuietButton made) {
    made.setLayoutData(Boxes.middle());
    return made;
  }
}
