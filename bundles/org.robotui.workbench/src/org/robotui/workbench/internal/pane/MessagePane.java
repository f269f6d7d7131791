package org.robotui.workbench.internal.pane;

import java.util.List;
import org.eclipse.swt.SWT;
import org.eclipse.swt.layout.GridData;
import org.eclipse.swt.layout.GridLayout;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.robotui.ui.Health;
import org.robotui.ui.PaintedCanvas;
import org.robotui.ui.Role;
import org.robotui.ui.StateView;
import org.robotui.ui.Theme;
import org.robotui.ui.control.QuietButton;

/** Says in the middle of a place why there is nothing else, and what would help. Display thread only. */
public final class MessagePane extends Composite {
  /**
   * Something that would help.
   *
   * @param label a short imperative
   * @param action does it
   */
  public record Choice(String label, Runnable action) {}

  private static final int HEIGHT = 96;

  /** Says it, with a button for each choice. */
  public MessagePane(Composite parent, Theme theme, Health health, String title, String sentence,
      List<Choice> choices) {
    super(parent, SWT.NONE);
    setBackground(theme.color(Role.PANEL));
    GridLayout layout = new GridLayout(Math.max(1, choices.size()), false);
    layout.marginWidth = 0;
    layout.marginHeight = 0;
    setLayout(layout);
    filler(choices.size());
    StateView view = new StateView(theme);
    PaintedCanvas canvas =
        new PaintedCanvas(this, theme, (gc, area) -> view.message(gc, area, health, title, sentence));
    GridData data = new GridData(SWT.FILL, SWT.CENTER, true, false, layout.numColumns, 1);
    data.heightHint = HEIGHT;
    canvas.setLayoutData(data);
    for (int i = 0; i < choices.size(); i++) {
      button(theme, choices.get(i), i, choices.size());
    }
    filler(choices.size());
  }

  private void button(Theme theme, Choice choice, int index, int count) {
    QuietButton button = new QuietButton(this, theme, choice.action()).text(choice.label()).checked(true);
    int align = count == 1 ? SWT.CENTER : index == 0 ? SWT.END : SWT.BEGINNING;
    button.setLayoutData(new GridData(align, SWT.CENTER, true, false));
  }

  private void filler(int columns) {
    Control gap = new Gap(this);
    gap.setLayoutData(new GridData(SWT.FILL, SWT.FILL, true, true, Math.max(1, columns), 1));
  }
}
