package org.robotui.gl.display;

import java.util.List;
import java.util.Optional;
import org.robotui.data.FrameId;
import org.robotui.data.Stamp;
import org.robotui.geometry.RigidTransform;

/** Where frames are in the fixed frame of the scene. Safe for all threads, never blocks. */
public interface Places {
  /** Where a frame is, or why that is not known. */
  sealed interface Place {
    /**
     * Known.
     *
     * @param fixedFromFrame the transform
     */
    record At(RigidTransform fixedFromFrame) implements Place {}

    /**
     * Not known.
     *
     * @param reason a sentence that names the missing link
     */
    record Missing(String reason) implements Place {}

    /**
     * The transform, where it is known.
     *
     * @return fixed frame from frame
     */
    default Optional<RigidTransform> found() {
      return this instanceof At at ? Optional.of(at.fixedFromFrame()) : Optional.empty();
    }
  }

  /**
   * The fixed frame.
   *
   * @return the frame that the scene stands on
   */
  FrameId fixed();

  /**
   * Where a frame was when something was measured, or near that time.
   *
   * @param frame the frame of the data
   * @param stamp when; empty for the newest time known
   * @return the place, or why there is none
   */
  Place at(FrameId frame, Optional<Stamp> stamp);

  /**
   * All frames now known.
   *
   * @return sorted by robot and name
   */
  List<FrameId> all();

  /**
   * The frame that carries another.
   *
   * @param frame a frame
   * @return its parent, or none where it is a root or unknown
   */
  Optional<FrameId> parent(FrameId frame);
}
