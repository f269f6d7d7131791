package org.robotui.ui;

import org.eclipse.swt.widgets.Control;

/** What is seen of a view, while it is shown in a part of a window. Display thread. */
@FunctionalInterface
public interface ViewSurface {
  /**
   * What stands in the part.
   *
   * @return the control
   */
  Control control();
}
