package org.robotui.workbench.internal.dock;

import java.util.Optional;
import org.eclipse.swt.widgets.Control;

/**
 * A view that is shown in a window.
 *
 * @param ruic the name of its robot UI
 * @param id of the view
 * @param control what it has made, which is another one after a restart
 */
public record SeenView(String ruic, String id, Control control) {
  /** The view that a control belongs to; none where the control is of the window, or says why there is no view. */
  public static Optional<SeenView> of(Control inside) {
    Control child = inside;
    while (child != null) {
      if (child.getParent() instanceof ViewHolder holder) {
        return holder.runs() ? Optional.of(new SeenView(holder.ruicName(), holder.id(), child)) : Optional.empty();
      }
      child = child.getParent();
    }
    return Optional.empty();
  }
}
