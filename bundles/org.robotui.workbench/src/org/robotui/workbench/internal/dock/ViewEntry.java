package org.robotui.workbench.internal.dock;

import java.util.List;
import org.robotui.ui.ViewAction;
import org.robotui.ui.ViewKey;

/**
 * A view of the robot that a window shows.
 *
 * @param id of its component
 * @param type of its component, which names its page in the documentation
 * @param title what users read
 * @param failed whether it does not work; its place says why
 * @param seen whether it is in front of its tabs
 * @param actions what can be done in it; none before it was seen for the first time
 * @param keys what it takes while it has the focus; none before it was seen for the first time
 */
public record ViewEntry(String id, String type, String title, boolean failed, boolean seen, List<ViewAction> actions,
    List<ViewKey> keys) {
  public ViewEntry {
    actions = List.copyOf(actions);
    keys = List.copyOf(keys);
  }

  /** Its title, and that it does not work where that is so. */
  public String label() {
    return failed ? title + " (does not work)" : title;
  }
}
