package org.robotui.data.navigation;

import org.robotui.data.Data;
import org.robotui.data.Delivery;
import org.robotui.data.Late;

/**
 * What the navigation of a robot says of a goal: while it drives there, and how that ended.
 *
 * @param goal the name that it gave the goal; empty where it gives none
 * @param state how far it is
 * @param text what it says about that, for example why it gave up; may be empty
 */
@Delivery(late = Late.NONE, expires = false)
public record NavigationStatus(String goal, State state, String text) implements Data {
  /** How far a goal is. */
  public enum State {
    /** The robot drives to it. */
    ACTIVE,
    /** The robot is there. */
    SUCCEEDED,
    /** It was canceled, or another goal took its place. */
    CANCELED,
    /** Navigation gave up. */
    ABORTED,
    /** Navigation did not take it. */
    REJECTED
  }
}
