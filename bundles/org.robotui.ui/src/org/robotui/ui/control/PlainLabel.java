package org.robotui.ui.control;

import org.eclipse.swt.SWT;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Label;
import org.robotui.ui.Face;
import org.robotui.ui.Role;
import org.robotui.ui.Theme;

/**
 * A label that keeps its colour: those of the toolkit get the one that the platform's style sheets give them by name.
 * Display thread.
 */
public final class PlainLabel extends Label {
  /**
   * A label on the ground of its parent.
   *
   * @param parent the parent
   * @param style {@link SWT#NONE}, or {@link SWT#WRAP} for several lines
   * @param theme colours and fonts
   * @param face how it is written
   * @param role the colour of its words
   */
  public PlainLabel(Composite parent, int style, Theme theme, Face face, Role role) {
    super(parent, style);
    setFont(theme.font(face));
    setForeground(theme.color(role));
    setBackground(parent.getBackground());
  }

  /**
   * The toolkit asks classes that are derived from it to say that they know what they do: nothing is changed but the
   * name.
   */
  @Override
  protected void checkSubclass() {
    // allowed
  }
}
