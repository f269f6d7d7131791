package org.robotui.data.marker;

import java.util.List;
import java.util.Optional;
import org.robotui.data.FrameId;
import org.robotui.data.Stamp;
import org.robotui.geometry.Quaternion;
import org.robotui.geometry.RigidTransform;

/**
 * A marker that is moved by hand. Poses are as the robot sent them, and may be none; see {@link Marker}.
 *
 * @param name unique at its server
 * @param description shown above it, may be empty
 * @param feedback where its server listens, as {@link MarkerFeedback} names it
 * @param frame the frame of its pose
 * @param stamp when its frame is looked up; empty where it moves with its frame
 * @param pose frame from marker, as its server has it
 * @param scale size of the controls that have no look of their own, metres
 * @param menu the entries of its menu, those of one level in their order
 * @param controls how it is moved
 */
public record InteractiveMarker(
    String name,
    String description,
    String feedback,
    FrameId frame,
    Optional<Stamp> stamp,
    RigidTransform pose,
    double scale,
    List<MenuEntry> menu,
    List<Control> controls) {
  /** What dragging does. */
  public enum Mode {
    /** Nothing. */
    NONE,
    /** Opens the menu. */
    MENU,
    /** Is clicked. */
    BUTTON,
    /** Moves along the control's x axis. */
    MOVE_AXIS,
    /** Moves in the control's y-z plane. */
    MOVE_PLANE,
    /** Turns about the control's x axis. */
    ROTATE_AXIS,
    /** Moves in the y-z plane and turns about x. */
    MOVE_ROTATE,
    /** Moves in the plane that faces the viewer. */
    MOVE_3D,
    /** Turns about all axes. */
    ROTATE_3D,
    /** Moves and turns about all axes. */
    MOVE_ROTATE_3D
  }

  /** What the orientation of a control is relative to. */
  public enum Orientation {
    /** To the marker: turns with it. */
    INHERIT,
    /** To the frame of the marker: stays when the marker turns. */
    FIXED,
    /** To the viewer: x points at the eye. */
    VIEW_FACING
  }

  /**
   * An entry of a menu.
   *
   * @param id names it, not 0
   * @param parent the entry above it, 0 for none
   * @param title what is read
   */
  public record MenuEntry(int id, int parent, String title) {}

  /**
   * One way to move it.
   *
   * @param name unique within the marker, may be empty
   * @param description a hint for users, may be empty
   * @param mode what dragging does
   * @param orientation what its rotation is relative to
   * @param rotation its axes, as sent: may be none
   * @param alwaysVisible seen also while nobody interacts
   * @param markers what is seen, poses in the marker's frame where a marker names no frame; empty for the usual look
   * @param independent true where a control that faces the viewer leaves the orientation of its markers alone
   */
  public record Control(
      String name,
      String description,
      Mode mode,
      Orientation orientation,
      Quaternion rotation,
      boolean alwaysVisible,
      List<Marker> markers,
      boolean independent) {
    /**
     * Copies the list.
     *
     * @param name of the control
     * @param description a hint
     * @param mode what dragging does
     * @param orientation what its rotation is relative to
     * @param rotation its axes
     * @param alwaysVisible seen always
     * @param markers what is seen
     * @param independent leaves the orientation of its markers alone
     */
    public Control {
      markers = List.copyOf(markers);
    }
  }

  /**
   * Copies the lists.
   *
   * @param name unique at its server
   * @param description shown above it
   * @param feedback where its server listens
   * @param frame of its pose
   * @param stamp of its frame
   * @param pose where it is
   * @param scale metres
   * @param menu its menu
   * @param controls how it is moved
   */
  public InteractiveMarker {
    menu = List.copyOf(menu);
    controls = List.copyOf(controls);
  }

  /**
   * The same marker elsewhere. Its controls stay the same objects.
   *
   * @param newFrame the frame of the pose
   * @param newStamp when the frame is looked up
   * @param newPose where it is now
   * @return the moved marker
   */
  public InteractiveMarker at(FrameId newFrame, Optional<Stamp> newStamp, RigidTransform newPose) {
    return new InteractiveMarker(name, description, feedback, newFrame, newStamp, newPose, scale, menu, controls);
  }
}
