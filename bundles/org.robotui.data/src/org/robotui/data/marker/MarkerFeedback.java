package org.robotui.data.marker;

import java.util.Optional;
import org.robotui.data.Conflation;
import org.robotui.data.Data;
import org.robotui.data.Delivery;
import org.robotui.data.FrameId;
import org.robotui.data.InFrame;
import org.robotui.data.Late;
import org.robotui.data.Stamp;
import org.robotui.geometry.RigidTransform;
import org.robotui.geometry.Vector3;

/**
 * What a user does with an interactive marker.
 *
 * @param topic where the marker's server listens: {@link InteractiveMarker#feedback()}
 * @param client who it is: the same for all that one display says, and different from all others
 * @param marker name of the marker
 * @param control name of the control, may be empty
 * @param event what was done
 * @param frame the frame of pose and point
 * @param stamp when that frame is looked up; empty for the newest time known
 * @param pose where the user moved the marker: frame from marker
 * @param menuEntry what was chosen, 0 for nothing
 * @param point what the pointer hit, where that is known
 */
@Delivery(conflation = Conflation.EVENT, late = Late.NONE, expires = false)
public record MarkerFeedback(
    String topic,
    String client,
    String marker,
    String control,
    Event event,
    FrameId frame,
    Optional<Stamp> stamp,
    RigidTransform pose,
    int menuEntry,
    Optional<Vector3> point)
    implements Data, InFrame {
  /** What was done. */
  public enum Event {
    /** The user still holds it. */
    KEEP_ALIVE,
    /** It was moved. */
    POSE_UPDATE,
    /** An entry of its menu was chosen. */
    MENU_SELECT,
    /** It was clicked. */
    BUTTON_CLICK,
    /** The button went down. */
    MOUSE_DOWN,
    /** The button went up. */
    MOUSE_UP
  }
}
