package org.robotui.workbench.internal.pane;

import java.util.List;
import org.robotui.ui.ViewAction;

/**
 * A view of the robot that a window shows.
 *
 * @param id of its component
 * @param title what users read
 * @param seen whether it is in front of its tabs
 * @param actions what can be done in it; none before it was seen for the first time
 */
public record ViewEntry(String id, String title, boolean seen, List<ViewAction> actions) {
  public ViewEntry {
    actions = List.copyOf(actions);
  }
}
