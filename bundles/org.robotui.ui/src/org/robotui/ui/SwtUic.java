package org.robotui.ui;

import java.util.List;
import org.eclipse.swt.widgets.Composite;
import org.eclipse.swt.widgets.Control;
import org.robotui.api.Uic;

/**
 * A view in a window. {@link #tick} runs on the view's own worker and prepares; the methods here run on the display
 * thread and only paint and take input: they never block, decode or send (sending goes through the outputs of its
 * context, which returns at once).
 */
public interface SwtUic extends Uic {
  /**
   * Creates the control. Called each time the view is shown in a part; the control of an earlier call has been disposed
   * by then. It must fill its parent without a border of its own.
   *
   * @param parent the part's composite, with a fill layout
   * @param context what the window gives
   * @return the control
   */
  Control createControl(Composite parent, UiContext context);

  /**
   * Shows what the last ticks prepared, usually by a redraw. Called on the display thread, never more often than
   * painted.
   */
  void refresh();

  /**
   * What the user can do in the view's title line and context menu, in the order shown.
   *
   * @return the actions, the same objects for each call
   */
  default List<ViewAction> actions() {
    return List.of();
  }

  /**
   * The keys that the view takes while it has the focus, the most used first; for the list of shortcuts (? and F1).
   *
   * @return the keys, without those that every table and every text field has
   */
  default List<ViewKey> keys() {
    return List.of();
  }

  /**
   * What the search of the window finds in the view, asked each time that the search opens. It returns at once what is
   * known already.
   *
   * @return the items, in the order in which they are found where they fit alike
   */
  default List<ViewItem> items() {
    return List.of();
  }
}
