package org.robotui.ui.control;

import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.robotui.ui.Health;
import org.robotui.ui.PaintedCanvas;
import org.robotui.ui.StateView;
import org.robotui.ui.Theme;

/** A message in the middle of a room that has nothing else to show. Display thread. */
public final class MessagePane {
  private final PaintedCanvas canvas;
  private Health health = Health.NONE;
  private String title = "";
  private String sentence = "";

  /**
   * An empty room.
   *
   * @param parent the parent
   * @param theme colours and fonts
   */
  public MessagePane(Composite parent, Theme theme) {
    StateView states = new StateView(theme);
    canvas = new PaintedCanvas(parent, theme, (gc, area) -> states.message(gc, area, health, title, sentence));
  }

  /**
   * What stands in the layout.
   *
   * @return the control
   */
  public Control control() {
    return canvas;
  }

  /**
   * Says something else.
   *
   * @param dot what to think of it
   * @param words a few
   * @param more what is so and what would help
   */
  public void show(Health dot, String words, String more) {
    if (health != dot || !title.equals(words) || !sentence.equals(more)) {
      health = dot;
      title = words;
      sentence = more;
      canvas.redraw();
    }
  }
}
